#include "framework/course/pages/page_words.h"

#include <regex>

namespace relief::pages {
namespace {

struct Phrase {
    std::string
        handout;  ///< a regular expression; a space stands for any white space, as lines of a handout end anywhere
    const char* page;
};

constexpr const char* by_its_button = "`$1` by its button “Open …”";

const Phrase phrases[] = {
    {"Open the lab with `\\./relief run [0-9]+`: a magenta chequer marks", "In the picture, a magenta chequer marks"},
    {"Open the lab with `\\./relief run [0-9]+`: the window names", "The page names"},
    {" and save it: (the shader reloads at once, and )?`\\./relief check [0-9]+` (builds the lab and )?names what is "
     "next",
     ": at each pause in typing the page draws, and the checks below the editor name what is next"},
    {"`\\./relief check [0-9]+` (builds the lab and )?shows how far you are",
     "The checks below the editor show how far you are"},
    {"`relief check` shows the public checks", "The page shows the public checks"},
    {"`--set (\\w+)=FILE --set (\\w+)=FILE`", "`$1` and `$2` by their buttons “Open …”"},
    {"`--set (\\w+)=FILE --set (\\w+)=([0-9]+)`", "`$1` by its button “Open …”, with `$2` $3"},
    {"`--set (\\w+)=FILE(\\.\\w+)?`", by_its_button},
    {", or an? [\\w\\s]+ dropped on the window", ""},
    {"; a file dropped on the window becomes the (first )?map", ""},
    {"in the window key", "on your computer, key"},
    {"key M, or `", "on your computer, key M, or `"},
};

}  // namespace

std::string in_page_words(const std::string& markdown) {
    std::string text = markdown;
    for (const Phrase& phrase : phrases) {
        const std::regex handout(std::regex_replace(phrase.handout, std::regex(" "), "\\s+"));
        text = std::regex_replace(text, handout, phrase.page);
    }
    return text;
}

}  // namespace relief::pages
