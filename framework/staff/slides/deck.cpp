#include "framework/staff/slides/deck.h"

#include <fmt/format.h>

#include <regex>
#include <set>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/course/manifest/manifest.h"
#include "framework/course/pages/sources.h"
#include "framework/course/pages/svg.h"
#include "framework/course/pages/template.h"
#include "framework/course/task/starter.h"

namespace relief::slides {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words = split(text, ' ');
    std::erase(words, "");
    return words;
}

/// Breaks lines of code that are too long for a slide, whose letters would shrink: before a comment, or after a comma,
/// a parenthesis or another space.
std::string fitted(const std::string& code) {
    constexpr size_t longest = 74;
    std::string result;
    for (std::string line : split(code, '\n')) {
        const size_t indent = line.find_first_not_of(' '), comment = line.find("//");
        const std::string next = std::string(indent == std::string::npos ? 0 : indent, ' ');
        if (line.size() > longest && comment != std::string::npos && comment > indent) {
            result += next + line.substr(comment) + '\n';  // a comment at the end goes before its line
            line.erase(line.find_last_not_of(' ', comment - 1) + 1);
        }
        const std::string begin = comment == indent ? next + "// " : next + "    ";
        while (line.size() > longest) {
            size_t end = line.rfind(' ', longest);
            if (const size_t comma = line.rfind(", ", longest - 1);
                comment != indent && comma != std::string::npos && comma > longest / 2)
                end = comma + 1;
            if (end == std::string::npos || end <= begin.size()) break;
            result += line.substr(0, end) + '\n';
            line = begin + line.substr(end + 1);
        }
        result += line + '\n';
    }
    result.pop_back();
    return result;
}

class Reader {
public:
    Reader(const std::string& text, const fs::path& file, std::string name, bool solutions)
        : lines_(split(text, '\n')), file_(file), name_(std::move(name)), solutions_(solutions) {}

    Deck read() {
        front_matter();
        while (at_ < lines_.size()) slide();
        return std::move(deck_);
    }

private:
    [[noreturn]] void fail(const std::string& message) const { throw Error({file_, int(at_) + 1}, message); }
    const std::string& line() const { return lines_[at_]; }

    void front_matter() {
        if (line() != "---") fail("a deck begins with Marp's directives between two lines of ---");
        do {
            deck_.text += line() + '\n';
            if (++at_ == lines_.size()) fail("the directives at the top are never closed by ---");
        } while (line() != "---");
        deck_.text += "---\n";
        ++at_;
    }

    /// Reads a slide up to and including the --- that ends it.
    void slide() {
        const std::string before = deck_.text;
        const size_t figures = deck_.figures.size();
        const bool hidden = is_solution();
        for (; at_ < lines_.size() && line() != "---"; ++at_)
            if (line().starts_with("```"))
                block(hidden);
            else
                deck_.text += with_figures(line()) + '\n';
        deck_.text += sources_note(std::string_view(deck_.text).substr(before.size()));
        const bool more = at_ < lines_.size();
        ++at_;
        if (hidden && !solutions_) {
            deck_.text = before;
            deck_.figures.resize(figures);
            // The rule before the hidden slide now precedes the next slide. If there is none, remove it.
            if (!more && deck_.text.ends_with("---\n")) deck_.text.erase(deck_.text.size() - 4);
        } else if (more) {
            deck_.text += "---\n";
        }
    }

    /// Returns a speaker's note with the entries that a slide cites; "" if it cites none.
    std::string sources_note(std::string_view slide) const {
        std::set<const pages::Source*> cited;
        for (const pages::Citation& citation : pages::citations_in(slide, sources_))
            if (citation.source) cited.insert(citation.source);
        std::string note;
        for (const pages::Source* source : cited)
            note += "\n" + pages::source_text(*source) + (source->doi.empty() ? "" : ", doi:" + source->doi);
        return note.empty() ? "" : "\n<!-- Sources" + note + "\n-->\n\n";
    }

    bool is_solution() const {
        for (size_t i = at_; i < lines_.size() && lines_[i] != "---"; ++i)
            if (lines_[i].find("_class: solution") != std::string::npos) return true;
        return false;
    }

    /// Reads a block from its opening fence to its closing one.
    void block(bool hidden) {
        const size_t opened = at_;
        const std::vector<std::string> words = words_of(line().substr(3));
        std::vector<std::string> inside;
        while (++at_ < lines_.size() && !line().starts_with("```")) inside.push_back(line());
        if (at_ == lines_.size()) {
            at_ = opened;
            fail("this ``` is never closed");
        }
        const size_t closed = at_;
        at_ = opened;  // place of errors
        if (!words.empty() && words[0] == "mistakes")
            mistakes({words.begin() + 1, words.end()}, inside);
        else if (words == std::vector<std::string>{"measured"})
            deck_.text += fmt::format("<!-- Measured by relief\n{}\n-->\n", join(inside, "\n"));
        else if (words.size() == 3)
            quote(words, inside, hidden);
        else if (words.size() == 2 || words.size() > 3)
            fail("a block of code that quotes says ```language file region");
        else
            for (size_t i = opened; i <= closed; ++i) deck_.text += lines_[i] + '\n';
        at_ = closed;
    }

    void quote(const std::vector<std::string>& words, const std::vector<std::string>& inside, bool hidden) {
        if (!inside.empty()) fail("a block that quotes a file has nothing in it: the file's region goes there");
        check::Region region;
        try {
            region = check::region_of(read_file(course_root() / words[1]), words[1], words[2]);
        } catch (const Error& error) {
            fail(error.what());
        }
        if (region.has_solution && !hidden)
            fail(fmt::format("{} has a solution in {}: quote it on a slide with <!-- _class: solution -->", words[1],
                             words[2]));
        deck_.text += fmt::format("```{}\n{}```\n\n<p class=\"source\">{}</p>\n", words[0], fitted(region.text),
                                  pages::html(words[1]));
    }

    void mistakes(const std::vector<std::string>& words, const std::vector<std::string>& ids) {
        if (words.empty()) fail("```mistakes says which lab, and how it is drawn: ```mistakes 10 --set view=one");
        if (ids.empty()) fail("name a mistake of the lab's manifest on each line");
        std::vector<std::string> pictures, hints;
        std::vector<std::string> shot = {"shot"};
        shot.insert(shot.end(), words.begin(), words.end());
        pictures.push_back(figure(shot));
        try {
            const Manifest manifest = load_manifest(find_lab(words[0]));
            for (const std::string& id : ids) hints.push_back(manifest.mistake(id).hint);
        } catch (const UsageError& error) {
            fail(error.what());
        }
        for (const std::string& id : ids) {
            std::vector<std::string> wrong = shot;
            wrong.insert(wrong.end(), {"--mistake", id});
            pictures.push_back(figure(wrong));
        }
        for (const bool answered : {false, true}) {
            pages::List shown;
            for (size_t i = 0; i < pictures.size(); ++i)
                shown.push_back(
                    pages::Fields{{"file", pictures[i]},
                                  {"alt", i == 0 ? "as it should be" : "with the mistake " + ids[i - 1]},
                                  {"letter", i == 0 ? "right" : std::string(1, char('A' + i - 1))},
                                  {"answered", answered && i > 0},
                                  {"hint", answered && i > 0 ? pages::with_code(hints[i - 1]) : pages::Value()}});
            deck_.text += pages::render("framework/staff/slides/mistakes",
                                        {{"title", answered ? "What went wrong" : "What went wrong here?"},
                                         {"figures", std::move(shown)}}) +
                          (answered ? "\n" : "\n\n---\n\n");
        }
    }

    std::string with_figures(const std::string& line) {
        static const std::regex form(R"(\]\(<((?:shot|bench) [^>]*)>\))");
        std::string result;
        auto rest = line.begin();
        for (auto match = std::sregex_iterator(line.begin(), line.end(), form); match != std::sregex_iterator();
             ++match) {
            result.append(rest, line.begin() + match->position());
            const std::string file = figure(words_of((*match)[1]));
            constexpr std::string_view bare = "![bare ";
            if (const size_t begin = result.rfind("!["); result.compare(begin, bare.size(), bare) == 0) {
                result.replace(begin, bare.size(), "![");
                deck_.figures.back().has_words = false;
            }
            result += "](" + file + ")";
            rest = line.begin() + match->position() + match->length();
        }
        return result.append(rest, line.end());
    }

    std::string figure(const std::vector<std::string>& command) {
        for (const std::string& word : command)
            if (word == "-o") fail("a figure has a place of its own: leave -o out");
        if (command[0] == "bench" && (command.size() < 2 || command[1].starts_with("-")))
            fail("a plot is of one topic: bench parallax --quick");
        const std::string file =
            fmt::format("{}/{:02}.{}", name_, deck_.figures.size() + 1, command[0] == "bench" ? "svg" : "png");
        deck_.figures.push_back({command, file, int(at_) + 1});
        return file;
    }

    std::vector<std::string> lines_;
    fs::path file_;
    std::string name_;
    bool solutions_;
    std::vector<pages::Source> sources_ = pages::load_sources();
    size_t at_ = 0;
    Deck deck_;
};

}  // namespace

Deck read_deck(const std::string& text, const fs::path& file, const std::string& name, bool solutions) {
    return Reader(text, file, name, solutions).read();
}

std::string with_words(const std::string& deck, const std::string& file, const std::string& words) {
    const size_t end = deck.find("](" + file + ")"), begin = deck.rfind("![", end);
    if (words.empty() || end == std::string::npos) return deck;
    std::vector<std::string> alt = words_of(deck.substr(begin + 2, end - begin - 2));
    if (alt.empty() || alt[0] == "bg") return deck;
    std::string width;
    if (alt[0].starts_with("w:")) {
        width = fmt::format(" style=\"width:{}px\"", alt[0].substr(2));
        alt.erase(alt.begin());
    }
    const std::string markup = words.substr(0, words.find_last_not_of('\n') + 1);
    return deck.substr(0, begin) +
           fmt::format("<span class=\"worded\"{}><img src=\"{}\" alt=\"{}\">{}</span>", width, file,
                       pages::html(join(alt, " ")), markup) +
           deck.substr(end + file.size() + 3);
}

std::string with_moving_drawings(const std::string& deck, const fs::path& drawings) {
    static const std::regex form(R"(!\[w:([0-9]+) [^\]]*\]\(diagrams/([a-z_]+\.svg)\))");
    std::string result;
    auto rest = deck.begin();
    for (auto match = std::sregex_iterator(deck.begin(), deck.end(), form); match != std::sregex_iterator(); ++match) {
        std::string svg = read_file(drawings / (*match)[2].str());
        if (!is_moving_drawing(svg)) continue;
        std::erase(svg, '\n');  // an empty line would end it
        result.append(rest, deck.begin() + match->position());
        result += fmt::format("<div class=\"plate\" style=\"width:{}px\">{}</div>", (*match)[1].str(), svg);
        rest = deck.begin() + match->position() + match->length();
    }
    return result.append(rest, deck.end());
}

}  // namespace relief::slides
