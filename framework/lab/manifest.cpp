#include "framework/lab/manifest.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <limits>

#include "framework/base/error.h"
#include "framework/base/file.h"
#include "framework/base/paths.h"
#include "framework/base/text.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

constexpr double any = std::numeric_limits<double>::max();

/// One table, read key by key; what nobody read is a mistake of the author's.
class Table {
public:
    Table(const fs::path& file, const toml::table& table, std::string what)
        : file_(file), table_(table), what_(std::move(what)) {}

    std::string text(const char* key) { return value<std::string>(need(key), key, "a text in quotes"); }

    void read(const char* key, std::string& result) {
        if (const toml::node* node = find(key)) result = value<std::string>(*node, key, "a text in quotes");
    }
    void read(const char* key, bool& result) {
        if (const toml::node* node = find(key)) result = value<bool>(*node, key, "true or false");
    }
    void read(const char* key, double& result, double low, double high) {
        if (const toml::node* node = find(key)) result = number(*node, key, low, high);
    }
    void read(const char* key, int& result, int low, int high) {
        const toml::node* node = find(key);
        if (!node) return;
        const auto whole = node->value_exact<int64_t>();
        if (!whole || *whole < low || *whole > high)
            fail(*node, fmt::format("'{}' must be a whole number from {} to {}", key, low, high));
        result = int(*whole);
    }
    void read(const char* key, std::vector<std::string>& result) {
        const toml::node* node = find(key);
        if (!node) return;
        const toml::array* array = node->as_array();
        if (!array) fail(*node, fmt::format("'{}' must be a list of texts", key));
        for (const toml::node& element : *array) result.push_back(value<std::string>(element, key, "a list of texts"));
    }
    /// A list of `count` numbers; false when the key is not there.
    template <int count>
    bool read(const char* key, std::array<double, count>& result, double low, double high) {
        const toml::node* node = find(key);
        if (!node) return false;
        const toml::array* array = node->as_array();
        if (!array || array->size() != count) fail(*node, fmt::format("'{}' must be {} numbers", key, count));
        for (int i = 0; i < count; ++i) result[i] = number((*array)[size_t(i)], key, low, high);
        return true;
    }

    std::optional<Table> table(const char* key) {
        const toml::node* node = find(key);
        if (!node) return {};
        if (!node->as_table()) fail(*node, fmt::format("'{}' must be a table, {{ key = value }}", key));
        return Table(file_, *node->as_table(), fmt::format("{}.{}", what_, key));
    }
    /// Each [[key]] in order.
    std::vector<Table> tables(const char* key) {
        std::vector<Table> result;
        const toml::node* node = find(key);
        if (!node) return result;
        const toml::array* array = node->as_array();
        if (!array || !array->is_array_of_tables()) fail(*node, fmt::format("write each {0} as [[{0}]]", key));
        for (const toml::node& element : *array)
            result.emplace_back(file_, *element.as_table(), fmt::format("[[{}]]", key));
        return result;
    }

    /// Each { ... } of a list, in order.
    std::vector<Table> inline_tables(const char* key) {
        std::vector<Table> result;
        const toml::node* node = find(key);
        if (!node) return result;
        const toml::array* array = node->as_array();
        if (!array) fail(*node, fmt::format("'{}' must be a list of {{ key = value }}", key));
        for (const toml::node& element : *array) {
            if (!element.as_table()) fail(element, fmt::format("'{}' must be a list of {{ key = value }}", key));
            result.emplace_back(file_, *element.as_table(), fmt::format("{}.{}", what_, key));
        }
        return result;
    }

    /// All keys with their values as text, for the knobs of a shot.
    std::vector<std::pair<std::string, std::string>> all_as_text() {
        std::vector<std::pair<std::string, std::string>> result;
        for (const auto& [key, node] : table_) {
            read_.emplace_back(key.str());
            std::string text;
            if (const auto string = node.value_exact<std::string>())
                text = *string;
            else if (const auto flag = node.value_exact<bool>())
                text = *flag ? "on" : "off";
            else
                text = fmt::format("{}", number(node, read_.back().c_str(), -any, any));
            result.emplace_back(key.str(), text);
        }
        return result;
    }

    /// Call last: throws for a key that nothing has asked for.
    void finish() const {
        for (const auto& [key, node] : table_)
            if (std::find(read_.begin(), read_.end(), key.str()) == read_.end())
                throw Error({file_, int(key.source().begin.line)}, unknown("key of " + what_ + ",", key.str(), read_));
    }

    [[noreturn]] void fail(const std::string& message) const { fail(table_, message); }
    /// At the value of a key, or at the table when it is not there.
    [[noreturn]] void fail(const char* key, const std::string& message) const {
        const toml::node* const node = table_.get(key);
        fail(node ? *node : table_, message);
    }
    [[noreturn]] void fail(const toml::node& node, const std::string& message) const {
        throw Error({file_, int(node.source().begin.line)}, message);
    }

private:
    const toml::node* find(const char* key) {
        read_.emplace_back(key);
        return table_.get(key);
    }
    const toml::node& need(const char* key) {
        const toml::node* node = find(key);
        if (!node) fail(table_, fmt::format("{} must have a '{}'", what_, key));
        return *node;
    }
    template <class Type>
    Type value(const toml::node& node, const char* key, const char* wanted) const {
        auto result = node.value_exact<Type>();
        if (!result) fail(node, fmt::format("'{}' must be {}", key, wanted));
        return *std::move(result);
    }
    double number(const toml::node& node, const char* key, double low, double high) const {
        const auto result = node.is_number() ? node.value<double>() : std::nullopt;
        if (!result) fail(node, fmt::format("'{}' must be a number", key));
        if (!(*result >= low && *result <= high))
            fail(node, fmt::format("'{}' must be from {} to {}", key, plain(low), plain(high)));
        return *result;
    }

    const fs::path& file_;
    const toml::table& table_;
    std::string what_;
    std::vector<std::string> read_;
};

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
    table.read("time", shot.time, 0, 1e6);
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

/// Inside the course, whoever wrote the manifest.
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

/// Runs a look-up whose failure is the table's.
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
    table.finish();
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
    table.finish();
    if (!is_course_path(task.file))
        table.fail("file", "'file' is a path inside the course, like shaders/20_x/task.glsl");
    return task;
}

Limits read_limits(Table table) {
    Limits limits;
    const auto read = [&](const char* key, std::optional<double>& limit, double highest) {
        double value = -1;
        table.read(key, value, 0, highest);
        if (value >= 0) limit = value;
    };
    read("mean", limits.mean, any), read("p99", limits.p99, any), read("largest", limits.largest, any);
    read("wrong", limits.wrong, 1);
    table.read("outline", limits.outline, 0, 1);
    table.finish();
    return limits;
}

CheckInfo read_check(Table& table, const Manifest& manifest) {
    CheckInfo check;
    check.task = table.text("task");
    check.name = table.text("name");
    check.shot.camera = manifest.camera;
    check.shot.size = {128, 128};
    if (auto shot = table.table("shot")) check.shot = read_shot(*shot, manifest.camera, check.shot.size);
    table.read("probe", check.shot.probe.name);
    check.against = table.text("against");
    if (auto limits = table.table("limit")) check.limits = read_limits(*limits);
    table.read("reason", check.reason);
    check.look_at = table.text("look_at");
    table.read("hidden", check.hidden);
    table.finish();
    require(table, "task", [&] { manifest.task(check.task); });
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

MistakeInfo read_mistake(Table& table, const Manifest& manifest) {
    MistakeInfo mistake;
    mistake.id = table.text("id");
    mistake.task = table.text("task");
    mistake.hint = table.text("hint");
    for (Table& edit : table.inline_tables("edits")) {
        mistake.edits.push_back({edit.text("file"), edit.text("find"), edit.text("replace")});
        edit.finish();
        if (!is_course_path(mistake.edits.back().file)) edit.fail("file", "'file' is a path inside the course");
    }
    table.read("same_as", mistake.same_as);
    table.finish();
    if (mistake.edits.empty()) table.fail("id", "a mistake has 'edits' = [{ file, find, replace }]");
    require(table, "task", [&] { manifest.task(mistake.task); });
    return mistake;
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

int Manifest::points() const {
    int sum = 0;
    for (const TaskInfo& task : tasks) sum += task.points;
    return sum;
}

const ProbeInfo& Manifest::probe(const std::string& wanted) const {
    return find_named(probes, &ProbeInfo::name, "probe", wanted);
}
const TaskInfo& Manifest::task(const std::string& wanted) const {
    return find_named(tasks, &TaskInfo::id, "task", wanted);
}
const CheckInfo& Manifest::check(const std::string& wanted) const {
    return find_named(checks, &CheckInfo::name, "check", wanted);
}

Manifest load_manifest(const fs::path& file) { return parse_manifest(read_file(file, size_t{1} << 24), file); }

Manifest parse_manifest(const std::string& text, const fs::path& file) {
    toml::table parsed;
    try {
        parsed = toml::parse(text, file.string());
    } catch (const toml::parse_error& error) {
        throw Error({file, int(error.source().begin.line)}, std::string(error.description()));
    }

    Table root(file, parsed, "a manifest");
    Manifest manifest;
    manifest.title = root.text("title");
    if (manifest.title.empty() || manifest.title.find('\n') != std::string::npos)
        root.fail("title", "'title' must be one line");
    root.read("learns", manifest.learns);
    if (auto camera = root.table("camera")) read_camera(*camera, manifest.camera);
    root.read("animated", manifest.animated);

    root.read("keep_back", manifest.keep_back);

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
    std::vector<Table> checks = root.tables("check"), mistakes = root.tables("mistake");
    for (Table& table : checks) {
        CheckInfo check = read_check(table, manifest);
        refuse_second(table, "name", "checks", manifest.checks, &CheckInfo::name, check.name);
        manifest.checks.push_back(std::move(check));
    }
    for (size_t i = 0; i < checks.size(); ++i) {
        const std::string& against = manifest.checks[i].against;
        if (against == "truth" || against == "solution") continue;
        require(checks[i], "against", [&] { manifest.check(against); });
        if (!(manifest.check(against).shot.probe == manifest.checks[i].shot.probe))
            checks[i].fail("against", fmt::format("'{}' looks at another probe", against));
    }
    for (Table& table : mistakes) {
        MistakeInfo mistake = read_mistake(table, manifest);
        refuse_second(table, "id", "mistakes", manifest.mistakes, &MistakeInfo::id, mistake.id);
        manifest.mistakes.push_back(std::move(mistake));
    }
    for (size_t i = 0; i < mistakes.size(); ++i)
        if (const std::string& other = manifest.mistakes[i].same_as; !other.empty())
            require(mistakes[i], "same_as", [&] { find_named(manifest.mistakes, &MistakeInfo::id, "mistake", other); });
    for (Table& table : root.tables("golden")) {
        GoldenInfo golden = read_golden(table, manifest);
        refuse_second(table, "name", "golden pictures", manifest.goldens, &GoldenInfo::name, golden.name);
        manifest.goldens.push_back(std::move(golden));
    }
    root.finish();
    return manifest;
}

Manifest load_manifest(const LabEntry& lab) { return load_manifest(course_root() / "labs" / lab.folder / "lab.toml"); }

}  // namespace relief
