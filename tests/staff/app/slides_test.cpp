// The decks of slides: every lab has one. Each command in the table of sources is valid. In a browser every picture
// loads, every formula is typeset, no slide overflows its frame, and no letter has less than 18 pt. A deck without
// solutions does not contain any.
#include <algorithm>
#include <map>
#include <set>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/core/lab/shot.h"
#include "framework/course/manifest/manifest.h"
#include "framework/course/task/starter.h"
#include "framework/staff/measure/bench.h"
#include "framework/staff/slides/deck.h"
#include "tests/browser.h"
#include "tests/code_shape.h"
#include "tests/process.h"

namespace relief::app {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

/// A script that returns the problems of all slides in the open page, one line each.
constexpr const char* find_problems = R"js((async () => {
  const found = [], sections = [...document.querySelectorAll('svg[data-marpit-svg] section')];
  const style = document.createElement('style');  // slides that are not shown are not laid out
  style.textContent = 'svg[data-marpit-svg], svg[data-marpit-svg] * { content-visibility: visible !important; }';
  document.head.append(style);
  // Code is shrunk to its slide only after it has been laid out, some frames later: it is looked at when nothing moves.
  for (let still = 0, last = ''; still < 10;) {
    await new Promise(requestAnimationFrame);
    const now = [...document.querySelectorAll('svg[data-marpit-svg] section *')]
        .map(element => { const box = element.getBoundingClientRect(); return [box.x, box.y, box.width, box.height]; }).join();
    still = now === last ? still + 1 : 0;
    last = now;
  }
  const loads = address => new Promise(done => {
    const image = new Image();
    image.onload = () => done(image.naturalWidth > 0);
    image.onerror = () => done(false);
    image.src = address;
  });
  for (const svg of document.querySelectorAll('svg[data-marpit-svg]')) {
    const number = 1 + [...svg.parentElement.children].indexOf(svg), say = text => found.push('slide ' + number + ': ' + text);
    for (const image of svg.querySelectorAll('img'))
      if (!await loads(image.src)) say('no picture ' + image.getAttribute('src'));
      else if (!image.alt.trim()) say('nothing stands in for ' + image.getAttribute('src'));
    for (const element of svg.querySelectorAll('*'))
      for (const [, address] of getComputedStyle(element).backgroundImage.matchAll(/url\("([^"]*)"\)/g))
        if (!await loads(address)) say('no picture ' + address);
    for (const error of svg.querySelectorAll('mjx-merror, [data-mml-node="merror"]'))
      say('a formula that is none: ' + (error.getAttribute('data-mjx-error') || error.textContent));
    for (const section of svg.querySelectorAll('section')) {
      const walk = document.createTreeWalker(section, NodeFilter.SHOW_TEXT);
      while (walk.nextNode()) {
        const text = walk.currentNode.textContent;
        if (!walk.currentNode.parentElement.closest('code, pre, mjx-container, style') && /\$|\\[a-zA-Z(\[]/.test(text))
          say('not set: ' + text.trim());
      }
      // Where things end, in the slide's own pixels. The picture behind it all has a frame of its own, and a title's
      // strip goes to the edges.
      if (['background', 'pseudo'].includes(section.dataset.marpitAdvancedBackground)) continue;
      const frame = section.getBoundingClientRect(), scale = frame.width / 1280;
      // 24 px are 18 pt on a slide of 13.3 inches. Indices in formulas are smaller.
      const letters = document.createTreeWalker(section, NodeFilter.SHOW_TEXT);
      while (letters.nextNode()) {
        const parent = letters.currentNode.parentElement, text = letters.currentNode.textContent.trim();
        if (!text || parent.closest('style, mjx-assistive-mml, mjx-container')) continue;
        const code = parent.closest('pre'), shrunk = code ? code.getBoundingClientRect().width / code.offsetWidth / scale : 1;
        const size = parseFloat(getComputedStyle(parent).fontSize) * Math.min(1, shrunk);
        if (size < 23.9) say('letters of ' + Math.round(size) + ' px: ' + text.slice(0, 60));
      }
      const [sides, bottom] = section.classList.contains('title') ? [0, 0] : [20, 44];
      for (const element of section.querySelectorAll('*')) {
        if (element.closest('footer, .source, mjx-assistive-mml') || element.closest('mjx-container') !== null && element.localName !== 'svg') continue;
        const box = element.getBoundingClientRect();
        if (box.width === 0 || box.height === 0) continue;
        const over = Math.max(Math.max(frame.left - box.left, box.right - frame.right, frame.top - box.top) / scale + sides,
                              (box.bottom - frame.bottom) / scale + bottom);
        if (over > 1) { say('runs out of its frame by ' + Math.round(over) + ': ' + element.localName + ' ' + element.textContent.trim().slice(0, 60)); break; }
      }
    }
  }
  return found;
})())js";

Names problems_of(const fs::path& page) {
    browser().open(page);
    const nlohmann::json answer = browser().call(
        "Runtime.evaluate", {{"expression", find_problems}, {"returnByValue", true}, {"awaitPromise", true}});
    if (answer.contains("exceptionDetails")) throw std::runtime_error(answer["exceptionDetails"].dump(1));
    Names problems = answer["result"]["value"];
    for (const std::string& complaint : browser().complaints())
        // Ignores the browser's remarks about the layout of hidden slides, which this test forces.
        if (!contains(complaint, "\"level\":\"verbose\"")) problems.push_back(complaint);
    return problems;
}

Names decks() {
    Names names;
    for (const auto& entry : fs::directory_iterator(course_root() / "slides"))
        if (entry.path().extension() == ".md") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

slides::Deck deck_of(const std::string& name, bool solutions = false) {
    const fs::path file = course_root() / "slides" / (name + ".md");
    return slides::read_deck(read_file(file), file, name, solutions);
}

slides::Deck deck(const std::string& text, bool solutions = false) {
    return slides::read_deck("---\nmarp: true\n---\n" + text, "d.md", "d", solutions);
}
std::string complaint(const std::string& text) {
    return message_of([&] { deck(text); });
}

// ---- the text of a deck ----

TEST(Deck, FiguresNameTheCommandsThatDrawThem) {
    const slides::Deck one =
        deck("a ![w:3 x](<shot 10 --set view=one>) b ![bg y](<bench parallax --quick>)\n\n![z](z.svg)\n");
    EXPECT_EQ(one.text, "---\nmarp: true\n---\na ![w:3 x](d/01.png) b ![bg y](d/02.svg)\n\n![z](z.svg)\n\n");
    ASSERT_EQ(one.figures.size(), 2u);
    EXPECT_EQ(one.figures[0].command, (Names{"shot", "10", "--set", "view=one"}));
    EXPECT_EQ(one.figures[1].command, (Names{"bench", "parallax", "--quick"}));
    EXPECT_EQ(one.figures[1].file, "d/02.svg");
    EXPECT_EQ(one.figures[1].line, 4);
    const slides::Deck bare = deck("![a](<shot 01>) ![bare w:9 b](<shot 02>)\n");
    EXPECT_TRUE(contains(bare.text, "![a](d/01.png) ![w:9 b](d/02.png)")) << bare.text;
    EXPECT_TRUE(bare.figures.at(0).has_words && !bare.figures.at(1).has_words);
    EXPECT_EQ(complaint("![x](<shot 10 -o a.png>)"), "d.md:4: a figure has a place of its own: leave -o out");
    EXPECT_EQ(complaint("\n![x](<bench --quick>)"), "d.md:5: a plot is of one topic: bench parallax --quick");
}

TEST(Deck, CodeIsARegionOfTheSource) {
    const std::string quote = "```glsl shaders/10_parallax_offset/surface.frag search\n```\n";
    const slides::Deck one = deck(quote);
    EXPECT_TRUE(contains(one.text, "```glsl\nvec2 along = ray_in_relief(to_eye")) << one.text;
    EXPECT_TRUE(contains(one.text, "shaders/10_parallax_offset/surface.frag</p>")) << one.text;
    EXPECT_FALSE(contains(one.text, "//(")) << one.text;
    EXPECT_TRUE(contains(complaint("```glsl shaders/10_parallax_offset/surface.frag serach\n```"),
                         "d.md:4: shaders/10_parallax_offset/surface.frag: unknown region 'serach': did you mean "
                         "'search'?"));
    EXPECT_TRUE(complaint("```glsl no/such.frag x\n```").starts_with("d.md:4: "));
    EXPECT_TRUE(complaint("a\n```glsl a\n```").starts_with("d.md:5: a block of code that quotes says"));
    EXPECT_TRUE(complaint("```glsl\n").starts_with("d.md:4: this ``` is never closed"));
    EXPECT_TRUE(complaint("```glsl a b\nx\n```").starts_with("d.md:4: a block"));
}

TEST(Deck, ShowsSolutionsOnlyOnRequest) {
    const std::string quote = "```glsl shaders/10_parallax_offset/task.glsl ray\n```\n";
    EXPECT_TRUE(contains(complaint(quote), "d.md:4: shaders/10_parallax_offset/task.glsl has a solution in ray"));
    const std::string slides = "first\n---\n<!-- _class: solution -->\n" + quote + "---\nlast";
    EXPECT_EQ(deck(slides).text, "---\nmarp: true\n---\nfirst\n---\nlast\n");
    EXPECT_EQ(deck("first\n---\n<!-- _class: solution -->\n" + quote).text, "---\nmarp: true\n---\nfirst\n");
    EXPECT_TRUE(contains(deck(slides, true).text, "return -seen.xy"));
}

TEST(Deck, MistakesAreShownBeforeTheyAreExplained) {
    const slides::Deck one = deck("```mistakes 10 --set view=one\nv-flipped\nnot-divided\n```\n");
    ASSERT_EQ(one.figures.size(), 3u);
    EXPECT_EQ(one.figures[0].command, (Names{"shot", "10", "--set", "view=one"}));
    EXPECT_EQ(one.figures[2].command, (Names{"shot", "10", "--set", "view=one", "--mistake", "not-divided"}));
    const size_t rule = one.text.find("\n---\n", 20), hint = one.text.find("v grows upwards");
    ASSERT_NE(hint, std::string::npos) << one.text;
    EXPECT_GT(hint, rule);
    EXPECT_TRUE(
        contains(complaint("```mistakes 10\nv-fliped\n```"), "d.md:4: unknown mistake 'v-fliped': did you mean"));
    EXPECT_TRUE(contains(complaint("```mistakes 99\nx\n```"), "d.md:4: "));
}

TEST(Deck, BreaksLinesOfCodeThatAreTooLongForASlide) {
    const std::string text = deck("```glsl shaders/common/light.glsl blinn-phong\n```\n").text;
    EXPECT_TRUE(contains(text, "float shininess,\n    vec3 normal, vec3 to_light, vec3 to_eye) {")) << text;
    for (const std::string& name : decks()) {
        bool is_code = false;
        for (const std::string& line : split(deck_of(name, true).text, '\n')) {
            if (line.starts_with("```")) is_code = !is_code;
            if (is_code) {
                EXPECT_LE(line.size(), 75u) << name << ": " << line;
            }
        }
    }
}

TEST(Deck, LaysWordsOverTheirPicture) {
    const std::string text = "a\n![w:300 x < y](d/01.png) ![](d/02.png) ![bg z](d/03.png)\n";
    EXPECT_EQ(
        slides::with_words(text, "d/01.png", "<b>one</b>\n"),
        "a\n<span class=\"worded\" style=\"width:300px\"><img src=\"d/01.png\" alt=\"x &lt; y\"><b>one</b></span> "
        "![](d/02.png) ![bg z](d/03.png)\n");
    EXPECT_EQ(slides::with_words(text, "d/01.png", ""), text);
    EXPECT_EQ(slides::with_words(text, "d/03.png", "<b>one</b>"), text);
    EXPECT_EQ(slides::with_words(text, "d/04.png", "<b>one</b>"), text);
}

TEST(Deck, MovesMeasurementsToTheSpeakersNotes) {
    EXPECT_EQ(deck("0.17\n\n```measured\n0.17  mean  shot 02\n```\n").text,
              "---\nmarp: true\n---\n0.17\n\n<!-- Measured by relief\n0.17  mean  shot 02\n-->\n\n");
}

// ---- the course's decks ----

TEST(Slides, EveryLabHasADeckWithPicturesCodeMistakesAndAnExercise) {
    const Names names = decks();
    EXPECT_TRUE(std::find(names.begin(), names.end(), "00_relief") != names.end()) << "the opening deck";
    EXPECT_TRUE(std::find(names.begin(), names.end(), "90_where_it_breaks") != names.end()) << "of all labs";
    for (const LabEntry& lab : registry()) {
        if (lab.number >= 20) continue;  // not one of the course's labs
        if (std::find(names.begin(), names.end(), lab.folder) == names.end()) {
            ADD_FAILURE() << "slides/" << lab.folder << ".md is missing";
            continue;
        }
        const std::string text = read_file(course_root() / "slides" / (lab.folder + ".md"));
        for (const char* part : {"](<shot ", "```mistakes ", "\n```glsl shaders/", "$$", "_class: exercise"})
            EXPECT_TRUE(contains(text, part)) << lab.folder << " has no " << part;
        for (const TaskInfo& task : load_manifest(lab).tasks)
            EXPECT_TRUE(contains(text, task.id)) << lab.folder << " says nothing of task " << task.id;
    }
}

TEST(Slides, EveryDeckEndsWithThreeQuestionsWhoseAnswersAreInTheNotes) {
    for (const std::string& name : decks()) {
        const std::string text = deck_of(name, true).text, last = text.substr(text.rfind("\n---\n"));
        EXPECT_TRUE(contains(last, "_class: questions")) << name;
        int questions = 0;
        for (const std::string& line : split(last, '\n'))
            if (line.size() > 3 && std::isdigit(line[0]) && line[1] == '.') {
                ++questions;
                EXPECT_TRUE(line.ends_with('?')) << name << ": " << line;
            }
        EXPECT_EQ(questions, 3) << name;
        EXPECT_GT(last.size() - last.rfind("<!-- "), 100u) << name << " has no notes on them";
    }
}

/// Returns the words of each command in a table of the text, which the table's head begins with `./relief shot`.
std::vector<Names> shots_in_tables(const std::string& text) {
    constexpr std::string_view begin = "| `";
    std::vector<Names> shots;
    bool of_shots = false;
    for (const std::string& line : split(text, '\n')) {
        if (!line.starts_with('|')) of_shots = false;
        if (contains(line, "`./relief shot`")) of_shots = true;
        const size_t at = line.find(begin);
        if (!of_shots || at == std::string::npos || contains(line, "`./relief shot`")) continue;
        const size_t words = at + begin.size();
        shots.push_back(split(line.substr(words, line.find('`', words) - words), ' '));
    }
    return shots;
}

/// Returns the words of each command `./relief run ...` in a table of the text, without "./relief run".
std::vector<Names> runs_in_tables(const std::string& text) {
    constexpr std::string_view begin = "`./relief run ";
    std::vector<Names> runs;
    for (const std::string& line : split(text, '\n')) {
        const size_t at = line.find(begin);
        if (!line.starts_with('|') || at == std::string::npos) continue;
        const size_t words = at + begin.size();
        runs.push_back(split(line.substr(words, line.find('`', words) - words), ' '));
    }
    return runs;
}

/// Returns the fault of a command: its lab, a knob, a value or a file does not exist, or a knob is ignored. Returns an
/// empty text for a valid command. Draws nothing.
std::string fault_of_shot(const Names& words) {
    try {
        const LabEntry& entry = find_lab(words.at(0));
        Shot shot;
        for (size_t i = 1; i < words.size(); i += 2) {
            const size_t equals = i + 1 < words.size() ? words[i + 1].find('=') : std::string::npos;
            if (words[i] != "--set" || equals == std::string::npos) return "expected --set knob=value";
            shot.set.emplace_back(words[i + 1].substr(0, equals), words[i + 1].substr(equals + 1));
        }
        const std::vector<KnobText> knobs = describe_knobs(*make_lab(entry, shot));
        for (const auto& [name, value] : shot.set)
            if (is_ignored(name, knobs)) return "the knob " + name + " has no effect here";
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

/// Expects that every command is valid where the course is. Returns their labs.
std::set<std::string> labs_of_valid(const std::vector<Names>& commands) {
    const std::filesystem::path folder = std::filesystem::current_path();
    std::filesystem::current_path(course_root());
    std::set<std::string> labs;
    for (const Names& words : commands) {
        EXPECT_EQ(fault_of_shot(words), "") << join(words, " ");
        labs.insert(words.at(0));
    }
    std::filesystem::current_path(folder);
    return labs;
}

TEST(Slides, ThePageOfSourcesHasACommandOfEachLabAndNoWrongOne) {
    const std::set<std::string> labs = labs_of_valid(shots_in_tables(read_file(course_root() / "labs/staff/SHOWN.md")));
    for (const LabEntry& lab : registry()) {
        if (lab.number >= 20) continue;  // not one of the course's labs
        EXPECT_TRUE(labs.contains(lab.two_digits())) << lab.folder;
    }
}

TEST(Slides, TheCommandsInTheGuidesTablesOpenALab) {
    EXPECT_GE(labs_of_valid(runs_in_tables(read_file(course_root() / "labs/staff/README.md"))).size(), 7u);
}

TEST(Slides, ACommandWithAWrongLabKnobOrValueIsAFault) {
    EXPECT_EQ(fault_of_shot({"05", "--set", "view=one", "--set", "method=angle"}), "");
    EXPECT_NE(fault_of_shot({"99"}), "");
    EXPECT_NE(fault_of_shot({"05", "--set", "veiw=one"}), "");
    EXPECT_NE(fault_of_shot({"05", "--set", "view=two"}), "");
    EXPECT_EQ(fault_of_shot({"05", "--set", "method=angle"}), "the knob method has no effect here");
    EXPECT_NE(fault_of_shot({"05", "--size", "8x8"}), "");
}

/// Returns the text without white space, because a slide may break lines elsewhere.
std::string packed(std::string text) {
    std::erase_if(text, [](unsigned char c) { return std::isspace(c); });
    return text;
}

TEST(Slides, ShowNoSolutionLineUnlessRequested) {
    std::map<std::string, std::string> all, with_solutions;
    for (const std::string& name : decks()) {
        all[name] = packed(deck_of(name).text);
        with_solutions[name] = packed(deck_of(name, true).text);
    }
    int shown_when_asked = 0;
    for (const LabEntry& lab : registry())
        for (const TaskInfo& task : load_manifest(lab).tasks)
            for (const std::string& line : check::solution_lines(read_file(course_root() / task.file), task.file)) {
                const std::string code = packed(line);
                if (code.size() < 24) continue;
                for (const auto& [name, text] : all) {
                    EXPECT_FALSE(contains(text, code)) << "slides/" << name << ".md: " << line;
                    shown_when_asked += contains(with_solutions[name], code);
                }
            }
    EXPECT_GT(shown_when_asked, 10) << "or this test looks at nothing";
}

TEST(Slides, ShowNoSolutionWithRenamedIdentifiers) {
    std::map<std::string, std::string> shapes, with_solutions;
    for (const std::string& name : decks()) {
        shapes[name] = shape_of(code_in_markdown(deck_of(name).text));
        with_solutions[name] = shape_of(code_in_markdown(deck_of(name, true).text));
    }
    int shown_when_asked = 0;
    for (const LabEntry& lab : registry()) {
        std::set<std::string> files;
        for (const TaskInfo& task : load_manifest(lab).tasks) files.insert(task.file);
        for (const std::string& file : files)
            for (const std::string& shape :
                 expressions_of(check::solution_lines(read_file(course_root() / file), file)))
                for (const auto& [name, text] : shapes) {
                    EXPECT_FALSE(contains(text, shape) && !is_common(shape))
                        << "slides/" << name << ".md has of " << file << ": " << shape;
                    shown_when_asked += contains(with_solutions[name], shape);
                }
    }
    EXPECT_GT(shown_when_asked, 10) << "or this test looks at nothing";
}

TEST(Slides, PlotsOfAllDecksNameValuesThatAreMeasured) {
    int plots = 0;
    for (const std::string& name : decks())
        for (const slides::DeckFigure& figure : deck_of(name, true).figures) {
            const Names& words = figure.command;
            if (words.front() != "bench") continue;
            std::vector<std::pair<std::string, Names>> wanted;
            for (size_t i = 3; i < words.size(); ++i)
                if (words[i - 1] == "--set") {
                    const size_t sign = words[i].find('=');
                    wanted.emplace_back(words[i].substr(0, sign), split(words[i].substr(sign + 1), ','));
                }
            const bool is_quick = std::find(words.begin(), words.end(), "--quick") != words.end();
            const measure::BenchSettings settings{.repeats = 3, .quick = is_quick, .is_chosen = !wanted.empty()};
            for (const measure::BenchTopic& topic : measure::bench_topics())
                if (topic.name == words[1]) {
                    ++plots;
                    EXPECT_NO_THROW(measure::filter_scenes(topic, topic.scenes(settings), wanted))
                        << name << ": relief " << join(words, " ");
                }
        }
    EXPECT_GE(plots, 10);
}

/// Returns the decks to be made: a sample, because their figures take minutes.
Names decks_to_make() { return sample_of(decks(), 5); }

/// Returns the folder of decks_to_make(), which the first call makes.
const fs::path& made_slides() {
    static const TemporaryFolder folder;
    static const Result result = [] {
        Names words = {relief_program(), "slides", "--solutions", "--no-pdf", "-o", (folder.path() / "s").string()};
        for (const std::string& name : decks_to_make()) words.push_back(name);
        return run(words);
    }();
    static const fs::path path = folder.path() / "s";
    EXPECT_EQ(result.code, 0) << result.err;
    return path;
}

class MadeDeck : public testing::TestWithParam<std::string> {};

TEST_P(MadeDeck, HasItsPicturesAndFormulasAndFitsItsFrame) {
    const fs::path page = made_slides() / (GetParam() + ".html");
    EXPECT_EQ(problems_of(page), Names{});
    EXPECT_GE(int(browser().eval("document.querySelectorAll('svg[data-marpit-svg]').length")), 8);
    EXPECT_FALSE(contains(read_file(page), "src=\"http")) << "slides need no network";
    EXPECT_EQ(browser().eval("document.documentElement.lang"), "en") << "whatever LANG says";
}

TEST(Slides, KeysOnASliderMoveItsDrawingAndNotTheDeck) {
    const std::string name = "10_parallax_offset";
    const Names made = decks_to_make();
    ASSERT_TRUE(std::find(made.begin(), made.end(), name) != made.end()) << "its first drawing moves";
    browser().open(made_slides() / (name + ".html"));
    const std::string hash = browser().eval(
        "location.hash = '#' + (1 + [...document.querySelectorAll('svg[data-marpit-svg]')].findIndex(one => "
        "one.querySelector('[data-moves]')))");
    ASSERT_TRUE(browser().tab_to(".sliders input"));
    browser().press("ArrowRight", 5);
    EXPECT_EQ(browser().eval("document.activeElement.value"), "50");
    EXPECT_EQ(browser().eval("location.hash"), hash);
}

TEST(Slides, AxeFindsNothingOnADeck) {
    for (const std::string& name : sample_of(decks_to_make(), 1)) {
        browser().open(made_slides() / (name + ".html"));
        EXPECT_EQ(browser().accessibility_faults(), Names{}) << name;
    }
}

INSTANTIATE_TEST_SUITE_P(Slides, MadeDeck, testing::ValuesIn(decks_to_make()),
                         [](const auto& name) { return "Deck" + name.param; });

TEST(Slides, ArePrintedAsPdfWithoutTemporaryFiles) {
    const TemporaryFolder folder;
    const Result result = run({relief_program(), "slides", "1", "-o", folder.path().string()});
    ASSERT_EQ(result.code, 0) << result.err;
    const fs::path page = folder.path() / "01_specular_highlights.html";
    const std::string pdf = read_file(folder.path() / "01_specular_highlights.pdf");
    EXPECT_TRUE(pdf.starts_with("%PDF-"));
    EXPECT_GT(pdf.size(), 1'000'000u) << "its pictures are in it";
    EXPECT_EQ(result.out, page.string() + "\n" + (folder.path() / "01_specular_highlights.pdf").string() + "\n");
    EXPECT_FALSE(fs::exists(folder.path() / "01_specular_highlights.md"));
}

TEST(Slides, ReportMissingPicturesWrongFormulasAndOverflow) {
    const TemporaryFolder folder;
    folder.write(
        "bad.md",
        "---\nmarp: true\ntheme: relief\n---\n# Good\n\n$x^2$\n\n---\n\n![gone](gone.png)\n\n---\n\n"
        "$\\frac{1$\n\n---\n\n![bg gone](gone.jpg)\n\n---\n\n\\alpha here\n\n---\n\n" +
            [] {
                std::string many;
                for (int i = 0; i < 30; ++i) many += "- item\n";
                return many;
            }() +
            "\n---\n\n<small>tiny</small>\n");
    const fs::path source = course_root() / "slides", marp = course_root() / "build/marp/node_modules/.bin/marp";
    const Result made = run({marp.string(), "--no-stdin", "--config-file", (source / "marp.yml").string(),
                             "--theme-set", (source / "relief.css").string(), "--", "bad.md"},
                            {.folder = folder.path(), .environment = {}});
    ASSERT_EQ(made.code, 0) << made.err;
    const Names problems = problems_of(folder.path() / "bad.html");
    const auto said = [&](const std::string& text) {
        return std::any_of(problems.begin(), problems.end(), [&](const auto& one) { return contains(one, text); });
    };
    const std::string all = join(problems, "\n");
    for (const char* text : {"slide 2: no picture gone.png", "slide 3: ", "slide 4: no picture file:",
                             "slide 5: not set: ", "slide 6: runs out of its frame by ", "slide 7: letters of "})
        EXPECT_TRUE(said(text)) << text << "\n" << all;
    EXPECT_FALSE(said("slide 1:")) << all;
}

}  // namespace
}  // namespace relief::app
