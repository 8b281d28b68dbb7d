// Pages of labs, submissions, classes and benchmarks: untrusted text and manifest text are escaped on all of them.
#include "framework/course/pages/lab_page.h"
#include "framework/course/pages/page.h"
#include "framework/staff/pages/bench_page.h"
#include "framework/staff/pages/export_pictures.h"
#include "framework/staff/pages/grade_page.h"
#include "framework/staff/pages/question_pages.h"
#include "framework/staff/pages/record_part.h"
#include "framework/staff/pages/student_page.h"
#include "tests/support.h"

namespace relief::pages {
namespace {

const std::string hostile = "x<script>&\"'";

/// Counts the escaped copies of the hostile text. Expects no unescaped copy.
int times_escaped(const std::string& page) {
    EXPECT_EQ(page.find("x<script>"), std::string::npos);
    EXPECT_EQ(page.find(hostile.substr(1 + std::string("<script>").size())), std::string::npos);
    int times = 0;
    for (size_t at = 0; (at = page.find("x&lt;script&gt;&amp;&quot;&#39;", at)) != std::string::npos; ++at) ++times;
    return times;
}

Manifest some_manifest() {
    Manifest manifest;
    manifest.title = hostile, manifest.learns = {hostile};
    TaskInfo& task = manifest.tasks.emplace_back();
    task.id = task.title = hostile;
    manifest.probes.push_back({.name = hostile, .unit = hostile, .error = ErrorMetric::angle});
    return manifest;
}

grade::SubmissionMark some_submission() {
    check::TaskVerdict task{.id = hostile,
                            .title = hostile,
                            .file = hostile,
                            .of = 3,
                            .checks = {},
                            .mistake = hostile,
                            .hint = hostile + "`" + hostile + "`"};
    for (const check::Outcome outcome : {check::Outcome::passed, check::Outcome::wrong, check::Outcome::broken})
        task.checks.push_back(
            {.outcome = outcome, .found = hostile, .look_at = hostile, .view = hostile, .name = hostile});
    grade::SubmissionMark mark;
    mark.name = mark.problem = mark.isolation = hostile;
    mark.labs.push_back({.lab = "02_" + hostile, .tasks = {task}, .log = hostile, .times = {}});
    mark.ignored = {hostile}, mark.ignored_count = 1;
    return mark;
}

StudentQuestions some_questions() {
    grade::Question value;
    value.lab = value.task = value.file = value.view = value.probe = hostile;
    value.pictures = {Image(4, 4, 3, 8)};
    value.call.name = hostile, value.call.arguments = {hostile}, value.call.count = 2;
    value.mark_is_lost = true;
    value.drawn_here = value.expected_here = value.unit = value.found = value.look_at = hostile;
    value.answer = "the answer";
    grade::Question picture = value, line = value;
    picture.kind = grade::QuestionKind::picture, line.kind = grade::QuestionKind::line;
    picture.pictures.assign(4, Image(4, 4, 3, 8)), line.pictures.assign(2, Image(4, 4, 3, 8));
    picture.changes = {{7, hostile, hostile}}, line.changes.assign(4, {7, hostile, hostile});
    return {hostile, {value, picture, line}, 4, {hostile}};
}

TEST(QuestionPages, ShowSubmissionsAsTextAndAnswersInTheKeyOnly) {
    const StudentQuestions student = some_questions();
    const std::string sheet = question_sheet(student), key = question_key({student});
    EXPECT_GT(times_escaped(sheet), 20);
    EXPECT_GT(times_escaped(key), 20);
    EXPECT_EQ(sheet.find("the answer"), std::string::npos);
    EXPECT_NE(key.find("the answer"), std::string::npos);
    EXPECT_EQ(key.find("data:image"), std::string::npos);
    EXPECT_NE(sheet.find("3 of 4 questions"), std::string::npos);
    EXPECT_NE(sheet.find("left: 12.50%; top: 12.50%"), std::string::npos) << "the mark is at the pixel's centre";
}

TEST(LabPage, ShowsAManifestAsText) {
    const LabEntry lab{.number = 2, .name = "lab", .folder = "02_lab"};
    const Manifest manifest = some_manifest();
    LabPage page;
    page.lab = &lab, page.manifest = &manifest, page.knob = page.probe = hostile, page.marks = {hostile};
    page.picture = page.handout = hostile, page.previous = page.next = &page;
    EXPECT_EQ(times_escaped(lab_page(page)), 11);
    page.methods = {{hostile, hostile, hostile, hostile}, {hostile, hostile, hostile, hostile}};
    EXPECT_GT(times_escaped(lab_page(page)), 30);
}

TEST(StudentPage, ShowsASubmissionAsText) {
    const grade::SubmissionMark mark = some_submission();
    const Manifest manifest = some_manifest();
    CheckInfo check;
    check.task = check.name = check.reason = check.against = check.shot.probe.name = hostile;
    const std::vector<grade::CheckPictures> pictures{
        {mark.labs[0].lab, &manifest, check, false, Image(2, 2, 3, 0.5f), Image(2, 2, 3, 0.25f)}};
    EXPECT_GT(times_escaped(student_page(mark, pictures, PageFor::instructor)), 30);
    EXPECT_GT(times_escaped(student_page(mark, pictures, PageFor::student)), 15);
}

TEST(StudentPage, UpdatesTheRecordAndKeepsTheRest) {
    grade::SubmissionMark mark = some_submission();
    mark.name = "jane", mark.labs[0].lab = "02_lab", mark.labs[0].tasks[0].id = "2.1";
    grade::ClassFile policy;
    policy.labs.push_back({.folder = "02_lab",
                           .tasks = {{.id = "2.1", .title = "A task", .file = "task.glsl", .points = 3}},
                           .due = grade::parse_moment("2027-03-01T12:00Z", {}, {}),
                           .canvas = {},
                           .moodle = {}});
    policy.late.percent_per_day = 50;
    policy.adjustments = {{"jane", "2.1", 0.5, hostile, {}}};
    policy.extensions = {{"jane", "", 1, "ill"}};
    policy.hand_ins = {{"jane", "", grade::parse_moment("2027-03-03T11:00Z", {}, {})}};
    const std::vector<grade::SubmissionMark> marks = {mark};  // the record points to it
    const grade::ClassRecord record = grade::class_record(marks, policy, {});
    for (const PageFor reader : {PageFor::instructor, PageFor::student}) {
        const std::string before = student_page(mark, {}, reader);
        const std::string page = with_record(before, record.students[0], grade::UtcOffset(60), reader);
        EXPECT_TRUE(contains(page, "1 day late: 50 % less")) << page.substr(page.find("<!--record"), 900);
        EXPECT_TRUE(contains(page, "due 2027-03-02 13:00 +01:00, with 1 day of extension"));
        EXPECT_TRUE(contains(page, "handed in 2027-03-03 12:00 +01:00"));
        EXPECT_EQ(contains(page, "extension: ill"), reader == PageFor::instructor)
            << "the student's page tells no reason";
        EXPECT_EQ(times_escaped(page), times_escaped(before) + 1) << "a note is text";
        EXPECT_EQ(with_record(page, record.students[0], grade::UtcOffset(60), reader), page);
        EXPECT_EQ(with_record(page, grade::record_of(mark), grade::UtcOffset(0), reader), before)
            << "and everything else stays";
    }
    grade::ClassReport report;
    report.marks = marks;
    EXPECT_GT(times_escaped(class_page(report, record)), times_escaped(class_page(report)));
}

TEST(ClassPage, ShowsSubmissionsAsText) {
    grade::ClassReport report;
    report.marks = {some_submission()}, report.seed = report.isolation.reason = hostile;
    EXPECT_GT(times_escaped(class_page(report)), 15);
}

TEST(BenchPage, ShowsRowsAndMachinesAsText) {
    const measure::BenchTopic topic{"parallax", hostile, hostile, {}};
    TopicResult result;
    result.topic = &topic;
    measure::BenchMachine& machine = result.machine;
    machine.cpu = machine.compiler = machine.commit = machine.renderer = hostile;
    for (const char* state : {"measured", hostile.c_str()}) {
        measure::BenchRow& row = result.rows.emplace_back();
        row.topic = "parallax", row.state = state, row.method = row.item = hostile;
        row.scene = row.knobs = {{hostile, hostile}}, row.work = {{hostile, 1}};
        row.times = {1, 1, 3}, row.repeats = 10, row.clock = hostile, row.error = {1, 1, 1, hostile, {}};
        row.picture = row.error_map = Image(2, 2, 3, 8);
    }
    EXPECT_GT(times_escaped(bench_page(std::vector{std::move(result)}, [](const auto&, const auto&) {})), 20);
}

TEST(ExportPictures, AreSmallBoundedAndNeverHidden) {
    const Manifest manifest = some_manifest();
    grade::CheckPictures one{
        .lab = "02", .manifest = &manifest, .check = {}, .drawn = Image(400, 300, 3, 8), .expected = {}};
    one.check.task = "2.1", one.check.name = "noise";
    uint32_t state = 1;  // noise does not compress
    for (float& value : one.drawn.values) value = float((state = state * 1664525 + 1013904223) >> 24) / 255;
    one.expected = one.drawn;
    std::fill(one.expected.values.begin(), one.expected.values.begin() + 3000, 0.f);
    const std::vector<grade::ExportPicture> three = export_pictures({one});
    ASSERT_EQ(three.size(), 3u);
    EXPECT_EQ(three[0].label, "yours");
    EXPECT_TRUE(three[0].uri.starts_with("data:image/png;base64,"));
    EXPECT_LT(three[0].uri.size(), 192u * 144 * 3 * 4 / 3 + 1000) << "192 pixels wide";

    const std::vector<grade::ExportPicture> many = export_pictures(std::vector(20, one));
    size_t bytes = 0;
    for (const grade::ExportPicture& picture : many) bytes += picture.uri.size();
    EXPECT_LE(bytes, max_export_bytes);
    EXPECT_GE(many.size(), 6u);
    EXPECT_EQ(many.size() % 3, 0u);

    grade::CheckPictures hidden_view = one, hidden_check = one;
    hidden_view.hidden_view = true, hidden_check.check.hidden = true;
    EXPECT_TRUE(export_pictures({hidden_view, hidden_check}).empty());

    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / pictures_file("jane");
    EXPECT_TRUE(read_pictures(file).empty());
    write_pictures(file, many);
    EXPECT_EQ(read_pictures(file).size(), many.size());
    EXPECT_EQ(read_pictures(file)[1].uri, many[1].uri);
    folder.write("pictures/jane.json", "[{");
    EXPECT_TRUE(read_pictures(file).empty());
}

TEST(StudentPage, ShowsAHintOncePerTask) {
    grade::SubmissionMark mark = some_submission();
    mark.labs[0].tasks[0].hint = "";  // that of a known mistake would replace it
    std::vector<check::Verdict>& checks = mark.labs[0].tasks[0].checks;
    for (check::Verdict& check : checks)
        check.outcome = check::Outcome::wrong, check.look_at = "mind the sign", check.view = "";
    checks[1].found = "something else";
    const std::string page = student_page(mark, {}, PageFor::student);
    const size_t first = page.find("mind the sign");
    EXPECT_NE(first, std::string::npos);
    EXPECT_EQ(page.find("mind the sign", first + 1), std::string::npos);
}

TEST(StudentPage, UnfoldsTheFirstPicturesOfATaskAndFoldsTheRest) {
    grade::SubmissionMark mark = some_submission();
    check::TaskVerdict& task = mark.labs[0].tasks[0];
    const Manifest manifest = some_manifest();
    std::vector<grade::CheckPictures> pictures;
    for (size_t i = 0; i < task.checks.size(); ++i) {
        task.checks[i].name = "check " + std::to_string(i), task.checks[i].outcome = check::Outcome::wrong;
        CheckInfo check;
        check.task = task.id, check.name = task.checks[i].name;
        pictures.push_back({mark.labs[0].lab, &manifest, check, false, Image(2, 2, 3, 0.5f), Image(2, 2, 3, 0.25f)});
    }
    const std::string page = student_page(mark, pictures, PageFor::instructor), open = "<details class=\"check\" open>";
    const size_t first = page.find(open);
    ASSERT_NE(first, std::string::npos);
    EXPECT_EQ(page.find(open, first + 1), std::string::npos);
    EXPECT_LT(first, page.find("check 0"));
    EXPECT_NE(page.find("<details class=\"check\">"), std::string::npos);
}

TEST(ClassPage, FoldsTheChecksThatEverybodyPassed) {
    grade::ClassReport report;
    report.marks = {some_submission()};
    std::vector<check::Verdict>& checks = report.marks[0].labs[0].tasks[0].checks;
    for (size_t i = 0; i < checks.size(); ++i) checks[i].name = "check " + std::to_string(i);
    const std::string page = class_page(report);
    const size_t list = page.find("<details class=\"fold\">");
    ASSERT_NE(list, std::string::npos);
    EXPECT_GT(page.find("check 0"), list) << "the check that passed";
    EXPECT_LT(page.find("check 1"), list);
    EXPECT_NE(page.find("1 other check passed by all"), std::string::npos);
}

}  // namespace
}  // namespace relief::pages
