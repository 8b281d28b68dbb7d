// The policy of a class: rosters and spreadsheets, times, class files, adjustments, and the record of students.
#include "framework/staff/class/class_file.h"

#include "framework/core/base/file.h"
#include "framework/core/base/text.h"
#include "framework/core/lab/lab.h"
#include "framework/staff/class/csv.h"
#include "framework/staff/class/exports.h"
#include "framework/staff/class/hand_in_log.h"
#include "framework/staff/class/record.h"
#include "tests/support.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;
using Cells = std::vector<std::string>;

const LabRegistration thirteen("13_displacement", nullptr), fourteen("14_adaptive_displacement", nullptr);
const std::string lab_14 = "14_adaptive_displacement";
constexpr int points_of_13 = 13, points_of_14 = 15;  // labs/*/lab.toml, without optional tasks

// ---- tables ----

std::vector<Cells> rows_of(const std::string& text) {
    std::vector<Cells> rows;
    const CsvTable table = parse_csv(text, "table.csv");
    for (const CsvRow& row : table.rows) rows.push_back(row.cells);
    return rows;
}

TEST(Csv, IsReadInTheDialectsOfSpreadsheets) {
    const std::vector<Cells> expected = {{"Doe, Jane", "1"}, {"a \"b\"\nc", ""}};
    EXPECT_EQ(rows_of("name,n\n\"Doe, Jane\",1\n\"a \"\"b\"\"\nc\",\n"), expected);
    EXPECT_EQ(rows_of("\xef\xbb\xbfname;n\r\nDoe, Jane;1\r\n\r\n;;\r\n\"a \"\"b\"\"\nc\"\r\n"), expected);
    EXPECT_EQ(rows_of("name\tn\nDoe, Jane\t 1 \n  \"a \"\"b\"\"\nc\"  \t"), expected);
    const TemporaryFolder folder;
    const CsvTable table = read_csv(folder.write("lines.csv", "a,b\n\"x\n\ny\",1\n\nz,2\n"));
    EXPECT_EQ(table.rows[0].line, 2);
    EXPECT_EQ(table.rows[1].line, 6) << "lines inside of quotes and empty ones count";
}

TEST(Csv, InvalidTextIsRefusedWithItsLine) {
    const std::pair<const char*, const char*> cases[] = {
        {"", "csv:1: is empty"},
        {"a,b\n1,2\n1,2,3\n", "csv:3: has 3 cells"},
        {"a,b\n1,\"2\n", "csv:2: a quoted cell has no end"},
        {"a,b\n\"1\"x,2\n", "csv:2: text follows a quoted cell"},
        {"a,a\n", "csv:1: has the column 'a' twice"},
        {"name\nM\xfcller\n", "csv: is not UTF-8"},
        {"\xff\xfen\0a\0", "csv: is not UTF-8"},
    };
    for (const auto& [text, message] : cases) {
        const std::string said = message_of([&] { rows_of(text); });
        EXPECT_TRUE(contains(said, message)) << said << " instead of " << message;
    }
}

/// Returns whether some program finds a cell that begins like a formula, for any separator that it may split at.
bool has_formula(const std::string& text) {
    bool begins = true;
    for (const char c : text) {
        if (begins && std::string_view("=+-@").find(c) != std::string_view::npos) return true;
        if (std::string_view(",;\t\n\r").find(c) != std::string_view::npos)
            begins = true;
        else if (c != ' ' && c != '"')
            begins = false;
    }
    return false;
}

TEST(Csv, ContainsNoFormulaForAnyDelimiter) {
    const std::pair<const char*, const char*> cases[] = {{"=cmd|'/C calc'!A0", "'=cmd|'/C calc'!A0"},
                                                         {"a;=1+1", "a;'=1+1"},
                                                         {"a,@x", "a,'@x"},
                                                         {"a\t+1", "a\t'+1"},
                                                         {"a\n-1", "a\n'-1"},
                                                         {"a;\" =1", "a;\" '=1"},
                                                         {"\xef\xbc\x9d"
                                                          "1",
                                                          "'\xef\xbc\x9d"
                                                          "1"},
                                                         {"a=1", "a=1"},
                                                         {"jane-doe@x.org", "jane-doe@x.org"},
                                                         {"O'Neill", "O'Neill"},
                                                         {"", ""}};
    for (const auto& [text, safe] : cases) EXPECT_EQ(defused(text), safe);
    // Every text is read back unchanged except for the apostrophes.
    unsigned state = 7;
    for (int i = 0; i < 2000; ++i) {
        std::string text = "x";
        for (int k = 0; k < 12; ++k) {
            state = state * 1664525u + 1013904223u;
            text += "=+-@,;\t\"' \na"[(state >> 24) % 12];
        }
        text += "x";
        const std::string safe = defused(text.substr(1));
        EXPECT_FALSE(has_formula(safe)) << safe;
        EXPECT_EQ(rows_of("n,text\n" + csv_line(Cells{"1", text}))[0][1], text) << "quoted wrongly";
    }
}

// ---- times ----

TEST(Moments, AreReadWithTheirOffset) {
    const auto seconds = [](const char* text, std::optional<UtcOffset> offset = {}) {
        return parse_moment(text, offset, {}).time_since_epoch().count();
    };
    // date -u -d 2027-03-01T22:59:00Z +%s
    EXPECT_EQ(seconds("2027-03-01T22:59:00Z"), 1803941940);
    for (const char* same : {"2027-03-01T23:59:00+01:00", "2027-03-01 23:59 +0100", "2027-03-01 17:59:00.75 -0500"})
        EXPECT_EQ(seconds(same), 1803941940) << same;
    EXPECT_EQ(seconds("2027-03-01T23:59", UtcOffset(60)), 1803941940);
    EXPECT_EQ(seconds("2027-03-01", UtcOffset(60)), 1803941940 + 59) << "a date is its last second";
    EXPECT_EQ(moment_text(parse_moment("2027-03-01T23:59+01:00", {}, {}), UtcOffset(-330)), "2027-03-01 17:29 -05:30");
    for (const char* wrong : {"2027-02-29", "2027-13-01", "2027-03-01T24:00Z", "2027-03-01T23:60Z", "1.3.2027", "",
                              "2027-03-01T23:59+1", "2027-03-01T23:59Zx", "2027-03-01X23:59Z", "yesterday"})
        EXPECT_TRUE(contains(message_of([&] { parse_moment(wrong, UtcOffset(0), {"f", 3}); }), "f:3: ")) << wrong;
    EXPECT_TRUE(contains(message_of([] { parse_moment("2027-03-01T23:59", {}, {"f", 3}); }), "has no offset"));
}

TEST(Lateness, CountsStartedDaysSinceTheDueDateOnceTheGraceIsOver) {
    const Moment due = parse_moment("2027-03-01T12:00Z", {}, {});
    const auto days = [&](int hours, double grace) { return days_late(due, due + std::chrono::hours(hours), grace); };
    EXPECT_EQ(days(-1, 0), 0);
    EXPECT_EQ(days(0, 0), 0);
    EXPECT_EQ(days(1, 0), 1);
    EXPECT_EQ(days(24, 0), 1);
    EXPECT_EQ(days(25, 0), 2);
    EXPECT_EQ(days(2, 2), 0);
    EXPECT_EQ(days(3, 2), 1);
    EXPECT_EQ(days(25, 2), 2) << "grace is no extension";
    const LateRule rule{.grace_hours = 0, .percent_per_day = 15, .floor_percent = 50};
    EXPECT_DOUBLE_EQ(late_share(0, rule), 1);
    EXPECT_DOUBLE_EQ(late_share(2, rule), 0.7);
    EXPECT_DOUBLE_EQ(late_share(9, rule), 0.5);
    EXPECT_DOUBLE_EQ(late_share(11, {.percent_per_day = 10}), 0) << "never below nothing";
}

// ---- class files ----

class ClassFiles : public testing::Test {
protected:
    ClassFile read(const std::string& text) {
        return read_class_file(folder.write("class.toml", text), folder.path() / "marks");
    }
    std::string refused(const std::string& text) {
        return message_of([&] { read(text); });
    }
    TemporaryFolder folder;
};

TEST_F(ClassFiles, TheExampleOfTheGuideIsValid) {
    const std::string guide = read_file(fs::path(source_folder) / "labs/staff/README.md");
    const auto block = [&](const std::string& kind) {
        const std::string begin = "```" + kind + "\n";
        const size_t at = guide.find(begin);
        EXPECT_NE(at, std::string::npos) << kind;
        return guide.substr(at + begin.size(), guide.find("```", at + 3) - at - begin.size());
    };
    folder.write("roster.csv", block("csv roster.csv"));
    folder.write("hand_ins.csv", block("csv hand_ins.csv"));
    folder.write("worksheet-14.csv", "Identifier,Grade,Last modified (grade)\n");
    folder.write("marks/adjustments.csv", block("csv adjustments.csv"));
    const ClassFile policy = read(block("toml"));
    ASSERT_EQ(policy.labs.size(), 2u);
    EXPECT_EQ(policy.labs[0].folder, "13_displacement");
    EXPECT_TRUE(policy.labs[0].due && policy.labs[1].due);
    EXPECT_EQ(policy.students.size(), 3u);
    EXPECT_EQ(policy.extensions.size(), 1u);
    EXPECT_GT(policy.hand_ins.size(), 0u);
    EXPECT_EQ(policy.adjustments.size(), 1u);
    EXPECT_EQ(policy.late.percent_per_day, 10);
    // The example has every key. Readers would have to guess a key that the guide omits.
    for (const char* key :
         {"utc_offset",    "roster",    "hand_ins",          "adjustments", "[[assigned]]", "due",
          "canvas",        "moodle",    "optional",          "[late]",      "grace_hours",  "percent_per_day",
          "floor_percent", "bank_days", "bank_days_per_lab", "[attempts]",  "per_day",      "[[extension]]",
          "days",          "note",      "[[student]]"})
        EXPECT_TRUE(contains(block("toml"), key)) << key;
}

const std::string some_labs = "utc_offset = \"+01:00\"\n[[assigned]]\nlab = 13\ndue = 2027-03-01T23:59:00\n";
const std::string some_students = some_labs + "[[student]]\nstudent = \"jane\"\n[[student]]\nstudent = \"joe\"\n";

TEST_F(ClassFiles, ErrorsAreOneLineWithTheirPlace) {
    folder.write("twice.csv", "student,email\njane,j@x.org\njoe,j@x.org\n");
    folder.write("formula.csv", "student,login\njane,=1+1\n");
    folder.write("one.csv", "student\njane\n");
    folder.write("other.csv", "student,nmae\njane,Jane\n");
    folder.write("nameless.csv", "name\nJane\n");
    folder.write("nobody.csv", "student,name\n");
    folder.write("times.csv", "student,lab,handed_in\njane,13,2027-03-01T12:00Z\njane,13,2027-03-02T12:00Z\n");
    folder.write("date.csv", "student,handed_in\njane,2027-03-01\n");
    folder.write("stranger.csv", "student,handed_in\njane,2027-03-01T12:00Z\njim,2027-03-01T12:00Z\n");
    folder.write("lab.csv", "student,lab,handed_in\njane,14,2027-03-01T12:00Z\n");
    const std::pair<std::string, const char*> cases[] = {
        {"labs = [13]\n" + some_labs, "class.toml:1: unknown key of a class file, 'labs'"},
        {"", "must name the labs that count"},
        {"[[assigned]]\nlab = 13\n[[assigned]]\nlab = \"displacement\"\n", "class.toml:4: "},
        {"[[assigned]]\nlab = 99\n", "class.toml:2: "},
        {"[[assigned]]\nlab = 13\n[[assigned]]\nlab = \"13\"\n", "class.toml:4: lab 13 is assigned twice"},
        {"[[assigned]]\nlab = 13\ndue = 2027-02-30T23:59:00+01:00\n", "class.toml:3: "},
        {"[[assigned]]\nlab = 13\ndue = 2027-03-01 23:59\n",
         "class.toml:3: Error while parsing time: expected ':', saw '\\n'; a date is 2027-03-01, one with a time"},
        {"[[assigned]]\nlab = 13\ndue = 2027-3-1\n", "; a date is 2027-03-01, one with a time 2027-03-01T23:59:00"},
        {"[[assigned]]\nlab = 13\ndue = \"Monday\"\n", "class.toml:3: 'due' must be a date without quotes"},
        {"[[assigned]]\nlab = 13\ndue = 2027-02-20T23:59:00\n", "class.toml:3: '2027-02-20T23:59:00' has no offset"},
        {"utc_offset = \"CET\"\n[[assigned]]\nlab = 13\n", "class.toml:1: 'CET' is no offset"},
        {some_labs + "duee = 3\n", "class.toml:5: unknown key of [[assigned]], 'duee': did you mean 'due'?"},
        {"roster = \"none.csv\"\n" + some_labs, "class.toml:1: there is no file"},
        {"roster = \"twice.csv\"\n" + some_labs, "twice.csv:3: email 'j@x.org' is there twice: also in line 2"},
        {"roster = \"formula.csv\"\n" + some_labs, "formula.csv:2: login '=1+1' would be a formula"},
        {"roster = \"other.csv\"\n" + some_labs, "other.csv:1: unknown column 'nmae': did you mean 'name'?"},
        {"roster = \"nobody.csv\"\n" + some_labs, "nobody.csv: names no student"},
        {"roster = \"nameless.csv\"\n" + some_labs, "nameless.csv:1: needs a column 'student'"},
        {some_students + "[[student]]\nstudent = \"joe\"\n",
         "class.toml:10: student 'joe' is there twice: also in line 8"},
        {"roster = \"one.csv\"\n" + some_students,
         "class.toml:7: student 'jane' is there twice: also in line 2 of one.csv"},
        {some_labs + "[late]\npercent_per_day = 10\n", "class.toml:5: [late] needs hand_ins"},
        {"hand_ins = \"times.csv\"\n" + some_labs, "times.csv:3: 'jane' has two times for lab 13: also in line 2"},
        {"hand_ins = \"date.csv\"\n" + some_labs, "date.csv:2: '2027-03-01' is no time"},
        {"hand_ins = \"stranger.csv\"\n" + some_students, "stranger.csv:3: 'jim' is not on the roster"},
        {"hand_ins = \"lab.csv\"\n" + some_labs, "lab.csv:2: lab 14 is not assigned"},
        {"hand_ins = \"stranger.csv\"\n" + some_labs + "[late]\npercent_per_day = 110\n",
         "class.toml:7: 'percent_per_day' must be from 0 to 100"},
        {"hand_ins = \"stranger.csv\"\n" + some_labs + "[late]\nbank_days_per_lab = 2\n",
         "class.toml:7: 'bank_days_per_lab' needs 'bank_days'"},
        {"hand_ins = \"stranger.csv\"\n" + some_labs + "[late]\nbank_days = 5\nbank_days_per_lab = 6\n",
         "class.toml:8: 'bank_days_per_lab' must be a whole number from 1 to 5"},
        {"hand_ins = \"stranger.csv\"\n" + some_labs + "[late]\nbank_days = 0\n",
         "class.toml:7: 'bank_days' must be a whole number from 1 to 366"},
        {some_labs + "[late]\nbank_days = 5\n", "class.toml:5: [late] needs hand_ins"},
        {some_labs + "[attempts]\n", "class.toml:5: [attempts] must have 'per_day'"},
        {some_labs + "[attempts]\nper_day = 0\n", "class.toml:6: 'per_day' must be a whole number from 1 to 1000"},
        {some_labs + "[attempts]\nper_dya = 3\n", "class.toml:"},
        {some_students + "[[extension]]\nstudent = \"jan\"\ndays = 3\n",
         "class.toml:10: 'jan' is not on the roster: did you mean 'jane'?"},
        {some_students + "[[extension]]\nstudent = \"jane\"\n", "class.toml:9: [[extension]] must have 'days'"},
        {some_students + "[[extension]]\nstudent = \"jane\"\ndays = 3\n[[extension]]\nstudent = \"jane\"\ndays = 4\n",
         "class.toml:13: 'jane' has two extensions for all labs"},
    };
    for (const auto& [text, message] : cases) {
        const std::string said = refused(text);
        EXPECT_TRUE(contains(said, message)) << text << "said: " << said << "\ninstead of: " << message;
        EXPECT_FALSE(contains(said, "\n")) << said;
    }
}

TEST_F(ClassFiles, AdjustmentsAreReadFromTheResultsUnlessTheFileNamesOthers) {
    folder.write("marks/adjustments.csv", "student,task,points,note\njane,13.1,+1,fair\n");
    folder.write("mine.csv", "student,task,points,note\njane,13.1,-0.5,unfair\n");
    EXPECT_EQ(read(some_labs).adjustments.at(0).points, 1);
    EXPECT_EQ(read("adjustments = \"mine.csv\"\n" + some_labs).adjustments.at(0).points, -0.5);
    EXPECT_EQ(read_class_file({}, folder.path() / "marks").adjustments.at(0).note, "fair")
        << "without a class file, too";
    EXPECT_EQ(read_class_file({}, folder.path()).adjustments.size(), 0u);
    folder.write("marks/adjustments.csv", "student,task,points,note\njane,13.1,one,fair\n");
    EXPECT_TRUE(contains(refused(some_labs), "adjustments.csv:2: 'one' is no number of points"));
    folder.write("marks/adjustments.csv", "student,task,points,note\njane,13.1,1,\n");
    EXPECT_TRUE(contains(refused(some_labs), "adjustments.csv:2: an adjustment needs a note"));
}

TEST_F(ClassFiles, AreRememberedForLaterRunsInTheFolder) {
    const fs::path file = folder.write("class.toml", some_labs), marks = folder.path() / "marks";
    fs::create_directories(marks);
    EXPECT_EQ(class_file_of(marks), "");
    keep_class_file(file, marks);
    EXPECT_EQ(class_file_of(marks), file);
    fs::rename(file, folder.path() / "moved.toml");
    EXPECT_TRUE(contains(message_of<UsageError>([&] { class_file_of(marks); }), "there is no class file"));
    keep_class_file("", marks);
    EXPECT_EQ(class_file_of(marks), "");
}

// ---- the record of students ----

/// Returns three checks, of which so many passed.
std::vector<check::Verdict> checks_with(int passed) {
    std::vector<check::Verdict> checks;
    for (int i = 0; i < 3; ++i)
        checks.push_back({.outcome = i < passed ? check::Outcome::passed : check::Outcome::wrong,
                          .found = "0.5",
                          .name = std::to_string(i)});
    return checks;
}

SubmissionMark submission(const std::string& name, std::map<std::string, int> points_by_task) {
    SubmissionMark mark;
    mark.name = name;
    for (const char* folder : {"13_displacement", "14_adaptive_displacement"}) {
        LabMark lab{.lab = folder};
        for (const auto& [id, points] : points_by_task)
            if (id.substr(0, 2) == lab.lab.substr(0, 2))
                lab.tasks.push_back(
                    {.id = id, .title = "A task", .file = "task.glsl", .of = 3, .checks = checks_with(points)});
        if (!lab.tasks.empty()) mark.labs.push_back(lab);
    }
    return mark;
}

TEST_F(ClassFiles, TheDenominatorIsTheSameForAll) {
    const std::vector<SubmissionMark> marks = {submission("jane", {{"13.1", 3}}),
                                               submission("joe", {{"13.1", 3}, {"14.1", 3}})};
    // Without a class file, every lab that was graded in the class counts.
    for (const StudentRecord& one : class_record(marks, {}, {}).students) EXPECT_EQ(one.of(), 6) << one.name;
    // With a class file, its assigned labs count, also if nobody handed them in. Other labs do not count.
    const ClassRecord both = class_record(marks, read(some_labs + "[[assigned]]\nlab = 14\n"), {});
    for (const StudentRecord& one : both.students) EXPECT_EQ(one.of(), points_of_13 + points_of_14) << one.name;
    const ClassRecord first = class_record(marks, read(some_labs), {});
    EXPECT_EQ(first.students[1].of(), points_of_13);
    EXPECT_EQ(first.students[1].points(), 3) << "lab 14 is not assigned";
    // In a run with --lab, only the given labs count.
    EXPECT_EQ(class_record(marks, read(some_labs + "[[assigned]]\nlab = 14\n"), {"14_adaptive_displacement"})
                  .students[0]
                  .of(),
              points_of_14);
    EXPECT_TRUE(contains(message_of([&] { class_record(marks, read(some_labs), {"14_adaptive_displacement"}); }),
                         "assigns none of the labs"));
}

TEST_F(ClassFiles, OptionalTasksMakeUpForLostPointsUnlessTheyCountLikeOthers) {
    const auto record = [&](const SubmissionMark& mark, const std::string& text) {
        const std::vector<SubmissionMark> own = {mark};
        const ClassRecord all = class_record(own, read("[[assigned]]\nlab = 14\n" + text), {});
        return std::pair(all.students[0].points(), all.students[0].of());
    };
    // 14.5 and 14.6 are optional. The marks say that each task of these submissions has 3 points.
    const std::vector<SubmissionMark> marks = {
        submission("few", {{"14.1", 2}, {"14.5", 3}}),
        submission("all", {{"14.1", 3}, {"14.2", 3}, {"14.3", 3}, {"14.4", 3}, {"14.5", 3}, {"14.7", 3}})};
    EXPECT_EQ(record(marks[0], ""), std::pair(5.0, points_of_14));
    const auto [points, of] = record(marks[1], "");
    EXPECT_EQ(points, of) << "never more than the maximum";
    EXPECT_EQ(record(marks[0], "optional = true\n").first, 5);
    EXPECT_GT(record(marks[0], "optional = true\n").second, points_of_14);
    EXPECT_GT(record(marks[1], "optional = true\n").first, points);
}

TEST_F(ClassFiles, NamesMatchInAnyUnicodeNormalForm) {
    const std::string apart = "Zoe\u0308", composed = "Zo\u00eb";
    folder.write("roster.csv", "student,email\n" + apart + ",zoe@x.org\n");
    folder.write("times.csv", "student,handed_in\n" + apart + ",2027-03-03 10:00\n");
    folder.write("marks/adjustments.csv", "student,task,points,note\n" + apart + ",13.1,1,fair\n");
    const ClassFile policy =
        read("roster = \"roster.csv\"\nhand_ins = \"times.csv\"\n" + some_labs +
             "[late]\npercent_per_day = 10\n[[extension]]\nstudent = \"" + apart + "\"\ndays = 1\n");
    const std::vector<SubmissionMark> marks = {submission(composed, {{"13.1", 1}})};
    const ClassRecord record = class_record(marks, policy, {});
    ASSERT_EQ(record.students.size(), 1u);
    EXPECT_EQ(record.students[0].student.email, "zoe@x.org");
    EXPECT_EQ(record.students[0].adjusted(), 2);
    EXPECT_EQ(record.students[0].labs[0].days_late, 1) << "with its time, and with its extension";
}

TEST_F(ClassFiles, AdjustmentsComeBeforeLatenessAndStayWithinTheTask) {
    folder.write("times.csv",
                 "student,lab,handed_in\njane,13,2027-03-03 10:00\njane,,2027-02-28 10:00\njoe,,2027-03-03 10:00\n"
                 "ann,,2027-03-20 10:00\n");
    folder.write("marks/adjustments.csv",
                 "student,task,points,note\njane,13.1,1,\"a slip; =1\"\njoe,13.1,5,all\njoe,13.2,-9,copied\n"
                 "kim,13.3,2,on paper\n");
    const std::vector<SubmissionMark> marks = {submission("jane", {{"13.1", 1}, {"13.2", 3}, {"14.1", 3}}),
                                               submission("joe", {{"13.1", 1}, {"13.2", 3}}),
                                               submission("ann", {{"13.1", 2}}), submission("bo", {{"13.1", 2}})};
    const ClassRecord record = class_record(
        marks,
        read("hand_ins = \"times.csv\"\n" + some_labs +
             "[[assigned]]\nlab = 14\ndue = 2027-02-20\n[late]\npercent_per_day = 10\nfloor_percent = 50\n"
             "[[student]]\nstudent = \"jane\"\n[[student]]\nstudent = \"joe\"\n[[student]]\nstudent = \"ann\"\n"
             "[[student]]\nstudent = \"kim\"\n"
             "[[extension]]\nstudent = \"joe\"\ndays = 1\n[[extension]]\nstudent = \"joe\"\nlab = 13\ndays = 5\n"),
        {});
    ASSERT_EQ(record.students.size(), 5u);
    const auto lab = [&](size_t student, size_t which) -> const LabRecord& {
        return record.students[student].labs[which];
    };
    EXPECT_EQ(lab(0, 0).days_late, 2);
    EXPECT_DOUBLE_EQ(lab(0, 0).graded(), 4);
    EXPECT_DOUBLE_EQ(lab(0, 0).points(), 0.8 * (1 + 1 + 3));
    EXPECT_EQ(lab(0, 1).days_late, 8) << "by the row without a lab";
    EXPECT_DOUBLE_EQ(lab(0, 1).points(), 0.5 * 3) << "not below the floor";
    EXPECT_EQ(lab(1, 0).days_late, 0) << "the longer extension counts";
    EXPECT_EQ(lab(1, 0).extension_days, 5);
    EXPECT_DOUBLE_EQ(lab(1, 0).points(), 3 + 0) << "a task has at most its points and at least none";
    EXPECT_EQ(record.students[1].remarks(), (Cells{"13.1: +2 points: all", "13.2: -3 points: copied"}))
        << "as many as they change: 5 were asked for, and 9";
    EXPECT_EQ(lab(2, 0).late_share, 0.5);
    EXPECT_FALSE(record.students[3].on_roster);
    EXPECT_EQ(lab(3, 0).days_late, 0) << "without a time nobody is late";
    EXPECT_EQ(record.students[4].name, "kim");
    EXPECT_EQ(record.students[4].mark, nullptr);
    EXPECT_EQ(record.students[4].points(), 2) << "an adjustment without a submission";
    EXPECT_EQ(record.students[4].state(), "nothing handed in");
    EXPECT_EQ(record.students[0].remarks(), (Cells{"13.1: +1 point: a slip; =1", "lab 13: 2 days late, 20 % less",
                                                   "lab 14: 8 days late, 50 % less"}));
    EXPECT_EQ(record.notes,
              (Cells{"1 student of the roster handed nothing in: kim", "1 submission is not on the roster: bo",
                     "1 submission has no time in hand_ins and counts as in time: bo"}));
}

TEST_F(ClassFiles, TheBankPaysForLateDaysInTheOrderOfTheDueDates) {
    // Lab 14 is due before lab 13. Jane is 3 days late with 14, and 2 with 13.
    folder.write("times.csv",
                 "student,lab,handed_in\njane,14,2027-02-23 10:00\njane,13,2027-03-03 10:00\n"
                 "joe,,2027-02-20 10:00\n");
    const std::string text = "hand_ins = \"times.csv\"\n" + some_labs +
                             "[[assigned]]\nlab = 14\ndue = 2027-02-20\n"
                             "[late]\npercent_per_day = 10\nbank_days = 3\nbank_days_per_lab = 2\n";
    const std::vector<SubmissionMark> marks = {submission("jane", {{"13.1", 3}, {"14.1", 3}}),
                                               submission("joe", {{"13.1", 3}})};
    const ClassRecord record = class_record(marks, read(text), {});
    const StudentRecord& jane = record.students[0];
    EXPECT_EQ(jane.labs[1].days_late, 3);
    EXPECT_EQ(jane.labs[1].bank_days, 2) << "at most as many as one lab may use";
    EXPECT_DOUBLE_EQ(jane.labs[1].points(), 0.9 * 3);
    EXPECT_EQ(jane.labs[0].days_late, 2);
    EXPECT_EQ(jane.labs[0].bank_days, 1) << "the rest of the bank";
    EXPECT_DOUBLE_EQ(jane.labs[0].points(), 0.9 * 3);
    EXPECT_EQ(jane.bank_used, 3);
    EXPECT_EQ(jane.remarks(),
              (Cells{"lab 13: 2 days late, of which 1 cost nothing, 10 % less",
                     "lab 14: 3 days late, of which 2 cost nothing, 10 % less", "late days of the term: 3 of 3 used"}));
    EXPECT_TRUE(contains(to_table(record), "late days")) << to_table(record);
    EXPECT_TRUE(contains(to_table(record), "      3/3  late: 0.6 less\n")) << to_table(record);
    EXPECT_TRUE(
        contains(to_late_days(record), "\njane,13,2027-03-01 23:59 +01:00,2027-03-03 10:00 +01:00,2,1,1,3,0,0,,0,\n"))
        << to_late_days(record);
    EXPECT_TRUE(contains(to_csv(record), "late days used (of 3)"));
    EXPECT_EQ(record.students[1].bank_used, 0);
    EXPECT_TRUE(record.students[1].remarks().empty());

    // A run of lab 13 alone knows from hand_ins.csv what lab 14 has used.
    const std::vector<SubmissionMark> only_13 = {submission("jane", {{"13.1", 3}})};
    const ClassRecord alone = class_record(only_13, read(text), {"13_displacement"});
    EXPECT_EQ(alone.students[0].labs[0].bank_days, 1);
    EXPECT_EQ(alone.students[0].bank_used, 3);

    // Days that the bank pays in full change no points.
    const ClassRecord paid = class_record(marks,
                                          read(text + "grace_hours = 0\nfloor_percent = 0\n"
                                                      "[[extension]]\nstudent = \"jane\"\ndays = 1\n"),
                                          {});
    EXPECT_EQ(paid.students[0].labs[1].bank_days, 2);
    EXPECT_EQ(paid.students[0].labs[0].bank_days, 1);
    EXPECT_FALSE(paid.students[0].is_changed());
    EXPECT_EQ(paid.students[0].remarks(lab_14), Cells{"lab 14: 2 days late, which cost nothing"});

    // A day that the bank does not pay costs as before, and the bank is off without the key.
    folder.write("times.csv", "student,lab,handed_in\njane,13,2027-03-03 10:00\n");
    const ClassRecord without =
        class_record(only_13, read("hand_ins = \"times.csv\"\n" + some_labs + "[late]\npercent_per_day = 10\n"), {});
    EXPECT_DOUBLE_EQ(without.students[0].points(), 0.8 * 3);
}

TEST(HandInLog, CountsTheHandInsOfALabOnADayOfTheClass) {
    const TemporaryFolder folder;
    const UtcOffset offset(60);
    const auto at = [](const char* time) { return parse_moment(time, {}, {}); };
    EXPECT_TRUE(read_hand_in_log(folder.path(), "jane").empty());
    log_hand_ins(folder.path(), "jane", {{"13_displacement", at("2027-03-01T22:50Z"), "a"}}, offset);
    log_hand_ins(folder.path(), "jane",
                 {{"13_displacement", at("2027-03-01T23:10Z"), "b"}, {lab_14, at("2027-03-01T23:10Z"), "c"}}, offset);
    const std::vector<GradedHandIn> log = read_hand_in_log(folder.path(), "jane");
    ASSERT_EQ(log.size(), 3u);
    EXPECT_EQ(log[0].graded_at, at("2027-03-01T22:50Z"));
    EXPECT_EQ(last_hand_in(log, "13_displacement")->files, "b");
    EXPECT_EQ(last_hand_in(log, "12_relief_exact"), nullptr);
    EXPECT_EQ(hand_ins_on_day(log, "13_displacement", at("2027-03-01T12:00Z"), offset), 1)
        << "23:10 UTC is the next day at +01:00";
    EXPECT_EQ(hand_ins_on_day(log, "13_displacement", at("2027-03-02T12:00Z"), offset), 1);
    EXPECT_EQ(hand_ins_on_day(log, "13_displacement", at("2027-03-01T12:00Z"), UtcOffset(0)), 2);
    folder.write("hand_ins/joe.csv", "lab,graded_at,files\n13_displacement,yesterday,a\n");
    EXPECT_TRUE(
        contains(message_of([&] { read_hand_in_log(folder.path(), "joe"); }), "joe.csv:2: 'yesterday' is no time"));
}

TEST(HandInLog, KeepsTheMarksOfLabsThatALaterRunDoesNotGrade) {
    const TemporaryFolder folder;
    SubmissionMark first = submission("jane", {{"13.1", 3}}), second = submission("jane", {{"14.1", 0}});
    first.course = second.course = "course";
    keep_marks(folder.path(), first);
    second.labs[0].kept = "for a reason";
    keep_marks(folder.path(), second);
    const auto marks = earlier_marks(folder.path(), "jane", "course");
    ASSERT_TRUE(marks && marks->lab("13_displacement") && marks->lab(lab_14));
    EXPECT_EQ(marks->lab("13_displacement")->points(), 3);
    EXPECT_EQ(marks->lab(lab_14)->kept, "");
    EXPECT_FALSE(earlier_marks(folder.path(), "jane", "another course or seed"));
    folder.write("hand_ins/jane.json", "{");
    EXPECT_FALSE(earlier_marks(folder.path(), "jane", "course"));
}

// ---- teams ----

class Teams : public ClassFiles {
protected:
    /// Returns the record of a class in which jane and joe are a team, and kim has none.
    ClassRecord record_of_class(const std::vector<SubmissionMark>& marks, const std::string& more = "") {
        folder.write("roster.csv", "student,canvas_id,team\njane,1,red\njoe,2,red\nkim,3,\n");
        return class_record(marks, read("roster = \"roster.csv\"\n" + more + some_labs + "[[assigned]]\nlab = 14\n"),
                            {});
    }
    static const StudentRecord& of(const ClassRecord& record, const std::string& name) {
        for (const StudentRecord& one : record.students)
            if (one.name == name) return one;
        throw Error("no record of " + name);
    }
};

TEST_F(Teams, OneSubmissionOfAMemberCountsForAll) {
    const std::vector marks = {submission("joe", {{"13.1", 2}, {"14.1", 3}}), submission("kim", {{"13.1", 1}})};
    const ClassRecord record = record_of_class(marks);
    EXPECT_EQ(record.students.size(), 3u);
    for (const char* member : {"jane", "joe"}) {
        EXPECT_EQ(of(record, member).points(), 5) << member;
        EXPECT_EQ(of(record, member).state(), "graded");
    }
    EXPECT_EQ(of(record, "joe").remarks(), Cells{}) << "there is nothing to choose";
    EXPECT_EQ(of(record, "jane").remarks(), Cells{"the submission 'joe' counts for team red"});
    EXPECT_EQ(of(record, "kim").points(), 1);
    EXPECT_EQ(record.notes, Cells{}) << "nobody of the team is missing";
    const std::string csv = to_csv(record), canvas = to_canvas(record);
    EXPECT_TRUE(contains(csv, "\njane,graded,5,")) << csv;
    EXPECT_TRUE(contains(csv, ",section,team,")) << csv;
    EXPECT_TRUE(contains(csv, ",red,")) << csv;
    EXPECT_TRUE(contains(canvas, "jane,1,,,,2,3\n")) << canvas;
    EXPECT_TRUE(contains(canvas, "joe,2,,,,2,3\n")) << canvas;
    EXPECT_TRUE(contains(to_surefire(of(record, "jane")), "name=\"points\" value=\"5\""));
}

TEST_F(Teams, ASubmissionOfTheTeamsNameCountsAndHasNoRowOfItsOwn) {
    const std::vector marks = {submission("red", {{"13.1", 2}})};
    const ClassRecord record = record_of_class(marks);
    EXPECT_EQ(record.students.size(), 3u);
    EXPECT_EQ(of(record, "jane").points(), 2);
    EXPECT_EQ(of(record, "joe").points(), 2);
    EXPECT_EQ(record.notes, Cells{"1 student of the roster handed nothing in: kim"});
}

TEST_F(Teams, OfTwoSubmissionsTheLastCountsLabByLab) {
    const std::vector marks = {submission("jane", {{"13.1", 3}}), submission("joe", {{"13.1", 1}, {"14.1", 2}})};
    folder.write("times.csv", "student,lab,handed_in\njane,,2027-02-20 10:00\njoe,,2027-02-21 10:00\n");
    const ClassRecord record = record_of_class(marks, "hand_ins = \"times.csv\"\n");
    const std::string why = "lab 13: the submission 'joe' counts for team red, and not 'jane': it was handed in last";
    for (const char* member : {"jane", "joe"}) {
        EXPECT_EQ(of(record, member).points(), 3) << member << ": 1 in lab 13, 2 in lab 14";
        EXPECT_EQ(of(record, member).remarks(), Cells{why});
        EXPECT_EQ(of(record, member).remarks("13_displacement"), Cells{why});
        EXPECT_EQ(of(record, member).remarks(lab_14), Cells{});
    }
    EXPECT_EQ(record.notes, (Cells{why, "1 student of the roster handed nothing in: kim"}));
    folder.write("times.csv", "student,lab,handed_in\njoe,,2027-02-21 10:00\n");
    const ClassRecord untimed = record_of_class(marks, "hand_ins = \"times.csv\"\n");
    EXPECT_EQ(of(untimed, "joe").points(), 5) << "3 in lab 13, 2 in lab 14";
    EXPECT_EQ(
        of(untimed, "joe").remarks(),
        Cells{"lab 13: the submission 'jane' counts for team red, and not 'joe': it has the most points, since not "
              "all have a time in hand_ins"});
    EXPECT_EQ(of(untimed, "joe").sources,
              (std::map<std::string, std::string>{{"13_displacement", "jane"}, {lab_14, "joe"}}));
}

TEST_F(Teams, LatenessIsThatOfTheSubmissionThatCountsAndAnExtensionIsForAll) {
    const std::vector marks = {submission("jane", {{"13.1", 3}})};
    folder.write("times.csv", "student,lab,handed_in\njane,,2027-03-04 10:00\n");
    const std::string late = "hand_ins = \"times.csv\"\n";
    folder.write("marks/adjustments.csv", "student,task,points,note\njoe,13.1,-1,was absent\n");
    folder.write("roster.csv", "student,team\njane,red\njoe,red\n");
    const std::string text = "roster = \"roster.csv\"\n" + late + some_labs + "[late]\npercent_per_day = 10\n";
    const ClassRecord record = class_record(marks, read(text), {});
    EXPECT_DOUBLE_EQ(of(record, "jane").points(), 0.7 * 3);
    EXPECT_DOUBLE_EQ(of(record, "joe").points(), 0.7 * 2) << "an adjustment is a member's own";
    const ClassRecord longer = class_record(marks, read(text + "[[extension]]\nstudent = \"joe\"\ndays = 2\n"), {});
    EXPECT_DOUBLE_EQ(of(longer, "jane").points(), 0.9 * 3);
    EXPECT_DOUBLE_EQ(of(longer, "joe").points(), 0.9 * 2);
}

TEST_F(Teams, AWaitingSubmissionIsThatOfAllMembers) {
    folder.write("roster.csv", "student,team\njane,red\njoe,red\nkim,\n");
    const std::vector<SubmissionMark> none;
    const ClassRecord record = class_record(none, read("roster = \"roster.csv\"\n" + some_labs), {}, {"joe"});
    EXPECT_EQ(of(record, "jane").state(), "not graded yet");
    EXPECT_EQ(of(record, "kim").state(), "nothing handed in");
}

TEST_F(Teams, OfAStudentsNameAreRefused) {
    folder.write("roster.csv", "student,team\njane,\njoe,jane\n");
    EXPECT_TRUE(contains(refused("roster = \"roster.csv\"\n" + some_labs),
                         "roster.csv:3: the team 'jane' has the name of a student: rename it"));
}

TEST_F(ClassFiles, AdjustmentsOfUnknownStudentsOrTasksAreRefused) {
    const std::vector<SubmissionMark> marks = {submission("jane", {{"13.1", 1}}),
                                               submission("m\xfcller", {{"13.1", 1}})};
    const auto said = [&](const std::string& row) {
        folder.write("marks/adjustments.csv", "student,task,points,note\n" + row + "\n");
        return message_of([&] { class_record(marks, read_class_file({}, folder.path() / "marks"), {}); });
    };
    EXPECT_TRUE(contains(said("jan,13.1,1,x"), "adjustments.csv:2: 'jan' is not in the class: did you mean 'jane'?"));
    EXPECT_TRUE(contains(said("jane,13.9,1,x"), "adjustments.csv:2: unknown task '13.9'"));
    // A name that is not UTF-8 is written as in results.csv.
    folder.write("marks/adjustments.csv", "student,task,points,note\nm\\xfcller,13.1,1,x\n");
    EXPECT_EQ(class_record(marks, read_class_file({}, folder.path() / "marks"), {}).students[1].points(), 2);
}

TEST_F(ClassFiles, WithoutARosterAnExtensionForAnUnknownStudentIsReported) {
    const ClassFile policy = read(some_labs + "[[extension]]\nstudent = \"jnae\"\ndays = 3\n");
    const std::vector marks = {submission("jane", {{"13.1", 1}})};
    EXPECT_EQ(class_record(marks, policy, {}).notes, Cells{"1 extension is for nobody who handed in: jnae"});
}

TEST_F(ClassFiles, AnUngradedSubmissionIsNotReportedAsMissing) {
    const std::vector marks = {submission("jane", {{"13.1", 1}})};
    const ClassRecord record = class_record(marks, read(some_students), {}, {"jane", "joe"});
    EXPECT_EQ(record.students.at(1).state(), "not graded yet");
    EXPECT_FALSE(record.students[1].is_marked());
    EXPECT_EQ(record.notes, Cells{});
}

TEST_F(ClassFiles, ALabThatTheMachineCouldNotGradeHasNoMark) {
    std::vector marks = {submission("jane", {{"13.1", 1}, {"14.1", 1}})};
    marks[0].labs[0].tasks[0].checks[0].outcome = check::Outcome::machine;
    const ClassRecord record = class_record(marks, {}, {});
    EXPECT_FALSE(record.students[0].is_marked());
    EXPECT_FALSE(record.students[0].labs[0].marked);
    EXPECT_TRUE(record.students[0].labs[1].marked);
}

}  // namespace
}  // namespace relief::grade
