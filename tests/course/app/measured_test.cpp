// Measures again each number that a handout or a deck declares as measured. Below the text stands a block:
//
//     ```measured
//     shot 18 --set view=skin --set shape=tube --size 512x512 --error normal
//     2.2 11 7.9 48  mean largest  --set normal_by=matrix --set bend={30|90}
//     2.1 11 6.1 48  mean largest  --set normal_by=inverse-transpose --set bend={30|90}
//     13 0.5 0.02  wrong %  bench parallax map=bricks angle=15-65 {usual|linear steps=32|linear steps=64}
//     0.170 0.386  test NormalFormat.HasTheErrorPublishedByCigolleEtAl
//     ```
//
// Each line has three parts. First come the numbers as written in the text. Then come the names of the error's figures,
// with a unit if it differs from the command's. The rest is the source, once for each of the words in braces. A source
// is a command of `relief`, or a row of the benchmark that all these words name, or a test that contains the number.
// Rows come from the baseline that the test `baseline` checks.
//
// A line without numbers is the common beginning of the sources of the lines below it. A line that begins with a blank
// continues the previous line.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "framework/core/base/file.h"
#include "framework/core/base/parallel.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/core/image/file.h"
#include "framework/staff/class/csv.h"
#include "framework/staff/measure/drawn_subject.h"
#include "tests/process.h"
#include "tests/support.h"

namespace relief::app {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;
using Measured = std::map<std::string, double>;  ///< by name: mean, largest

Words words_of(const std::string& text) {
    Words words = split(text, ' ');
    std::erase(words, "");
    return words;
}

/// Expands "a {b|c} {d|e}" to "a b d", "a b e", "a c d", "a c e".
Words each_of(const std::string& text) {
    const size_t open = text.find('{'), close = text.find('}', open);
    if (close == text.npos) return {text};
    Words all;
    for (const std::string& one : split(text.substr(open + 1, close - open - 1), '|'))
        for (const std::string& whole : each_of(text.substr(0, open) + one + text.substr(close + 1)))
            all.push_back(whole);
    return all;
}

/// A number of a text and its source.
struct Claim {
    std::string place;   ///< "labs/01_specular_highlights/README.md:48"
    std::string number;  ///< as written
    std::string what, unit, source;
};

/// The claims of one text. `faults` has a line for each unreadable block, and for each number that is missing from the
/// text above its block.
struct Claims {
    std::vector<Claim> claims;
    Words faults;
};

/// Returns whether `text` contains the number, and not as a part of a longer one.
bool has_number(const std::string& text, const std::string& number) {
    const auto is_digit = [&](size_t at) {
        return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at]));
    };
    const auto is_point = [&](size_t at) { return at < text.size() && (text[at] == '.' || text[at] == ','); };
    for (size_t at = text.find(number); at != text.npos; at = text.find(number, at + 1)) {
        const size_t end = at + number.size();
        const bool begins = at == 0 || (!is_digit(at - 1) && !(is_point(at - 1) && at > 1 && is_digit(at - 2)));
        if (begins && !is_digit(end) && !(is_point(end) && is_digit(end + 1))) return true;
    }
    return false;
}

bool is_number(const std::string& word) {
    return word.find_first_not_of("0123456789.,", word[0] == '<') == word.npos && word != "<";
}
bool is_name(const std::string& word) {
    static const Words names = {"mean", "p99", "largest", "wrong", "triangles", "taps"};
    return std::find(names.begin(), names.end(), word) != names.end();
}
bool is_unit(const std::string& word) { return word == "mm" || word == "%"; }
bool is_source(const std::string& word) { return word == "shot" || word == "bench" || word == "test"; }

/// Removes and returns the leading words for which `is_one` is true.
Words taken(Words& words, bool (*is_one)(const std::string&)) {
    const auto end = std::find_if_not(words.begin(), words.end(), is_one);
    const Words first(words.begin(), end);
    words.erase(words.begin(), end);
    return first;
}

/// Reads one line of a block. `above` is the text that must contain its numbers; `common` is the common beginning of
/// sources.
void read_line(const std::string& line, const std::string& place, const std::string& above, std::string& common,
               Claims& all) {
    Words words = words_of(line);
    const Words numbers = taken(words, is_number), names = taken(words, is_name), units = taken(words, is_unit);
    if (words.empty() || !is_source(words[0])) words.insert(words.begin(), common);
    const std::string source = join(words, " ");
    if (!is_source(words_of(source + " ?")[0]) || units.size() > 1)
        return all.faults.push_back(place + ": not numbers, what they are, and what measures them: " + line);
    if (numbers.empty()) return void(common = source);
    const Words sources = each_of(source);
    const size_t each = std::max<size_t>(1, names.size());
    if (!names.empty() && numbers.size() != each * sources.size())
        return all.faults.push_back(
            fmt::format("{}: {} numbers of {} measurements", place, numbers.size(), each * sources.size()));
    for (size_t i = 0; i < numbers.size(); ++i) {
        const std::string written = numbers[i].substr(numbers[i][0] == '<');
        if (!has_number(above, written)) all.faults.push_back(place + ": the text above does not have " + written);
        all.claims.push_back({place, numbers[i], names.empty() ? "" : names[i % each], units.empty() ? "" : units[0],
                              sources[names.empty() ? 0 : i / each]});
    }
}

void read_text(const std::string& text, const std::string& name, Claims& all) {
    const Words lines = split(text, '\n');
    std::string above;
    for (size_t i = 0; i < lines.size(); ++i) {
        if (lines[i] != "```measured") {
            above += lines[i] + '\n';
            continue;
        }
        std::string common;
        for (++i; i < lines.size() && lines[i] != "```";) {
            const std::string place = fmt::format("{}:{}", name, i + 1);
            std::string line = lines[i++];
            while (i < lines.size() && lines[i].starts_with(" ")) line += lines[i++];
            read_line(line, place, above, common, all);
        }
        above.clear();
    }
}

/// Returns half a unit of the last written digit, plus a little for another Mesa version. In an integer of more than
/// three digits, trailing zeros do not count as digits.
double tolerance(std::string number) {
    std::erase(number, ',');
    const size_t point = number.find('.');
    if (point != number.npos) return 0.55 * std::pow(10, -double(number.size() - point - 1));
    const size_t digits = std::max<size_t>(3, number.find_last_not_of('0') + 1);
    return number == "0" ? 0.00055 : 0.55 * std::pow(10, double(number.size() - std::min(digits, number.size())));
}

bool agrees(const std::string& number, double measured) {
    std::string digits = number.substr(number[0] == '<');
    std::erase(digits, ',');
    const double written = parse_number(digits).value();
    return number[0] == '<' ? measured < written : std::abs(measured - written) <= tolerance(digits);
}

/// Returns the figures of the error that `relief shot ... --error ...` draws.
Measured measured_by_shot(const std::string& command) {
    const TemporaryFolder folder;
    const fs::path picture = folder.path() / "error.pfm";
    Words words = words_of(command);
    words.insert(words.begin(), relief_program());
    words.insert(words.end(), {"-o", picture.string()});
    const Result result = run(words);
    if (result.code != 0) throw Error(command + ": " + result.err);
    const measure::BenchError error = measure::error_over(read_image(picture), "");
    return {{"mean", error.mean}, {"p99", error.p99}, {"largest", error.largest}, {"wrong", error.wrong.value()}};
}

/// Returns the figures of the baseline's row with all these words: first the topic, then words of its scene, method and
/// knobs. Of several, that without other words.
Measured measured_by_bench(const std::string& command) {
    static const grade::CsvTable table = grade::read_csv(course_root() / "tests/staff/measure/baseline.csv");
    const Words wanted = words_of(command);
    const grade::CsvRow *found = nullptr, *others = nullptr;
    for (const grade::CsvRow& row : table.rows) {
        Words has = {"bench", table.cell(row, "topic")};
        for (const char* column : {"scene", "method", "knobs"})
            for (const std::string& word : words_of(table.cell(row, column))) has.push_back(word);
        if (!std::all_of(wanted.begin(), wanted.end(),
                         [&](const std::string& word) { return std::find(has.begin(), has.end(), word) != has.end(); }))
            continue;
        if (has.size() == wanted.size()) {  // the row has no other words: exactly the one that is meant
            found = &row, others = nullptr;
            break;
        }
        (found ? others : found) = &row;
    }
    if (!found) throw Error(command + ": no such row in the baseline");
    if (others) throw Error(fmt::format("{}: lines {} and {} of the baseline", command, found->line, others->line));
    Measured values;
    for (const auto& [name, column] : {std::pair("mean", "error_mean"),
                                       {"p99", "error_p99"},
                                       {"largest", "error_largest"},
                                       {"wrong", "error_wrong"}})
        if (const auto value = parse_number(table.cell(*found, column))) values[name] = *value;
    for (const std::string& word : words_of(table.cell(*found, "work")))
        if (const Words parts = split(word, '='); parts.size() == 2)
            values[parts[0]] = parse_number(parts[1]).value_or(NAN);
    return values;
}

/// Returns the text of all test files, concatenated.
const std::string& all_tests() {
    static const std::string text = [] {
        std::string all;
        for (const auto& entry : fs::recursive_directory_iterator(course_root() / "tests"))
            if (entry.path().extension() == ".cpp") all += read_file(entry.path());
        return all;
    }();
    return text;
}

/// "test Suite.Name": returns whether that test contains a number that rounds to this one.
bool is_in_test(const std::string& number, const std::string& source) {
    const Words name = split(words_of(source).at(1), '.');
    std::smatch begin;
    const std::string& all = all_tests();
    if (name.size() != 2 ||
        !std::regex_search(all, begin, std::regex("TEST(_F|_P)?\\(" + name[0] + ", *" + name[1] + "\\)")))
        throw Error("no " + source);
    const size_t from = size_t(begin.position());
    const std::string body = all.substr(from, all.find("\n}\n", from) - from);
    static const std::regex literal(R"([0-9]*\.?[0-9]+(e-?[0-9]+)?)");
    for (auto at = std::sregex_iterator(body.begin(), body.end(), literal); at != std::sregex_iterator(); ++at)
        if (agrees(number, std::stod(at->str()))) return true;
    return false;
}

/// The result of a measured shot, or the reason for its failure.
struct Shown {
    Measured measured;
    std::string failure;
};

/// Returns why a claim is false, or "".
std::string fault_of(const Claim& claim, const std::map<std::string, Shown>& shots) {
    if (claim.source.starts_with("test "))
        return is_in_test(claim.number, claim.source) ? "" : claim.number + " is not in " + claim.source;
    const bool is_shot = claim.source.starts_with("shot ");
    if (is_shot && !shots.at(claim.source).failure.empty()) return shots.at(claim.source).failure;
    const Measured of = is_shot ? shots.at(claim.source).measured : measured_by_bench(claim.source);
    const auto value = of.find(claim.what);
    if (value == of.end()) return fmt::format("no {} is measured by {}", claim.what, claim.source);
    const double measured = value->second * (claim.unit == "mm" ? 1000 : claim.unit == "%" ? 100 : 1);
    if (agrees(claim.number, measured)) return "";
    return fmt::format("{}, but {:.6g} is measured by {}", claim.number, measured, claim.source);
}

/// Returns a line for each claim that is false or cannot be measured. Draws shots in parallel.
Words faults_of(const Claims& all) {
    std::map<std::string, Shown> shots;
    for (const Claim& claim : all.claims)
        if (claim.source.starts_with("shot ")) shots[claim.source];
    std::vector<std::pair<const std::string, Shown>*> each;
    for (auto& shot : shots) each.push_back(&shot);
    parallel_each(each.size(), 0, [&](size_t i) {
        try {
            each[i]->second.measured = measured_by_shot(each[i]->first);
        } catch (const Error& error) {
            each[i]->second.failure = error.what();
        }
    });
    Words lines = all.faults;
    for (const Claim& claim : all.claims) try {
            if (const std::string fault = fault_of(claim, shots); !fault.empty())
                lines.push_back(claim.place + ": " + fault);
        } catch (const Error& error) {
            lines.push_back(claim.place + ": " + error.what());
        }
    return lines;
}

std::vector<fs::path> handouts_and_decks() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(course_root() / "labs"))
        if (fs::exists(entry.path() / "README.md") && fs::exists(entry.path() / "lab.toml"))
            files.push_back(entry.path() / "README.md");
    for (const auto& entry : fs::directory_iterator(course_root() / "slides"))
        if (entry.path().extension() == ".md") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

Words faults_in(const std::string& text, const std::string& line) {
    Claims all;
    read_text(text + "\n```measured\n" + line + "\n```\n", "t", all);
    return faults_of(all);
}

TEST(Measured, AClaimPairsNumbersOfTheTextWithTheirMeasurement) {
    Claims all;
    read_text("2.5 and 3\n```measured\n2.5 3  mean mm  shot 01\n  --set a={b|c}\n```\n", "t", all);
    EXPECT_EQ(all.faults, Words{});
    ASSERT_EQ(all.claims.size(), 2u);
    EXPECT_EQ(all.claims[1].place, "t:3");
    EXPECT_EQ(all.claims[1].number, "3");
    EXPECT_EQ(all.claims[1].unit, "mm");
    EXPECT_EQ(all.claims[1].source, "shot 01 --set a=c");
    read_text("1 2 3 4\n```measured\nshot 01\n1 2 3 4  mean largest  {a|b}\n```\n", "t", all);
    ASSERT_EQ(all.claims.size(), 6u);
    EXPECT_EQ(all.claims[3].what + " " + all.claims[3].source, "largest shot 01 a");
    EXPECT_EQ(all.claims[4].what + " " + all.claims[4].source, "mean shot 01 b");
    const std::string bench = "bench storage do=encode oct8";
    EXPECT_EQ(faults_in("0.34 and 10", "0.34  mean  " + bench), Words{});
    EXPECT_EQ(faults_in("10.34 and 0.345", "0.34  mean  " + bench), Words{"t:3: the text above does not have 0.34"});
    EXPECT_EQ(faults_in("2.5", "2.5  " + bench), Words{"t:3: no  is measured by " + bench});
    EXPECT_EQ(faults_in("2.5", "2.5  mean"),
              Words{"t:3: not numbers, what they are, and what measures them: 2.5  mean"});
    EXPECT_EQ(faults_in("1 2 3", "1 2 3  mean  shot {1|2}"), Words{"t:3: 3 numbers of 2 measurements"});
}

TEST(Measured, ANumberIsRightToItsLastDigit) {
    EXPECT_TRUE(agrees("5.5", 5.52) && agrees("5.5", 5.451) && agrees("11", 11.19) && agrees("21,900", 21889));
    EXPECT_FALSE(agrees("5.5", 5.56) || agrees("11", 11.6) || agrees("21,900", 21801) || agrees("0.10", 0.106));
    EXPECT_TRUE(agrees("0", 6e-6) && agrees("<0.01", 0.005));
    EXPECT_FALSE(agrees("0", 0.3) || agrees("<0.01", 0.01));
}

TEST(Measured, AFalseClaimIsReportedWithItsLine) {
    const std::string shot = "shot 02 --set view=one --size 32x32 --error normal";
    const Words wrong = faults_in("99", "99  mean  " + shot);
    ASSERT_EQ(wrong.size(), 1u);
    EXPECT_TRUE(wrong[0].starts_with("t:3: 99, but 0.1") && wrong[0].ends_with("is measured by " + shot)) << wrong[0];
    const std::string bench = "bench storage do=encode oct8", test = "test Measured.ANumberIsRightToItsLastDigit";
    EXPECT_EQ(faults_in("99", "99  mean  " + bench), Words{"t:3: 99, but 0.338272 is measured by " + bench});
    EXPECT_EQ(faults_in("99", "99  " + test), Words{"t:3: 99 is not in " + test});
    EXPECT_EQ(faults_in("5.52", "5.52  " + test), Words{});
    EXPECT_EQ(faults_in("1", "1  test No.Such"), Words{"t:3: no test No.Such"});
}

TEST(Measured, OfSeveralRowsOnlyTheOneWithoutOtherWordsIsMeant) {
    const double mean = measured_by_bench("bench terminator slope=1 elevation=5 usual").at("mean"),
                 by_place = measured_by_bench("bench terminator elevation=5 error=by-place usual").at("mean");
    EXPECT_GT(by_place, 1.5 * mean);
    EXPECT_THROW(measured_by_bench("bench terminator elevation=5 usual"), Error);
    EXPECT_THROW(measured_by_bench("bench terminator elevation=6 usual"), Error);
}

TEST(Measured, NumbersInHandoutsAndDecksMatchTheMeasurements) {
    Claims all;
    for (const fs::path& file : handouts_and_decks())
        read_text(read_file(file), file.lexically_relative(course_root()).string(), all);
    EXPECT_GT(all.claims.size(), 450u) << "are the blocks read?";
    // Draws a sample of the shots. `relief test --all` draws all of them.
    std::set<std::string> shots;
    for (const Claim& claim : all.claims)
        if (claim.source.starts_with("shot ")) shots.insert(claim.source);
    const Words drawn = sample_of(Words(shots.begin(), shots.end()), 36);
    std::erase_if(all.claims, [&](const Claim& claim) {
        return shots.contains(claim.source) && !std::ranges::binary_search(drawn, claim.source);
    });
    for (const std::string& line : faults_of(all)) ADD_FAILURE() << line;
}

}  // namespace
}  // namespace relief::app
