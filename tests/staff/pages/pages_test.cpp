// Pages of labs, submissions, classes and benchmarks: a stranger's text, or a manifest's, is text on all of them.
#include "framework/pages/lab_page.h"
#include "framework/pages/page.h"
#include "framework/staff/pages/bench_page.h"
#include "framework/staff/pages/grade_page.h"
#include "framework/staff/pages/student_page.h"
#include "tests/support.h"

namespace relief {
namespace {

const std::string hostile = "x<script>&\"'";

/// How often the text is there, escaped; it must not be there as it is.
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

SubmissionMark some_submission() {
    TaskMark task{.id = hostile,
                  .title = hostile,
                  .file = hostile,
                  .of = 3,
                  .checks = {},
                  .mistake = hostile,
                  .hint = hostile + "`" + hostile + "`"};
    for (const Outcome outcome : {Outcome::passed, Outcome::wrong, Outcome::broken})
        task.checks.push_back(
            {.name = hostile, .outcome = outcome, .found = hostile, .look_at = hostile, .view = hostile});
    SubmissionMark mark;
    mark.name = mark.problem = mark.isolation = hostile;
    mark.labs.push_back({.lab = "02_" + hostile, .tasks = {task}, .log = hostile, .times = {}});
    mark.ignored = {hostile}, mark.ignored_count = 1;
    return mark;
}

TEST(LabPage, ShowsAManifestAsText) {
    const LabEntry lab{.number = 2, .name = "lab", .folder = "02_lab"};
    const Manifest manifest = some_manifest();
    LabPage page;
    page.lab = &lab, page.manifest = &manifest, page.knob = page.probe = hostile, page.marks = {hostile};
    page.picture = page.handout = hostile, page.previous = page.next = &page;
    EXPECT_EQ(times_escaped(lab_page(page)), 9);
    page.methods = {{hostile, hostile, hostile, hostile}, {hostile, hostile, hostile, hostile}};
    EXPECT_GT(times_escaped(lab_page(page)), 30);
}

TEST(StudentPage, ShowsASubmissionAsText) {
    const SubmissionMark mark = some_submission();
    const Manifest manifest = some_manifest();
    CheckInfo check;
    check.task = check.name = check.reason = check.against = check.shot.probe.name = hostile;
    const std::vector<CheckPictures> pictures{
        {mark.labs[0].lab, &manifest, check, false, Image(2, 2, 3, 0.5f), Image(2, 2, 3, 0.25f)}};
    EXPECT_GT(times_escaped(student_page(mark, pictures, PageFor::instructor)), 30);
    EXPECT_GT(times_escaped(student_page(mark, pictures, PageFor::student)), 15);
}

TEST(ClassPage, ShowsSubmissionsAsText) {
    ClassReport report;
    report.marks = {some_submission()}, report.seed = report.isolation.reason = hostile;
    EXPECT_GT(times_escaped(class_page(report)), 15);
}

TEST(BenchPage, ShowsRowsAndMachinesAsText) {
    const BenchTopic topic{"parallax", hostile, {}};
    TopicResult result;
    result.topic = &topic;
    BenchMachine& machine = result.machine;
    machine.cpu = machine.clock = machine.compiler = machine.commit = machine.renderer = hostile;
    for (const char* state : {"measured", hostile.c_str()}) {
        BenchRow& row = result.rows.emplace_back();
        row.topic = "parallax", row.state = state, row.method = row.item = hostile;
        row.scene = row.knobs = {{hostile, hostile}}, row.work = {{hostile, 1}};
        row.times = {1, 1, 1}, row.repeats = 10, row.error = {1, 1, 1, hostile, {}};
        row.picture = row.error_map = Image(2, 2, 3, 8);
    }
    EXPECT_GT(times_escaped(bench_page(std::vector{std::move(result)})), 20);
}

}  // namespace
}  // namespace relief
