#include "framework/course/manifest/manifest.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <limits>
#include <set>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/course/manifest/paths.h"
#include "framework/course/manifest/toml_table.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

constexpr double any = std::numeric_limits<double>::max();
constexpr glm::ivec2 usual_check_size{128, 128};

void read_camera(Table parent, Orbit& camera) {
    parent.read("yaw", camera.yaw, -36000, 36000);
    parent.read("pitch", camera.pitch, -89, 89);
    parent.read("distance", camera.distance, 1e-3, 1e6);
    parent.read("field_of_view", camera.field_of_view, 1, 170);
    std::array<double, 3> target{};
    if (parent.read<3>("target", target, -1e6, 1e6)) camera.target = {target[0], target[1], target[2]};
    parent.finish();
}

Shot read_shot(Table table, const Orbit& camera, glm::ivec2 usual_size) {
    Shot shot;
    shot.camera = camera;
    shot.size = usual_size;
    if (auto knobs = table.table("set")) shot.set = knobs->all_as_text();
    if (auto place = table.table("camera")) read_camera(*place, shot.camera);
    table.read("probe", shot.probe.name);
    table.read("time", shot.time, -2e9, 2e9);
    std::array<double, 2> size{};
    if (table.read<2>("size", size, 1, max_picture_side)) {
        shot.size = {int(size[0]), int(size[1])};
        if (shot.size.x != size[0] || shot.size.y != size[1])
            table.fail("size", "'size' must be whole numbers of pixels");
    }
    table.finish();
    return shot;
}

bool is_identifier(const std::string& name) {
    return !name.empty() && name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
}

ErrorMetric read_metric(Table& table) {
    std::string text = "distance";
    table.read("error", text);
    if (text == "distance") return ErrorMetric::distance;
    if (text == "angle") return ErrorMetric::angle;
    if (text == "absolute") return ErrorMetric::absolute;
    const std::vector<std::string> known = {"distance", "angle", "absolute"};
    table.fail("error", unknown("error", text, known));
}

bool is_file_name(const std::string& name) {
    return !name.empty() && name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-_") == std::string::npos;
}

/// Returns whether a path stays inside the course. A manifest may come from anyone.
bool is_course_path(const std::string& path) {
    const fs::path normal = fs::path(path).lexically_normal();
    return !path.empty() && normal.is_relative() && *normal.begin() != "..";
}

template <class Things, class Member>
void refuse_second(const Table& table, const char* key, const char* kind, const Things& things, Member name,
                   const std::string& wanted) {
    for (const auto& thing : things)
        if (thing.*name == wanted) table.fail(key, fmt::format("two {} are named '{}'", kind, wanted));
}

template <class Thing>
const Thing& find_named(const std::vector<Thing>& things, std::string Thing::*name, const char* kind,
                        const std::string& wanted) {
    std::vector<std::string> known;
    for (const Thing& thing : things) {
        if (thing.*name == wanted) return thing;
        known.push_back(thing.*name);
    }
    throw UsageError(unknown(kind, wanted, known));
}

/// Calls a look-up. Its UsageError becomes an Error at a key of the table.
template <class LookUp>
void require(const Table& table, const char* key, LookUp look_up) {
    try {
        look_up();
    } catch (const UsageError& error) {
        table.fail(key, error.what());
    }
}

ProbeInfo read_probe(Table& table) {
    ProbeInfo probe;
    probe.name = table.text("name");
    table.read("unit", probe.unit);
    probe.error = read_metric(table);
    table.read("limit", probe.limit, 0, any);
    table.read("any_length", probe.any_length);
    table.read("signed", probe.is_signed);
    if (auto knobs = table.table("without")) probe.without = knobs->all_as_text();
    table.finish();
    if (probe.name == calls_probe) table.fail("name", fmt::format("'{}' is the probe of examples", calls_probe));
    if (!is_identifier(probe.name))
        table.fail("name", fmt::format("'{}' becomes PROBE_<name> in the shader: use a-z, 0-9 and _", probe.name));
    return probe;
}

TaskInfo read_task(Table& table) {
    TaskInfo task;
    task.id = table.text("id");
    task.title = table.text("title");
    task.file = table.text("file");
    table.read("points", task.points, 0, 1000);
    table.read("functions", task.functions);
    table.read("optional", task.optional);
    table.finish();
    if (!is_course_path(task.file))
        table.fail("file", "'file' is a path inside the course, like shaders/20_x/task.glsl");
    return task;
}

/// Reads what a lab costs, what it builds on, and its place in the course's paths.
void read_effort(Table& root, Manifest& manifest) {
    root.read("hours", manifest.hours, 0.5, 100);
    root.read("needs", manifest.needs);
    root.read("mathematics", manifest.mathematics);
    root.read("leave_out", manifest.leave_out);
    root.read("elective", manifest.elective);
    auto weeks = root.table("weeks");
    if (!weeks) return;
    for (const CoursePath& path : course_paths)
        if (weeks->has(path.name)) weeks->read(path.name, manifest.weeks[path.name], 1, path.weeks);
    weeks->finish();
}

Limits read_limits(Table table) {
    Limits limits;
    const auto read = [&](const char* key, std::optional<double>& limit, double highest) {
        double value = -1;
        table.read(key, value, 0, highest);
        if (value >= 0) limit = value;
    };
    read("mean", limits.mean, any);
    read("p99", limits.p99, any);
    read("largest", limits.largest, any);
    read("at_least", limits.at_least, any);
    read("wrong", limits.wrong, 1);
    table.read("outline", limits.outline, 0, 1);
    table.finish();
    if (limits.at_least && !(limits.mean && *limits.at_least < *limits.mean))
        table.fail("at_least", "'at_least' is of the mean, and less than its limit");
    return limits;
}

CheckInfo read_check(Table& table, const Manifest& manifest) {
    CheckInfo check;
    check.task = table.text("task");
    check.name = table.text("name");
    check.shot.camera = manifest.camera;
    check.shot.size = usual_check_size;
    if (auto shot = table.table("shot")) check.shot = read_shot(*shot, manifest.camera, usual_check_size);
    table.read("probe", check.shot.probe.name);
    check.against = table.text("against");
    if (auto limits = table.table("limit")) check.limits = read_limits(*limits);
    table.read("reason", check.reason);
    check.look_at = table.text("look_at");
    table.read("needs", check.needs);
    table.read("leans_on", check.leans_on);
    table.finish();
    require(table, "task", [&] { manifest.task(check.task); });
    const auto refuse_wrong = [&](const char* key, const std::vector<std::string>& tasks) {
        for (auto one = tasks.begin(); one != tasks.end(); ++one) {
            require(table, key, [&] { manifest.task(*one); });
            if (*one == check.task) table.fail(key, fmt::format("'{}' names other tasks than the check's own", key));
            if (std::find(tasks.begin(), one, *one) != one)
                table.fail(key, fmt::format("'{}' names task {} twice", key, *one));
        }
    };
    refuse_wrong("needs", check.needs);
    refuse_wrong("leans_on", check.leans_on);
    if (check.shot.probe) require(table, "probe", [&] { manifest.probe(check.shot.probe.name); });
    const Limits& limits = check.limits;
    const bool limited = limits.mean || limits.p99 || limits.largest || limits.wrong;
    if (check.shot.probe && !limited)
        table.fail("name", "a check of a probe has a 'limit', like { mean = 0.5, wrong = 0.06 }");
    if (limited && check.reason.empty()) table.fail("name", "a 'limit' has a 'reason'");
    if (!check.shot.probe && limited) table.fail("name", "a picture is compared by the course's rule: no 'limit'");
    if (check.against == "truth" && !check.shot.probe) table.fail("against", "a truth is of a 'probe'");
    return check;
}

/// Reads the edits of a task's code. An edit that names no file is one of the task's file.
std::vector<Edit> read_edits(Table& table, const char* kind, const Manifest& manifest, const std::string& task) {
    require(table, "task", [&] { manifest.task(task); });
    std::vector<Edit> edits;
    for (Table& edit : table.inline_tables("edits")) {
        std::string file = manifest.task(task).file;
        edit.read("file", file);
        edits.push_back({file, edit.text("find"), edit.text("replace")});
        edit.finish();
        if (!is_course_path(edits.back().file)) edit.fail("file", "'file' is a path inside the course");
        if (edits.back().find == edits.back().replace) edit.fail("replace", "'replace' is what stands there");
    }
    if (edits.empty()) table.fail("id", fmt::format("{} has 'edits' = [{{ find, replace }}]", kind));
    return edits;
}

MistakeInfo read_mistake(Table& table, const Manifest& manifest) {
    MistakeInfo mistake;
    mistake.id = table.text("id");
    mistake.task = table.text("task");
    mistake.hint = table.text("hint");
    mistake.edits = read_edits(table, "a mistake", manifest, mistake.task);
    table.read("same_as", mistake.same_as);
    table.finish();
    return mistake;
}

void read_words(Table& table, const Manifest& manifest, ExampleInfo& example) {
    example.task = table.text("task");
    example.asks = table.text("asks");
    require(table, "task", [&] { manifest.task(example.task); });
    table.read("calls", example.calls);
    table.read("within", example.within, 0, any);
    table.read("needs", example.needs);
    for (const std::string& other : example.needs) require(table, "needs", [&] { manifest.task(other); });
}

constexpr const char* without_calls = "an example has 'calls' = [\"function(arguments)\"]";

void read_public_example(Table& table, Manifest& manifest) {
    ExampleInfo example;
    read_words(table, manifest, example);
    if (table.has("edits"))
        table.fail("edits", "the 'edits' of an example belong in staff/grading.toml: they show the solution");
    table.finish();
    if (example.calls.empty()) table.fail("asks", without_calls);
    for (const ExampleInfo& other : manifest.examples)
        if (other.task == example.task && other.asks == example.asks)
            table.fail("asks", fmt::format("two examples of task {} ask for \"{}\"", example.task, example.asks));
    manifest.examples.push_back(std::move(example));
}

/// Reads an example of the staff's file. If a public example has the same words, the edits are of that example, and
/// calls are hidden ones in addition.
void read_staff_example(Table& table, Manifest& manifest) {
    ExampleInfo example;
    example.hidden = true;
    read_words(table, manifest, example);
    example.edits = read_edits(table, "an example", manifest, example.task);
    table.finish();
    const auto same = std::find_if(manifest.examples.begin(), manifest.examples.end(), [&](const ExampleInfo& other) {
        return !other.hidden && other.task == example.task && other.asks == example.asks;
    });
    if (same == manifest.examples.end()) {
        if (example.calls.empty()) table.fail("asks", without_calls);
    } else {
        if (!same->edits.empty())
            table.fail("asks", fmt::format("two examples of task {} ask for \"{}\"", example.task, example.asks));
        same->edits = std::exchange(example.edits, {});
        if (example.calls.empty()) return;
    }
    manifest.examples.push_back(std::move(example));
}

/// Adds a check for each task that has public examples, or hidden ones.
void add_example_checks(bool hidden, Manifest& manifest) {
    for (const TaskInfo& task : manifest.tasks) {
        CheckInfo check;
        check.task = task.id;
        check.name = fmt::format("{} of task {}", hidden ? "more words" : "the words", task.id);
        check.against = "solution";
        check.shot.probe.name = calls_probe;
        check.shot.calls.file = task.file;
        check.shot.calls.includes = manifest.example_includes;
        std::set<std::string> needs;
        for (const ExampleInfo& example : manifest.examples) {
            if (example.task != task.id || example.hidden != hidden) continue;
            check.shot.calls.texts.insert(check.shot.calls.texts.end(), example.calls.begin(), example.calls.end());
            needs.insert(example.needs.begin(), example.needs.end());
        }
        check.needs.assign(needs.begin(), needs.end());
        if (!check.shot.calls) continue;
        check.shot.size = {int(check.shot.calls.texts.size()), 1};
        check.look_at = "read the task's text once more, sentence by sentence";
        check.hidden = hidden;
        manifest.checks.push_back(std::move(check));
    }
}

/// Reads knobs that vary: two numbers are a range, texts are choices.
std::vector<VaryInfo> read_vary(Table table) {
    std::vector<VaryInfo> all;
    for (const std::string& knob : table.keys()) {
        VaryInfo& vary = all.emplace_back(VaryInfo{.knob = knob});
        if (table.is_texts(knob.c_str())) {
            table.read(knob.c_str(), vary.choices);
        } else {
            std::array<double, 2> range{};
            table.read<2>(knob.c_str(), range, -any, any);
            vary.low = range[0], vary.high = range[1];
            if (!(vary.low < vary.high))
                table.fail(knob.c_str(), fmt::format("'{}' must be a range, low to high", knob));
        }
    }
    return all;
}

QuestionInfo read_question(Table& table) {
    QuestionInfo question;
    question.asks = table.text("asks");
    question.right = table.text("right");
    table.read("wrong", question.wrong);
    question.why = table.text("why");
    if (question.wrong.size() < 2) table.fail("wrong", "'wrong' has two answers or more");
    table.finish();
    return question;
}

EquivalentInfo read_equivalent(Table& table, const Manifest& manifest) {
    EquivalentInfo equivalent;
    equivalent.id = table.text("id");
    equivalent.task = table.text("task");
    equivalent.why = table.text("why");
    equivalent.edits = read_edits(table, "an equivalent", manifest, equivalent.task);
    table.finish();
    for (const Edit& edit : equivalent.edits)
        if (std::none_of(manifest.tasks.begin(), manifest.tasks.end(),
                         [&](const TaskInfo& task) { return task.file == edit.file; }))
            table.fail("edits",
                       fmt::format("'{}' is no task's file: an equivalent is what a student writes", edit.file));
    return equivalent;
}

CompareInfo read_compare(Table table, const Manifest& manifest) {
    CompareInfo compare;
    compare.knob = table.text("knob");
    table.read("values", compare.values);
    compare.shot.camera = manifest.camera, compare.shot.size = CompareInfo::usual_size;
    if (auto shot = table.table("shot")) compare.shot = read_shot(*shot, manifest.camera, compare.shot.size);
    table.read("probe", compare.shot.probe.name);
    table.finish();
    if (compare.values.size() == 1) table.fail("values", "'values' are two at least: there is nothing to compare");
    for (const std::string& value : compare.values)
        if (std::count(compare.values.begin(), compare.values.end(), value) > 1)
            table.fail("values", fmt::format("'{}' stands twice in 'values'", value));
    for (const auto& [knob, value] : compare.shot.set)
        if (knob == compare.knob)
            table.fail("shot", fmt::format("'{}' is what is compared: 'shot' must not set it", knob));
    if (compare.shot.probe) require(table, "probe", [&] { manifest.probe(compare.shot.probe.name); });
    return compare;
}

GoldenInfo read_golden(Table& table, const Manifest& manifest) {
    GoldenInfo golden;
    golden.name = table.text("name");
    golden.shot.camera = manifest.camera;
    if (auto shot = table.table("shot")) golden.shot = read_shot(*shot, manifest.camera, golden.shot.size);
    table.finish();
    if (!is_file_name(golden.name))
        table.fail("name", fmt::format("'{}' names a file: use a-z, 0-9, - and _", golden.name));
    if (golden.shot.probe) require(table, "shot", [&] { manifest.probe(golden.shot.probe.name); });
    return golden;
}

}  // namespace

bool CheckInfo::depends_on(const std::string& other_task) const {
    const auto has = [&](const auto& tasks) {
        return std::find(tasks.begin(), tasks.end(), other_task) != tasks.end();
    };
    return has(needs) || has(leans_on);
}

int Manifest::points() const {
    int sum = 0;
    for (const TaskInfo& task : tasks) sum += task.optional ? 0 : task.points;
    return sum;
}

int Manifest::optional_points() const {
    int sum = 0;
    for (const TaskInfo& task : tasks) sum += task.optional ? task.points : 0;
    return sum;
}

const ProbeInfo& Manifest::probe(const std::string& wanted) const {
    static const ProbeInfo calls{.name = calls_probe, .unit = ""};
    if (wanted == calls_probe) return calls;
    return find_named(probes, &ProbeInfo::name, "probe", wanted);
}
const TaskInfo& Manifest::task(const std::string& wanted) const {
    return find_named(tasks, &TaskInfo::id, "task", wanted);
}
const CheckInfo& Manifest::check(const std::string& wanted) const {
    return find_named(checks, &CheckInfo::name, "check", wanted);
}
const Shot& Manifest::view_of_check(const std::string& wanted) const {
    const Shot& shot = check(wanted).shot;
    if (shot.calls)
        throw UsageError(fmt::format("'{}' has no view: it calls functions of {}", wanted, shot.calls.file));
    return shot;
}
const MistakeInfo& Manifest::mistake(const std::string& wanted) const {
    return find_named(mistakes, &MistakeInfo::id, "mistake", wanted);
}
const GoldenInfo& Manifest::golden(const std::string& wanted) const {
    return find_named(goldens, &GoldenInfo::name, "golden picture", wanted);
}

namespace {

void read_checks(Table& root, bool hidden, Manifest& manifest) {
    std::vector<Table> tables = root.tables("check");
    const size_t first = manifest.checks.size();
    for (Table& table : tables) {
        CheckInfo check = read_check(table, manifest);
        check.hidden = hidden;
        refuse_second(table, "name", "checks", manifest.checks, &CheckInfo::name, check.name);
        manifest.checks.push_back(std::move(check));
    }
    for (size_t i = 0; i < tables.size(); ++i) {
        const CheckInfo& check = manifest.checks[first + i];
        if (check.against == "truth" || check.against == "solution") continue;
        require(tables[i], "against", [&] { manifest.check(check.against); });
        if (!(manifest.check(check.against).shot.probe == check.shot.probe))
            tables[i].fail("against", fmt::format("'{}' looks at another probe", check.against));
    }
}

/// Adds a check of the picture to each task that has none. A picture takes every task of its lab.
void add_picture_checks(Manifest& manifest) {
    std::vector<CheckInfo> added;
    for (const TaskInfo& task : manifest.tasks) {
        const auto is_own = [&](const CheckInfo& check) { return check.task == task.id && !check.shot.calls; };
        const auto first = std::find_if(manifest.checks.begin(), manifest.checks.end(), is_own);
        if (first == manifest.checks.end() ||
            std::any_of(manifest.checks.begin(), manifest.checks.end(),
                        [&](const CheckInfo& check) { return is_own(check) && !check.shot.probe; }))
            continue;
        CheckInfo& check = added.emplace_back(*first);
        check.name = fmt::format("the picture of '{}'", first->name);
        check.shot.probe = {};
        check.shot.size = usual_check_size;
        check.against = "solution";
        check.limits = {};
        check.reason.clear();
        check.look_at = "the picture is made of what the probe shows: return the same wherever you are called";
        check.hidden = check.added = true;
        check.needs.clear();
        check.leans_on.clear();
        for (const TaskInfo& other : manifest.tasks)
            if (other.id != task.id) check.needs.push_back(other.id);
    }
    manifest.checks.insert(manifest.checks.end(), added.begin(), added.end());
}

}  // namespace

Manifest load_manifest(const fs::path& file) {
    constexpr size_t longest = size_t{1} << 24;
    Manifest manifest = parse_manifest(read_file(file, longest), file);
    const fs::path grading = file.parent_path() / "staff" / "grading.toml";
    if (fs::exists(grading)) add_grading(manifest, read_file(grading, longest), grading);
    return manifest;
}

Manifest parse_manifest(const std::string& text, const fs::path& file) {
    const toml::table parsed = parse_toml(text, file);
    Table root(file, parsed, "a manifest");
    Manifest manifest;
    manifest.title = root.text("title");
    if (manifest.title.empty() || manifest.title.find('\n') != std::string::npos)
        root.fail("title", "'title' must be one line");
    root.read("learns", manifest.learns);
    read_effort(root, manifest);
    if (auto camera = root.table("camera")) read_camera(*camera, manifest.camera);
    root.read("animated", manifest.animated);
    root.read("task_includes", manifest.task_includes);

    for (Table& table : root.tables("probe")) {
        ProbeInfo probe = read_probe(table);
        refuse_second(table, "name", "probes", manifest.probes, &ProbeInfo::name, probe.name);
        manifest.probes.push_back(std::move(probe));
    }
    for (Table& table : root.tables("task")) {
        TaskInfo task = read_task(table);
        refuse_second(table, "id", "tasks", manifest.tasks, &TaskInfo::id, task.id);
        manifest.tasks.push_back(std::move(task));
    }
    if (manifest.points() == 0 && manifest.optional_points() > 0)
        root.fail("task", "a lab with points has a task that is not optional");
    read_checks(root, false, manifest);
    root.read("example_includes", manifest.example_includes);
    for (Table& table : root.tables("example")) read_public_example(table, manifest);
    add_example_checks(false, manifest);
    if (auto compare = root.table("compare")) manifest.compare = read_compare(*compare, manifest);
    for (Table& table : root.tables("golden")) {
        GoldenInfo golden = read_golden(table, manifest);
        refuse_second(table, "name", "golden pictures", manifest.goldens, &GoldenInfo::name, golden.name);
        manifest.goldens.push_back(std::move(golden));
    }
    if (!manifest.goldens.empty()) manifest.cover = manifest.goldens.front().name;
    root.read("cover", manifest.cover);
    if (!manifest.cover.empty()) require(root, "cover", [&] { manifest.golden(manifest.cover); });
    for (const char* key : {"mistake", "equivalent", "question", "vary"})
        if (root.has(key))
            root.fail(key, fmt::format("'{}' belongs in staff/grading.toml, which students do not get", key));
    root.finish();
    return manifest;
}

void add_grading(Manifest& manifest, const std::string& text, const fs::path& file) {
    const toml::table parsed = parse_toml(text, file);
    Table root(file, parsed, "a lab's grading");
    read_checks(root, true, manifest);
    add_picture_checks(manifest);
    for (Table& table : root.tables("example")) read_staff_example(table, manifest);
    add_example_checks(true, manifest);
    std::vector<Table> mistakes = root.tables("mistake");
    for (Table& table : mistakes) {
        MistakeInfo mistake = read_mistake(table, manifest);
        refuse_second(table, "id", "mistakes", manifest.mistakes, &MistakeInfo::id, mistake.id);
        manifest.mistakes.push_back(std::move(mistake));
    }
    for (size_t i = 0; i < mistakes.size(); ++i)
        if (const std::string& other = manifest.mistakes[i].same_as; !other.empty())
            require(mistakes[i], "same_as", [&] { manifest.mistake(other); });
    for (Table& table : root.tables("question")) manifest.questions.push_back(read_question(table));
    if (auto vary = root.table("vary")) manifest.vary = read_vary(*vary);
    for (Table& table : root.tables("equivalent")) {
        EquivalentInfo equivalent = read_equivalent(table, manifest);
        refuse_second(table, "id", "equivalents", manifest.equivalents, &EquivalentInfo::id, equivalent.id);
        manifest.equivalents.push_back(std::move(equivalent));
    }
    root.finish();
}

Manifest load_manifest(const LabEntry& lab) { return load_manifest(course_root() / "labs" / lab.folder / "lab.toml"); }

}  // namespace relief
