// The contract of every lab, tested on all labs of the course, and on a new lab.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <regex>
#include <set>
#include <utility>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/core/gl/counters.h"
#include "framework/core/gl/draw_watch.h"
#include "framework/core/gl/gl.h"
#include "framework/core/gl/program.h"
#include "framework/core/image/compare.h"
#include "framework/core/image/file.h"
#include "framework/core/lab/words.h"
#include "framework/course/manifest/manifest.h"
#include "framework/library/kit/labels.h"
#include "framework/library/maps/visualize.h"
#include "tests/support.h"
#include "tests/words.h"

namespace relief {

static void PrintTo(const LabEntry& lab, std::ostream* stream) { *stream << lab.folder; }

namespace {

class EveryLab : public testing::TestWithParam<LabEntry> {
protected:
    Manifest manifest_ = load_manifest(GetParam());
    Shot shot(Probe probe = {}) const {
        return {.size = {160, 120}, .time = 0.5, .camera = manifest_.camera, .probe = std::move(probe), .set = {}};
    }
    Image picture(const Shot& wanted) const { return render_shot(*make_lab(GetParam(), wanted), wanted); }
    bool changes_a_larger_picture(const KnobText& knob) const;
};

/// One lab for several small pictures, so that its programs are compiled once, as in the menu.
class SmallLab {
public:
    SmallLab(const LabEntry& entry, Shot shot) : shot_(small(std::move(shot))), lab_(make_lab(entry, shot_)) {}
    Lab& lab() const { return *lab_; }
    const Shot& shot() const { return shot_; }
    Image draw() const {
        draw_lab(*lab_, frame_of(shot_, target_));
        return read_picture(target_);
    }

private:
    static Shot small(Shot shot) {
        shot.size = {96, 72};
        return shot;
    }
    Shot shot_;
    std::unique_ptr<Lab> lab_;
    Target target_{TargetKind::picture, shot_.size};
};

/// Returns the extreme values of a knob: the ends of its range, or all of its choices.
std::vector<std::string> extremes(const KnobText& knob) {
    if (!knob.is_number()) return knob.choices;
    return {plain(knob.low), plain(knob.high)};
}

bool EveryLab::changes_a_larger_picture(const KnobText& knob) const {
    Shot large = shot();
    large.size = {640, 480};
    const Image usual = picture(large);
    const std::vector<std::string> values = extremes(knob);
    return std::any_of(values.begin(), values.end(), [&](const std::string& value) {
        Shot other = large;
        other.set.emplace_back(knob.name, value);
        return picture(other).values != usual.values;
    });
}

/// Returns whether a knob only selects another way to the same picture, or the lab has to work to find out whether the
/// picture is the same: a bake shows whether rays have other hits in reach.
bool finds_it_in_another_way(const LabEntry& lab, const std::string& knob) {
    return (lab.name == "baking" && (knob == "take" || knob == "reach")) ||
           (lab.name == "obj_materials" && knob == "programs") || (lab.name == "relief_exact" && knob == "method") ||
           (lab.name == "tangent_space" && knob == "order");
}

/// Returns whether a knob rightly changes nothing in the picture of a new lab, although its help names no condition.
bool may_change_nothing(const LabEntry& lab, const KnobText& knob) {
    if (extremes(knob).size() < 2 || finds_it_in_another_way(lab, knob.name)) return true;  // other values are files
    return knob.name == "shift" ||                                                          // whole tiles look alike
           knob.name == "size" ||                             // two pictures have their own size, as its help says
           (lab.name == "planet" && knob.name == "level") ||  // its help names two knobs
           (lab.name == "parallax_occlusion" && knob.name == "skip") ||       // skips what nobody sees
           (lab.name == "time_and_error" && knob.name == "triangle_taps") ||  // its map is too rough for triangles
           (lab.name == "moving_frames" && (knob.name == "signs" || knob.name == "folds")) ||  // nothing folds yet
           (lab.name == "layered_normals" && knob.name == "question");                         // decides what is exact
}

/// Counts the textures that are created while an object of this class lives.
class TexturesMade {
public:
    TexturesMade() {
        count = 0, real = glad_glGenTextures;
        glad_glGenTextures = [](GLsizei number, GLuint* names) {
            count += number;
            real(number, names);
        };
    }
    ~TexturesMade() { glad_glGenTextures = real; }
    TexturesMade(const TexturesMade&) = delete;
    TexturesMade& operator=(const TexturesMade&) = delete;
    static inline int64_t count = 0;

private:
    static inline PFNGLGENTEXTURESPROC real = nullptr;
};

/// Values for all knobs of a lab, as set_knob() takes them.
using Setting = std::vector<std::pair<std::string, std::string>>;

std::string text_of(const Setting& setting, const Probe& probe) {
    std::string text = probe ? "--probe " + probe.name : "a picture";
    for (const auto& [knob, value] : setting) text += " --set " + knob + "=" + value;
    return text;
}

/// Returns a random setting. Half of the knobs keep their values. Leaves out maps of more than 1024 texels a side,
/// which take seconds.
Setting random_setting(const std::vector<KnobText>& knobs, std::mt19937& dice) {
    Setting setting;
    for (const KnobText& knob : knobs) {
        std::vector<std::string> values = extremes(knob);
        std::erase_if(values, [](const std::string& value) { return value == "4096"; });
        std::string value = values[dice() % values.size()];
        if (knob.is_number() && dice() % 2) {
            const double low = double(knob.low), high = double(knob.high), share = dice() / 4294967296.0;
            value =
                knob.is_whole ? std::to_string(int(low + share * (high - low + 1))) : plain(low + share * (high - low));
        }
        setting.emplace_back(knob.name, dice() % 2 ? value : knob.value);
    }
    return setting;
}

/// Returns the bytes of a shot's values, or the message of the error.
std::string bytes_or_error(Lab& lab, const Setting& setting, const Shot& shot) {
    try {
        for (const auto& [knob, value] : setting) set_knob(lab, knob, value);
        const Image image = draw_shot(lab, shot);
        return {reinterpret_cast<const char*>(image.values.data()), image.values.size() * sizeof(float)};
    } catch (const Error& error) {
        return error.what();
    }
}

TEST_P(EveryLab, HasATitleAGoalAHandoutAndAShaderFolder) {
    EXPECT_FALSE(manifest_.title.empty());
    EXPECT_FALSE(manifest_.learns.empty());
    const std::filesystem::path handout = course_root() / "labs" / GetParam().folder / "README.md";
    ASSERT_TRUE(std::filesystem::exists(handout));
    if (GetParam().number < 20) {  // one of the course's labs
        const std::string text = read_file(handout), top = text.substr(0, text.find("\n## "));
        EXPECT_TRUE(contains(top, "**Begin here.** Open the lab with `./relief run " + GetParam().two_digits()));
    }
    EXPECT_TRUE(std::filesystem::is_directory(course_root() / "shaders" / GetParam().folder));
}

// `view=one` can be pasted after --set. A table may have `view` one, since its column says what to do.
TEST_P(EveryLab, HasAHandoutWhoseSentencesWriteSettingsInCode) {
    std::string prose;
    bool is_code = false;
    for (const std::string& line : split(read_file(course_root() / "labs" / GetParam().folder / "README.md"), '\n')) {
        is_code ^= line.starts_with("```");
        if (!is_code && !line.starts_with("|")) prose += line + " ";
    }
    for (const KnobText& knob : describe_knobs(*make_lab(GetParam(), shot())))
        for (const std::string& value : extremes(knob)) {
            const std::string ends = knob.is_number() ? " -?[0-9]" : "( to)? " + value + "(?![\\w-])";
            std::smatch found;
            EXPECT_FALSE(std::regex_search(prose, found, std::regex("`" + knob.name + "`" + ends)))
                << "write `" << knob.name << "=" << value << "` instead of " << found.str();
        }
}

TEST_P(EveryLab, TitlesItsKnobsDifferentlyAndShortEnoughForThePanel) {
    constexpr size_t longest = 18;  // letters of 8 pixels in half of the panel's 340
    std::set<std::string> titles;
    for (const KnobText& knob : describe_knobs(*make_lab(GetParam(), shot()))) {
        const std::string title = knob.help.title_of(knob.name);
        EXPECT_LE(title.size(), longest) << title;
        EXPECT_TRUE(titles.insert(title).second) << "two knobs have the title " << title;
    }
}

TEST_P(EveryLab, IsMadeAndDescribedWithoutAnyGlObject) {
    const Counters before = counters();
    describe_knobs(*make_lab(GetParam(), shot()));
    EXPECT_EQ(counters().live, before.live);
}

TEST_P(EveryLab, DrawsTheSamePictureEachTime) { EXPECT_EQ(picture(shot()).values, picture(shot()).values); }

TEST_P(EveryLab, DrawsWithEachKnobAtItsEndsSaysWhichHaveNoEffectAndCompilesNothingForEqualPictures) {
    const SmallLab small(GetParam(), shot());
    const auto draw = [&] {
        Image image = small.draw();
        refuse_unusable(image, small.shot());
        return image;
    };
    const Image usual = draw();
    const TexturesMade textures;
    // A key without an ignored knob, and with the values that count, makes nothing again.
    struct Work {
        int64_t links = counters().links, textures = TexturesMade::count, draw_calls = counters().draw_calls;
    };
    const Work before_again;
    draw();
    const int64_t usual_calls = counters().draw_calls - before_again.draw_calls;
    const std::vector<KnobText> knobs = describe_knobs(small.lab());
    for (const KnobText& knob : knobs) {
        bool has_effect = false;
        for (const std::string& value : sample_of(extremes(knob), 4)) {
            set_knob(small.lab(), knob.name, value);
            const Work before;
            bool is_same = false;
            try {
                is_same = draw().values == usual.values;
                has_effect |= !is_same;
                if (is_same && !finds_it_in_another_way(GetParam(), knob.name)) {
                    const Work after;
                    EXPECT_EQ(after.links, before.links) << knob.name << " = " << value << " compiles";
                    EXPECT_EQ(after.textures, before.textures) << knob.name << " = " << value << " makes textures";
                    EXPECT_LE(after.draw_calls - before.draw_calls, usual_calls) << knob.name << " = " << value;
                }
            } catch (const Error& error) {
                ADD_FAILURE() << knob.name << " = " << value << ": " << error.what();
            }
            set_knob(small.lab(), knob.name, knob.value);
            // What the lab keeps is that of the usual picture again.
            if (!is_same || finds_it_in_another_way(GetParam(), knob.name)) draw();
        }
        EXPECT_TRUE(has_effect || is_ignored(knob.name, knobs) || may_change_nothing(GetParam(), knob) ||
                    changes_a_larger_picture(knob))
            << knob.name << " has no effect at the settings of a new lab, and its help does not say so";
    }
}

// A lab keeps maps and measurements from picture to picture. A picture must not depend on an earlier one.
TEST_P(EveryLab, DrawsASettingAlikeBeforeAndAfterAnotherOne) {
    const char* const given = std::getenv("RELIEF_TEST_SEED");
    const unsigned seed = given ? unsigned(std::stoul(given)) : tests_all() ? std::random_device()() : 3;
    std::mt19937 dice(seed + unsigned(GetParam().number));
    const std::vector<KnobText> knobs = describe_knobs(*make_lab(GetParam(), shot()));
    const auto random_shot = [&] {
        const size_t probe = dice() % (manifest_.probes.size() + 1);
        Shot random = shot({probe == 0 ? "" : manifest_.probes[probe - 1].name});
        random.size = {48, 36};
        if (dice() % 2) random.camera.yaw += double(dice() % 360);
        return random;
    };
    for (int round = 0; round < (tests_all() ? 12 : 3); ++round) {
        const Setting a = random_setting(knobs, dice), b = random_setting(knobs, dice);
        const Shot of_a = random_shot(), of_b = random_shot();
        const std::string fresh = bytes_or_error(*make_lab(GetParam(), shot()), a, of_a);
        const auto lab = make_lab(GetParam(), shot());
        bytes_or_error(*lab, b, of_b);
        EXPECT_EQ(bytes_or_error(*lab, a, of_a) == fresh, true) << "after " << text_of(b, of_b.probe);
        bytes_or_error(*lab, b, of_b);
        EXPECT_EQ(bytes_or_error(*lab, a, of_a) == fresh, true) << "again after " << text_of(b, of_b.probe);
        if (HasFailure())
            FAIL() << text_of(a, of_a.probe) << ", camera " << camera_text(of_a.camera) << " and "
                   << camera_text(of_b.camera) << ", RELIEF_TEST_SEED=" << seed;
    }
}

// The window shows such a knob in grey.
TEST_P(EveryLab, IgnoresAKnobWhereItsHelpExcludesIt) {
    const SmallLab small(GetParam(), shot());
    Lab& lab = small.lab();
    const auto draw = [&] { return small.draw().values; };
    const std::vector<KnobText> knobs = describe_knobs(lab);
    for (const KnobText& knob : knobs) {
        const auto names_it = [&](const KnobText& other) { return other.name == knob.help.knob; };
        EXPECT_EQ(std::count_if(knobs.begin(), knobs.end(), names_it), knob.help.knob.empty() ? 0 : 1) << knob.name;
        for (const KnobText& other : knobs) {
            if (!names_it(other)) continue;
            const std::vector<std::string> known = extremes(other);
            for (const std::string& value : knob.help.values)
                EXPECT_EQ(std::count(known.begin(), known.end(), value), 1) << knob.name << ": " << value;
            for (const std::string& value : extremes(other)) {
                set_knob(lab, other.name, value);
                if (is_ignored(knob.name, describe_knobs(lab))) {
                    const auto usual = draw();
                    for (const std::string& end : extremes(knob)) {
                        set_knob(lab, knob.name, end);
                        EXPECT_EQ(draw() == usual, true)
                            << other.name << " = " << value << ", " << knob.name << " = " << end;
                    }
                    set_knob(lab, knob.name, knob.value);
                }
            }
            set_knob(lab, other.name, other.value);
        }
    }
}

// In the window a shader may not compile while its author types. Once it compiles again, the picture is as before.
TEST_P(EveryLab, ADrawThatThrowsChangesNoKnobAndNotTheNextPicture) {
    std::vector<std::string> views = {""};
    for (const KnobText& knob : describe_knobs(*make_lab(GetParam(), shot())))
        if (knob.name == "view") views = extremes(knob);
    for (const std::string& view : views) {
        Shot wanted = shot();
        if (!view.empty()) wanted.set = {{"view", view}};
        const Image expected = SmallLab(GetParam(), wanted).draw();
        const SmallLab small(GetParam(), wanted);
        const auto values = [&] {
            std::vector<std::string> all;
            for (const KnobText& knob : describe_knobs(small.lab())) all.push_back(knob.name + "=" + knob.value);
            return all;
        };
        const std::vector<std::string> before = values();
        // Each program of the picture fails once: one more program compiles in every frame. The program of the labels
        // always compiles. Otherwise it would fail last, and no program would fail after a caption.
        bool is_broken = true;
        for (int frame = 0; is_broken && frame < 50; ++frame) {
            is_broken = false;
            int compiled = 0;
            const ShaderRewriting fails([&](std::vector<ShaderSource>& stages, GLuint) {
                if (stages.back().stage.stem() != "label" && compiled++ == (frame == 0 ? 0 : 1))
                    is_broken = true, throw Error("does not compile");
            });
            try {
                EXPECT_EQ(small.draw().values == expected.values, true) << view << ": after " << frame << " failures";
            } catch (const Error&) {
                EXPECT_TRUE(is_broken);
            }
            EXPECT_EQ(values(), before) << view << ": frame " << frame;
        }
        EXPECT_FALSE(is_broken) << view;
    }
}

// The window ends the first draw of a lab after each program that takes long to compile, and draws again.
TEST_P(EveryLab, ADrawThatEndsAfterAnyDrawCallDoesNotChangeTheNextPicture) {
    const Image expected = SmallLab(GetParam(), shot()).draw();
    const SmallLab small(GetParam(), shot());
    struct Pause {};
    bool is_whole = false;
    for (int calls = 1; !is_whole; calls += 1 + calls / 10) {
        int left = calls;
        try {
            const DrawWatch watch([&](const std::function<void()>& draw_call) {
                draw_call();
                if (--left == 0) throw Pause();
            });
            small.draw();
            is_whole = true;
        } catch (const Pause&) {
            EXPECT_EQ(take_gl_errors(), "") << "after " << calls << " draw calls";
        }
    }
    EXPECT_EQ(small.draw().values == expected.values, true);
}

TEST_P(EveryLab, DrawsInAnyShapeOfPicture) {
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(2, 97), glm::ivec2(97, 2)}) {
        Shot odd = shot();
        odd.size = size;
        try {
            picture(odd);
        } catch (const Error& error) {  // two columns of background are a picture of one colour; nothing else may fail
            EXPECT_TRUE(contains(error.what(), "one colour")) << error.what();
        }
    }
}

// A number below a picture that changes with the window cannot equal the one of a handout. Labs that count what the
// picture itself has (patches, holes, pixels of each method) say so.
TEST_P(EveryLab, MeasuresTheSameNumbersForAPictureOfAnySizeOrSaysThatItDoesNot) {
    const std::string handout = read_file(course_root() / "labs" / GetParam().folder / "README.md");
    const bool is_said = std::regex_search(handout, std::regex("below a\\s+picture depend on its size"));
    EXPECT_EQ(is_said, (std::set<int>{9, 14, 17}.contains(GetParam().number)));
    if (is_said) return;
    const auto numbers_of = [&](glm::ivec2 size, const std::string& view) {
        Shot sized = shot();
        sized.size = size;
        if (!view.empty()) sized.set = {{"view", view}};
        std::vector<PictureWord> words;
        sized.words = &words;
        picture(sized);
        std::multiset<std::string> numbers;
        for (const PictureWord& word : words)
            if (word.kind == PictureWord::Kind::caption && word.text.find_first_of("0123456789") != std::string::npos)
                numbers.insert(word.text);
        return numbers;
    };
    const std::map<int, std::string> views = {{2, "blocks"}, {5, "frames"}, {12, "compare"}, {19, "blends"}};
    const std::string view = views.contains(GetParam().number) ? views.at(GetParam().number) : "";
    EXPECT_EQ(numbers_of({120, 180}, view), numbers_of({256, 144}, view));
}

/// While it exists, draw calls and clears do nothing. A lab then takes the numbers of its captions from an earlier
/// draw.
class WithoutPixels {
public:
    WithoutPixels() { glEnable(GL_RASTERIZER_DISCARD); }
    WithoutPixels(const WithoutPixels&) = delete;
    ~WithoutPixels() { glDisable(GL_RASTERIZER_DISCARD); }

private:
    DrawWatch no_draw_{[](const std::function<void()>&) {}};
};

/// Returns the faults of the words over a view at a size, in the letters of pictures and in those of the window.
std::string faults_of_view(Lab& lab, Shot shot, glm::ivec2 size) {
    shot.size = size;
    std::vector<PictureWord> words;
    shot.words = &words;
    draw_lab(lab, frame_of(shot, Target(TargetKind::picture, size)));
    for (PictureWord& word : words) word = scaled(std::move(word), size);
    const Letters of_window{
        .width = [](const std::string& text, float height) { return 0.6f * height * float(text.size()); },
        .usual = 15,
        .least = 12.75f,
        .share = 0.8f};
    return faults_of_words(words, size, Labels::letters(size)) + faults_of_words(words, size, of_window);
}

// The opening view on a phone, in a small window and on a large screen; with --all also each reference screenshot.
TEST_P(EveryLab, NoWordOverAPictureIsCutOrOverlapsAnother) {
    constexpr std::array sizes = {glm::ivec2(343, 571), glm::ivec2(470, 731), glm::ivec2(640, 480),
                                  glm::ivec2(1920, 1080)};
    // These labs count what the picture itself has. Their large pictures cost seconds.
    const bool depends_on_pixels = std::set<int>{9, 14, 17}.contains(GetParam().number);
    const bool is_long = tests_all();
    std::vector<std::pair<std::string, Shot>> views = {{"the opening view", shot()}};
    for (const GoldenInfo& golden : manifest_.goldens)
        if (is_long && !golden.shot.probe) views.emplace_back(golden.name, golden.shot);
    for (const auto& [name, view] : views) {
        Shot once = view;
        once.size = {64, 48};
        const std::unique_ptr<Lab> lab = make_lab(GetParam(), once);
        std::optional<WithoutPixels> without_pixels;
        if (!depends_on_pixels) {
            render_shot(*lab, once);  // measures the numbers of the captions
            without_pixels.emplace();
        }
        for (const glm::ivec2 size : sizes) {
            EXPECT_EQ(faults_of_view(*lab, once, size), "") << name << " at " << size.x << " x " << size.y;
            if (depends_on_pixels && !is_long) break;
        }
    }
}

/// The knobs of a lab that accept a file.
class FileKnobs final : public Knobs {
public:
    explicit FileKnobs(Lab& lab) { lab.knobs(*this); }
    std::vector<std::string> names;

private:
    void slider(const char*, float&, float, float, const KnobHelp&) override {}
    void steps(const char*, int&, int, int, const KnobHelp&) override {}
    void toggle(const char*, bool&, const KnobHelp&) override {}
    void choice(const char*, int&, std::span<const char* const>, const KnobHelp&) override {}
    void choice_or_file(const char* name, int&, OwnFile&, std::span<const char* const>, const KnobHelp&) override {
        names.emplace_back(name);
    }
};

KnobHelp help_of(Lab& lab, const std::string& name) {
    for (const KnobText& knob : describe_knobs(lab))
        if (knob.name == name) return knob.help;
    throw Error("there is no knob " + name);
}

TEST_P(EveryLab, ShowsTheNotesAboutAFileInItsPicture) {
    const TemporaryFolder folder;
    Image heights(16, 16, 1), normals(16, 16, 3);
    for (size_t i = 0; i < 256; ++i) {
        heights.values[i] = float(i % 16) / 15;
        normals.values[3 * i] = normals.values[3 * i + 1] = 0.5f, normals.values[3 * i + 2] = 1;
    }
    heights.values[40] = normals.values[40] = NAN;
    write_image(folder.path() / "h.exr", heights), write_image(folder.path() / "n.exr", normals);
    folder.write("m.obj",
                 "v -1 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 2\nvt 0 0\nvt 1 0\nvt 0 1\nl 1 2\n"
                 "f 1/1 2/2 3/3\nf 2/1 1/2 4/3\nf 3/1 2/2 4/3\nf 1/1 3/2 4/3\n");
    const std::unique_ptr<Lab> plain = make_lab(GetParam(), shot());
    for (const std::string& knob : FileKnobs(*plain).names) {
        std::string named;
        const KnobHelp needs = help_of(*plain, knob);
        for (const char* const file : {"m.obj", "h.exr", "n.exr"}) {
            Shot with = shot();
            if (!needs.values.empty()) with.set = {{needs.knob, needs.values[0]}};
            with.set.emplace_back(knob, (folder.path() / file).string());
            testing::internal::CaptureStderr();
            const std::unique_ptr<Lab> lab = [&]() -> std::unique_ptr<Lab> {
                try {
                    return make_lab(GetParam(), with);
                } catch (const Error&) {
                    return nullptr;  // the knob is for another kind of file
                }
            }();
            const std::string printed = testing::internal::GetCapturedStderr();
            if (!lab) continue;
            std::vector<PictureWord> words;
            with.words = &words;
            draw_shot(*lab, with);
            for (const PictureWord& word : words)
                if (word.text.starts_with(std::string(file) + ":")) named = file;
            EXPECT_TRUE(contains(printed, "relief: " + std::string(file) + ":")) << knob << ": " << printed;
        }
        EXPECT_NE(named, "") << knob << ": no note in the picture";
    }
}

/// Expects that a larger value is never darker. Pixels without a surface, or without a value, are left out.
void expect_rising(const Image& probe, const Image& picture, const std::string& name,
                   const std::function<double(const float*)>& value, const std::function<double(const float*)>& color) {
    std::vector<std::pair<double, double>> all;
    for (size_t i = 0; i < probe.pixel_count(); ++i) {
        const float* const own = &probe.values[i * size_t(probe.channels)];
        if (std::isfinite(own[0]) && !std::isnan(value(own)))
            all.emplace_back(value(own), color(&picture.values[i * 3]));
    }
    std::sort(all.begin(), all.end());
    for (size_t i = 1; i < all.size(); ++i)
        ASSERT_GE(all[i].second, all[i - 1].second - 1e-6) << name << ": colours are rounded to floats";
}

/// Expects that a probe's picture repeats no colour.
void expect_no_repetition(const Image& probe, const ProbeInfo& info) {
    const Image picture = visualize_probe(probe, info.colors());
    if (info.error != ErrorMetric::absolute) {
        for (int c = 0; c < 3; ++c)
            expect_rising(
                probe, picture, info.name, [=](const float* v) { return double(v[c]); },
                [=](const float* color) { return double(color[c]); });
        return;
    }
    // Each scale of single numbers rises in lightness. If the sign matters, values below 0 have a separate scale.
    for (const double sign : {1.0, -1.0})
        expect_rising(
            probe, picture, info.name, [=](const float* v) { return sign * *v >= 0 ? std::abs(double(*v)) : NAN; },
            [](const float* color) { return double(color[0]) + color[1] + color[2]; });
}

TEST_P(EveryLab, EachProbeIsFiniteAgreesWithItsTruthAndRepeatsNoColour) {
    EXPECT_FALSE(manifest_.probes.empty());
    for (const ProbeInfo& info : manifest_.probes) {
        const Shot wanted = shot({info.name});
        const auto lab = make_lab(GetParam(), wanted);
        const Image probe = render_shot(*lab, wanted);  // throws when it is not a number anywhere
        expect_no_repetition(probe, info);
        const Frame frame{0, wanted.size, wanted.time, Camera(wanted.camera, 4.0 / 3), wanted.probe};
        const auto truth = lab->truth(frame);
        if (!truth) continue;
        const ErrorSummary error = summarize(error_image(probe, *truth, info.error));
        EXPECT_GT(error.count, probe.pixel_count() / 100) << info.name;
        EXPECT_EQ(error.not_finite, 0u) << info.name;
        EXPECT_LT(error.p99, info.limit) << info.name << " in " << info.unit;
    }
}

// A lab that draws a picture that is higher than wide with a wider field of view must use it for the exact values, too.
TEST_P(EveryLab, AgreesWithItsExactValuesInAPortraitPictureAsInALandscapeOne) {
    const auto mean_error = [&](const ProbeInfo& info, glm::ivec2 size) -> std::optional<double> {
        Shot wanted = shot({info.name});
        wanted.size = size;
        const auto lab = make_lab(GetParam(), wanted);
        const Frame frame{0, size, wanted.time, Camera(wanted.camera, double(size.x) / size.y), wanted.probe};
        const auto truth = lab->truth(frame);
        if (!truth) return {};
        return summarize(error_image(render_shot(*lab, wanted), *truth, info.error)).mean;
    };
    for (const ProbeInfo& info : manifest_.probes) {
        const std::optional<double> landscape = mean_error(info, {96, 48});
        if (!landscape) continue;
        // The two pictures show other parts of a scene: at most 1.2 times the error. Another camera gives 17 times.
        EXPECT_LE(mean_error(info, {48, 96}), 3 * *landscape) << info.name << " in " << info.unit;
        return;  // one probe is enough
    }
}

TEST_P(EveryLab, FreesEveryObjectAndByte) {
    const Counters before = counters();
    picture(shot());
    EXPECT_EQ(counters().live, before.live);
    EXPECT_EQ(counters().texture_bytes, before.texture_bytes);
}

TEST_P(EveryLab, ComesBackIdenticalAfterAnyOtherLab) {
    const Shot own = shot();
    const auto lab = make_lab(GetParam(), own);
    const Image before = render_shot(*lab, own);
    const Counters objects = counters();
    // Every sixth lab, so that each lab is the other one three times. `relief test --all` draws all pairs.
    const size_t step = tests_all() ? 1 : std::min<size_t>(6, registry().size());
    for (size_t i = size_t(GetParam().number) % step; i < registry().size(); i += step) {
        const LabEntry& other = registry()[i];
        Shot theirs;
        theirs.size = {64, 48};
        theirs.camera = load_manifest(other).camera;
        render_shot(*make_lab(other, theirs), theirs);
        EXPECT_EQ(render_shot(*lab, own).values, before.values) << "after " << other.folder;
    }
    EXPECT_EQ(counters().live, objects.live);
}

INSTANTIATE_TEST_SUITE_P(Labs, EveryLab, testing::ValuesIn(registry()),
                         [](const auto& lab) { return "Lab" + lab.param.folder; });

TEST(Labs, AreRegistered) { EXPECT_FALSE(registry().empty()); }

}  // namespace
}  // namespace relief
