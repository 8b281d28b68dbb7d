// The bibliography: its entries, the handouts and slides that print them, and the citations of the whole course.
#include "framework/course/pages/sources.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "framework/core/base/file.h"
#include "framework/core/base/text.h"
#include "framework/staff/slides/deck.h"
#include "tests/support.h"

namespace relief::pages {
namespace {

namespace fs = std::filesystem;

constexpr const char* some = R"(["Bly 1999"]
authors = ["Bly", "Fry", "Guy"]
title = "Splines"
in = "I3D"
doi = "10.1/x"

["Möl 1999"]
authors = ["Möl"]
title = "Normals"
in = "a web page"
)";

std::vector<Source> some_sources() { return parse_sources(some, "s.toml"); }

TEST(Bibliography, ReportsTheLineOfAWrongEntry) {
    const auto complaint = [](const std::string& text) { return message_of([&] { parse_sources(text, "s.toml"); }); };
    const std::string rest = "\ntitle = \"T\"\nin = \"I\"\n";
    EXPECT_TRUE(contains(complaint("[\"Bly 1999\"]\nauthors = [\"Fry\"]" + rest),
                         "s.toml:1: the key 'Bly 1999' is not its first author and a year"));
    EXPECT_TRUE(contains(complaint("[\"Bly 99\"]\nauthors = [\"Bly\"]" + rest), "s.toml:1: "));
    EXPECT_TRUE(contains(complaint("\n[\"Bly 1999\"]" + rest), "s.toml:2: "));
    EXPECT_TRUE(contains(complaint("[\"Bly 1999\"]\nauthors = [\"Bly\"]\ntitel = \"T\""), "title"));
    EXPECT_TRUE(contains(complaint("[\"Bly 1999\"]\nauthors = [\"Bly\"]\nyear = 1999" + rest), "year"));
    EXPECT_TRUE(contains(complaint("a = 1\n"), "s.toml:1: a is no entry"));
    EXPECT_FALSE(complaint("[\"Bly 1999\"\n").empty());
}

TEST(Citations, AreFoundInEachFormOfWriting) {
    const std::vector<Source> sources = some_sources();
    const auto found = [&](const std::string& text) {
        std::string result;
        for (const Citation& one : citations_in(text, sources))
            result +=
                fmt::format("[{}={}]", text.substr(one.begin, one.end - one.begin), one.source ? one.source->key : "");
        return result;
    };
    EXPECT_EQ(found("as Bly 1999 has it"), "[Bly 1999=Bly 1999]");
    EXPECT_EQ(found("(Bly et al. 1999), (Bly and others, 1999)"),
              "[Bly et al. 1999=Bly 1999][Bly and others, 1999=Bly 1999]");
    EXPECT_EQ(found("Bly, Fry and Guy (1999)."), "[Bly, Fry and Guy (1999=Bly 1999]");
    EXPECT_EQ(found("Möl 1999"), "[Möl 1999=Möl 1999]");
    EXPECT_EQ(found("Mol 1999, Guy 1999, Bly 1998"), "[Mol 1999=][Guy 1999=][Bly 1998=]") << "no entry has these";
    EXPECT_EQ(found("Ably 1999"), "[Ably 1999=]") << "a part of a name is no name";
    EXPECT_EQ(found("in 1999, of 2016 triangles, 12019, Bly 19990, x-1999, 1999"), "");
}

TEST(WithSources, PrintsTheEntryOfEachKeyInTheListOfAHandout) {
    EXPECT_EQ(with_sources("- Bly 1999\n\n## Sources\n\nBegin with Möl 1999.\n\n- Bly 1999: why: so\n- Möl 1999\n",
                           some_sources(), "r.md"),
              "- Bly 1999\n\n## Sources\n\nBegin with Möl 1999.\n\n"
              "- Bly, Fry and Guy, \"Splines\", I3D, 1999, [doi:10.1/x](https://doi.org/10.1/x): why: so\n"
              "- Möl, \"Normals\", a web page, 1999\n");
    EXPECT_EQ(message_of([] { with_sources("\n## Sources\n\n- Bly 1989\n", some_sources(), "r.md"); }),
              "r.md:4: labs/sources.toml has no entry 'Bly 1989': did you mean 'Bly 1999'?");
}

TEST(Deck, CitedEntriesBecomeSpeakersNotes) {
    const std::string text =
        slides::read_deck("---\nmarp: true\n---\nA (Mikkelsen 2008)\n\n---\n\nB\n", "d.md", "d", false).text;
    EXPECT_TRUE(contains(text,
                         "A (Mikkelsen 2008)\n\n\n<!-- Sources\nMikkelsen, \"Simulation of wrinkled surfaces "
                         "revisited\", master's thesis, University of Copenhagen, 2008\n-->\n\n---\n"))
        << text;
    EXPECT_EQ(split(text, '<').size(), 2u) << "no note for a slide that cites nothing";
}

TEST(Bibliography, HasWellFormedDistinctDois) {
    std::set<std::string> dois;
    for (const Source& source : load_sources()) {
        if (source.doi.empty()) continue;
        EXPECT_TRUE(std::regex_match(source.doi, std::regex(R"(10\.\d{4,5}/[^\s/]\S*)"))) << source.key;
        EXPECT_TRUE(dois.insert(source.doi).second) << source.key << ": another entry has this DOI";
    }
    EXPECT_GT(dois.size(), 40u);
}

/// Returns the text with the names of the bibliography in ASCII, as shaders have them.
std::string in_ascii(std::string text) {
    for (const std::string& pair : split("áa äa ée èe íi ñn öo üu ßss ćc čc řr šs ŽZ", ' '))  // letters of two bytes
        for (size_t at; (at = text.find(pair.substr(0, 2))) != std::string::npos;) text.replace(at, 2, pair.substr(2));
    return text;
}

/// Returns the text with each line break, and the marks of a comment after it, as one space.
std::string in_one_line(const std::string& text) {
    std::string result;
    for (const std::string& line : split(text, '\n')) {
        size_t begin = std::min(line.size(), line.find_first_not_of(" \t"));
        for (const std::string_view mark : {"///", "//", "#"})
            if (std::string_view(line).substr(begin).starts_with(mark)) {
                begin = std::min(line.size(), line.find_first_not_of(" \t", begin + mark.size()));
                break;
            }
        result += (result.empty() ? "" : " ") + line.substr(begin);
    }
    return result;
}

std::vector<fs::path> files_that_cite() {
    static const std::set<std::string> kinds = {".md",   ".h",    ".cpp",  ".glsl", ".frag",
                                                ".vert", ".tesc", ".tese", ".toml"};
    std::vector<fs::path> files;
    for (const char* folder : {"labs", "shaders", "slides", "framework", "tests"})
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(source_folder) / folder))
            if (kinds.contains(entry.path().extension().string()) && entry.path().stem() != "sources" &&
                entry.path().filename() != "sources_test.cpp")
                files.push_back(entry.path());
    return files;
}

/// Returns the keys of a handout's list of sources.
std::set<std::string> listed_in(const std::string& handout) {
    std::set<std::string> keys;
    for (const std::string& line :
         split(handout.substr(std::min(handout.size(), handout.find("\n## Sources\n"))), '\n'))
        if (line.starts_with("- ")) keys.insert(line.substr(2, line.find(':') - 2));
    return keys;
}

TEST(Bibliography, HasAnEntryForEachCitationAndACitationForEachEntry) {
    const std::set<std::string> no_names = {"RFC", "SIGGRAPH", "Ada"};  // Ada is a GPU
    const std::vector<Source> sources = load_sources();
    std::vector<Source> in_shaders = sources;
    for (Source& source : in_shaders)
        for (std::string& author : source.authors) author = in_ascii(author);
    std::set<std::string> unused;
    for (const Source& source : sources) unused.insert(source.key);
    size_t handouts = 0;
    for (const fs::path& file : files_that_cite()) {
        const std::string raw = read_file(file), text = in_one_line(raw);
        const bool is_handout = file.filename() == "README.md" && contains(raw, "\n## Sources\n");
        const std::set<std::string> listed = is_handout ? listed_in(raw) : std::set<std::string>();
        for (const std::string& key : listed) unused.erase(key);
        if (is_handout) {
            ++handouts;
            EXPECT_FALSE(listed.empty()) << file;
            EXPECT_NO_THROW(with_sources(raw, sources, file)) << file;
        }
        for (const Citation& one : citations_in(text, contains(file.string(), "/shaders/") ? in_shaders : sources)) {
            const std::string words = text.substr(one.begin, one.end - one.begin);
            if (!one.source) {
                EXPECT_TRUE(no_names.contains(words.substr(0, words.find_first_of(" ,"))))
                    << file << ": labs/sources.toml has no entry for '" << words << "'";
                continue;
            }
            unused.erase(one.source->key);
            EXPECT_TRUE(!is_handout || listed.contains(one.source->key)) << file << " does not list " << words;
        }
    }
    EXPECT_EQ(unused, std::set<std::string>()) << "nothing cites these";
    EXPECT_GE(handouts, 19u);
}

}  // namespace
}  // namespace relief::pages
