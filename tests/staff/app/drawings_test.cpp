// The drawings of handouts and decks in a browser: no letter is cut or too small. Those that move compute what the
// labs' exact values do, and stand still without their script and on paper.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/course/manifest/manifest.h"
#include "framework/course/pages/handout_page.h"
#include "framework/course/pages/svg.h"
#include "framework/course/web/tessellator.h"
#include "framework/staff/reference/parallax.h"
#include "tests/browser.h"

namespace relief {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Names = std::vector<std::string>;

std::vector<double> numbers_after(const std::string& text, std::string_view begin) {
    std::vector<double> numbers;
    for (size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1))
        numbers.push_back(std::strtod(text.c_str() + at + begin.size(), nullptr));
    return numbers;
}

TEST(Drawings, LettersHave18PointsAtTheirShownSize) {
    int drawings = 0;
    for (const auto& deck : fs::directory_iterator(course_root() / "slides")) {
        if (deck.path().extension() != ".md") continue;
        for (const std::string& line : split(read_file(deck.path()), '\n')) {
            const size_t file = line.find("](diagrams/");
            if (file == std::string::npos) continue;
            ++drawings;
            const std::string svg = line.substr(file + 2, line.find(')', file) - file - 2);
            const std::string drawing = read_file(course_root() / "assets" / svg);
            const std::vector<double> sizes = numbers_after(drawing, "font-size=\""),
                                      shown = numbers_after(line, "![w:"),
                                      width = numbers_after(drawing, "viewBox=\"0 0 ");
            ASSERT_TRUE(!sizes.empty() && !shown.empty() && !width.empty()) << deck.path() << ": " << svg;
            const double least = *std::min_element(sizes.begin(), sizes.end());
            EXPECT_GE(least * shown[0] / width[0], 23.9) << deck.path() << ": " << svg;  // 24 px are 18 pt
        }
    }
    EXPECT_GT(drawings, 40);
}

/// A function that returns the texts of a drawing that leave it or meet, one line each.
constexpr const char* bad_texts = R"js(const badTexts = svg => {
  const paper = svg.viewBox.baseVal, back = svg.getScreenCTM().inverse(), found = [];
  const texts = [...svg.querySelectorAll('text')].map(element => {
    const box = element.getBoundingClientRect();
    const low = new DOMPoint(box.left, box.top).matrixTransform(back), high = new DOMPoint(box.right, box.bottom).matrixTransform(back);
    const rim = 0.2 * (high.y - low.y);  // a line is higher than its letters
    return { words: element.textContent, left: low.x, right: high.x, top: low.y + rim, bottom: high.y - rim };
  });
  texts.forEach((a, i) => {
    if (a.left < 1 || a.top < 0 || a.right > paper.width - 1 || a.bottom > paper.height) found.push('outside: ' + a.words);
    for (const b of texts.slice(0, i))
      if (a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom) found.push(a.words + ' meets ' + b.words);
  });
  return found;
};)js";

/// Returns the value of a JavaScript expression that may call badTexts().
json with_bad_texts(const std::string& expression) {
    return browser().eval(std::string("(() => {") + bad_texts + "return " + expression + "; })()");
}

TEST(Drawings, TextsAreInsideThemAndApart) {
    for (const auto& entry : fs::directory_iterator(course_root() / "assets/diagrams")) {
        browser().open(entry.path());
        EXPECT_EQ(Names(with_bad_texts("badTexts(document.documentElement)")), Names{}) << entry.path();
    }
    const TemporaryFolder folder;
    folder.write("bad.svg",
                 "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 50' font-size='20'>"
                 "<text x='80' y='30'>outside</text><text x='10' y='30'>a b</text><text x='20' y='30'>c</text></svg>");
    browser().open(folder.path() / "bad.svg");
    EXPECT_EQ(Names(with_bad_texts("badTexts(document.documentElement)")), (Names{"outside: outside", "c meets a b"}));
}

/// The handouts of the labs with drawings that move, as pages.
class MovingDrawings : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder_ = std::make_unique<TemporaryFolder>();
        std::vector<const LabEntry*> labs;
        for (const int number : {5, 10, 11, 13}) labs.push_back(&find_lab(std::to_string(number)));
        for (const LabEntry* lab : labs) {
            const auto put = [](const std::string& name, const std::string& bytes) { folder_->write(name, bytes); };
            put(pages::handout_file(*lab), pages::handout_page(*lab, load_manifest(*lab), labs, put, {}));
        }
    }
    static void TearDownTestSuite() { folder_.reset(); }

    /// Opens the handout of a lab.
    static void open(int lab) { browser().open(folder_->path() / pages::handout_file(find_lab(std::to_string(lab)))); }

    static std::string figure(const std::string& name) {
        return "document.querySelector('figure:has([data-moves=" + name + "])')";
    }
    /// Sets the sliders of a drawing. Returns the attributes of its parts.
    static std::map<std::string, json> move(const std::string& name, const std::vector<double>& values) {
        return browser().eval("(figure => { const values = " + json(values).dump() + R"js(;
          figure.querySelectorAll('input').forEach((input, i) => { input.value = values[i]; });
          figure.querySelector('.sliders').dispatchEvent(new Event('input'));
          return Object.fromEntries([...figure.querySelectorAll('[data-part]')].map(part => [part.dataset.part,
            Object.fromEntries([...part.attributes].map(one => [one.name, one.value]))]));
        })js" + ")(" + figure(name) +
                              ")");
    }
    static double number(const json& part, const char* attribute) { return std::stod(std::string(part[attribute])); }

    static inline std::unique_ptr<TemporaryFolder> folder_;
};

/// Attributes are written in tenths of a drawing's unit.
constexpr double tenth = 0.051;

/// Returns the relief of a drawing: straight pieces between points `spacing` apart, from the first one on.
HeightField field_of(const std::string& points, double spacing, double top, double ground) {
    std::vector<glm::dvec2> all;
    for (const std::string& point : split(points, ' ')) {
        const size_t comma = point.find(',');
        all.emplace_back(std::stod(point), (ground - std::stod(point.substr(comma + 1))) / (ground - top));
    }
    Image heights(int((all.back().x - all.front().x) / spacing) + 1, 1, 1, 32);
    size_t next = 1;
    for (int i = 0; i < heights.width; ++i) {
        const double x = all.front().x + i * spacing;
        while (all[next].x < x) ++next;
        const glm::dvec2 a = all[next - 1], b = all[next];
        heights.values[size_t(i)] = float(glm::mix(a.y, b.y, (x - a.x) / (b.x - a.x)));
    }
    return HeightField(heights, false);
}

TEST_F(MovingDrawings, AreThoseFive) {
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator(course_root() / "assets/diagrams"))
        if (is_moving_drawing(read_file(entry.path()))) found.insert(entry.path().stem().string());
    EXPECT_EQ(found, (std::set<std::string>{"ray_in_relief", "one_tap", "crossing_of_two_lines", "gram_schmidt",
                                            "stages_of_a_patch"}));
}

TEST_F(MovingDrawings, AreCompleteWithoutTheirScriptAndUnchangedByIt) {
    const char* elements = "[...document.querySelectorAll('[data-moves] *:not(title)')].map(one => one.outerHTML)";
    for (const int lab : {5, 10, 11, 13}) {
        browser().scripts(false);
        open(lab);
        const json still = browser().eval(elements);
        EXPECT_GT(still.size(), 15u) << lab;
        EXPECT_EQ(browser().eval("document.querySelectorAll('.sliders').length"), 0) << lab;
        browser().scripts(true);
        open(lab);
        EXPECT_EQ(browser().eval(elements), still) << lab;
        const std::string sliders =
            "[...document.querySelectorAll('.sliders')].filter(one => one.checkVisibility()).length";
        EXPECT_EQ(browser().eval(sliders), browser().eval("document.querySelectorAll('[data-moves]').length")) << lab;
        browser().paper(true);
        EXPECT_EQ(browser().eval(sliders), 0) << lab << " on paper";
        browser().paper(false);
        EXPECT_EQ(browser().complaints(), Names{}) << lab;
    }
}

TEST_F(MovingDrawings, TheirTextsStayInsideAndApart) {
    for (const int lab : {5, 10, 11, 13}) {
        open(lab);
        // All pairs of eleven values.
        EXPECT_EQ(Names(with_bad_texts(R"js([...document.querySelectorAll('[data-moves]')].flatMap(svg => {
          const box = svg.closest('figure').querySelector('.sliders'), [one, two] = box.querySelectorAll('input'), found = [];
          const set = (input, i) => { input.value = +input.min + (input.max - input.min) * i / 10; };
          for (let i = 0; i <= 10; ++i)
            for (let j = 0; j <= (two ? 10 : 0); ++j) {
              set(one, i);
              if (two) set(two, j);
              box.dispatchEvent(new Event('input'));
              found.push(...badTexts(svg).map(text => `${svg.dataset.moves} ${one.value} ${two?.value}: ${text}`));
            }
          return found; }))js")),
                  Names{})
            << lab;
    }
}

TEST_F(MovingDrawings, AreMovedByKeysAndByADragOnAPhone) {
    browser().width(390);
    open(10);
    ASSERT_TRUE(browser().tab_to(".sliders input"));
    browser().press("ArrowRight", 3);
    EXPECT_EQ(browser().eval("document.activeElement.getAttribute('aria-valuetext')"), "48°");
    EXPECT_EQ(browser().eval("document.activeElement.labels[0].innerText.trim().split('\\n')[0]"),
              "angle from the normal");
    const json frame = browser().eval(
        "(() => { const svg = document.querySelector('[data-moves]'); svg.scrollIntoView({block: 'center'}); const box "
        "= "
        "svg.getBoundingClientRect(); return [box.left, box.top, box.width / 760]; })()");
    // From the entry, 100 units down and 60 to the right.
    const double x = double(frame[0]) + 250 * double(frame[2]), y = double(frame[1]) + 220 * double(frame[2]);
    for (const char* type : {"mousePressed", "mouseReleased"})
        browser().call("Input.dispatchMouseEvent",
                       {{"type", type}, {"x", x}, {"y", y}, {"button", "left"}, {"buttons", 1}, {"clickCount", 1}});
    EXPECT_EQ(browser().eval("document.querySelector('.sliders input').value"), "31") << "the arc tangent of 0.6";
    EXPECT_EQ(browser().eval("document.scrollingElement.scrollWidth"), 390);
    browser().width(0);
}

TEST_F(MovingDrawings, TheRayMeetsTheReliefFirstWhereTheExactSearchSays) {
    open(10);
    for (double angle = 15; angle <= 60; ++angle) {
        auto parts = move("ray_in_relief", {angle});
        const double along = 250 * std::tan(glm::radians(angle)), spacing = 8;
        const HeightField field = field_of(parts["surface"]["points"], spacing, 120, 370);
        const ReliefRay ray{{(190 - 40) / spacing + 0.5, 0.5}, {along / spacing, 0}, std::cos(glm::radians(angle))};
        const auto hit = field.first_hit(ray.in_texels(), 1);
        ASSERT_TRUE(hit);
        EXPECT_NEAR(number(parts["hit"], "cx"), 190 + hit->t * along, tenth) << angle;
        EXPECT_NEAR(number(parts["hit"], "cy"), 120 + hit->t * 250, tenth) << angle;
        EXPECT_NEAR(number(parts["along"], "x2"), 190 + along, tenth) << angle;
    }
}

TEST_F(MovingDrawings, TheOneTapGuessesWhatParallaxOffsetDoes) {
    open(10);
    for (double entry = 0; entry <= 100; entry += 4)
        for (const double angle : {30.0, 45.0, 58.0, 65.0}) {
            auto parts = move("one_tap", {entry, angle});
            const double uv = 150 + 3.1 * entry, along = 260 * std::tan(glm::radians(angle)), spacing = 5;
            const HeightField field = field_of(parts["surface"]["points"], spacing, 120, 380);
            const ReliefRay ray{{(uv - 30) / spacing + 0.5, 0.5}, {along / spacing, 0}, std::cos(glm::radians(angle))};
            const double guess = parallax_offset(field, ray).t;
            EXPECT_NEAR(number(parts["guess"], "cx"), uv + guess * along, tenth) << entry << " " << angle;
            EXPECT_NEAR(number(parts["guess"], "cy"), 120 + guess * 260, tenth) << entry << " " << angle;
            const auto hit = field.first_hit(ray.in_texels(), 1);
            ASSERT_TRUE(hit);
            EXPECT_NEAR(number(parts["hit"], "cx"), uv + hit->t * along, tenth) << entry << " " << angle;
        }
}

TEST_F(MovingDrawings, TheLinesCrossAtTheSharesOfTheGapsAndTheHitIsOnBothCurves) {
    open(11);
    for (double after = -0.24; after < -0.015; after += 0.02)
        for (const double bend : {-0.04, 0.0, 0.03, 0.06}) {
            auto parts = move("crossing_of_two_lines", {after, bend});
            const double share = 0.22 / (0.22 - after);
            EXPECT_NEAR(number(parts["cross"], "cx"), 110 + 530 * share, tenth) << after;
            EXPECT_NEAR(number(parts["cross"], "cy"), 330 - 160 * share, tenth) << "on the chord";
            // The surface leaves its chord by `bend` in the middle. The ray's height falls from gap to gap below it.
            const auto gap = [&](double s) { return 0.22 + s * (after - 0.22) - 4 * bend * s * (1 - s); };
            double above = 0, below = 1;
            for (int i = 0; i < 60; ++i) {
                const double middle = (above + below) / 2;
                (gap(middle) > 0 ? above : below) = middle;
            }
            EXPECT_NEAR(number(parts["hit"], "cx"), 110 + 530 * above, tenth) << after << " " << bend;
            EXPECT_NEAR(number(parts["hit"], "cy"), 110 + above * (60 - 1000 * after), tenth) << after << " " << bend;
        }
}

TEST_F(MovingDrawings, GramSchmidtLeavesTheNormalOutOfTheSum) {
    open(5);
    for (double angle = 10; angle <= 85; ++angle) {
        auto parts = move("gram_schmidt", {angle});
        const glm::dvec2 normal(0, 1), foot(250, 289);
        const auto arrow = [&](const char* name) {
            return glm::dvec2(number(parts[name], "x2") - foot.x, foot.y - number(parts[name], "y2"));
        };
        const glm::dvec2 sum = arrow("sum"), rest = sum - glm::dot(sum, normal) * normal;
        EXPECT_NEAR(std::atan2(sum.y, sum.x), glm::radians(angle), 1e-3);
        EXPECT_NEAR(arrow("tangent").x, rest.x, tenth) << angle;
        EXPECT_NEAR(arrow("tangent").y, rest.y, tenth) << angle;
        EXPECT_NEAR(number(parts["taken"], "x1"), foot.x + sum.x, tenth) << "from the sum down to the rest";
    }
}

TEST_F(MovingDrawings, APatchIsDividedAsByTheTessellator) {
    open(13);
    using web::TessellationSpacing;
    const std::array spacings = {TessellationSpacing::equal, TessellationSpacing::fractional_even,
                                 TessellationSpacing::fractional_odd};
    for (size_t spacing = 0; spacing < spacings.size(); ++spacing)
        for (int tenths = 10; tenths <= 80; ++tenths) {
            const float level = float(tenths) / 10;
            auto parts = move("stages_of_a_patch", {tenths / 10.0, double(spacing)});
            std::set<double> expected, drawn;
            for (const glm::vec3& point :
                 web::tessellate(4, spacings[spacing], {{level, level, level, level}, {level, level}}).points)
                if (point.y == 0) expected.insert(std::round(10 * (500 + 140 * double(point.x))));
            // The first line of the grid is the edge: "M500.0 128.0 535.0 128.0 ...".
            const std::string grid = parts["grid"]["d"];
            const Names words = split(grid.substr(1, grid.find('M', 1) - 1), ' ');
            for (size_t i = 0; i < words.size(); i += 2) drawn.insert(std::round(10 * std::stod(words[i])));
            ASSERT_EQ(drawn.size(), expected.size()) << level << " " << spacing;
            for (auto a = drawn.begin(), b = expected.begin(); a != drawn.end(); ++a, ++b)
                EXPECT_NEAR(*a, *b, 1) << level << " " << spacing;
        }
}

}  // namespace
}  // namespace relief
