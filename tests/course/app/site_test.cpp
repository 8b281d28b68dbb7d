// The course's web site made by `relief gallery`, and the page of known mistakes, in a browser.
#include <algorithm>
#include <set>

#include "framework/core/base/file.h"
#include "framework/core/base/text.h"
#include "framework/core/image/compare.h"
#include "framework/core/image/file.h"
#include "framework/course/manifest/manifest.h"
#include "framework/course/pages/template.h"
#include "tests/browser.h"
#include "tests/course/app/course_copy.h"

namespace relief::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Names = std::vector<std::string>;

constexpr const char* lab_10 = "10_parallax_offset";

const Circumstances no_display{{}, {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}}};

/// One copy of the course and one site for all tests, made without a display. It has a deck of lab 01 and a page of
/// measurements. With a sample of labs, the site has these, and those that a test opens.
class Site : public testing::Test {
protected:
    static void SetUpTestSuite() {
        course_ = std::make_unique<CourseCopy>();
        const fs::path build = course_->path() / "build";
        fs::create_directories(build / "slides/01_specular_highlights");
        fs::create_directories(build / "bench");
        course_->overwrite("build/slides/01_specular_highlights.html",
                           "<!doctype html><html lang=en><title>Deck</title><img "
                           "src=\"01_specular_highlights/one.png\" alt=one>");
        course_->overwrite("build/slides/01_specular_highlights.pdf", "%PDF-");
        fs::copy(course_->path() / "labs/01_specular_highlights/golden/wipe.png",
                 build / "slides/01_specular_highlights/one.png");
        course_->overwrite("build/bench/index.html", "<!doctype html><html lang=en><title>Times</title>");
        std::string numbers;
        for (const std::string& lab : files_in(course_->path() / "labs")) {
            const std::string number = lab.substr(0, 2);
            if (!fs::exists(course_->path() / "labs" / lab / "lab.toml")) continue;
            if (!is_in_sample(number) && number != "01" && number != "10" && number != "17") continue;
            numbers += (numbers.empty() ? "" : ",") + number, labs_.push_back(lab);
        }
        std::sort(labs_.begin(), labs_.end());
        made_ = course_->relief({"gallery", "--labs", numbers}, no_display);
    }
    static void TearDownTestSuite() { course_.reset(); }

    static fs::path site() { return course_->path() / "build/gallery"; }
    static Manifest manifest(const std::string& lab) {
        return load_manifest(course_->path() / "labs" / lab / "lab.toml");
    }
    static const Names& labs() { return labs_; }
    static void open(const std::string& page) { browser().open(site() / page); }

    static inline std::unique_ptr<CourseCopy> course_;
    static inline Result made_;
    static inline Names labs_;
};

constexpr const char* wider_than_the_screen =
    "document.scrollingElement.scrollWidth > 360 ? [...document.querySelectorAll('body *')].filter(one => "
    "one.getBoundingClientRect().right > 360).map(one => one.outerHTML.slice(0, 90)) : []";

/// Elements that clip their content and may show a scroll bar.
constexpr const char* scrolls =
    "[...document.querySelectorAll('main *')].filter(one => /auto|scroll/.test(getComputedStyle(one).overflowX + "
    "getComputedStyle(one).overflowY)).map(one => one.outerHTML.slice(0, 90))";

constexpr const char* clipped_formulas =
    "[...document.querySelectorAll('.formulas')].filter(one => one.scrollWidth > one.clientWidth).length";

// A file in the place of its folder stops it before it draws.
TEST(Menu, WithoutADisplayIsTheGallery) {
    const CourseCopy course;
    course.overwrite("build", "");
    const Result menu = course.relief({}, no_display);
    EXPECT_EQ(menu.code, 1);
    EXPECT_TRUE(contains(menu.err, "build/gallery: cannot make this folder")) << menu.err;
}

TEST_F(Site, IsMadeOfFewBytesALab) {
    EXPECT_EQ(made_.code, 0) << made_.err;
    EXPECT_EQ(made_.out, (site() / "index.html").string() + "\n");
    EXPECT_FALSE(contains(made_.err, "has no slides")) << "lab 01 has some";
    for (const std::string& lab : labs()) {
        uintmax_t bytes = 0;
        for (const auto& entry : fs::recursive_directory_iterator(site()))
            if (entry.is_regular_file() && contains(entry.path().lexically_relative(site()).string(), lab))
                bytes += entry.file_size();
        EXPECT_LT(bytes, 8u << 20) << lab;
    }
}

// Follows every link from the first page, on a screen and on a phone, in light and in dark mode. Every target must
// exist.
TEST_F(Site, EveryLinkedPageIsCompleteLegibleAndFitsAPhone) {
    std::vector<fs::path> pages = {site() / "index.html"};
    std::set<fs::path> known(pages.begin(), pages.end());
    std::set<std::pair<fs::path, std::string>> places;  // a page and an id in it
    std::set<std::pair<fs::path, std::string>> ids;
    for (size_t i = 0; i < pages.size(); ++i) {
        const fs::path page = pages[i];
        const bool ours = page.parent_path() == site();
        browser().open(page);
        EXPECT_TRUE(browser().load_images()) << page;
        if (ours) {
            EXPECT_GT(int(browser().eval("document.images.length")) + contains(page.string(), "-handout") +
                          (page.stem() == "accessibility" || page.stem() == "sources"),
                      0)
                << page;
            EXPECT_EQ(browser().eval("[...document.images].filter(image => image.hasAttribute('width') && "
                                     "!image.src.endsWith('.svg') && "
                                     "image.getAttribute('width') != image.naturalWidth).map(image => image.src)"),
                      json::array())
                << page;
            EXPECT_EQ(browser().faint_texts_in_both(), Names{}) << page;
            browser().width(360);
            EXPECT_EQ(Names(browser().eval(wider_than_the_screen)), Names{}) << page;
            EXPECT_EQ(browser().eval(clipped_formulas), 0) << page << " on a phone";
            browser().width(0);
            EXPECT_EQ(browser().eval(clipped_formulas), 0) << page;
            browser().paper(true);
            EXPECT_EQ(browser().eval(scrolls), json::array()) << page << " on paper";
            EXPECT_EQ(browser().eval("[...document.querySelectorAll('.measured pre')].filter(one => "
                                     "!one.checkVisibility({contentVisibilityAuto: true})).length"),
                      0)
                << page << " on paper";
            browser().paper(false);
            for (const Browser::Control& control : browser().controls())
                EXPECT_NE(control.name, "") << page << ": a " << control.role;
        }
        for (const std::string& id : Names(browser().eval("[...document.querySelectorAll('[id]')].map(one => one.id)")))
            EXPECT_TRUE(ids.emplace(page, id).second) << page << " has two of " << id;
        for (const std::string& link : Names(browser().eval("[...document.links].map(link => decodeURI(link.href))"))) {
            if (!link.starts_with("file://")) continue;
            const std::vector<std::string> parts = split(link.substr(7), '#');
            const fs::path to = parts[0];
            EXPECT_TRUE(fs::is_regular_file(to)) << page << " links to " << to;
            EXPECT_TRUE(to.string().starts_with(site().string())) << page << " links to " << to;
            if (parts.size() > 1) places.emplace(to, parts[1]);
            if (to.extension() == ".html" && known.insert(to).second) pages.push_back(to);
        }
        EXPECT_EQ(browser().complaints(), Names{}) << page;
    }
    for (const auto& place : places) EXPECT_TRUE(ids.contains(place)) << place.first << "#" << place.second;
    // The first page, accessibility, the sources, a page and a handout for each lab, a deck, the measurements.
    EXPECT_EQ(pages.size(), 3 + 2 * labs().size() + 2);
    EXPECT_TRUE(fs::exists(site() / "slides/01_specular_highlights.pdf"));
}

TEST_F(Site, TheFirstPageListsEveryLabWithItsPointsAndExistingSlides) {
    open("index.html");
    Names titles, learns;
    int points = 0;
    for (const std::string& lab : labs()) {
        titles.push_back(lab.substr(0, 2) + " " + manifest(lab).title);
        points += manifest(lab).points() + manifest(lab).optional_points();
        for (const std::string& line : manifest(lab).learns) learns.push_back(line);
    }
    EXPECT_EQ(Names(browser().eval("[...document.querySelectorAll('article h3')].map(one => one.textContent)")),
              titles);
    EXPECT_EQ(browser().eval("document.querySelectorAll('section:not(.paths) > h2').length"), 3);
    EXPECT_EQ(browser().eval("document.querySelectorAll('.paths h3').length"), std::getenv("RELIEF_TEST_LABS") ? 0 : 3)
        << "ways through the course, where all labs are there";
    EXPECT_EQ(browser().eval("document.querySelectorAll('.hero img').length"), 1);
    EXPECT_EQ(Names(browser().eval("[...document.querySelectorAll('article li')].map(one => one.textContent)")),
              learns);
    EXPECT_EQ(browser().eval("document.querySelector('.sum').textContent"),
              std::to_string(labs().size()) + "labs" +
                  std::string(browser().eval("document.querySelectorAll('.sum b')[1].textContent")) + "tasks" +
                  std::to_string(points) + "points");
    Names links = {"Begin here: " + titles.front(), "Speed and error", "Where each source is shown"};
    if (!std::getenv("RELIEF_TEST_LABS")) links.emplace_back("Ways through the course");
    EXPECT_EQ(Names(browser().eval("[...document.querySelectorAll('header .links a')].map(link => link.textContent)")),
              links);
    Names decks;
    for (const std::string& lab : labs()) {
        open(lab + ".html");
        for (const std::string& deck : Names(browser().eval("[...document.links].filter(link => link.textContent == "
                                                            "'Slides').map(link => link.getAttribute('href'))")))
            decks.push_back(deck);
    }
    EXPECT_EQ(decks, Names{"slides/01_specular_highlights.html"});
}

TEST_F(Site, CardsTurnTheMethodsOfALabUnlessAReaderWantsThemStill) {
    const char* strip = "document.querySelector('#lab-01 .turning > div')";
    const auto style = [&](const std::string& name) {
        return browser().eval(std::string("getComputedStyle(") + strip + ")." + name);
    };
    open("index.html");
    EXPECT_EQ(
        browser().eval(std::string("[...") + strip + ".querySelectorAll('img')].map(one => one.getAttribute('src'))"),
        (Names{"01_specular_highlights/method-vertex-normal.png", "01_specular_highlights/method-normal-map.png"}))
        << "the pictures of the lab's page";
    EXPECT_EQ(style("animationName"), "frames");
    EXPECT_EQ(style("animationTimingFunction"), "steps(2, jump-none)");
    EXPECT_EQ(style("animationPlayState"), "running");
    ASSERT_TRUE(browser().tab_to(".hold input"));
    browser().press("Space");
    EXPECT_EQ(style("animationPlayState"), "paused");
    browser().call("Emulation.setEmulatedMedia",
                   {{"features", {{{"name", "prefers-reduced-motion"}, {"value", "reduce"}}}}});
    EXPECT_EQ(browser().eval(std::string(strip) + ".checkVisibility()"), false);
    browser().dark(false);
}

TEST_F(Site, OnTheFirstPageACardIsOneTabStopAndALinkSkipsToTheCards) {
    open("index.html");
    EXPECT_EQ(browser().eval("Math.max(...[...document.querySelectorAll('article')].map(card => "
                             "card.querySelectorAll('a, button, [tabindex]').length))"),
              1);
    browser().press("Tab");
    EXPECT_EQ(browser().eval("document.activeElement.textContent"), "Skip to the labs");
    EXPECT_EQ(browser().eval("document.activeElement.getBoundingClientRect().top > 0"), true) << "visible with focus";
    browser().press("Enter");
    browser().press("Tab");
    EXPECT_EQ(browser().eval("document.activeElement.type"), "search");
    browser().press("Tab");
    EXPECT_EQ(browser().eval("document.activeElement.closest('article').id"), "lab-01");
    // A click anywhere on a card opens the lab.
    browser().eval("document.querySelector('article img').scrollIntoView({block: 'center'})");
    EXPECT_EQ(
        browser().eval("(() => { const box = document.querySelector('article img').getBoundingClientRect(); return "
                       "document.elementFromPoint(box.left + box.width / 2, box.top + box.height / 2)"
                       ".getAttribute('href'); })()"),
        "01_specular_highlights.html");
}

TEST_F(Site, TheKeyboardMovesTheWipeBetweenTwoMethods) {
    open(std::string(lab_10) + ".html");
    const auto clip = [] {
        return browser().eval("getComputedStyle(document.querySelector('.laid img + img')).clipPath");
    };
    EXPECT_EQ(clip(), "inset(0px 50% 0px 0px)");
    ASSERT_TRUE(browser().tab_to(".wipe input"));
    browser().press("ArrowRight", 3);
    EXPECT_EQ(clip(), "inset(0px 47% 0px 0px)");
    EXPECT_EQ(browser().eval("document.activeElement.getAttribute('aria-valuetext')"), "53 % offset");
    browser().press("Home");
    EXPECT_EQ(clip(), "inset(0px 100% 0px 0px)") << "only the right method";
    browser().press("End");
    EXPECT_EQ(clip(), "inset(0px 0% 0px 0px)") << "only the left one";
    EXPECT_EQ(browser().complaints(), Names{});
}

TEST_F(Site, BoxesSelectTheMethodsAndASwitchShowsTheErrorMap) {
    open(std::string(lab_10) + ".html");
    const auto shown = [] {
        return Names(
            browser().eval("[...document.querySelectorAll('.laid img')].map(image => "
                           "image.src.replace(/.*\\//, ''))"));
    };
    EXPECT_EQ(shown(), (Names{"method-steep.png", "method-offset.png"})) << "the right one lies below";
    ASSERT_TRUE(browser().tab_to("select"));
    browser().press("ArrowRight");
    EXPECT_EQ(shown(), (Names{"method-steep.png", "method-limited.png"}));
    browser().press("Tab");
    browser().press("ArrowLeft", 2);
    EXPECT_EQ(shown(), (Names{"method-offset.png", "method-limited.png"}));
    EXPECT_EQ(browser().eval("document.querySelector('.stage .scale').checkVisibility()"), false);
    browser().press("Tab");
    browser().press("ArrowRight");
    EXPECT_EQ(shown(), (Names{"method-offset-error.png", "method-limited-error.png"}));
    EXPECT_EQ(browser().eval("document.querySelector('.stage .scale').checkVisibility()"), true);
    const std::string scale = browser().eval("document.querySelector('.stage .scale').textContent");
    EXPECT_TRUE(scale.ends_with(" texels and more")) << scale;
    EXPECT_TRUE(browser().load_images());
    const std::string said = browser().eval("document.querySelector('.sides').textContent");
    EXPECT_TRUE(contains(said, "limited: ") && contains(said, " texels")) << said;
    EXPECT_EQ(browser().complaints(), Names{});
}

TEST_F(Site, WithoutScriptsEveryMethodIsVisibleAndNoControlIs) {
    browser().scripts(false);
    open(std::string(lab_10) + ".html");
    browser().scripts(true);
    EXPECT_EQ(
        browser().eval("[...document.querySelectorAll('input, select')].filter(one => one.checkVisibility()).length"),
        0);
    EXPECT_EQ(
        browser().eval("[...document.querySelectorAll('.methods img')].filter(one => one.checkVisibility()).length"),
        6);
    EXPECT_TRUE(browser().load_images());
}

TEST_F(Site, TheCommandOfALabsPageMeasuresItsLastNumber) {
    int measured = 0;
    for (const std::string& lab : labs()) {
        open(lab + ".html");
        const std::string command = browser().eval("document.querySelector('.all code')?.textContent ?? ''");
        const std::string number = browser().eval(
            "[...document.querySelectorAll('.methods figcaption')].at(-1).lastChild.textContent.trim().split(' ')[0]");
        EXPECT_EQ(command.empty(), number.empty()) << lab;
        if (command.empty()) continue;
        Names words = split(command, ' ');
        words.erase(words.begin());
        words.insert(words.end(), {"-o", "error.pfm"});
        const Result result = course_->relief(words);
        const size_t mean = result.out.find("mean ");
        ASSERT_NE(mean, std::string::npos) << command << ": " << result.out << result.err;
        EXPECT_EQ(rounded(std::stod(result.out.substr(mean + 5))), number) << command;
        ++measured;
    }
    EXPECT_GT(2 * measured, int(labs().size()));
}

TEST_F(Site, AxeFindsNothingOnAPageOfEachKind) {
    for (const char* page : {"index.html", "accessibility.html", "10_parallax_offset.html",
                             "10_parallax_offset-handout.html", "17_time_and_error-handout.html"}) {
        open(page);
        EXPECT_EQ(browser().accessibility_faults(), Names{}) << page;
    }
}

TEST_F(Site, WordsOfAHandoutsPicturesAreLegibleTextAlsoOnAPhone) {
    constexpr const char* smallest =
        "Math.min(...[...document.querySelectorAll('.worded b')].map(word => "
        "parseFloat(getComputedStyle(word).fontSize)))";
    for (const int width : {0, 360}) {
        browser().width(width);
        open("10_parallax_offset-handout.html");
        EXPECT_GT(int(browser().eval("document.querySelectorAll('.worded .tile b').length")), 10);
        EXPECT_GE(double(browser().eval(smallest)), 12) << width;
        EXPECT_EQ(browser().eval("document.querySelector('.worded').innerText.includes('texel')"), true) << width;
    }
    browser().width(0);
}

TEST_F(Site, DrawingsAreDarkOnADarkScreen) {
    for (const auto& [page, drawing] : {std::pair("17_time_and_error-handout.html", ".drawing img"),
                                        {"10_parallax_offset-handout.html", ".drawing svg"}}) {
        open(page);
        const auto filter = [&] {
            return browser().eval("getComputedStyle(document.querySelector('" + std::string(drawing) + "')).filter");
        };
        EXPECT_EQ(filter(), "none") << page;
        browser().dark(true);
        EXPECT_EQ(filter(), "invert(0.88) hue-rotate(180deg)") << page << ": white becomes 0.12";
        browser().dark(false);
    }
}

TEST_F(Site, MethodsDifferAsPicturesAndTheBetterOneInItsErrorMap) {
    for (const std::string& lab : labs()) {
        open(lab + ".html");
        const Names files = browser().eval(
            "[...document.querySelectorAll('.methods .picture')].map(image => "
            "decodeURI(image.src).slice(7))");
        ASSERT_GE(files.size(), 2u) << lab;
        // Not each of them: lab 17's method within a budget of a pixel looks like the exact one.
        const Image last = read_image(files.back());
        EXPECT_TRUE(std::any_of(files.begin(), files.end() - 1, [&](const std::string& file) {
            return difference(read_image(file), last, 8.0 / 255).pixels_over > last.pixel_count() / 200;
        })) << lab;
        const std::optional<CompareInfo> compare = manifest(lab).compare;
        ASSERT_TRUE(compare) << lab;
        EXPECT_EQ(size_t(browser().eval("document.querySelectorAll('.methods .map').length")),
                  compare->shot.probe ? files.size() : 0)
            << lab;
    }
    const auto sum = [](const char* file) {
        double all = 0;
        for (const float value : read_image(site() / lab_10 / file).values) all += value;
        return all;
    };
    EXPECT_GT(sum("method-offset-error.png"), 1.3 * sum("method-steep-error.png")) << "one scale for both";
}

TEST(Quiz, AsksWithoutScriptsAndTellsNothingOfTheEdits) {
    const TemporaryFolder folder;
    const Result made = run({relief_program(), "mistakes", "10", "--quiz", "-o", folder.path().string()});
    ASSERT_EQ(made.code, 0) << made.err;
    const std::string page = read_file(folder.path() / "index.html");
    const Manifest lab = load_manifest(fs::path(source_folder) / "labs" / lab_10 / "lab.toml");
    for (const MistakeInfo& mistake : lab.mistakes) {
        EXPECT_FALSE(contains(page, mistake.id)) << mistake.id;
        for (const Edit& edit : mistake.edits) {
            EXPECT_FALSE(contains(page, pages::html(edit.find))) << mistake.id;
            EXPECT_TRUE(edit.replace.size() < 5 || !contains(page, pages::html(edit.replace))) << mistake.id;
        }
    }
    EXPECT_FALSE(contains(page, "<script"));
    browser().open(folder.path() / "index.html");
    EXPECT_TRUE(browser().load_images());
    const auto count = [](const char* selector) {
        return int(browser().eval("document.querySelectorAll(" + json(selector).dump() + ").length"));
    };
    const int questions = count("article"), pairs = count("article:has(.pair)");
    EXPECT_GE(pairs, 2);
    EXPECT_EQ(questions - pairs, int(lab.questions.size()));
    EXPECT_GE(lab.questions.size(), 1u) << "at which angle one tap goes wrong";
    EXPECT_EQ(count("article li"), 4 * questions);
    EXPECT_EQ(count("article img"), (2 + 3) * pairs);
    EXPECT_EQ(count("details[open]"), 0);
    EXPECT_EQ(
        browser().eval("[...document.querySelectorAll('article')].every(one => {"
                       " const yes = one.querySelectorAll('.yes'), letter = yes[0].closest('li').querySelector('b');"
                       " const shown = one.querySelectorAll('.pair img')[1];"
                       " return yes.length == 1 && one.querySelectorAll('.no').length == 3 &&"
                       "   (!shown || shown.src.endsWith(`-${letter.textContent}.png`)); })"),
        true)
        << "one hint is the picture's";
}

/// The page of lab 02's mistakes.
class MistakesPage : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder_ = std::make_unique<TemporaryFolder>();
        made_ = run({relief_program(), "mistakes", "2", "-o", folder_->path().string()});
    }
    static void TearDownTestSuite() { folder_.reset(); }
    void SetUp() override {
        ASSERT_EQ(made_.code, 0) << made_.err;
        for (const MistakeInfo& mistake :
             load_manifest(fs::path(source_folder) / "labs/02_normal_map_storage/lab.toml").mistakes)
            ids_.push_back(mistake.id);
        std::sort(ids_.begin(), ids_.end());
        open();
    }
    static void open(const std::string& place = "") {
        browser().open_address("about:blank");  // a change of the place alone loads nothing
        browser().open_address("file://" + (folder_->path() / "index.html").string() + place);
    }
    static Names texts(const std::string& selector) {
        Names found = browser().eval("[...document.querySelectorAll(" + json(selector).dump() +
                                     ")].filter(one => one.checkVisibility()).map(one => one.textContent)");
        std::sort(found.begin(), found.end());
        return found;
    }

    Names ids_;

private:
    static inline std::unique_ptr<TemporaryFolder> folder_;
    static inline Result made_;
};

TEST_F(MistakesPage, StartsWithAPictureOfEachMistakeAndLoadsThoseInView) {
    EXPECT_EQ(texts(".index a b"), ids_);
    EXPECT_EQ(texts("article h2 code"), Names{});
    EXPECT_EQ(browser().eval("document.querySelectorAll('.index img').length"), json(ids_.size()));
    EXPECT_EQ(browser().eval("document.querySelectorAll('img:not([loading=lazy])').length"), 0);
    EXPECT_EQ(browser().eval("[...document.querySelectorAll('.difference img')].filter(one => one.complete).length"), 0)
        << "nothing shows them";
    EXPECT_LT(int(browser().eval("document.documentElement.scrollHeight")), 3000);
}

TEST_F(MistakesPage, ShowsOneMistakeAScreen) {
    browser().call("Emulation.setDeviceMetricsOverride",
                   {{"width", 1440}, {"height", 900}, {"deviceScaleFactor", 1}, {"mobile", false}});
    for (const std::string& id : ids_) {
        open("#02-" + id);
        EXPECT_EQ(texts("article h2 code"), Names{id});
        EXPECT_EQ(texts(".index a b"), Names{});
        EXPECT_LE(int(browser().eval("document.documentElement.scrollHeight")), 900) << id;
    }
    browser().width(0);
}

TEST_F(MistakesPage, LinksAndArrowsGoToTheNeighbours) {
    open("#02-times-256");
    EXPECT_EQ(texts("article [rel]"), (Names{"Next →", "← Previous"}));
    browser().press("ArrowRight");
    EXPECT_EQ(texts("article h2 code"), Names{"decoded-without-shift"});
    ASSERT_TRUE(browser().tab_to("article:target .wipe input"));
    browser().press("ArrowRight");
    EXPECT_EQ(texts("article h2 code"), Names{"decoded-without-shift"}) << "the wipe keeps its keys";
    EXPECT_EQ(browser().eval("document.activeElement.value"), "1");
    browser().press("End");
    EXPECT_EQ(browser().eval("document.activeElement.getAttribute('aria-valuetext')"), "100 % expected");
    open("#02-decoded-without-shift");
    browser().press("ArrowLeft", 2);
    EXPECT_EQ(texts("article h2 code"), Names{"truncated"});
    EXPECT_EQ(texts("article [rel]"), Names{"Next →"});
    browser().eval("document.querySelector('article:target [href=\"#lab-02\"]').click()");
    EXPECT_EQ(texts(".index a b"), ids_);
}

TEST_F(MistakesPage, WorksWithoutScripts) {
    browser().scripts(false);
    open();
    EXPECT_EQ(texts(".index a b"), ids_);
    EXPECT_EQ(texts(".filter label"), Names{});
    open("#02-truncated");
    EXPECT_EQ(texts("article h2 code"), Names{"truncated"});
    browser().scripts(true);
}

TEST_F(MistakesPage, ShowsEveryMistakeBesideTheSolution) {
    EXPECT_TRUE(browser().load_images());
    // Both pictures are stacked, and they differ visibly.
    const Names files = browser().eval(
        "[...document.querySelectorAll('article')].map(one => [...one.querySelectorAll("
        "'.laid img')].map(image => decodeURI(image.src).slice(7))).flat()");
    ASSERT_EQ(files.size(), 2 * ids_.size());
    for (size_t i = 0; i < files.size(); i += 2)
        EXPECT_GT(difference(read_image(files[i]), read_image(files[i + 1]), 8.0 / 255).pixels_over, 30u) << files[i];
    const Names maps = browser().eval(
        "[...document.querySelectorAll('article figure.difference img')].map(image => decodeURI(image.src).slice(7))");
    EXPECT_EQ(maps.size(), ids_.size());
    for (const std::string& map : maps) {
        const Image picture = read_image(map);
        EXPECT_GT(*std::max_element(picture.values.begin(), picture.values.end()), 0.5)
            << map << " shows no difference";
    }
    EXPECT_EQ(browser().eval("document.querySelectorAll('.badge:not(.passed)').length"), json(ids_.size()));
    EXPECT_EQ(browser().eval("document.querySelectorAll('details[open]').length"), 0) << "edits are folded away";
    browser().paper(true);
    EXPECT_EQ(texts("article h2 code"), ids_);
    EXPECT_LT(
        int(browser().eval("Math.max(...[...document.querySelectorAll('article')].map(one => one.offsetHeight))")), 480)
        << "two mistakes on a sheet, each of them whole";
    browser().paper(false);
}

TEST_F(MistakesPage, IsFilteredByWords) {
    ASSERT_TRUE(browser().tab_to("input[type=search]"));
    browser().type("truncated 2.1");
    EXPECT_EQ(browser().eval("document.querySelector('output').textContent"),
              "1 of " + std::to_string(ids_.size()) + " shown");
    EXPECT_EQ(texts(".index a b"), Names{"truncated"});
}

TEST_F(MistakesPage, IsLegibleForEverybody) {
    for (const char* place : {"", "#lab-02", "#02-truncated"}) {
        open(place);
        for (const Browser::Control& control : browser().controls()) EXPECT_NE(control.name, "") << control.role;
        EXPECT_EQ(browser().faint_texts_in_both(), Names{}) << place;
        browser().width(360);
        EXPECT_EQ(Names(browser().eval(wider_than_the_screen)), Names{}) << place;
        browser().width(0);
        EXPECT_EQ(browser().complaints(), Names{}) << place;
        EXPECT_EQ(browser().accessibility_faults(), Names{}) << place;
    }
}

}  // namespace
}  // namespace relief::app
