// A handout's Markdown in a page.
#include "framework/course/pages/markdown_page.h"

#include <regex>

#include "framework/course/pages/picture_words.h"
#include "tests/support.h"

namespace relief::pages {
namespace {

/// As a page has it, without white space between tags. There is one picture and one place for links.
std::string shown(const std::string& markdown) {
    const TemporaryFolder folder;
    folder.write("page.mustache", "{{#blocks}}\n{{> block}}\n{{/blocks}}");
    const PagePlaces places{.link = [](const std::string& target) -> std::optional<std::string> {
                                if (target == "there.md") return "there.html";
                                return {};
                            },
                            .picture = [](const std::string& target) -> std::optional<PagePicture> {
                                if (target == "one.png") return PagePicture{"pictures/one.png", 4, 3};
                                if (target == "worded.png")
                                    return PagePicture{
                                        .file = "worded.png",
                                        .width = 4,
                                        .height = 3,
                                        .words = picture_words(std::vector{PictureWord{.text = "word"}})};
                                return {};
                            }};
    const std::string page =
        render((folder.path() / "page").string(), {{"blocks", markdown_blocks(parse_markdown(markdown), places)}});
    return std::regex_replace(page, std::regex("\\s*(^|<[^>]*>|$)\\s*"), "$1");
}

TEST(MarkdownPage, ListsAreNestedAndClosed) {
    EXPECT_EQ(shown("* a\n* b\n\n  3. c\n  4. d\n\n  after\n\nend"),
              "<ul><li>a</li><li>b<ol start=\"3\"><li>c</li><li>d</li></ol><p>after</p></li></ul><p>end</p>");
    EXPECT_EQ(shown("1. a\n\n* b"), "<ol><li>a</li></ol><ul><li>b</li></ul>");
}

TEST(MarkdownPage, WordsAreLaidOverAFigure) {
    const std::string page = shown("![caption](worded.png)");
    EXPECT_NE(page.find("<span class=\"worded\"><img src=\"worded.png\""), std::string::npos) << page;
    EXPECT_NE(page.find("word</b></span></span></span><figcaption>caption"), std::string::npos) << page;
    EXPECT_EQ(shown("![caption](one.png)").find("worded"), std::string::npos);
}

TEST(MarkdownPage, TextIsEscapedAndStyled) {
    EXPECT_EQ(shown("a `<b>&'` **c *d***"),
              "<p>a<code>&lt;b&gt;&amp;&#39;</code><strong>c</strong><strong><em>d</em></strong></p>");
    EXPECT_EQ(shown("```\n<x>\n```\n\n> q\n\n---"),
              "<pre tabindex=\"0\" role=\"region\" aria-label=\"code "
              "1\">&lt;x&gt;</pre><blockquote><p>q</p></blockquote><hr>");
}

TEST(MarkdownPage, FoldsTheMeasurementsOfANumber) {
    const std::string page = shown("0.17\n\n```measured\n0.17  mean  shot 02\n```");
    EXPECT_TRUE(page.starts_with("<p>0.17</p><details class=\"measured\"><summary>How it was measured</summary>"))
        << page;
    EXPECT_TRUE(page.ends_with(">0.17  mean  shot 02</pre></details>")) << page;
}

TEST(MarkdownPage, ShowsMissingLinksAndPicturesAsText) {
    EXPECT_EQ(shown("[a](there.md) [b](nowhere.md)"), "<p><a href=\"there.html\">a</a>b</p>");
    EXPECT_EQ(
        shown("![a \"q\"](one.png) ![b](two.png)"),
        "<p><img src=\"pictures/one.png\" width=\"4\" height=\"3\" alt=\"a &quot;q&quot;\" loading=\"lazy\">b</p>");
}

TEST(MarkdownPage, HeadingsHaveIdsAndTablesAHead) {
    EXPECT_EQ(shown("# A `b`!\n\n# A b"), "<h1 id=\"a-b\">A<code>b</code>!</h1><h1 id=\"a-b-2\">A b</h1>");
    EXPECT_EQ(shown("| a | b |\n|---|---|\n| 1 | 2 |"),
              "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"table 1\"><table><thead><tr><th "
              "scope=\"col\">a</th><th scope=\"col\">b</th></tr></thead><tbody><tr><td>1</td><td>2</td></tr></tbody>"
              "</table></div>");
}

}  // namespace
}  // namespace relief::pages
