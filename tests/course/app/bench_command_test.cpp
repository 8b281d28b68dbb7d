// relief bench from the command line, and its page in a browser.
#include <algorithm>
#include <csignal>
#include <random>
#include <thread>

#include "framework/core/base/file.h"
#include "framework/core/image/file.h"
#include "framework/course/pages/page.h"
#include "framework/staff/pages/bench_page.h"
#include "tests/browser.h"
#include "tests/course/app/course_copy.h"

namespace relief::app {
namespace {

class BenchCommand : public testing::Test {
protected:
    static void SetUpTestSuite() { course_ = std::make_unique<CourseCopy>(); }
    static void TearDownTestSuite() { course_.reset(); }
    static const CourseCopy& course() { return *course_; }

private:
    static inline std::unique_ptr<CourseCopy> course_;
};

TEST_F(BenchCommand, BenchWritesATableACsvAPlotAndAPage) {
    const Result result = course().relief({"bench", "storage", "--quick", "--repeats", "1", "-o", "measured"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_TRUE(contains(result.out, "oct8-precise")) << result.out;
    const auto folder = course().path() / "measured";
    const std::string csv = read_all(folder / "storage.csv");
    EXPECT_TRUE(csv.starts_with("topic,scene,method,")) << csv;
    EXPECT_EQ(occurrences(csv, "\n"), 1u + 34u)
        << "a header, encoding and decoding of 13 formats and of what is usual, 6 maps";
    EXPECT_TRUE(contains(read_all(folder / "storage.svg"), "</svg>"));
    EXPECT_TRUE(contains(read_all(folder / "index.html"), "</html>"));
}

TEST_F(BenchCommand, ALabStandsForItsTopicsOfWhichOnlyTheRequestedKnobValuesAreMeasured) {
    const Result result = course().relief(
        {"bench", "02", "--quick", "--repeats", "1", "-o", "lab", "--set", "do=decode", "--set", "bits=16,48"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(occurrences(read_all(course().path() / "lab" / "storage.csv"), "\n"), 1u + 4u);
}

TEST_F(BenchCommand, ASweepHasASentenceForEachMethodACurveAndNoTime) {
    const Result result = course().relief({"bench", "stability", "-o", "sweep", "--set", "input=angle-of-two-vectors"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_TRUE(contains(result.out, "keeps 0.1 shares for all inputs of this sweep")) << result.out;
    EXPECT_TRUE(contains(result.out, "not finite from 10000 on. Rounding makes")) << result.out;
    const auto folder = course().path() / "sweep";
    const std::string csv = read_all(folder / "stability.csv"), page = read_all(folder / "index.html");
    EXPECT_TRUE(contains(csv, "1000000:not-finite")) << csv;
    EXPECT_TRUE(contains(read_all(folder / "stability.svg"), "class=\"point\" data-row=\"3\""));
    EXPECT_TRUE(contains(page, "<ul class=\"verdicts\">") && contains(page, "<b>acos-of-dot</b>"));
    EXPECT_FALSE(contains(page, "wall clock")) << "nothing is timed";
}

TEST_F(BenchCommand, RefusesWrongUseInOneLine) {
    const auto bench = [](std::vector<std::string> words) {
        words.insert(words.begin(), "bench");
        return course().relief(words);
    };
    expect_refused(bench, {{{"04"}, "no topic is about lab 04 alone"},
                           {{"tangent"}, "did you mean 'tangents'"},
                           {{"--repeats", "9"}, "from 10 to 1000"},
                           {{"--size", "512x512"}, "--size takes a whole number from 64 to 4096, not '512x512'"},
                           {{"--quick", "--repeats", "0"}, "from 1 to 1000"},
                           {{"parallax", "--set", "map=brick"}, "choose from bricks, stones, posts"},
                           {{"parallax", "--set", "maps=bricks"}, "did you mean 'map'"},
                           {{"parallax", "--set", "bricks"}, "knob=value"},
                           {{"--update"}, "--work"},
                           {{"storage", "--work", "--update"}, "the whole baseline"}});
}

TEST_F(BenchCommand, AKilledSweepLeavesAReadableTable) {
    const auto csv = course().path() / "killed" / "parallax.csv";
    {
        Process sweep({(course().path() / "bin/relief").string(), "bench", "parallax", "--quick", "--repeats", "1000",
                       "-o", csv.parent_path().string()});
        for (int i = 0; i < 600 && sweep.running(); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
            if (std::filesystem::exists(csv) && contains(read_all(csv), "measured")) break;
        }
        ASSERT_TRUE(sweep.running()) << sweep.wait().err;
        sweep.signal(SIGKILL);
        sweep.wait();
    }
    const std::vector<measure::BenchRow> rows = measure::read_bench_csv(read_all(csv));
    ASSERT_EQ(rows.size(), 2u * 22u) << "those that are still open have their lines, too";
    size_t measured = 0;
    for (const measure::BenchRow& row : rows) measured += row.is_measured();
    EXPECT_GT(measured, 0u);
    EXPECT_LT(measured, rows.size());
}

TEST_F(BenchCommand, FailsWhenTheErrorExceedsTheBaseline) {
    // The topic storage has only errors. With a smaller error in the file, the run must fail with a message.
    const auto file = course().path() / "tests/staff/measure/baseline.csv";
    make_folder(file.parent_path());
    const std::string baseline = read_all(std::filesystem::path(source_folder) / "tests/staff/measure/baseline.csv");
    write_file(file, baseline);
    const Result same = course().relief({"bench", "storage", "--work"});
    EXPECT_EQ(same.code, 0) << same.err;
    std::vector<measure::BenchRow> rows = measure::read_bench_csv(baseline);
    for (measure::BenchRow& row : rows)
        if (row.topic == "storage" && row.method == "oct8") row.error.mean *= 0.9;
    write_file(file, measure::bench_csv(rows, {}));
    const Result grown = course().relief({"bench", "storage", "--work"});
    EXPECT_EQ(grown.code, 1);
    EXPECT_TRUE(contains(grown.err, "storage, do=encode, oct8, bits=16: mean error")) << grown.err;
    write_file(file, "nonsense\n");
    const Result broken = course().relief({"bench", "storage", "--work"});
    EXPECT_EQ(broken.code, 1);
    EXPECT_TRUE(contains(broken.err, "baseline.csv:1: ")) << broken.err;
}

TEST_F(BenchCommand, StartTimesShotsAndTheirPhases) {
    if (!RELIEF_HAS_FLOOR) GTEST_SKIP() << "the hand-written program is not built without OSMesa's header";
    const auto folder = course().path() / "started";
    const Result result = run({relief_program(), "bench", "start", "--quick", "--repeats", "1", "-o", folder.string()});
    EXPECT_EQ(result.code, 0) << result.err;
    const auto rows = measure::read_bench_csv(read_all(folder / "start.csv"));
    ASSERT_EQ(rows.size(), 6u) << "two floors and a shot for each of PNG and PPM";
    for (const measure::BenchRow& row : rows) {
        EXPECT_TRUE(row.is_measured()) << row.state;
        EXPECT_EQ(row.work.size(), row.method == "shot" ? 9u : 0u);
        for (const auto& [phase, milliseconds] : row.work) EXPECT_GE(milliseconds, 0) << phase;
    }
}

TEST_F(BenchCommand, StartMeasuresShotsWhereTheTestsAreNotBuilt) {
    const Result result = course().relief({"bench", "start", "--quick", "--repeats", "1", "-o", "alone"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_TRUE(contains(result.err, "floor-png: it is built with the tests")) << result.err;
    const auto rows = measure::read_bench_csv(read_all(course().path() / "alone/start.csv"));
    ASSERT_EQ(rows.size(), 2u) << "a shot for each of PNG and PPM";
    for (const measure::BenchRow& row : rows) EXPECT_TRUE(row.is_measured()) << row.state;
}

TEST_F(BenchCommand, StartReportsWhyAShotFailsButNotItsEvents) {
    const CourseCopy broken;
    broken.overwrite("shaders/01_specular_highlights/task.glsl", "nonsense\n");
    const Result result = broken.relief({"bench", "start", "--quick", "--repeats", "1", "-o", "failed"});
    EXPECT_EQ(result.code, 1);
    for (const measure::BenchRow& row : measure::read_bench_csv(read_all(broken.path() / "failed/start.csv"))) {
        EXPECT_TRUE(contains(row.state, "shaders/01_specular_highlights/task.glsl:1: ")) << row.state;
        EXPECT_FALSE(contains(row.state, " ms] ")) << row.state;
    }
}

TEST_F(BenchCommand, ThePageKeepsTheTopicsOfEarlierRunsAndReplacesMeasuredOnes) {
    const auto bench = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"bench", "--quick", "--repeats", "1", "-o", "kept"});
        EXPECT_EQ(course().relief(more).code, 0);
        return read_all(course().path() / "kept/index.html");
    };
    const auto section = [](const std::string& page, const std::string& topic) {
        const size_t at = page.find("<section id=\"" + topic + "\"");
        return page.substr(at, page.find("</section>", at) - at);
    };
    const std::string first = bench({"storage", "--set", "bits=16"});
    bench({"start"});
    const std::string last = bench({"start"});
    EXPECT_EQ(section(last, "storage"), section(first, "storage"));
    for (const char* topic : {"storage", "start"}) {
        EXPECT_EQ(occurrences(last, std::string("<section id=\"") + topic + "\""), 1u) << topic;
        EXPECT_EQ(occurrences(last, std::string("<li><a href=\"#") + topic + "\""), 1u) << topic;
    }
}

// ---- the page ----

/// A topic of two scenes. One has four methods with a picture and an error map each. The other has only times, and one
/// of its methods has crashed.
struct Page {
    TemporaryFolder folder;
    std::filesystem::path file = folder.path() / "index.html";
    const measure::BenchTopic topic{"parallax", "searches & more", "question?", {}};

    explicit Page(bool is_quick = false) {
        pages::TopicResult result;
        result.topic = &topic;
        result.machine = {.cpu = "<b>CPU</b>", .renderer = "llvmpipe", .is_quick = is_quick};
        for (const auto& [method, time, error] :
             {std::tuple{"quick", 1e6, 1.}, {"good", 4e6, 0.01}, {"dominated", 5e6, 0.5}, {"<exact>", 9e6, 0.}}) {
            measure::BenchRow& row = result.rows.emplace_back();
            row.topic = "parallax", row.scene = {{"map", "bricks"}}, row.method = method, row.item = "frame";
            row.state = "measured", row.times = {time, time * 0.9, time * 1.2}, row.repeats = 10;
            row.error = {error, error, error, "texel", 0.25}, row.work = {{"taps", time / 1e6}, {"draws", 1}};
            row.picture = Image(8, 8, 3, 8), row.error_map = Image(8, 8, 3, 8), row.error_map_max = 4;
        }
        for (const char* state : {"measured", "crashed: Segmentation fault"}) {
            measure::BenchRow row = result.rows.back();
            row.scene = {{"map", "posts"}}, row.method = "windows", row.state = state, row.error = {};
            row.picture = row.error_map = {}, row.repeats = row.is_measured() ? 10 : 0;
            result.rows.push_back(row);
        }
        EXPECT_TRUE(pages::draw_plots(result));
        const auto put = [&](const std::string& name, const Image& picture) {
            pages::write_beside_page(file.parent_path() / name, encode_image(picture, ImageFormat::png));
        };
        write_file(file, pages::bench_page(std::vector{std::move(result)}, put));
    }
};

/// Topics of many methods with close points, with long and short names, and with times without errors.
struct CrowdedPage {
    TemporaryFolder folder;
    std::filesystem::path file = folder.path() / "index.html";

    CrowdedPage() {
        std::vector<measure::BenchTopic> topics;
        for (const char* name : {"storage", "tangents", "normals", "parallax"})
            topics.push_back({name, "searches", std::string("Which ") + name + "?", {}});
        std::vector<pages::TopicResult> results;
        std::mt19937 random(7);
        std::uniform_real_distribution<double> share(0, 1);
        for (const measure::BenchTopic& topic : topics) {
            pages::TopicResult& result = results.emplace_back();
            result.topic = &topic, result.machine = {.cpu = "CPU", .renderer = "llvmpipe"};
            for (int i = 0; i < 40; ++i) {
                measure::BenchRow& row = result.rows.emplace_back();
                const char* const names[] = {"oct16", "oct16-precise", "xyz8", "mikktspace-by-angle", "a"};
                row.topic = topic.name, row.method = names[i % 5], row.knobs = {{"bits", std::to_string(i)}};
                row.item = "normal", row.state = "measured", row.peer = i % 3 == 0, row.repeats = 10;
                const double time = 1e6 * std::pow(20, share(random));
                row.times = {time, time * 0.95, time * 1.05};
                const double error = std::pow(10, -2 * share(random));
                if (i % 8 != 3) row.error = {error, error, error, "degree", {}};
            }
            EXPECT_TRUE(pages::draw_plots(result));
        }
        write_file(file, pages::bench_page(results, {}));
    }
};

std::string words() { return browser().eval("document.querySelector('#look p').textContent"); }
const char* const is_shown = "!document.getElementById('look').hidden";

TEST(BenchPage, LabelsOverlapNeitherLabelsNorBarsInWideOrNarrowPlots) {
    const CrowdedPage page;
    browser().open(page.file);
    browser().eval("document.querySelectorAll('details').forEach(one => { one.open = true; })");
    for (const int width : {1440, 390}) {
        browser().width(width);
        // Among all words in a visible plot, finds pairs that overlap by more than the edge of a letter, and words over
        // a level line: the bar of a point, or a step of the front. A pale line joins the points of a method.
        const nlohmann::json found = browser().eval(R"js((() => {
            const overlaps = [];
            let names = 0, bars = 0;
            for (const plot of document.querySelectorAll('figure svg')) {
                const boxes = [...plot.querySelectorAll('text')].filter(text => text.textContent.trim())
                    .map(text => [text.textContent.trim(), text.getBoundingClientRect()]).filter(one => one[1].width > 0);
                names += boxes.filter(one => one[0].startsWith('oct16')).length;
                if (boxes.length) names += plot.parentElement.querySelectorAll('.key li').length;
                boxes.forEach(([one, a], i) => boxes.slice(0, i).forEach(([other, b]) => {
                    if (Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1 &&
                        Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 3) overlaps.push(one + ' on ' + other);
                }));
                for (const path of plot.querySelectorAll('g[id*=_plot_] path:not([stroke="rgb(221, 215, 203)"])')) {
                    const lines = path.getAttribute('d').matchAll(/M([\d.]+),([\d.]+)\s+L([\d.]+),([\d.]+)/g);
                    for (const [x1, y1, x2, y2] of [...lines].map(one => one.slice(1))) {
                        if (y1 != y2 || !boxes.length) continue;
                        ++bars;
                        const [a, b] = [x1, x2].map(x => new DOMPoint(x, y1).matrixTransform(path.getScreenCTM()));
                        for (const [one, box] of boxes) {
                            const rim = 0.25 * (box.bottom - box.top);  // a line is higher than its letters
                            if (a.x < box.right && box.left < b.x && a.y < box.bottom - rim && box.top + rim < a.y)
                                overlaps.push(one + ' on a bar');
                        }
                    }
                }
            }
            return {overlaps, names, bars};
        })())js");
        EXPECT_EQ(found.at("overlaps"), nlohmann::json::array()) << width;
        EXPECT_GT(found.at("bars"), 20) << width;
        EXPECT_GT(found.at("names"), 10) << width << ": the claim is empty when no point has its name";
    }
    browser().width(0);
}

TEST(BenchPage, ShowsThePicturesBehindAPointAndBehindItsLine) {
    const Page page;
    browser().open(page.file);
    EXPECT_EQ(browser().eval("document.querySelectorAll('.broad .point').length"), 5) << "what has crashed has none";
    EXPECT_EQ(browser().eval(is_shown), false);
    browser().eval("document.querySelector('.point[data-row=\"1\"]').dispatchEvent(new MouseEvent('mouseenter')), 0");
    EXPECT_EQ(browser().eval(is_shown), true);
    EXPECT_EQ(browser().eval("document.querySelectorAll('#look img').length"), 2);
    EXPECT_TRUE(contains(words(), "good"));
    EXPECT_EQ(browser().eval("document.querySelectorAll('tr.chosen').length"), 1);
    // With the keyboard, from the table.
    browser().eval("document.querySelector('section details').open = true");
    ASSERT_TRUE(browser().tab_to("tr[data-row=\"3\"]"));
    browser().press("Enter");
    EXPECT_TRUE(contains(words(), "<exact>"));
    browser().press("Escape");
    EXPECT_EQ(browser().eval(is_shown), false);
    EXPECT_TRUE(browser().complaints().empty());
}

TEST(BenchPage, APlotIsOneTabStopAndArrowsGoFromPointToPoint) {
    const Page page;
    browser().open(page.file);
    ASSERT_TRUE(browser().tab_to("figure .point"));
    EXPECT_EQ(browser().eval(is_shown), true);
    const std::string first = words();
    browser().press("ArrowRight");
    EXPECT_NE(words(), first);
    EXPECT_EQ(browser().eval("document.activeElement.getAttribute('aria-label') == "
                             "document.activeElement.querySelector('title').textContent"),
              true);
    browser().press("Tab");
    EXPECT_EQ(browser().eval("document.activeElement.matches('.point')"), false);
}

TEST(BenchPage, PlotsHaveLettersOf14PixelsOnScreensAndPhones) {
    const Page one;
    const CrowdedPage many;
    for (const std::filesystem::path& page : {one.file, many.file})
        for (const int width : {1440, 1024, 768, 390}) {
            browser().open(page);
            browser().width(width);
            browser().eval("document.querySelectorAll('details').forEach(one => { one.open = true; })");
            const nlohmann::json sizes = browser().eval(R"((() => {
                const words = [...document.querySelectorAll('figure svg text')]
                    .filter(one => one.textContent.trim() && one.getBoundingClientRect().width > 0);
                return words.map(one => Math.hypot(one.getScreenCTM().a, one.getScreenCTM().b) *
                    parseFloat(getComputedStyle(one).fontSize));
            })())");
            ASSERT_GT(sizes.size(), 20u) << width;
            EXPECT_GE(*std::min_element(sizes.begin(), sizes.end()), 13.99) << width;
            browser().width(0);
        }
}

TEST(BenchPage, SaysThatARunWasQuickInThePlotItself) {
    const Page slow(false), quick(true);
    for (const Page* page : {&slow, &quick}) {
        browser().open(page->file);
        EXPECT_EQ(browser().eval("document.querySelectorAll('.broad, .narrow').length"), 4);
        EXPECT_EQ(browser().eval("[...document.querySelectorAll('.broad, .narrow')].filter(one => "
                                 "one.textContent.includes('quick run')).length"),
                  page == &quick ? 4 : 0);
    }
}

TEST(BenchPage, NarrowPlotsHaveNumbersWithAKeyBelow) {
    const Page one;
    const CrowdedPage many;
    for (const std::filesystem::path& page : {one.file, many.file}) {
        browser().open(page);
        const nlohmann::json keys = browser().eval(R"([...document.querySelectorAll('.narrow:has(.key)')].map(plot => {
            const words = [...plot.querySelectorAll('svg text')].map(text => text.textContent.trim());
            const names = [...plot.querySelectorAll('.key li')].map(name => name.textContent.trim());
            return {numbered: words.includes('1'), named: names.filter(name =>
                words.includes(name)).length};
        }))");
        ASSERT_FALSE(keys.empty());
        for (const nlohmann::json& key : keys) {
            EXPECT_TRUE(key["numbered"]) << page;
            EXPECT_EQ(key["named"], 0) << "the plot itself has no names: " << page;
        }
    }
}

TEST(BenchPage, MarksTheFrontListsSharedValuesAndReportsFailures) {
    const Page page;
    browser().open(page.file);
    EXPECT_EQ(browser().eval("[...document.querySelectorAll('tr.front td:first-child')].map(e => e.textContent)"),
              (nlohmann::json{"quick", "good", "<exact>"}));
    const std::string text = browser().eval("document.body.textContent");
    EXPECT_TRUE(contains(text, "All: 1 draws"));
    EXPECT_TRUE(contains(text, "crashed: Segmentation fault"));
    EXPECT_TRUE(contains(text, "<b>CPU</b>"));
    EXPECT_EQ(browser().eval("[...document.querySelectorAll('[id]')].map(e => e.id).filter((id, i, all) => "
                             "all.indexOf(id) !== i).length"),
              0)
        << "names are there once";
}

TEST(BenchPage, HasEnoughContrastAndNoAxeFaults) {
    const Page one;
    const CrowdedPage many;
    for (const std::filesystem::path& page : {one.file, many.file}) {
        browser().open(page);
        EXPECT_EQ(browser().accessibility_faults(), std::vector<std::string>{});
        const auto follows_the_scheme = [](bool is_dark) {
            EXPECT_EQ(browser().eval("getComputedStyle(document.querySelector('figure svg')).filter == 'none'"),
                      !is_dark)
                << "plots follow the scheme";
        };
        EXPECT_EQ(browser().faint_texts_in_both(follows_the_scheme), std::vector<std::string>{});
    }
}

TEST(BenchPage, FitsTheWidthOfAPhone) {
    const Page page;
    browser().open(page.file);
    browser().call("Emulation.setDeviceMetricsOverride",
                   {{"width", 380}, {"height", 800}, {"deviceScaleFactor", 1}, {"mobile", true}});
    EXPECT_LE(browser().eval("document.documentElement.scrollWidth").get<int>(), 380) << "tables scroll by themselves";
    browser().call("Emulation.clearDeviceMetricsOverride");
}

}  // namespace
}  // namespace relief::app
