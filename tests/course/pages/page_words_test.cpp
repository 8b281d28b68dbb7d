// Handouts in the words of a lab's page.
#include "framework/course/pages/page_words.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "tests/support.h"

namespace relief::pages {
namespace {

TEST(PageWords, SayWhatOneDoesInThePage) {
    EXPECT_EQ(
        in_page_words("**Begin here.** Open the lab with `./relief run 11`: a magenta chequer marks what is not "
                      "written yet. Write task 11.1\nand save it: the shader reloads at once, and `./relief\n"
                      "check 11` names what is next. Set `steps`."),
        "**Begin here.** In the picture, a magenta chequer marks what is not written yet. Write task 11.1: at each "
        "pause in typing the page draws, and the checks below the editor name what is next. Set `steps`.");
    EXPECT_EQ(in_page_words("| `--set shape=FILE`, or a file dropped on the window | your own model |"),
              "| `shape` by its button “Open …” | your own model |");
    EXPECT_EQ(in_page_words("| key M, or `./relief shot 03 --map -o map.png` | the map |"),
              "| on your computer, key M, or `./relief shot 03 --map -o map.png` | the map |");
}

// Also a handout that is written later.
TEST(PageWords, LeaveNothingThatAPageDoesNotHave) {
    size_t handouts = 0;
    for (const auto& lab : std::filesystem::directory_iterator(course_root() / "labs")) {
        if (!std::filesystem::exists(lab.path() / "lab.toml")) continue;
        const std::string handout = read_file(lab.path() / "README.md"), words = in_page_words(handout);
        EXPECT_NE(words, handout) << lab.path();
        for (const char* const word : {"./relief run", "save it", "the window ", "the window:", "dropped on", "=FILE"})
            EXPECT_FALSE(contains(words, word)) << lab.path() << ": " << word;
        ++handouts;
    }
    EXPECT_GE(handouts, 19u);
}

}  // namespace
}  // namespace relief::pages
