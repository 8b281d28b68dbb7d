// Templates: every inserted value is escaped, and a missing value is an error.
#include "framework/course/pages/template.h"

#include <fmt/format.h>

#include <regex>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/library/maps/visualize.h"
#include "tests/support.h"

namespace relief::pages {
namespace {

namespace fs = std::filesystem;

const std::string markup = "<script>&\"'";

std::string rendered(const std::string& text, const Fields& values) {
    const TemporaryFolder folder;
    folder.write("one.mustache", text);
    return render((folder.path() / "one").string(), values);
}

TEST(Template, AValueIsEscapedBetweenTagsAndInAttributes) {
    EXPECT_EQ(rendered("<a title=\"{{x}}\">{{x}}</a>", {{"x", markup}}),
              "<a title=\"&lt;script&gt;&amp;&quot;&#39;\">&lt;script&gt;&amp;&quot;&#39;</a>");
    EXPECT_EQ(rendered("{{#x}}{{> with_code}}{{/x}}", {{"x", with_code("a `<b>` & `c")}}),
              "a <code>&lt;b&gt;</code> &amp; c");
}

TEST(Template, FalseEmptyTextsAndEmptyListsHideASection) {
    for (const Value& nothing : {Value(), Value(false), Value(""), Value(List{}), rows(List{})})
        EXPECT_EQ(rendered("{{#x}}yes{{/x}}{{^x}}no{{/x}}", {{"x", nothing}}), "no");
    for (const Value& something : {Value(true), Value(0), Value("0"), Value(Fields{}), rows(List{"a"})})
        EXPECT_EQ(rendered("{{#x}}yes{{/x}}{{^x}}no{{/x}}", {{"x", something}}), "yes");
    EXPECT_EQ(rendered("{{#x}}<ul>{{#rows}}<li>{{.}}</li>{{/rows}}</ul>{{/x}}", {{"x", rows(List{"a", "b"})}}),
              "<ul><li>a</li><li>b</li></ul>");
}

TEST(Template, MissingValuesAndUnclosedSectionsAreErrors) {
    EXPECT_THROW(rendered("{{nmae}}", {{"name", "x"}}), Error);
    EXPECT_THROW(rendered("{{#x}}{{/y}}", {{"x", true}, {"y", true}}), Error);
    EXPECT_THROW(rendered("{{> no such file}}", {}), Error);
    EXPECT_THROW(render("no such file", {}), Error);
}

/// Returns the texts of all templates of the course, by name.
std::map<std::string, std::string> templates() {
    std::map<std::string, std::string> all;
    const fs::path root = source_folder;
    for (const auto& entry : fs::recursive_directory_iterator(root / "framework"))
        if (entry.path().extension() == ".mustache")
            all[entry.path().lexically_relative(root).replace_extension()] = read_file(entry.path());
    return all;
}

/// Returns the contents of all tags {{...}} with their signs: "name", "#name", "{name".
std::vector<std::string> tags_of(const std::string& text) {
    static const std::regex form(R"(\{\{([#^/>!&{]?)\s*([^}]*)\}\})");
    std::vector<std::string> tags;
    for (auto match = std::sregex_iterator(text.begin(), text.end(), form); match != std::sregex_iterator(); ++match)
        tags.push_back((*match)[1].str() + (*match)[2].str());
    return tags;
}

/// The values that are not escaped. The course's own code and files provide them.
const std::set<std::pair<std::string, std::string>> not_escaped = {
    {"framework/course/pages/block", "math"},    // formula.cpp's
    {"framework/course/pages/block", "moving"},  // a drawing of assets/diagrams
    {"framework/course/pages/page", "page.style"}, {"framework/course/pages/page", "page.script"},
    {"framework/staff/pages/bench", "section"},     // topic.mustache, possibly from an earlier run
    {"framework/staff/pages/mistakes", "article"},  // mistake.mustache, from another process
    {"framework/staff/pages/topic", "broad"},       // gnuplot's SVG
    {"framework/staff/pages/topic", "narrow"}};

TEST(Templates, OnlyOurOwnTextIsNotEscaped) {
    std::set<std::pair<std::string, std::string>> found;
    for (const auto& [name, text] : templates())
        for (const std::string& tag : tags_of(text))
            if (tag[0] == '{' || tag[0] == '&') found.emplace(name, tag.substr(1));
    EXPECT_EQ(found, not_escaped);
}

/// Returns a value for each name in all templates: `value`, or nothing for the names in `none`.
Fields for_all(const std::string& value, const std::set<std::string>& none) {
    Fields values, page, last;
    for (const auto& [file, text] : templates())
        for (const std::string& tag : tags_of(text)) {
            const std::string name = tag.substr(tag.find_first_not_of("#^/{") == 0 ? 0 : 1);
            if (tag[0] == '!' || tag[0] == '>' || name == ".") continue;
            const Value given = none.contains(name) ? Value() : Value(value);
            if (name.starts_with("page."))
                page[name.substr(5)] = given;
            else if (name.starts_with("last."))
                last[name.substr(5)] = given;
            else
                values[name] = given;
        }
    page["body"] = "with_code";
    values["page"] = page, values["last"] = last;
    return values;
}

TEST(Templates, ValuesAreEscapedEverywhere) {
    std::set<std::string> optional;
    for (const auto& [name, text] : templates())
        for (const std::string& tag : tags_of(text))
            if (tag[0] == '^') optional.insert(tag.substr(1));
    const std::regex raw("<script>&|&\"|\"'");
    ASSERT_TRUE(std::regex_search(markup, raw));
    int escaped = 0;
    for (const auto& [name, text] : templates())
        for (const std::set<std::string>& none : {std::set<std::string>{}, optional}) {
            Fields values = for_all(markup, none);
            for (const auto& [file, ours] : not_escaped) {
                if (!ours.starts_with("page."))
                    values[ours] = "ours";  // also if another template includes that file
                else if (file == name)
                    values["page"].fields[ours.substr(5)] = "ours";
            }
            const std::string page = render(name, values);
            EXPECT_EQ(page.find(markup), std::string::npos) << name << "\n" << page;
            escaped += page.find("&lt;script&gt;&amp;&quot;&#39;") != std::string::npos;
        }
    EXPECT_GT(escaped, 30) << "the claim is empty when nothing is shown";
}

TEST(Styles, TheErrorScaleHasTheColoursOfTheErrorMap) {
    std::string stops;
    for (int i = 0; i <= 5; ++i) {
        const glm::dvec3 color = 255.0 * heat_color(i / 5.0);
        stops += fmt::format("{}rgb({:.0f} {:.0f} {:.0f})", i ? ", " : "", color.r, color.g, color.b);
    }
    EXPECT_NE(page_file("colors", ".css").find(stops), std::string::npos) << stops;
}

TEST(Styles, NameTheirColoursInOnePlace) {
    static const std::regex color("(#[0-9a-f]{3,8}|rgba?\\([^)]*\\))[ ,;)]");
    const fs::path root = source_folder;
    for (const auto& entry : fs::recursive_directory_iterator(root / "framework")) {
        if (entry.path().extension() != ".css" || entry.path().filename() == "colors.css") continue;
        const std::string text = read_file(entry.path());
        for (auto match = std::sregex_iterator(text.begin(), text.end(), color); match != std::sregex_iterator();
             ++match)
            ADD_FAILURE() << entry.path() << " names " << (*match)[1];
    }
}

}  // namespace
}  // namespace relief::pages
