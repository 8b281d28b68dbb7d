// The pages of `relief grade` in a browser, used by keyboard and through the screen reader's information.
#include <cmath>
#include <set>

#include "framework/core/base/file.h"
#include "framework/course/pages/page.h"
#include "framework/staff/pages/grade_page.h"
#include "framework/staff/pages/originality_page.h"
#include "framework/staff/pages/question_pages.h"
#include "framework/staff/pages/student_page.h"
#include "framework/staff/pages/summaries.h"
#include "tests/browser.h"

namespace relief::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Names = std::vector<std::string>;

constexpr const char* lab_02 = "02_normal_map_storage";
constexpr const char* lab_05 = "05_tangent_basis";

check::TaskVerdict task_verdict(const std::string& id, int of, const std::vector<check::Outcome>& outcomes,
                                const std::string& mistake = "") {
    check::TaskVerdict mark{
        .id = id, .title = "A task", .file = "shaders/task.glsl", .of = of, .checks = {}, .mistake = {}, .hint = {}};
    for (const check::Outcome outcome : outcomes) {
        const size_t number = mark.checks.size() + 1;
        mark.checks.push_back({.outcome = outcome,
                               .found = "found " + std::to_string(number),
                               .look_at = outcome == check::Outcome::wrong ? "look here" : "",
                               .name = "check " + std::to_string(number),
                               .hidden = number == 3});
    }
    if (!mistake.empty()) mark.mistake = mistake, mark.hint = "The hint of " + mistake;
    return mark;
}

grade::SubmissionMark submission(const std::string& name,
                                 const std::vector<std::pair<const char*, check::TaskVerdict>>& tasks) {
    grade::SubmissionMark mark;
    mark.name = name, mark.isolation = "namespaces", mark.seconds = 4;
    for (const auto& [lab, one] : tasks)
        mark.labs.push_back(
            {.lab = lab, .tasks = {one}, .log = "", .times = {.compile = 0.5, .draw = 1, .compare = 0.25}});
    return mark;
}

constexpr check::Outcome passed = check::Outcome::passed, wrong = check::Outcome::wrong,
                         unfinished = check::Outcome::unfinished;

/// A class with 11, 7, 2, 9 and 0 points. One submission is not graded, and one cannot be read.
grade::ClassReport some_class() {
    grade::ClassReport report;
    report.isolation.level = grade::Isolation::namespaces, report.taken_over = 2, report.seconds = 12.5,
    report.prepared = 3.25;
    report.marks = {submission("s10", {{lab_02, task_verdict("2.1", 3, {passed, passed, passed})},
                                       {lab_05, task_verdict("5.1", 8, {passed})}}),
                    submission("s9", {{lab_02, task_verdict("2.1", 3, {wrong, wrong, passed}, "truncated")},
                                      {lab_05, task_verdict("5.1", 6, {passed})}}),
                    submission("Anna", {{lab_02, task_verdict("2.1", 3, {passed, wrong, passed}, "truncated")}}),
                    submission("o'd \"d\"\n<b>", {{lab_02, task_verdict("2.1", 9, {passed})}}),
                    submission("zoe", {{lab_02, task_verdict("2.1", 3, {unfinished, unfinished, unfinished})}}),
                    submission("machine", {{lab_02, task_verdict("2.1", 3,
                                                                 {check::Outcome::machine, check::Outcome::machine,
                                                                  check::Outcome::machine})}}),
                    submission("empty", {})};
    report.marks.back().problem = "there is no task file in it";
    report.marks[4].ignored = {"<i>notes</i>.txt"}, report.marks[4].ignored_count = 3;
    report.marks[4].labs[0].log = "task.glsl:3: error: '<vec3>' & more";
    return report;
}

/// A folder as `relief grade` leaves it.
struct Graded {
    TemporaryFolder folder;
    grade::ClassReport report = some_class();
    fs::path page = folder.path() / "a folder" / "report.html";
    Graded() { pages::write_summaries(report, page.parent_path()); }
};

Names names_shown() {
    return browser().eval(
        "[...document.querySelectorAll('#marks tbody tr')].filter(row => row.checkVisibility()).map(row "
        "=> row.cells[0].textContent)");
}

std::string text_of(const std::string& selector) {
    return browser().eval("document.querySelector(" + json(selector).dump() + ").textContent");
}

/// Returns a sphere's normals, shifted by `tilt`.
Image sphere(float tilt) {
    Image image(24, 24, 3);
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 24; ++x) {
            const float u = float(x - 12) / 12 + tilt, v = float(y - 12) / 12, w = 1 - u * u - v * v;
            const float inside[] = {u, v, std::sqrt(std::max(w, 0.0f))};
            for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = w > 0 ? inside[c] : no_surface;
        }
    return image;
}

const Manifest& manifest() {
    static const Manifest one = [] {
        Manifest made;
        made.probes.push_back({.name = "normal", .unit = "degree", .error = ErrorMetric::angle});
        return made;
    }();
    return one;
}

/// Returns the pictures of checks 1 (a probe) and 2 (a picture) of a submission.
std::vector<grade::CheckPictures> two_pictures() {
    CheckInfo probe, picture;
    probe.task = picture.task = "2.1", probe.against = "truth", picture.against = "solution";
    probe.name = "check 1", picture.name = "check 2", probe.reason = "rounding", probe.limits.mean = 0.5;
    probe.shot.probe.name = "normal";
    std::vector<grade::CheckPictures> two{{lab_02, &manifest(), probe, false, sphere(0.2f), sphere(0)},
                                          {lab_02, &manifest(), picture, true, sphere(0.1f), sphere(0)}};
    // Extreme values that a submission can send.
    const float strange[] = {NAN, INFINITY, -INFINITY, 1e38f, -1e38f, 1e-45f};
    for (grade::CheckPictures& one : two) std::copy(std::begin(strange), std::end(strange), one.drawn.pixel(3, 12));
    return two;
}

// ---- the class ----

TEST(ClassPage, IsSortedByItsHeadersWithTheKeyboard) {
    const Graded graded;
    browser().open(graded.page);
    const Names as_graded = {"s10", "s9", "Anna", "o'd \"d\"\\x0a<b>", "zoe", "machine", "empty"};
    EXPECT_EQ(names_shown(), as_graded);
    ASSERT_TRUE(browser().tab_to("th:nth-child(1) button"));
    browser().press("Enter");
    EXPECT_EQ(names_shown(), (Names{"Anna", "empty", "machine", "o'd \"d\"\\x0a<b>", "s9", "s10", "zoe"}));
    EXPECT_EQ(browser().eval("document.activeElement.closest('th').ariaSort"), "ascending");
    browser().press("Space");
    EXPECT_EQ(names_shown(), (Names{"zoe", "s10", "s9", "o'd \"d\"\\x0a<b>", "machine", "empty", "Anna"}));
    EXPECT_EQ(browser().eval("document.activeElement.closest('th').ariaSort"), "descending");
    // Sorted by points: 0, 0, 2, 7, 9, 11. A submission that is not graded is last in both orders.
    browser().press("Tab");
    browser().press("Enter");
    EXPECT_EQ(names_shown(), (Names{"zoe", "empty", "Anna", "s9", "o'd \"d\"\\x0a<b>", "s10", "machine"}));
    browser().press("Enter");
    EXPECT_EQ(names_shown(), (Names{"s10", "o'd \"d\"\\x0a<b>", "s9", "Anna", "zoe", "empty", "machine"}));
    EXPECT_EQ(browser().eval("[...document.querySelectorAll('[aria-sort]')].map(head => head.ariaSort).join()"),
              "none,descending,none,none");
    // Sorted by lab 05, for which two submissions have points: 6 and 8.
    ASSERT_TRUE(browser().tab_to("th:nth-child(6) button"));
    browser().press("Enter");
    EXPECT_EQ((Names{names_shown().at(0), names_shown().at(1)}), (Names{"s9", "s10"}));
    EXPECT_EQ(browser().complaints(), Names{});
}

TEST(ClassPage, IsFilteredByNameOutcomeAndMistake) {
    const Graded graded;
    browser().open(graded.page);
    EXPECT_EQ(text_of("#shown"), "7 of 7 shown");
    ASSERT_TRUE(browser().tab_to("#filter"));
    const struct {
        const char* typed;
        Names left;
    } cases[] = {{"ANNA", {"Anna"}},          {"wrong", {"s9", "Anna"}},   {"trunc", {"s9", "Anna"}},
                 {"truncated  S9", {"s9"}},   {"unfinished", {"zoe"}},     {"all passed", {"s10"}},
                 {"not graded", {"machine"}}, {"no task file", {"empty"}}, {"nobody", {}}};
    for (const auto& [typed, left] : cases) {
        browser().eval("filter.select()");
        browser().type(typed);
        EXPECT_EQ(names_shown(), left) << typed;
        EXPECT_EQ(text_of("#shown"), std::to_string(left.size()) + " of 7 shown");
    }
    EXPECT_EQ(browser().eval("told.role || told.localName"), "output") << "a screen reader is told of changes";
    // The button of a known mistake filters by it.
    ASSERT_TRUE(browser().tab_to(".pick"));
    browser().press("Enter");
    EXPECT_EQ(names_shown(), (Names{"s9", "Anna"}));
    EXPECT_EQ(browser().eval("document.activeElement.id"), "filter");
}

TEST(ClassPage, CountsTheOutcomesOfEachCheck) {
    const Graded graded;
    browser().open(graded.page);
    const std::string list = text_of("#checks ul");
    for (const char* part : {"2.1 check 13 passed · 1 wrong · 1 unfinished · 1 not graded",
                             "2.1 check 21 passed · 2 wrong · 1 unfinished · 1 not graded",
                             "2.1 check 3 hidden3 passed · 1 unfinished · 1 not graded"})
        EXPECT_TRUE(contains(list, part)) << part << "\n" << list;
    // The width of its bar matches its numbers: 3 of 6 submissions have passed.
    EXPECT_NEAR(double(browser().eval("(() => { const bar = document.querySelector('#checks .bar'); return "
                                      "bar.querySelector('.passed').offsetWidth / bar.offsetWidth; })()")),
                0.5, 0.02);
    EXPECT_TRUE(contains(text_of("#checks p"), "The hardest checks: 2.1 check 2 (1 of 5)")) << text_of("#checks p");
    EXPECT_TRUE(contains(text_of("#mistakes tbody"), "2.1\u00a0truncatedThe hint of truncatedshow 2"));
}

TEST(ClassPage, ReportsTheTimePerStepAndReusedResults) {
    const Graded graded;
    browser().open(graded.page);
    // 8 labs at 0.5, 1 and 0.25 seconds; 7 submissions at 4 seconds each, minus the named parts.
    const std::string time = text_of("#time");
    for (const char* part : {"compiling 14 % (4.0 s)", "drawing 29 % (8.0 s)", "comparing 7 % (2.0 s)",
                             "waiting, reading and recognising known mistakes 50 % (14.0 s)", "took 12.5 seconds, 3.2"})
        EXPECT_TRUE(contains(time, part)) << part << "\n" << time;
    EXPECT_EQ(browser().eval("[...document.querySelectorAll('.numbers div')].map(card => "
                             "[...card.children].map(part => part.textContent).join(': ')).join('; ')"),
              "submissions: 7; median: 4.5 points; not graded: grade again: 1; unchanged, not graded again: 2");
    EXPECT_EQ(text_of("footer"), "Made by ./relief grade. Isolation: namespaces.") << "in small print";
}

TEST(ClassPage, HidesControlsThatNeedScriptsWhenScriptsAreOff) {
    const Graded graded;
    browser().scripts(false);
    browser().open(graded.page);
    EXPECT_EQ(
        browser().eval("[...document.querySelectorAll('#filter, .pick')].filter(one => one.checkVisibility()).length"),
        0);
    EXPECT_EQ(browser().eval("getComputedStyle(document.querySelector('thead button')).pointerEvents"), "none");
    browser().scripts(true);
    browser().open(graded.page);
    EXPECT_EQ(browser().eval("[...document.querySelectorAll('#filter, .pick')].every(one => one.checkVisibility())"),
              true);
}

TEST(ClassPage, DependsOnlyOnTheStoredResults) {
    const grade::ClassReport report = some_class();
    grade::ClassReport read;  // gets the run's own numbers below
    read.taken_over = report.taken_over, read.seconds = report.seconds, read.prepared = report.prepared;
    for (const grade::SubmissionMark& mark : report.marks) read.marks.push_back(grade::from_json(grade::to_json(mark)));
    EXPECT_EQ(pages::class_page(read), pages::class_page(report));
    for (const pages::PageFor reader : {pages::PageFor::instructor, pages::PageFor::student})
        EXPECT_EQ(pages::student_page(read.marks[4], {}, reader), pages::student_page(report.marks[4], {}, reader));
}

TEST(ClassPage, IsSmallWithAThousandSubmissions) {
    grade::ClassReport report;
    const std::vector<grade::SubmissionMark> some = some_class().marks;
    for (int i = 0; i < 1000; ++i) {
        report.marks.push_back(some[size_t(i) % some.size()]);
        report.marks.back().name = "student-" + std::to_string(i);
    }
    const TemporaryFolder folder;
    const std::string page = pages::class_page(report);
    EXPECT_LT(page.size(), 700'000u);
    EXPECT_FALSE(contains(page, "<img"));
    browser().open(folder.write("report.html", page));
    EXPECT_EQ(text_of("#shown"), "1000 of 1000 shown");
    ASSERT_TRUE(browser().tab_to("th:nth-child(1) button"));
    browser().press("Enter", 2);
    EXPECT_EQ(names_shown().at(0), "student-999");
    // The table must not push the rest of the page out of reach.
    EXPECT_LT(int(browser().eval("document.documentElement.scrollHeight")), 4000);
}

// ---- a submission ----

/// Pages of Anna (wrong, with pictures; check 2 is wrong only from a hidden view) and zoe (unfinished), beside the
/// class's page.
struct GradedWithPictures : Graded {
    fs::path student(const std::string& name, pages::PageFor reader = pages::PageFor::instructor) const {
        return page.parent_path() / pages::page_file(name, reader);
    }
    GradedWithPictures() {
        report.marks[2].labs[0].tasks[0] =
            task_verdict("2.1", 3, {wrong, check::Outcome::broken, passed, unfinished}, "truncated");
        report.marks[2].labs[0].tasks[0].checks[1].view = "camera 12.5 7 3";
        for (const pages::PageFor reader : {pages::PageFor::instructor, pages::PageFor::student})
            write_file(student("Anna", reader), pages::student_page(report.marks[2], two_pictures(), reader));
    }
};

TEST(StudentPage, AWipeFollowsTheKeyboard) {
    const GradedWithPictures graded;
    browser().open(graded.student("Anna"));
    const auto clip = [](int which) {
        return browser().eval("getComputedStyle(document.querySelectorAll('.laid img + img')[" + std::to_string(which) +
                              "]).clipPath");
    };
    EXPECT_EQ(clip(0), "inset(0px 100% 0px 0px)") << "first only what was submitted is seen";
    ASSERT_TRUE(browser().tab_to(".wipe input"));
    browser().press("ArrowRight", 10);
    EXPECT_EQ(clip(0), "inset(0px 90% 0px 0px)");
    EXPECT_EQ(clip(1), "inset(0px 100% 0px 0px)") << "each has its own";
    browser().press("End");
    EXPECT_EQ(clip(0), "inset(0px 0% 0px 0px)");
    browser().press("ArrowLeft");
    EXPECT_EQ(clip(0), "inset(0px 1% 0px 0px)");
    EXPECT_EQ(browser().eval("document.activeElement.getAttribute('aria-valuetext')"), "99 % expected");
    EXPECT_EQ(browser().eval("document.activeElement.labels[0].textContent"), "wipe to the expected picture");
    EXPECT_EQ(
        browser().eval("(() => { const [mine, over] = document.querySelectorAll('.laid img'), a = "
                       "mine.getBoundingClientRect(), b = over.getBoundingClientRect(); return a.left == b.left && "
                       "a.top == b.top && a.width == b.width && a.height == b.height && a.width > 100; })()"),
        true)
        << "one lies upon the other";
    EXPECT_EQ(browser().complaints(), Names{});
}

TEST(StudentPage, WithoutScriptsThePicturesLieSideBySide) {
    const GradedWithPictures graded;
    browser().width(1440);  // three columns
    browser().scripts(false);
    browser().open(graded.student("Anna"));
    browser().scripts(true);
    EXPECT_EQ(browser().eval("document.querySelectorAll('input').length"), 0) << "a slider that would do nothing";
    browser().wait_for("[...document.images].every(image => image.complete)");
    EXPECT_EQ(
        browser().eval("(() => { const box = kind => document.querySelector(kind).getBoundingClientRect(), a = "
                       "box('.mine img'), b = box('.expected img'), c = box('.difference img'); return a.right <= "
                       "b.left && b.right <= c.left && a.top == b.top && b.top == c.top; })()"),
        true)
        << browser().eval(
               "JSON.stringify([innerWidth, ...['.mine img', '.expected img', '.difference img'].map(kind => "
               "document.querySelector(kind).getBoundingClientRect())])");
    browser().width(0);
}

TEST(StudentPage, ShowsAllFindingsButPicturesOnlyOfFailedChecks) {
    const GradedWithPictures graded;
    browser().open(graded.student("Anna"));
    EXPECT_EQ(text_of(".hint"), "It looks like a known mistake: truncatedThe hint of truncated");
    const std::string all = text_of("main");
    for (const char* part :
         {"found 1", "rounding", "check 2 hidden view", "found 3", "hidden check", "0.75 of 3 points"})
        EXPECT_TRUE(contains(all, part)) << part;
    EXPECT_FALSE(contains(all, "look here")) << "the hint of a known mistake stands above";
    EXPECT_EQ(browser().eval("document.querySelectorAll('figure').length"), 6);
    EXPECT_EQ(browser().eval("[...document.images].every(image => image.complete && image.naturalWidth == 24)"), true);
    EXPECT_EQ(browser().eval("document.querySelectorAll('.difference .scale').length"), 2);
    EXPECT_EQ(browser().eval("document.querySelector('.kept').querySelectorAll('img').length"), 0);
    EXPECT_EQ(text_of("h1"), "Anna");
    browser().open(graded.student("zoe"));
    const std::string zoe = text_of("main");
    for (const char* part : {"ignored", "<i>notes</i>.txt", "and 2 more", "error: '<vec3>' & more"})
        EXPECT_TRUE(contains(zoe, part)) << part;
    browser().open(graded.student("empty"));
    EXPECT_TRUE(contains(text_of("header"), "there is no task file in it"));
    browser().open(graded.student("machine"));
    EXPECT_TRUE(contains(text_of("header"), "This costs nobody a point"));
}

TEST(StudentPage, ForStudentsRevealsNoHiddenCheckAndHasNoLinks) {
    GradedWithPictures graded;
    // A wrong hidden check: its name, numbers and pictures must not appear, but its outcome and hint do.
    check::TaskVerdict& anna = graded.report.marks[2].labs[0].tasks[0];
    anna.checks[2].outcome = wrong, anna.checks[2].name = "from below", anna.checks[2].look_at = "mind the sign";
    std::vector<grade::CheckPictures> pictures = two_pictures();
    pictures.push_back(pictures[0]);
    pictures[2].check.name = "from below", pictures[2].check.hidden = true, pictures[2].check.reason = "unknown below";
    const auto page = [&](pages::PageFor reader) {
        return pages::student_page(graded.report.marks[2], pictures, reader);
    };
    write_file(graded.student("Anna", pages::PageFor::student), page(pages::PageFor::student));
    browser().open(graded.student("Anna", pages::PageFor::student));
    const std::string all = text_of("main");
    for (const char* part : {"found 1", "rounding", "hidden check", "mind the sign", "check 2",
                             "correct in the view that you know, but not in another one"})
        EXPECT_TRUE(contains(all, part)) << part;
    EXPECT_FALSE(contains(all, "hidden check: passed"));
    EXPECT_EQ(browser().eval("document.querySelectorAll('figure').length"), 3) << "of check 1 alone";
    const std::vector<std::string> secrets = {"camera 12.5",   "found 2",     "found 3",    "from below",
                                              "unknown below", "report.html", "hidden view"};
    for (const std::string& secret : secrets) {
        EXPECT_FALSE(contains(page(pages::PageFor::student), secret)) << secret;
        EXPECT_TRUE(contains(page(pages::PageFor::instructor), secret)) << secret;
    }
    anna.checks[2].outcome = passed;
    EXPECT_TRUE(contains(page(pages::PageFor::student), "hidden check: passed"));
    for (const char* name : {"Anna", "zoe", "machine", "empty"}) {
        browser().open(graded.student(name, pages::PageFor::student));
        EXPECT_EQ(browser().eval("[...document.links].filter(link => link.pathname != location.pathname).length"), 0);
        const std::string text = read_file(graded.student(name, pages::PageFor::student));
        for (const char* other : {"s10", "Anna", "o&#39;d", "zoe"})
            EXPECT_TRUE(other == std::string(name) || !contains(text, other)) << other << " on the page of " << name;
    }
}

TEST(StudentPage, IsWrittenWithoutPicturesThatWereNotKept) {
    const GradedWithPictures graded;
    const std::string before = read_file(graded.student("Anna")), after_head = before.substr(before.find("<main>"));
    fs::remove(graded.student("s9"));
    pages::write_summaries(graded.report, graded.page.parent_path());
    const std::string kept = read_file(graded.student("Anna"));
    EXPECT_EQ(kept.substr(kept.find("<main>")), after_head) << "its pictures are lost";
    browser().open(graded.student("s9"));
    EXPECT_TRUE(contains(text_of("footer"), "The pictures were not stored"));
}

// ---- both ----

TEST(Pages, EscapeHostileNamesAndRunOnlyOurScripts) {
    const TemporaryFolder folder;
    const std::string name =
        "</title><script>document.title = 'ran'</script><img src=x onerror=\"document.title='ran'\">";
    grade::ClassReport report;
    report.marks = {submission(name, {{lab_02, task_verdict("2.1", 3, {wrong, wrong, wrong})}})};
    report.marks[0].problem = name, report.marks[0].ignored = {name}, report.marks[0].ignored_count = 1;
    report.marks[0].labs[0].log = report.marks[0].labs[0].tasks[0].checks[0].found = name;
    report.marks[0].labs[0].tasks[0].mistake = report.marks[0].labs[0].tasks[0].hint = name;
    pages::write_summaries(report, folder.path());
    for (const fs::path& page :
         {folder.path() / "report.html", folder.path() / pages::page_file(name, pages::PageFor::instructor),
          folder.path() / pages::page_file(name, pages::PageFor::student)}) {
        browser().open(page);
        EXPECT_NE(browser().eval("document.title"), "ran");
        EXPECT_EQ(browser().eval("document.images.length"), 0);
        EXPECT_EQ(browser().eval("document.scripts.length"), 1);
        EXPECT_EQ(text_of("bdi"), name);
    }
    // Even if it were markup, the browser must neither run it nor send a request.
    folder.write("closed.mustache", name + "<h1>here</h1>");
    folder.write("ours.js", "document.title += '!'");
    const std::string here = folder.path().string() + "/";
    browser().open(folder.write(
        "closed.html",
        pages::render({.title = "closed", .body = here + "closed", .styles = {}, .scripts = {here + "ours"}}, {})));
    EXPECT_EQ(browser().eval("document.title"), "closed!");
    EXPECT_FALSE(browser().complaints().empty()) << "the picture at 'x' is not refused";
}

TEST(Pages, NameEveryControlResolveEveryLinkAndAreLegibleForEverybody) {
    const GradedWithPictures graded;
    for (const fs::path& page : {graded.page, graded.student("Anna"), graded.student("zoe"), graded.student("s10"),
                                 graded.student("Anna", pages::PageFor::student)}) {
        browser().open(page);
        std::multiset<std::string> named;
        for (const Browser::Control& control : browser().controls()) {
            EXPECT_NE(control.name, "") << page << ": a " << control.role;
            if (control.role == "slider" || control.role == "button") named.insert(control.name);
        }
        EXPECT_EQ(std::set<std::string>(named.begin(), named.end()).size(), named.size()) << "two of one name";
        const std::vector<std::string> links = browser().eval("[...document.links].map(link => link.href)");
        EXPECT_FALSE(links.empty());
        for (const std::string& link : links) {
            const size_t hash = link.find('#');
            std::string file = link.substr(7, hash - 7);
            for (size_t at = 0; (at = file.find("%20", at)) != file.npos;) file.replace(at, 3, " ");
            EXPECT_TRUE(fs::exists(file)) << link;
            if (hash == std::string::npos) continue;
            const std::string end = "document.getElementById(" + json(link.substr(hash + 1)).dump() + ")";
            EXPECT_EQ(browser().eval(end + " != null"), true) << link;
        }
        EXPECT_EQ(browser().faint_texts_in_both(), Names{}) << page;
        EXPECT_EQ(browser().accessibility_faults(), Names{}) << page;
    }
}

TEST(Pages, OfSharedCodeAreLegibleForEverybody) {
    const TemporaryFolder folder;
    const std::string file = "shaders/02_normal_map_storage/task.glsl", text = "float f() {\n    return 1.0;\n}\n";
    grade::OriginalityReport report;
    for (const char* name : {"jane", "joe", "eve"})
        report.authors.push_back({.name = name, .files = {{file, text}}, .problems = {}});
    grade::SharedTask shared{.task = "2.1", .file = file, .bits = 30, .shared = 5, .rare = 3, .sides = {}};
    for (grade::SharedSide& side : shared.sides)
        side = {
            .share = 0.5, .lines = {{1, 2}}, .ranges = {{0, 12, true}, {16, 27, false}}, .pieces = {{0, text.size()}}};
    report.pairs = {{.authors = {0, 1}, .bits = 30, .by_chance = 1e-4, .cluster = 1, .tasks = {shared}}};
    report.tasks = {{.id = "2.1", .title = "Bytes", .texts = 3, .known = 2, .own_tokens = 30},
                    {.id = "2.2", .title = "A pair", .texts = 3, .known = 2, .own_tokens = 9, .is_too_short = true}};
    report.clusters = {{0, 1}};
    report.compared = 3, report.alarm_bits = 25.4, report.below_alarm_bits = 20, report.usual_count = 1;
    browser().open(folder.write("originality.html", pages::originality_page(report)));
    EXPECT_EQ(browser().accessibility_faults(), Names{});
    EXPECT_EQ(browser().faint_texts_in_both(), Names{});
}

TEST(Pages, WithQuestionsAreLegibleForEverybody) {
    const TemporaryFolder folder;
    grade::Question value;
    value.task = "2.1", value.file = "shaders/02_normal_map_storage/task.glsl", value.view = "three bytes and back";
    value.pictures = {sphere(0)};
    value.call.name = "decode_unorm8", value.call.arguments = {"code (0.5, 0.5, 1)"};
    value.mark_is_lost = true;
    value.answer = "(0, 0, 1)", value.drawn_here = value.expected_here = "1", value.found = "mean 3 degrees";
    grade::Question picture = value, line = value;
    picture.kind = grade::QuestionKind::picture, line.kind = grade::QuestionKind::line;
    picture.pictures.assign(4, sphere(0)), line.pictures.assign(2, sphere(0));
    const std::string code = "return vec3(code.xy * 2.0 - 1.0, sqrt(max(0.0, 1.0 - dot(code.xy, code.xy)))); // z";
    picture.changes = {{7, code, code}}, line.changes.assign(4, {7, code, ""});
    const pages::StudentQuestions student{"jane", {value, picture, line}, 5, {"lab 10: has no shader task"}};
    for (const fs::path& page : {folder.write("sheet.html", pages::question_sheet(student)),
                                 folder.write("key.html", pages::question_key({student}))}) {
        browser().open(page);
        EXPECT_EQ(browser().accessibility_faults(), Names{}) << page;
        EXPECT_EQ(browser().faint_texts_in_both(), Names{}) << page;
    }
}

}  // namespace
}  // namespace relief::app
