// Exports against the published rules of their formats, with names and texts that would break them.
#include "framework/staff/class/exports.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "framework/core/base/text.h"
#include "framework/staff/class/csv.h"
#include "tests/support.h"

namespace relief::grade {
namespace {

using nlohmann::json;
using Cells = std::vector<std::string>;

const std::vector<std::string> hostile = {"Doe, \"Jane\"",
                                          "=cmd|'/C calc'!A0",
                                          "two\nlines",
                                          "m\xfcller",
                                          "x;=1+1\t@SUM(A1)",
                                          "\xe2\x80\xae"
                                          "drawkcab",
                                          "</testsuite>",
                                          "]]>&amp;<!--",
                                          "\x01\x1b[31m\xef\xbf\xbf",
                                          "+49 30 1234",
                                          "-1",
                                          "a\rb"};

/// A class of hostile names. Each student has a failed hidden check, a hostile message, an adjustment and a late lab.
struct HostileClass {
    std::vector<SubmissionMark> marks;
    ClassRecord record;

    HostileClass() {
        ClassFile policy;
        const Moment due = parse_moment("2027-03-01T12:00Z", {}, {});
        policy.labs.push_back({.folder = "02_storage",
                               .tasks = {{.id = "2.1", .title = "A & B", .file = "task.glsl", .points = 4}},
                               .due = due,
                               .canvas = "Lab 2 (4711)",
                               .moodle = {}});
        policy.late = {.grace_hours = 0, .percent_per_day = 10, .floor_percent = 0};
        for (size_t i = 0; i < hostile.size(); ++i) {
            SubmissionMark& mark = marks.emplace_back();
            mark.name = hostile[i], mark.seconds = 1.25;
            LabMark lab{.lab = "02_storage"};
            lab.tasks.push_back({.id = "2.1",
                                 .title = "A & B",
                                 .file = "task.glsl",
                                 .of = 4,
                                 .checks = {{.outcome = check::Outcome::passed, .found = "0", .name = "open"},
                                            {.outcome = check::Outcome::wrong,
                                             .found = "secret finding " + hostile[i],
                                             .look_at = "look " + hostile[i],
                                             .name = "secret name",
                                             .hidden = true}},
                                 .mistake = "known",
                                 .hint = hostile[i]});
            mark.labs.push_back(lab);
            const std::string key = printable(hostile[i]), number = std::to_string(i);
            policy.students.push_back({key, hostile[i] == "m\xfcller" ? "M\xc3\xbcller" : hostile[i],
                                       "s" + number + "@x.org", "login" + number, number, "sis" + number,
                                       "Section, 1"});
            policy.adjustments.push_back({key, "2.1", 1, hostile[i], {}});
            policy.hand_ins.push_back({key, "", due + std::chrono::hours(1)});
        }
        policy.students.push_back({"absent", "Not There", "absent@x.org", "away", "99", "sis99", ""});
        record = class_record(marks, policy, {});
    }
};
constexpr double counted = (2 + 1) * 0.9;  // an adjustment, and a day late

/// Parses a file strictly by RFC 4180. Returns its rows, or fails the test.
std::vector<Cells> strict_rows(const std::string& text) {
    std::vector<Cells> rows(1, Cells(1));
    EXPECT_TRUE(text.ends_with('\n'));
    for (size_t i = 0; i + 1 < text.size(); ++i) {
        if (text[i] == '"') {
            EXPECT_EQ(rows.back().back(), "") << "a quote inside of a cell without quotes";
            for (++i; i < text.size() && (text[i] != '"' || text.substr(i + 1, 1) == "\""); ++i)
                rows.back().back() += text[text[i] == '"' ? i++ : i];
            EXPECT_TRUE(i + 1 < text.size() && std::string_view(",\n").find(text[i + 1]) != std::string_view::npos);
        } else if (text[i] == ',')
            rows.back().emplace_back();
        else if (text[i] == '\n')
            rows.emplace_back(1);
        else
            rows.back().back() += text[i];
    }
    for (const Cells& row : rows) EXPECT_EQ(row.size(), rows.front().size());
    return rows;
}

/// Expects that no cell is a formula, for any character at which a spreadsheet splits lines.
void expect_harmless(const std::string& text) {
    for (const char separator : {',', ';', '\t'})
        for (const std::string& line : split(text, '\n'))
            for (const std::string& cell : split(line, separator)) {
                const size_t at = cell.find_first_not_of("\" ");
                if (at == std::string::npos || parse_number(cell)) continue;
                EXPECT_EQ(std::string_view("=+-@").find(cell[at]), std::string_view::npos) << cell;
            }
}

TEST(ResultsCsv, HasIdentifiersMaximaAndNoFormulas) {
    const HostileClass some;
    const std::string text = to_csv(some.record);
    expect_harmless(text);
    const std::vector<Cells> rows = strict_rows(text);
    EXPECT_EQ(rows.at(0),
              (Cells{"submission", "state", "points", "of", "name", "email", "login", "canvas_id", "sis_id", "section",
                     "by the checks", "adjusted by", "late by", "remarks", "lab 02 (of 4)", "2.1 (of 4)"}));
    ASSERT_EQ(rows.size(), hostile.size() + 2);
    EXPECT_EQ(rows[1], (Cells{"Doe, \"Jane\"", "graded", "2.7", "4", "Doe, \"Jane\"", "s0@x.org", "login0", "0", "sis0",
                              "Section, 1", "2", "1", "-0.3",
                              "2.1: +1 point: Doe, \"Jane\"; lab 02: 1 day late, 10 % less", "2.7", "3"}));
    EXPECT_EQ(rows[2][0], "'=cmd|'/C calc'!A0");
    EXPECT_EQ(rows[4][0], "m\\xfcller");
    EXPECT_EQ(rows[6][0], "\\u202edrawkcab");
    EXPECT_EQ(rows.back(), (Cells{"absent", "nothing handed in", "0", "4", "Not There", "absent@x.org", "away", "99",
                                  "sis99", "", "0", "0", "0", "", "0", ""}));
}

// Canvas's importer: "Student" and "ID" come first, and "Section" is the last column of the student. Assignments follow
// as "Title (id)". The row of maxima has "Points Possible" in its first cell. Grades are numbers with a decimal point.
TEST(Canvas, TakesTheGradebook) {
    const HostileClass some;
    const std::string text = to_canvas(some.record);
    expect_harmless(text);
    const std::vector<Cells> rows = strict_rows(text);
    EXPECT_EQ(rows.at(0), (Cells{"Student", "ID", "SIS User ID", "SIS Login ID", "Section", "Lab 2 (4711)"}));
    EXPECT_EQ(rows.at(1), (Cells{"    Points Possible", "", "", "", "", "4"}));
    ASSERT_EQ(rows.size(), hostile.size() + 3);
    std::set<std::string> ids;
    for (size_t i = 2; i < rows.size(); ++i) {
        EXPECT_FALSE(rows[i][0].empty());
        EXPECT_FALSE(contains(rows[i][0], "Points Possible"));
        EXPECT_TRUE(ids.insert(rows[i][1]).second) << rows[i][1];
        const auto grade = parse_number(rows[i][5]);
        EXPECT_TRUE(grade && *grade >= 0 && *grade <= 4) << rows[i][5];
    }
    EXPECT_EQ(rows[2][5], "2.7");
    EXPECT_EQ(rows.back(), (Cells{"Not There", "99", "sis99", "away", "", "0"}));
}

TEST(Canvas, KeepsFractionsOfAPoint) {
    HostileClass some;
    LabRecord& lab = some.record.students[0].labs[0];
    lab.late_share = 1;
    for (const auto& [points, text] : {std::pair(2.3125, "2.3125"), {7.0 / 9 * 3, "2.333333333"}, {0.1 + 0.2, "0.3"}}) {
        lab.tasks[0].adjusted = points;
        EXPECT_EQ(strict_rows(to_canvas(some.record))[2][5], text);
    }
}

// Moodle's importer finds Identifier, Grade and Last modified (grade) by their names. The other columns must not
// change. It skips a grade above the maximum.
TEST(Moodle, TakesItsOwnWorksheetBack) {
    HostileClass some;
    const TemporaryFolder folder;
    const std::string head =
        "Identifier,Full name,Email address,Status,Grade,Maximum Grade,Grade can be changed,Last modified "
        "(submission),Last "
        "modified (grade),Feedback comments\n";
    std::string sheet = "\xef\xbb\xbf" + head;
    sheet +=
        "Participant 11,\"Doe, \"\"Jane\"\"\",S0@X.org,\"Submitted for grading - \",,100.00,Yes,\"Monday, 1 March "
        "2027\",-,\n";
    sheet += "Participant 12,Locked,s1@x.org,No submission,7.00,100.00,No,-,-,before\n";
    sheet += "Participant 13,Not There,absent@x.org,No submission,,100.00,Yes,-,-,\n";
    sheet += "Participant 14,Somebody,other@x.org,No submission,,100.00,Yes,-,-,\n";
    some.record.policy.labs[0].moodle = folder.write("sheet.csv", sheet);
    Cells notes;
    const std::string text = to_moodle(some.record, some.record.policy.labs[0], notes);
    const std::vector<Cells> before = strict_rows(sheet.substr(3)), after = strict_rows(text);
    EXPECT_TRUE(text.starts_with(head)) << "Moodle finds columns by their names";
    ASSERT_EQ(after.size(), before.size());
    for (size_t i = 1; i < after.size(); ++i)
        for (size_t column = 0; column < before[0].size(); ++column)
            if (before[0][column] != "Grade" && before[0][column] != "Feedback comments") {
                EXPECT_EQ(after[i][column], before[i][column]);
            }
    EXPECT_EQ(after[1][4], "67.5") << "2.7 of 4 points, of 100";
    EXPECT_TRUE(contains(after[1][9], "2.7 of 4 points; 2.1: +1 point: Doe, \"Jane\"; lab 02: 1 day late"))
        << after[1][9];
    EXPECT_EQ(after[2], before[2]) << "locked";
    EXPECT_EQ(after[3][4], "0");
    EXPECT_EQ(after[3][9], "0 of 4 points; nothing handed in");
    EXPECT_EQ(after[4], before[4]) << "nobody of the roster";
    EXPECT_EQ(
        notes,
        Cells{"sheet.csv: 1 of 4 rows have no email address, username or ID number of the roster: Participant 14"});
    some.record.policy.labs[0].moodle = folder.write("german.csv", "ID,Bewertung\nTeilnehmer 1,\n");
    EXPECT_TRUE(contains(message_of([&] { to_moodle(some.record, some.record.policy.labs[0], notes); }),
                         "german.csv:1: has no column 'Identifier': download Moodle's grading worksheet again"));
}

bool is_utf8(const std::string& text) {
    try {
        return !json(text).dump().empty();
    } catch (const json::exception&) {
        return false;
    }
}

// PrairieLearn, External grading: the score is in [0, 1], the file has at most 1 MB, and tests have points and
// max_points.
TEST(PrairieLearn, TakesTheResults) {
    const HostileClass some;
    for (const StudentRecord& one : some.record.students) {
        const std::string text = to_prairielearn(one);
        EXPECT_LT(text.size(), 1'000'000u);
        const json result = json::parse(text);
        EXPECT_EQ(result.at("gradable"), true);
        EXPECT_TRUE(result.at("score").is_number());
        EXPECT_NEAR(double(result.at("score")), one.mark ? counted / 4 : 0, 1e-9);
        EXPECT_TRUE(result.at("message").is_string() && result.at("output").is_string());
        for (const json& test : result.at("tests")) {
            for (const char* key : {"name", "message", "output"}) EXPECT_TRUE(test.at(key).is_string()) << key;
            EXPECT_TRUE(test.at("points").is_number() && test.at("max_points").is_number());
            EXPECT_LE(double(test.at("points")), double(test.at("max_points")));
        }
        // Students read the text, so it contains no secret.
        EXPECT_FALSE(contains(text, "secret")) << text;
        EXPECT_EQ(result["tests"].size(), one.mark ? 2u : 0u);
    }
    SubmissionMark unreadable, failed = some.marks[0], large = some.marks[0];
    unreadable.problem = "the archive is damaged";
    EXPECT_EQ(json::parse(to_prairielearn(record_of(unreadable))),
              (json{{"gradable", false}, {"format_errors", {"the archive is damaged"}}}));
    failed.labs[0].tasks[0].checks[0].outcome = check::Outcome::machine;
    const json result = json::parse(to_prairielearn(record_of(failed)));
    EXPECT_EQ(result.at("gradable"), false) << "costs no attempt";
    EXPECT_FALSE(result.contains("score"));
    large.labs[0].tasks[0].checks.resize(
        1000, {.outcome = check::Outcome::wrong, .found = std::string(4000, 'x'), .name = "many"});
    EXPECT_LT(to_prairielearn(record_of(large)).size(), 1'000'000u);
}

/// A submission whose first check fails in its own view, the second in a hidden view, and the third is hidden.
SubmissionMark with_failures() {
    SubmissionMark mark;
    mark.name = "jane";
    LabMark lab{.lab = "02_storage"};
    lab.tasks.push_back(
        {.id = "2.1",
         .title = "A",
         .file = "task.glsl",
         .of = 4,
         .checks = {{.outcome = check::Outcome::wrong, .found = "<b> & more", .name = "own"},
                    {.outcome = check::Outcome::wrong, .found = "0", .view = "a hidden view", .name = "turned"},
                    {.outcome = check::Outcome::wrong, .found = "0", .name = "secret", .hidden = true},
                    {.outcome = check::Outcome::passed, .found = "0", .name = "right"}}});
    mark.labs.push_back(lab);
    return mark;
}

std::vector<ExportPicture> pictures_of_all(size_t bytes) {
    std::vector<ExportPicture> pictures;
    for (const char* check : {"own", "turned", "secret", "right"})
        pictures.push_back({"02_storage", "2.1", check, "yours", "data:image/png;base64," + std::string(bytes, 'A')});
    return pictures;
}

TEST(PrairieLearn, ShowsPicturesOfFailedChecksInViewsThatStudentsKnow) {
    const SubmissionMark mark = with_failures();
    const json tests = json::parse(to_prairielearn(record_of(mark), pictures_of_all(8))).at("tests");
    EXPECT_EQ(tests[0].at("images"), (json{{{"label", "yours"}, {"url", "data:image/png;base64,AAAAAAAA"}}}));
    for (const int hidden_or_right : {1, 2, 3}) EXPECT_FALSE(tests[size_t(hidden_or_right)].contains("images"));
    const std::string large = to_prairielearn(record_of(mark), pictures_of_all(1'000'000));
    EXPECT_LT(large.size(), 1'000'000u);
    EXPECT_TRUE(contains(json::parse(large)["tests"][0].at("output").get<std::string>(), "<b> & more"));
}

TEST(Gradescope, ShowsPicturesOfFailedChecksInViewsThatStudentsKnow) {
    const SubmissionMark mark = with_failures();
    const json tests = json::parse(to_gradescope(record_of(mark), pictures_of_all(8))).at("tests");
    EXPECT_EQ(tests[0].at("output_format"), "html");
    const std::string html = tests[0].at("output");
    EXPECT_TRUE(contains(html, "wrong: &lt;b&gt; &amp; more</pre>")) << html;
    EXPECT_TRUE(contains(html, "<img alt=\"yours\" src=\"data:image/png;base64,AAAAAAAA\">")) << html;
    for (const int hidden_or_right : {1, 2, 3}) {
        EXPECT_EQ(tests[size_t(hidden_or_right)].at("output_format"), "text");
        EXPECT_FALSE(contains(tests[size_t(hidden_or_right)].dump(), "base64"));
    }
}

TEST(Exports, PointsOfTheListedChecksAddUpToTheMark) {
    SubmissionMark mark = with_failures();
    std::vector<check::Verdict>& checks = mark.labs[0].tasks[0].checks;
    checks[0].of_words = checks[3].of_words = true;  // one share of three; one call is wrong, so all of it is lost
    checks[1].outcome = check::Outcome::passed;
    const double points = mark.labs[0].points();
    EXPECT_NEAR(points, 4.0 / 3, 1e-9);
    for (const auto& [text, got, most] : {std::tuple(to_prairielearn(record_of(mark)), "points", "max_points"),
                                          std::tuple(to_gradescope(record_of(mark)), "score", "max_score")}) {
        double sum = 0, all = 0;
        const json tests = json::parse(text).at("tests");
        for (const json& test : tests) sum += test.value(got, 0.0), all += test.value(most, 0.0);
        EXPECT_NEAR(sum, points, 1e-9) << got;
        EXPECT_NEAR(all, 4, 1e-9) << most;
    }
}

// Gradescope, Autograder Specifications.
TEST(Gradescope, TakesTheResultsAsPlainText) {
    const std::set<std::string> top = {"score",         "execution_time",     "output",
                                       "output_format", "test_output_format", "test_name_format",
                                       "visibility",    "stdout_visibility",  "extra_data",
                                       "tests",         "leaderboard"},
                                each = {"score",  "max_score",     "status", "name",       "name_format", "number",
                                        "output", "output_format", "tags",   "visibility", "extra_data"},
                                visibilities = {"hidden", "after_due_date", "after_published", "visible"};
    const HostileClass some;
    for (const StudentRecord& one : some.record.students) {
        const json result = json::parse(to_gradescope(one));
        for (const auto& [key, value] : result.items()) EXPECT_TRUE(top.contains(key)) << key;
        for (const char* key : {"output_format", "test_output_format", "test_name_format"})
            EXPECT_EQ(result.at(key), "text");
        if (!one.mark) {
            EXPECT_FALSE(result.contains("score"));
            continue;
        }
        EXPECT_NEAR(double(result.at("score")), counted, 1e-9);
        EXPECT_TRUE(contains(std::string(result.at("output")), "Gradescope shows no total while a check is hidden"));
        EXPECT_TRUE(contains(std::string(result.at("output")), "lab 02: 1 day late, 10 % less"));
        EXPECT_TRUE(contains(std::string(result.at("output")), "The checks alone gave 2 of 4 points."));
        int hidden = 0;
        for (const json& test : result.at("tests")) {
            for (const auto& [key, value] : test.items()) EXPECT_TRUE(each.contains(key)) << key;
            EXPECT_EQ(test.at("output_format"), "text");
            EXPECT_EQ(test.at("name_format"), "text");
            EXPECT_TRUE(visibilities.contains(test.at("visibility")));
            EXPECT_TRUE(!test.contains("status") || test["status"] == "passed" || test["status"] == "failed");
            EXPECT_TRUE(test.at("tags").is_array());
            hidden += test["visibility"] == "hidden";
            EXPECT_TRUE(test["visibility"] == "hidden" || !contains(test.dump(), "secret")) << test.dump();
        }
        EXPECT_EQ(hidden, 1);
    }
    SubmissionMark open = some.marks[0];
    open.labs[0].tasks[0].checks.pop_back();
    EXPECT_FALSE(contains(to_gradescope(record_of(open)), "hidden"));
}

// ---- JUnit ----

/// An element of XML 1.0, as far as the exports use XML.
struct Element {
    std::string name;
    std::map<std::string, std::string> attributes;
    std::vector<Element> children;

    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const Element& child : children) all.push_back(child.name);
        return all;
    }
};

/// Parses a document or fails the test: one root, attributes in double quotes, properly nested elements, and only the
/// five entities.
class Xml {
public:
    explicit Xml(std::string text) : text_(std::move(text)) {}
    Element root() {
        const std::string head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
        EXPECT_TRUE(text_.starts_with(head) && is_utf8(text_));
        for (const char c : text_) EXPECT_TRUE(static_cast<unsigned char>(c) >= ' ' || c == '\n') << int(c);
        EXPECT_FALSE(contains(text_, "\xef\xbf\xbf"));
        at_ = head.size();
        Element element = next();
        skip_blanks();
        EXPECT_EQ(at_, text_.size()) << "one root";
        return element;
    }

private:
    Element next() {
        skip_blanks();
        Element element;
        expect("<");
        element.name = word();
        while (skip_blanks(), at_ < text_.size() && text_[at_] != '>' && text_[at_] != '/') {
            const std::string key = word();
            expect("=\"");
            const size_t end = std::min(text_.find('"', at_), text_.size());
            EXPECT_TRUE(element.attributes.emplace(key, unescaped(text_.substr(at_, end - at_))).second) << key;
            at_ = end + 1;
        }
        if (text_.compare(at_, 2, "/>") == 0) return at_ += 2, element;
        expect(">");
        while (!failed_ && (skip_blanks(), text_.compare(at_, 2, "</") != 0)) element.children.push_back(next());
        expect("</" + element.name + ">");
        return element;
    }
    static std::string unescaped(const std::string& text) {
        EXPECT_EQ(text.find('<'), std::string::npos);
        for (size_t at = 0; (at = text.find('&', at)) != std::string::npos; ++at) {
            bool known = false;
            for (const char* entity : {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;", "&apos;"})
                known |= text.compare(at, std::string(entity).size(), entity) == 0;
            EXPECT_TRUE(known) << text.substr(at, 9);
        }
        return text;
    }
    std::string word() {
        const size_t begin = at_;
        while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '-')) ++at_;
        return text_.substr(begin, at_ - begin);
    }
    void expect(const std::string& part) {
        if (text_.compare(std::min(at_, text_.size()), part.size(), part) != 0 && !failed_) {
            failed_ = true;
            ADD_FAILURE() << "no " << part << " at " << text_.substr(std::min(at_, text_.size()), 60);
        }
        at_ = failed_ ? text_.size() : at_ + part.size();
    }
    void skip_blanks() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
    }
    std::string text_;
    size_t at_ = 0;
    bool failed_ = false;
};

using Keys = std::set<std::string>;
Keys keys_of(const Element& element) {
    Keys keys;
    for (const auto& [key, value] : element.attributes) keys.insert(key);
    return keys;
}

/// Expects the common parts of both kinds of suite. The counts must agree with the cases.
void expect_cases(const Element& suite, const StudentRecord& one) {
    std::map<std::string, int> found;
    for (const Element& child : suite.children) {
        if (child.name != "testcase") continue;
        ++found["tests"];
        EXPECT_EQ(keys_of(child), (Keys{"name", "classname", "time"}));
        EXPECT_TRUE(parse_number(child.attributes.at("time")));
        EXPECT_LE(child.children.size(), 1u);
        for (const Element& fault : child.children) {
            EXPECT_TRUE(fault.name == "failure" || fault.name == "error");
            ++found[fault.name + "s"];
            EXPECT_EQ(keys_of(fault), (Keys{"type", "message"}));
        }
    }
    for (const char* count : {"tests", "failures", "errors"})
        EXPECT_EQ(suite.attributes.at(count), std::to_string(found[count])) << count;
    EXPECT_EQ(suite.attributes.at("skipped"), "0");
    EXPECT_FALSE(suite.attributes.at("name").empty());
    ASSERT_EQ(suite.children.front().name, "properties");
    for (const Element& property : suite.children.front().children) {
        EXPECT_EQ(property.name, "property");
        EXPECT_EQ(keys_of(property), (Keys{"name", "value"}));
    }
    EXPECT_EQ(found["tests"], one.mark ? 2 : 1);
}

// Ant's schema (windyroad/JUnit-Schema): testsuites has no attribute. A suite has all of these attributes, and these
// children in this order. Jenkins' schema (junit-10.xsd) allows all of this.
TEST(JUnit, IsReadByAntAndJenkins) {
    const HostileClass some;
    const Element root = Xml(to_junit(some.record, parse_moment("2027-03-01T12:34:56Z", {}, {}))).root();
    EXPECT_EQ(root.name, "testsuites");
    EXPECT_EQ(keys_of(root), Keys{});
    ASSERT_EQ(root.children.size(), hostile.size() + 1);
    for (size_t i = 0; i < root.children.size(); ++i) {
        const Element& suite = root.children[i];
        EXPECT_EQ(keys_of(suite), (Keys{"name", "package", "id", "timestamp", "hostname", "tests", "failures", "errors",
                                        "skipped", "time"}));
        EXPECT_EQ(suite.attributes.at("id"), std::to_string(i));
        EXPECT_EQ(suite.attributes.at("timestamp"), "2027-03-01T12:34:00") << "without a zone";
        std::vector<std::string> order = suite.names();
        order.erase(std::remove(order.begin(), order.end(), "testcase"), order.end());
        EXPECT_EQ(order, (Cells{"properties", "system-out", "system-err"}));
        EXPECT_EQ(suite.names()[1], "testcase");
        expect_cases(suite, some.record.students[i]);
    }
    EXPECT_EQ(root.children[0].attributes.at("failures"), "1");
}

// surefire-test-report.xsd: the root is a suite with exactly these attributes. Times have at most three decimals.
TEST(JUnit, MatchesTheSurefireSchema) {
    const HostileClass some;
    for (const StudentRecord& one : some.record.students) {
        const Element suite = Xml(to_surefire(one)).root();
        EXPECT_EQ(suite.name, "testsuite");
        EXPECT_EQ(keys_of(suite), (Keys{"name", "time", "tests", "errors", "skipped", "failures"}));
        const std::string& time = suite.attributes.at("time");
        EXPECT_LE(time.size() - time.find('.'), 4u);
        for (const std::string& name : suite.names()) EXPECT_TRUE(name == "properties" || name == "testcase") << name;
        expect_cases(suite, one);
    }
}

TEST(Table, ShowsOneMaximumForAllAndEachChange) {
    const HostileClass some;
    const std::vector<std::string> lines = split(to_table(some.record), '\n');
    EXPECT_TRUE(contains(lines.at(1), "2.7/4")) << lines[1];
    EXPECT_TRUE(contains(lines.at(1), "adjusted by 1  late: 0.3 less")) << lines[1];
    // The points of 2.7/4 and 0/4 stand below each other, and so do the words behind them.
    const std::string& last = lines.at(hostile.size() + 1);
    EXPECT_TRUE(contains(last, "0/4    nothing handed in")) << last;
    EXPECT_EQ(last.rfind("0/4"), lines[1].rfind("2.7/4")) << last << "\n" << lines[1];
}

}  // namespace
}  // namespace relief::grade
