// lab.toml and staff/grading.toml: all keys are read, and each mistake is reported with its line.
#include "framework/course/manifest/manifest.h"

#include <set>

#include "framework/core/base/paths.h"
#include "framework/course/manifest/paths.h"
#include "tests/support.h"

namespace relief {
namespace {

using Set = std::vector<std::pair<std::string, std::string>>;

/// Loads a lab.toml of this text, and a staff/grading.toml unless `grading` is empty.
Manifest load(const std::string& text, const std::string& grading = "") {
    const TemporaryFolder folder;
    if (!grading.empty()) folder.write("staff/grading.toml", grading);
    return load_manifest(folder.write("lab.toml", text));
}

/// Returns the error of loading these texts, without the folder: "lab.toml:2: ...".
std::string refusal(const std::string& text, const std::string& grading = "") {
    const std::string message = message_of([&] { load(text, grading); });
    return message.substr(
        std::min(message.size(), message.rfind(grading.empty() ? "lab.toml:" : "staff/grading.toml:")));
}

TEST(Manifest, IsReadWhole) {
    const Manifest manifest = load(R"(
title = "Parallax occlusion mapping"
learns = ["march a ray", "what a step costs"]
camera = { yaw = 60, pitch = -10.5, distance = 2.5, target = [1, 2, 3], field_of_view = 30 }
animated = true

[[probe]]
name = "normal"
unit = "degree"
error = "angle"
[[probe]]
name = "uv"
[[probe]]
name = "depth"
error = "absolute"

[[task]]
id = "11.1"
points = 3
title = "March"
file = "shaders/11/task.glsl"
[[task]]
id = "11.2"
points = 4
title = "Intersect"
file = "shaders/11/task.glsl"

[compare]
knob = "steps"
values = ["4", "16"]
shot = { set = { shadows = false }, camera = { yaw = 7 } }
probe = "uv"

[[golden]]
name = "default"
[[golden]]
name = "steep-uv_2"
shot = { set = { steps = 4, scale = 0.5, shadows = false, method = "cone" }, probe = "uv", time = 1.5, size = [64, 32], camera = { yaw = 5 } }
)");
    EXPECT_EQ(manifest.title, "Parallax occlusion mapping");
    EXPECT_EQ(manifest.learns, (std::vector<std::string>{"march a ray", "what a step costs"}));
    const Orbit camera{.yaw = 60, .pitch = -10.5, .distance = 2.5, .target = {1, 2, 3}, .field_of_view = 30};
    EXPECT_EQ(manifest.camera, camera);
    EXPECT_TRUE(manifest.animated);
    ASSERT_EQ(manifest.probes.size(), 3u);
    EXPECT_EQ(manifest.probe("normal").unit, "degree");
    EXPECT_EQ(manifest.probe("normal").error, ErrorMetric::angle);
    EXPECT_EQ(manifest.probe("uv").error, ErrorMetric::distance);
    EXPECT_EQ(manifest.probe("depth").error, ErrorMetric::absolute);
    ASSERT_EQ(manifest.tasks.size(), 2u);
    EXPECT_EQ(manifest.tasks[1].id, "11.2");
    EXPECT_EQ(manifest.tasks[1].title, "Intersect");
    EXPECT_EQ(manifest.tasks[1].file, "shaders/11/task.glsl");
    EXPECT_EQ(manifest.points(), 7);
    ASSERT_TRUE(manifest.compare);
    EXPECT_EQ(manifest.compare->knob, "steps");
    EXPECT_EQ(manifest.compare->values, (std::vector<std::string>{"4", "16"}));
    EXPECT_EQ(manifest.compare->shot.set, (Set{{"shadows", "off"}}));
    EXPECT_EQ(manifest.compare->shot.camera.yaw, 7);
    EXPECT_EQ(manifest.compare->shot.camera.pitch, -10.5);
    EXPECT_EQ(manifest.compare->shot.probe.name, "uv");
    EXPECT_EQ(manifest.compare->shot.size, glm::ivec2(560, 420));
    ASSERT_EQ(manifest.goldens.size(), 2u);
    EXPECT_EQ(manifest.goldens[0].shot.camera, camera);
    const Shot& shot = manifest.goldens[1].shot;
    EXPECT_EQ(manifest.goldens[1].name, "steep-uv_2");
    EXPECT_EQ(std::set(shot.set.begin(), shot.set.end()),
              (std::set<Set::value_type>{{"steps", "4"}, {"scale", "0.5"}, {"shadows", "off"}, {"method", "cone"}}));
    EXPECT_EQ(shot.probe.name, "uv");
    EXPECT_EQ(shot.time, 1.5);
    EXPECT_EQ(shot.size, glm::ivec2(64, 32));
    EXPECT_EQ(shot.camera.yaw, 5);
    EXPECT_EQ(shot.camera.distance, 2.5) << "what a shot leaves out is the lab's";
}

TEST(Manifest, QuestionsAreTheStaffsAndHaveTwoWrongAnswersOrMore) {
    const std::string two = "[[question]]\nasks = \"a?\"\nright = \"b\"\nwrong = [\"c\", \"d\"]\nwhy = \"e\"\n",
                      one = "[[question]]\nasks = \"a?\"\nright = \"b\"\nwrong = [\"c\"]\nwhy = \"e\"\n";
    Manifest manifest = load("title = \"a\"\n");
    add_grading(manifest, two, "grading.toml");
    ASSERT_EQ(manifest.questions.size(), 1u);
    EXPECT_EQ(manifest.questions[0].right, "b");
    EXPECT_EQ(manifest.questions[0].wrong, (std::vector<std::string>{"c", "d"}));
    EXPECT_THROW(add_grading(manifest, one, "grading.toml"), Error);
    EXPECT_TRUE(contains(refusal("title = \"a\"\n" + two), "belongs in staff/grading.toml"));
}

TEST(Manifest, StatesTimeNeedsAndWhatMayBeLeftOut) {
    const std::string begin =
        "title = \"a\"\nhours = 1\nneeds = [\"03\", \"06\", \"15\"]\nmathematics = [\"gradients\"]\n"
        "leave_out = [\"In the code\"]\nweeks = { short = 3 }\n";
    const std::string tasks =
        "[[task]]\nid = \"1.1\"\ntitle = \"b\"\nfile = \"shaders/01/task.glsl\"\npoints = 3\n"
        "[[task]]\nid = \"1.2\"\ntitle = \"c\"\nfile = \"labs/01/task.cpp\"\npoints = 2\noptional = true\n";
    const Manifest manifest = load(begin + tasks);
    EXPECT_EQ(manifest.points(), 3);
    EXPECT_EQ(manifest.optional_points(), 2);
    EXPECT_EQ(points_of_lab(manifest), "3 points and 2 optional");
    EXPECT_EQ(manifest.weeks, (std::map<std::string, int>{{"short", 3}}));
    EXPECT_EQ(
        effort_text(manifest),
        "About 1 hour. Before it: labs 03, 06 and 15; gradients. C++ in task 1.2. You may leave out task 1.2, and "
        "the chapter “In the code”.");
    EXPECT_EQ(effort_text(load("title = \"a\"\nhours = 2.5\nelective = true\n")),
              "About 2.5 hours. No C++. An elective: no other lab needs it.");
    EXPECT_EQ(effort_text(load("title = \"a\"\nhours = 2\n")), "About 2 hours. No C++. Leave nothing out.");
    EXPECT_EQ(refusal("title = \"a\"\nweeks = { short = 4 }\n"),
              "lab.toml:2: 'short' must be a whole number from 1 to 3");
    EXPECT_TRUE(contains(refusal("title = \"a\"\nweeks = { long = 1 }\n"), "long"));
    EXPECT_TRUE(contains(refusal("title = \"a\"\n[[task]]\nid = \"1.1\"\ntitle = \"b\"\nfile = \"a/b.glsl\"\n"
                                 "points = 1\noptional = true\n"),
                         "a lab with points has a task that is not optional"));
}

TEST(Manifest, NeedsOnlyATitle) {
    const Manifest manifest = load("title = \"A\"\n");
    EXPECT_EQ(manifest.camera, Orbit{});
    EXPECT_TRUE(manifest.probes.empty() && manifest.tasks.empty() && manifest.goldens.empty() && !manifest.animated);
    EXPECT_FALSE(manifest.compare);
    EXPECT_EQ(manifest.points(), 0);
}

TEST(Manifest, AMistakeIsNamedWithItsLine) {
    const struct {
        const char *text, *message;
    } mistakes[] = {
        {"title = \"A\"\nanimated = yes\n", "lab.toml:2: "},
        {"title = \"A\"\n\ntitle = \"B\"\n", "lab.toml:3: "},
        {"title = \"A\"\nanimatde = true\n",
         "lab.toml:2: unknown key of a manifest, 'animatde': did you mean 'animated'?"},
        {"animated = true\n", "lab.toml:1: a manifest must have a 'title'"},
        {"", "lab.toml:1: a manifest must have a 'title'"},
        {"title = 7\n", "lab.toml:1: 'title' must be a text in quotes"},
        {"title = \"A\"\nanimated = 1\n", "lab.toml:2: 'animated' must be true or false"},
        {"title = \"A\"\nlearns = \"x\"\n", "lab.toml:2: 'learns' must be a list of texts"},
        {"title = \"A\"\nlearns = [\n\"x\",\n5]\n", "lab.toml:4: 'learns' must be a list of texts"},
        {"title = \"A\"\ncamera = 5\n", "lab.toml:2: 'camera' must be a table"},
        {"title = \"A\"\ncamera = { yaw = \"5\" }\n", "lab.toml:2: 'yaw' must be a number"},
        {"title = \"A\"\n[camera]\npitch = 90\n", "lab.toml:3: 'pitch' must be from -89 to 89"},
        {"title = \"A\"\n[camera]\nyaw = nan\n", "lab.toml:3: 'yaw' must be from"},
        {"title = \"A\"\n[camera]\ndistance = 0\n", "lab.toml:3: 'distance' must be from"},
        {"title = \"A\"\n[camera]\nfield_of_view = 180\n", "lab.toml:3: 'field_of_view' must be from 1 to 170"},
        {"title = \"A\"\n[camera]\ntarget = [0, 1]\n", "lab.toml:3: 'target' must be 3 numbers"},
        {"title = \"A\"\n[camera]\n\nfov = 40\n", "lab.toml:4: unknown key of a manifest.camera, 'fov'"},
        {"title = \"A\"\nprobe = \"uv\"\n", "lab.toml:2: write each probe as [[probe]]"},
        {"title = \"A\"\n[probe]\nname = \"uv\"\n", "lab.toml:2: write each probe as [[probe]]"},
        {"title = \"A\"\n\n[[probe]]\nunit = \"m\"\n", "lab.toml:3: [[probe]] must have a 'name'"},
        {"title = \"A\"\n[[task]]\nid = \"1\"\ntitle = \"T\"\nfile = \"f\"\npoints = 1.5\n",
         "lab.toml:6: 'points' must be a whole number from 0 to 1000"},
        {"title = \"A\"\n[[task]]\nid = \"1\"\ntitle = \"T\"\nfile = \"f\"\npoints = -1\n",
         "lab.toml:6: 'points' must be a whole number"},
        {"title = \"A\"\n[[golden]]\nname = \"a\"\nshot = { size = [0, 8] }\n", "lab.toml:4: 'size' must be from 1 to"},
        {"title = \"A\"\n[[golden]]\nname = \"a\"\nshot = { size = [8.5, 8] }\n", "lab.toml:4: 'size' must be"},
        {"title = \"A\"\n[[golden]]\nname = \"a\"\nshot = { time = -3e9 }\n",
         "lab.toml:4: 'time' must be from -2000000000"},
        {"title = \"A\"\n[[golden]]\nname = \"a\"\nshot = { set = { steps = [1] } }\n",
         "lab.toml:4: 'steps' must be a number"},
        {"title = \"A\"\n[[golden]]\nname = \"../a\"\n", "lab.toml:3: '../a' names a file: use a-z"},
        {"title = \"A\"\n[compare]\nvalues = [\"1\", \"2\"]\n", "lab.toml:2: a manifest.compare must have a 'knob'"},
        {"title = \"A\"\n[compare]\nknob = 3\n", "lab.toml:3: 'knob' must be a text in quotes"},
        {"title = \"A\"\n[compare]\nknob = \"a\"\nvalues = [1, 2]\n", "lab.toml:4: 'values' must be a list of texts"},
        {"title = \"A\"\n[compare]\nknob = \"a\"\nvalues = [\"1\"]\n", "lab.toml:4: 'values' are two at least"},
        {"title = \"A\"\n[compare]\nknob = \"a\"\nvalues = [\"1\", \"1\"]\n",
         "lab.toml:4: '1' stands twice in 'values'"},
        {"title = \"A\"\n[compare]\nknob = \"a\"\nvalue = [\"1\"]\n",
         "lab.toml:4: unknown key of a manifest.compare, 'value': did you mean 'values'?"},
        {"title = \"A\"\n[compare]\nknob = \"a\"\nshot = { size = [0, 8] }\n", "lab.toml:4: 'size' must be from 1 to"},
        {"title = \"A\"\n[compare]\nknob = \"a\"\nshot = { set = { a = 1 } }\n",
         "lab.toml:4: 'a' is what is compared: 'shot' must not set it"},
        {"title = \"A\"\n[compare]\nknob = \"a\"\nprobe = \"uv\"\n", "lab.toml:4: unknown probe 'uv'"},
        {"title = \"A\"\n[[compare]]\nknob = \"a\"\n", "lab.toml:2: 'compare' must be a table"},
        {"title = \"A\"\n[[golden]]\nname = \"a\"\n\n[[golden]]\nname = \"a\"\n",
         "lab.toml:6: two golden pictures are named 'a'"},
    };
    for (const auto& [text, message] : mistakes) {
        const std::string found = refusal(text);
        EXPECT_TRUE(found.starts_with(message)) << text << "gives\n" << found << "\nnot\n" << message;
    }
}

constexpr const char* with_task = R"(title = "A"
[[probe]]
name = "uv"
[[task]]
id = "1.1"
title = "T"
file = "shaders/x/task.glsl"
)";

TEST(Manifest, ChecksMistakesAndEquivalentsAreReadWhole) {
    const Manifest manifest = load(std::string(with_task) + R"(
[[check]]
task = "1.1"
name = "near"
shot = { set = { steps = 32 }, camera = { yaw = 60 }, size = [64, 32] }
probe = "uv"
against = "truth"
limit = { mean = 0.5, wrong = 0.06, outline = 0.1 }
reason = "as published"
look_at = "the crossing"
)",
                                   R"(
[[check]]
task = "1.1"
name = "far"
probe = "uv"
against = "near"
limit = { largest = 1, p99 = 0.5 }
reason = "the same"
look_at = "both"
[[mistake]]
id = "flipped"
task = "1.1"
hint = "The sign."
edits = [{ file = "shaders/x/task.glsl", find = "a", replace = "b" }, { file = "labs/x/task.cpp", find = "c", replace = "" }]
[[mistake]]
id = "turned"
task = "1.1"
hint = "The other sign."
edits = [{ find = "c", replace = "d" }]
same_as = "flipped"
[[equivalent]]
id = "by-hand"
task = "1.1"
why = "Without the library."
edits = [{ file = "shaders/x/task.glsl", find = "a", replace = '''
two
lines''' }]
)");
    ASSERT_EQ(manifest.checks.size(), 3u) << "the last one is of the picture";
    const CheckInfo& check = manifest.check("near");
    EXPECT_EQ(check.task, "1.1");
    EXPECT_EQ(check.shot.size, glm::ivec2(64, 32));
    EXPECT_EQ(check.shot.camera.yaw, 60);
    EXPECT_EQ(check.shot.probe.name, "uv");
    EXPECT_EQ(check.against, "truth");
    EXPECT_EQ(check.limits.mean, 0.5);
    EXPECT_EQ(check.limits.wrong, 0.06);
    EXPECT_EQ(check.limits.outline, 0.1);
    EXPECT_FALSE(check.limits.p99 || check.limits.largest || check.hidden);
    EXPECT_EQ(check.reason, "as published");
    EXPECT_EQ(check.look_at, "the crossing");
    EXPECT_TRUE(manifest.check("far").hidden);
    EXPECT_EQ(manifest.check("far").shot.size, glm::ivec2(128, 128)) << "small, so that a check takes no time";
    ASSERT_EQ(manifest.mistakes.size(), 2u);
    EXPECT_EQ(manifest.mistakes[0].edits.at(1).file, "labs/x/task.cpp");
    EXPECT_EQ(manifest.mistakes[0].edits.at(1).replace, "");
    EXPECT_EQ(manifest.mistakes[1].same_as, "flipped");
    EXPECT_EQ(manifest.mistakes[1].edits.at(0).file, "shaders/x/task.glsl") << "the task's";
    ASSERT_EQ(manifest.equivalents.size(), 1u);
    EXPECT_EQ(manifest.equivalents[0].id, "by-hand");
    EXPECT_EQ(manifest.equivalents[0].task, "1.1");
    EXPECT_EQ(manifest.equivalents[0].why, "Without the library.");
    EXPECT_EQ(manifest.equivalents[0].edits.at(0).replace, "two\nlines");
}

const std::string example = "[[example]]\ntask = \"1.1\"\nasks = \"never NaN\"\n",
                  calls = "calls = [\"f(0.0)\", \"f(1.0)\"]\n",
                  one_edit = "edits = [{ find = \"a\", replace = \"b\" }]\n";

TEST(Manifest, TheExamplesOfATaskAreAPublicAndAHiddenCheck) {
    const std::string other = "[[example]]\ntask = \"1.1\"\nasks = \"at most 1\"\ncalls = [\"f(3.0)\"]\n";
    const Manifest manifest =
        load(with_task + example + calls, example + "calls = [\"f(2.0)\"]\n" + one_edit + other + one_edit);
    ASSERT_EQ(manifest.examples.size(), 3u);
    EXPECT_FALSE(manifest.examples[0].hidden);
    EXPECT_EQ(manifest.examples[0].edits.size(), 1u) << "the staff's file has those of the same words";
    EXPECT_TRUE(manifest.examples[1].hidden && manifest.examples[2].hidden);
    EXPECT_TRUE(manifest.examples[1].edits.empty()) << "they are the public example's";
    EXPECT_EQ(manifest.examples[2].edits.size(), 1u);
    ASSERT_EQ(manifest.checks.size(), 2u);
    const CheckInfo& check = manifest.checks[0];
    EXPECT_FALSE(check.hidden);
    EXPECT_EQ(check.task, "1.1");
    EXPECT_EQ(check.against, "solution");
    EXPECT_EQ(check.shot.calls.file, "shaders/x/task.glsl");
    EXPECT_EQ(check.shot.calls.texts, (std::vector<std::string>{"f(0.0)", "f(1.0)"}));
    EXPECT_EQ(check.shot.size, glm::ivec2(2, 1)) << "one pixel a call";
    EXPECT_EQ(manifest.probe(check.shot.probe.name).name, calls_probe);
    EXPECT_TRUE(manifest.checks[1].hidden);
    EXPECT_EQ(manifest.checks[1].name, "more words of task 1.1");
    EXPECT_EQ(manifest.checks[1].shot.calls.texts, (std::vector<std::string>{"f(2.0)", "f(3.0)"}));
    EXPECT_EQ(load(with_task + example + calls, example + one_edit).checks.size(), 1u) << "edits alone add no call";
    EXPECT_EQ(load(with_task + example + calls).checks.size(), 1u) << "students get the public one";
    EXPECT_EQ(message_of<UsageError>([&] { manifest.view_of_check(check.name); }),
              "'the words of task 1.1' has no view: it calls functions of shaders/x/task.glsl");
}

// Otherwise a submission could be right in the probe, and wrong in the picture.
TEST(Manifest, ATaskWithProbesOnlyGetsAHiddenCheckOfItsPicture) {
    const std::string second = "[[task]]\nid = \"1.2\"\ntitle = \"T\"\nfile = \"shaders/x/task.glsl\"\n";
    const std::string of_a_probe =
        "[[check]]\ntask = \"1.1\"\nname = \"near\"\nshot = { set = { steps = 32 }, size = [24, 8] }\nprobe = \"uv\"\n"
        "against = \"truth\"\nlimit = { mean = 1 }\nreason = \"r\"\nlook_at = \"x\"\n";
    const std::string of_a_picture =
        "[[check]]\ntask = \"1.2\"\nname = \"lit\"\nagainst = \"solution\"\nlook_at = \"x\"\n";
    const std::string text = with_task + second + of_a_probe + of_a_picture;
    EXPECT_EQ(load(text).checks.size(), 2u) << "students do not get it";
    const Manifest manifest = load(text, "vary = { yaw = [0, 1] }\n");
    ASSERT_EQ(manifest.checks.size(), 3u) << "1.2 has a check of its picture";
    const CheckInfo& added = manifest.checks.back();
    EXPECT_EQ(added.name, "the picture of 'near'");
    EXPECT_EQ(added.task, "1.1");
    EXPECT_TRUE(added.hidden && added.added);
    EXPECT_FALSE(added.shot.probe);
    EXPECT_EQ(added.shot.set, manifest.check("near").shot.set);
    EXPECT_EQ(added.shot.size, glm::ivec2(128, 128)) << "a picture of a few pixels allows no odd one";
    EXPECT_EQ(added.against, "solution");
    EXPECT_EQ(added.needs, std::vector<std::string>{"1.2"}) << "a picture takes all tasks of its lab";
}

TEST(Manifest, AnInvalidCheckMistakeOrEquivalentIsReportedWithItsLine) {
    const std::string check = "[[check]]\ntask = \"1.1\"\nname = \"a\"\nlook_at = \"x\"\n";
    const std::string task_2 = "[[task]]\nid = \"1.2\"\ntitle = \"t\"\nfile = \"f\"\n";
    const std::string mistake = "[[mistake]]\nid = \"m\"\ntask = \"1.1\"\nhint = \"h\"\n";
    const std::string equivalent = "[[equivalent]]\nid = \"e\"\ntask = \"1.1\"\nwhy = \"w\"\n";
    const std::string edits = "edits = [{ file = \"shaders/x/task.glsl\", find = \"a\", replace = \"b\" }]\n";
    const std::pair<std::string, const char*> texts[] = {
        {check, "lab.toml:8: [[check]] must have a 'against'"},
        {check + "against = \"truht\"\n", "lab.toml:12: unknown check 'truht'"},
        {check + "against = \"truth\"\n", "lab.toml:12: a truth is of a 'probe'"},
        {check + "against = \"truth\"\nprobe = \"uv\"\n", "lab.toml:10: a check of a probe has a 'limit'"},
        {check + "against = \"truth\"\nprobe = \"vu\"\n", "lab.toml:13: unknown probe 'vu'"},
        {check + "against = \"truth\"\nprobe = \"uv\"\nlimit = { mean = 1 }\n",
         "lab.toml:10: a 'limit' has a 'reason'"},
        {check + "against = \"truth\"\nprobe = \"uv\"\nlimit = { maen = 1 }\n",
         "lab.toml:14: unknown key of [[check]].limit, 'maen'"},
        {check + "against = \"solution\"\nlimit = { mean = 1 }\nreason = \"r\"\n",
         "lab.toml:10: a picture is compared by the course's rule"},
        {"[[check]]\ntask = \"1.2\"\nname = \"a\"\nlook_at = \"x\"\nagainst = \"solution\"\n",
         "lab.toml:9: unknown task '1.2'"},
        {check + "against = \"solution\"\nneeds = \"1.2\"\n", "lab.toml:13: 'needs' must be a list of texts"},
        {check + "against = \"solution\"\nneeds = [\"1.3\"]\n", "lab.toml:13: unknown task '1.3'"},
        {check + "against = \"solution\"\nneeds = [\"1.1\"]\n",
         "lab.toml:13: 'needs' names other tasks than the check's own"},
        {task_2 + check + "against = \"solution\"\nneeds = [\"1.2\", \"1.2\"]\n",
         "lab.toml:17: 'needs' names task 1.2 twice"},
        {check + "against = \"solution\"\n" + mistake, "lab.toml:13: 'mistake' belongs in staff/grading.toml"},
        {example, "lab.toml:10: an example has 'calls'"},
        {example + calls + edits, "lab.toml:12: the 'edits' of an example belong in staff/grading.toml"},
        {example + calls + example + calls, "lab.toml:14: two examples of task 1.1 ask for \"never NaN\""},
    };
    for (const auto& [text, message] : texts) {
        const std::string found = refusal(with_task + text);
        EXPECT_TRUE(found.starts_with(message)) << text << "gives\n" << found << "\nnot\n" << message;
    }
    const std::pair<std::string, const char*> staffs_texts[] = {
        {mistake, "staff/grading.toml:2: a mistake has 'edits'"},
        {mistake + "edits = [{ file = \"../x\", find = \"a\", replace = \"b\" }]\n",
         "staff/grading.toml:5: 'file' is a path inside the course"},
        {mistake + "edits = [{ file = \"x\", find = \"a\", replace = \"b\" }]\nsame_as = \"n\"\n",
         "staff/grading.toml:6: unknown mistake 'n'"},
        {mistake + "edits = [{ file = \"x\", find = \"a\", replace = \"b\" }]\n" + mistake +
             "edits = [{ file = \"x\", find = \"a\", replace = \"b\" }]\n",
         "staff/grading.toml:7: two mistakes are named 'm'"},
        {mistake + "edits = [{ file = \"x\", find = \"a\", replace = \"a\" }]\n",
         "staff/grading.toml:5: 'replace' is what stands there"},
        {equivalent, "staff/grading.toml:2: an equivalent has 'edits'"},
        {"[[equivalent]]\nid = \"e\"\ntask = \"1.1\"\n" + edits,
         "staff/grading.toml:1: [[equivalent]] must have a 'why'"},
        {equivalent + "hint = \"h\"\n" + edits, "staff/grading.toml:5: unknown key of [[equivalent]], 'hint'"},
        {equivalent + "edits = [{ file = \"shaders/x/task.glsl\", fnid = \"a\", find = \"a\", replace = \"b\" }]\n",
         "staff/grading.toml:5: unknown key of [[equivalent]].edits, 'fnid'"},
        {equivalent + "edits = [{ file = \"shaders/x/lab.frag\", find = \"a\", replace = \"b\" }]\n",
         "staff/grading.toml:5: 'shaders/x/lab.frag' is no task's file"},
        {"[[equivalent]]\nid = \"e\"\ntask = \"1.2\"\nwhy = \"w\"\n" + edits,
         "staff/grading.toml:3: unknown task '1.2'"},
        {equivalent + edits + equivalent + edits, "staff/grading.toml:7: two equivalents are named 'e'"},
        {"[[example]]\ntask = \"1.1\"\nasks = \"a\"\n" + edits, "staff/grading.toml:3: an example has 'calls'"},
        {"[[example]]\ntask = \"1.1\"\nasks = \"a\"\ncalls = [\"f()\"]\n",
         "staff/grading.toml:1: an example has 'edits'"},
    };
    for (const auto& [text, message] : staffs_texts) {
        const std::string found = refusal(with_task, text);
        EXPECT_TRUE(found.starts_with(message)) << text << "gives\n" << found << "\nnot\n" << message;
    }
}

TEST(Manifest, SuggestsErrorsAndProbes) {
    EXPECT_TRUE(refusal("title = \"A\"\n[[probe]]\nname = \"uv\"\nerror = \"distnace\"\n")
                    .starts_with("lab.toml:4: unknown error 'distnace': did you mean 'distance'?"));
    const std::string probe = "title = \"A\"\n[[probe]]\nname = \"normal\"\n";
    EXPECT_TRUE(refusal(probe + "[[golden]]\nname = \"a\"\nshot = { probe = \"nromal\" }\n")
                    .starts_with("lab.toml:6: unknown probe 'nromal': did you mean 'normal'?"));
    const Manifest manifest = load(probe);
    EXPECT_TRUE(contains(message_of<UsageError>([&] { manifest.probe("nromal"); }), "did you mean 'normal'?"));
}

TEST(Manifest, KnobsOfAShotKeepAllTheirDigits) {
    const Manifest manifest =
        load("title = \"A\"\n[[golden]]\nname = \"a\"\nshot.set = { big = 12345678, fine = 0.123456789 }\n");
    for (const auto& [name, value] : manifest.goldens.at(0).shot.set)
        EXPECT_EQ(value, name == "big" ? "12345678" : "0.123456789");
}

}  // namespace
}  // namespace relief
