// Handouts as blocks of styled text.
#include "framework/course/pages/markdown.h"

#include <filesystem>
#include <random>

#include "framework/core/base/file.h"
#include "framework/core/base/text.h"
#include "tests/support.h"

namespace relief::pages {
namespace {

Spans spans_of(std::string_view text) {
    const auto blocks = parse_markdown(text);
    EXPECT_EQ(blocks.size(), 1u) << text;
    return blocks.empty() ? Spans{} : blocks.front().spans;
}

/// Returns a span as text with its styles as letters in front: "b:bold", "bi:both", "plain".
std::string shown_as(const Span& span) {
    std::string style;
    if (span.bold) style += 'b';
    if (span.italic) style += 'i';
    if (span.code) style += 'c';
    if (span.image) style += 'p';
    if (!span.target.empty()) style += "(" + span.target + ")";
    return (style.empty() ? "" : style + ":") + span.text;
}
std::string line_of(std::string_view text) {
    std::string line;
    for (const Span& span : spans_of(text)) line += (line.empty() ? "" : "|") + shown_as(span);
    return line;
}
/// Returns blocks as "kind+level marker text", one line each.
std::string outline(std::string_view text) {
    static constexpr const char* kinds[] = {"text", "heading", "item", "quote", "code", "table", "rule"};
    std::string result;
    for (const Block& block : parse_markdown(text)) {
        result += kinds[int(block.kind)] + std::to_string(block.level) + block.marker;
        for (const Span& span : block.spans) result += " " + shown_as(span);
        if (!block.text.empty()) result += " " + block.text;
        for (const auto& row : block.rows) {
            result += " [";
            for (const Spans& cell : row) {
                for (const Span& span : cell) result += shown_as(span);
                result += ";";
            }
            result += "]";
        }
        result += "\n";
    }
    return result;
}

TEST(Markdown, LinesOfAParagraphBecomeOneAndABlankLineEndsIt) {
    EXPECT_EQ(outline("one\ntwo\n\nthree\r\n"), "text0 one two\ntext0 three\n");
    EXPECT_EQ(outline("one  \ntwo\\\nthree"), "text0 one\ntwo\nthree\n") << "breaks that were asked for";
}

TEST(Markdown, HeadingsHaveSixLevelsAndASpace) {
    EXPECT_EQ(outline("# One\n## Two ##\n###### Six\n####### seven\n#none"),
              "heading1 One\nheading2 Two\nheading6 Six\ntext0 ####### seven #none\n");
    EXPECT_EQ(outline("text\n# Heading\ntext"), "text0 text\nheading1 Heading\ntext0 text\n");
}

TEST(Markdown, StylesAreReadFromTheirMarks) {
    EXPECT_EQ(line_of("a **bold** and *slanted* `code`, both ***here***"),
              "a |b:bold| and |i:slanted| |c:code|, both |bi:here");
    EXPECT_EQ(line_of("__bold__ _slanted_ **bold *both***"), "b:bold| |i:slanted| |b:bold |bi:both");
    EXPECT_EQ(line_of("``code with ` in it`` and `` ` ``"), "c:code with ` in it| and |c:`");
    EXPECT_EQ(line_of("**`code` in bold**"), "bc:code|b: in bold");
}

TEST(Markdown, LinksAndImagesKeepTheirTargets) {
    EXPECT_EQ(line_of("see [the *page*](a/b.md \"title\")"), "see |(a/b.md):the |i(a/b.md):page");
    EXPECT_EQ(line_of("![a [b] picture](../p.png)"), "p(../p.png):a [b] picture");
    EXPECT_EQ(line_of("<https://example.org/x>."), "(https://example.org/x):https://example.org/x|.");
}

TEST(Markdown, TextWithoutMarkupStaysAsWritten) {
    for (const std::string& text :
         split("clip_from_world and u_eye_;2 * 3 * 4;a ** b;**open;*open;`open;[a] (b);[a](b;![a](b;![;[;<http://a b>;"
               "a | b;n · h, 0)^shininess;x < y;];a\\;a ****;__;``;a *",
               ';'))
        EXPECT_EQ(line_of(text), text);
    EXPECT_EQ(line_of("\\*not\\* \\`this\\` a\\b"), "*not* `this` a\\b");
    EXPECT_EQ(line_of("*a `*` b*"), "i:a |ic:*|i: b") << "marks within code close nothing";
}

TEST(Markdown, ListsNestByIndent) {
    EXPECT_EQ(outline("- a\n  goes on\n  - b\n* c\n\n  of c\n\nnot of it\n"),
              "item0* a goes on\nitem1* b\nitem0* c\ntext1 of c\ntext0 not of it\n");
    EXPECT_EQ(outline("1. a\n2) b\n   - c\n10. d"), "item01. a\nitem02. b\nitem1* c\nitem010. d\n");
    EXPECT_EQ(outline("Blinn, in\n1978. Then\n- a"), "text0 Blinn, in 1978. Then\nitem0* a\n")
        << "a year is not an item";
    EXPECT_EQ(outline("-\n-x\n"), "item0*\ntext0 -x\n") << "no space, no item";
}

TEST(Markdown, CodeIsKeptToTheLetter) {
    EXPECT_EQ(outline("```glsl\nfloat a; // *b*\n\n  # c\n```\ntext"),
              "code0 float a; // *b*\n\n  # c\n\ntext0 text\n");
    EXPECT_EQ(outline("~~~\n```\n~~~\n"), "code0 ```\n\n");
    EXPECT_EQ(outline("text\n\n    indented\n      more\n\ntext"),
              "text0 text\ncode0 indented\n  more\n\ntext0 text\n");
    EXPECT_EQ(outline("- a\n  ```\n  b\n  ```\n- c"), "item0* a\ncode1 b\n\nitem0* c\n");
    EXPECT_EQ(outline("```\nnever closed"), "code0 never closed\n\n");
}

TEST(Markdown, TablesHaveAsManyCellsInEveryRowAsInTheirHeading) {
    EXPECT_EQ(outline("| a | b |\n|---|:-:|\n| `x \\| y` | **z** |\n| 1 |\n| 1 | 2 | 3 |\n\ntext"),
              "table0 [a;b;] [c:x | y;b:z;] [1;;] [1;2;]\ntext0 text\n");
    EXPECT_EQ(outline("a | b\n--- | ---\n1 | 2"), "table0 [a;b;] [1;2;]\n");
    EXPECT_EQ(outline("| a |\n|---|\n| b \\|\n| c \\"), "table0 [a;] [b |;] [c \\;]\n");
}

TEST(Markdown, ReadsRulesAndQuotes) {
    EXPECT_EQ(outline("---\n* * *\n> said\n> so\nlazily\n\ntext"), "rule0\nrule0\nquote0 said so lazily\ntext0 text\n");
}

TEST(Markdown, UnclosedEmphasisEndsWithItsBlock) {
    EXPECT_EQ(outline("_[a](_)\n\nb"), "text0 i(_):a\ntext0 b\n") << "what md4c 0.4.8 makes of an open mark";
}

TEST(Markdown, AnEmptyTextHasNoBlocks) {
    for (const char* text : {"", "\n", " \n\t\n", "\xef\xbb\xbf"}) EXPECT_TRUE(parse_markdown(text).empty());
}

// Unclosed syntax and random bytes: all text comes back in some block, in bounded time.
TEST(Markdown, AcceptsAnyText) {
    std::mt19937 random(1);
    const std::string alphabet = "**__``~~[]()!<>|-:#\\ \n\n\tab1.+\xc3\xb6";
    for (int i = 0; i < 3000; ++i) {
        std::string text;
        for (size_t length = random() % 120; length > 0; --length) text += alphabet[random() % alphabet.size()];
        size_t letters = 0;
        for (const Block& block : parse_markdown("x " + text)) {
            letters += block.text.size();
            for (const Span& span : block.spans) letters += span.text.size();
            for (const auto& row : block.rows)
                for (const Spans& cell : row) {
                    for (const Span& span : cell) letters += span.text.size();
                    ++letters;
                }
        }
        ASSERT_GT(letters, 0u) << text;
    }
    for (const std::string piece : {"*", "**", "[", "](", "`", "- ", "> ", "|", "*a ", "![", "_a_", "a\n- "}) {
        std::string text;
        for (int i = 0; i < 5000; ++i) text += piece;
        text += "x";
        EXPECT_FALSE(parse_markdown(text).empty()) << piece;
    }
}

TEST(Markdown, ALineHasCodeBetweenBackticks) {
    const std::string line = "`along` is *divided*: times `depth`";
    EXPECT_EQ(
        line_with_code(line),
        (Spans{{.text = "along", .code = true}, {.text = " is *divided*: times "}, {.text = "depth", .code = true}}));
    EXPECT_EQ(line_with_code("a ` b"), (Spans{{.text = "a "}, {.text = " b"}}));
    EXPECT_EQ(line_with_code(""), Spans{});
}

TEST(Markdown, LeavesOutTheTagsThatFoldMeasuredBlocksOnGitHub) {
    const auto blocks = parse_markdown(
        "1.5 texels\n\n<details><summary>How it was measured</summary>\n\n```measured\n1.5 mean\n```\n\n</details>\n\n"
        "<details>\n");
    ASSERT_EQ(blocks.size(), 3u);
    EXPECT_EQ(plain_text(blocks[0].spans), "1.5 texels");
    EXPECT_EQ(blocks[1].language, "measured");
    EXPECT_EQ(plain_text(blocks[2].spans), "<details>") << "other tags are text";
}

TEST(Handouts, FoldAllMeasuredBlocksOnGitHub) {
    size_t count = 0;
    for (const auto& lab : std::filesystem::directory_iterator(std::filesystem::path(source_folder) / "labs")) {
        if (!std::filesystem::exists(lab.path() / "lab.toml")) continue;
        const std::string text = read_file(lab.path() / "README.md");
        const std::string begin = "```measured\n", fold = "<details><summary>How it was measured</summary>\n\n";
        for (size_t at = text.find(begin); at != text.npos; at = text.find(begin, at + 1), ++count) {
            EXPECT_EQ(text.substr(at - fold.size(), fold.size()), fold) << lab.path();
            EXPECT_TRUE(text.substr(text.find("\n```\n", at)).starts_with("\n```\n\n</details>\n")) << lab.path();
        }
    }
    EXPECT_GT(count, 30u);
}

}  // namespace
}  // namespace relief::pages
