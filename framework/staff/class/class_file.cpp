#include "framework/staff/class/class_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "framework/core/base/file.h"
#include "framework/core/base/text.h"
#include "framework/core/lab/registry.h"
#include "framework/course/manifest/toml_table.h"
#include "framework/staff/class/csv.h"
#include "framework/staff/grade/strangers_text.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

constexpr const char* kept_name = "class_file.txt";

/// Returns the lab that `text` names. Reports an unknown lab at its place in the file.
const LabEntry& lab_at(const Place& place, const std::string& text) {
    try {
        return find_lab(text);
    } catch (const UsageError& error) {
        throw Error(place, error.what());
    }
}

/// Returns ": did you mean 'jane'?", or an empty text.
std::string suggested(const std::string& name, const Words& known) {
    const auto near = nearest(name, known);
    return near ? fmt::format(": did you mean '{}'?", printable(*near)) : "";
}

class ClassFileReader {
public:
    explicit ClassFileReader(const fs::path& file) : file_(file) { class_.file = file; }

    /// Reads the class file. Returns the path of its adjustments, or an empty path.
    fs::path read() {
        const toml::table parsed = parse_toml(read_file(file_, size_t{1} << 24), file_);
        Table root(file_, parsed, "a class file");
        std::string offset, roster, hand_ins, adjustments;
        root.read("utc_offset", offset);
        if (!offset.empty() && !(offset_ = parse_offset(offset)))
            root.fail("utc_offset", fmt::format("'{}' is no offset: write it as in \"+01:00\"", printable(offset)));
        class_.utc_offset = offset_.value_or(UtcOffset(0));
        for (Table& table : root.tables("assigned")) read_assigned(table);
        if (class_.labs.empty()) root.fail("a class file must name the labs that count: [[assigned]] with lab = \"1\"");
        root.read("roster", roster);
        if (!roster.empty()) read_roster_table(beside(root, "roster", roster));
        for (Table& table : root.tables("student")) read_student(table);
        refuse_ambiguous_teams();
        if (auto late = root.table("late")) read_late(*late);
        if (auto attempts = root.table("attempts")) read_attempts(*attempts);
        for (Table& table : root.tables("extension")) read_extension(table);
        root.read("hand_ins", hand_ins);
        if (!hand_ins.empty()) read_hand_ins(beside(root, "hand_ins", hand_ins));
        if (root.has("late") && hand_ins.empty())
            root.fail("late", "[late] needs hand_ins = \"FILE.csv\" with the times: without it nobody is late");
        root.read("adjustments", adjustments);
        const fs::path adjusted = adjustments.empty() ? fs::path() : beside(root, "adjustments", adjustments);
        root.finish();
        std::sort(class_.labs.begin(), class_.labs.end(),
                  [](const AssignedLab& a, const AssignedLab& b) { return a.folder < b.folder; });
        return adjusted;
    }

    ClassFile result() { return std::move(class_); }

private:
    fs::path beside(const Table& table, const char* key, const std::string& name) const {
        const fs::path path = file_.parent_path() / name;
        if (std::error_code unknown; !fs::is_regular_file(path, unknown))
            table.fail(key, fmt::format("there is no file '{}'", path.string()));
        return path;
    }

    /// Returns the lab with the number or name in `lab`.
    const LabEntry& lab_of(Table& table) {
        int number = 0;
        std::string text;
        if (table.is_whole("lab"))
            table.read("lab", number, 0, 99);
        else
            table.read("lab", text);
        return lab_at({file_, table.line("lab")}, number > 0 ? std::to_string(number) : text);
    }

    void read_assigned(Table& table) {
        if (!table.has("lab")) table.fail("[[assigned]] must have a 'lab'");
        const LabEntry& entry = lab_of(table);
        if (class_.lab(entry.folder)) table.fail("lab", fmt::format("lab {} is assigned twice", entry.two_digits()));
        AssignedLab lab{
            .folder = entry.folder, .tasks = load_manifest(entry).tasks, .due = {}, .canvas = {}, .moodle = {}};
        if (lab.tasks.empty()) table.fail("lab", fmt::format("lab {} has no tasks", entry.two_digits()));
        if (const std::string due = table.date("due"); !due.empty())
            lab.due = parse_moment(due, offset_, {file_, table.line("due")});
        if (bool counts = false; table.read("optional", counts), counts)
            for (TaskInfo& task : lab.tasks) task.optional = false;
        lab.canvas = "Lab " + entry.two_digits();
        table.read("canvas", lab.canvas);
        std::string moodle;
        table.read("moodle", moodle);
        if (!moodle.empty()) lab.moodle = beside(table, "moodle", moodle);
        table.finish();
        class_.labs.push_back(std::move(lab));
    }

    void read_late(Table& table) {
        table.read("grace_hours", class_.late.grace_hours, 0, 1000);
        table.read("percent_per_day", class_.late.percent_per_day, 0, 100);
        table.read("floor_percent", class_.late.floor_percent, 0, 100);
        table.read("bank_days", class_.late.bank_days, 1, 366);
        if (table.has("bank_days_per_lab") && class_.late.bank_days == 0)
            table.fail("bank_days_per_lab", "'bank_days_per_lab' needs 'bank_days', the days of the whole term");
        class_.late.bank_days_per_lab = class_.late.bank_days;
        table.read("bank_days_per_lab", class_.late.bank_days_per_lab, 1, class_.late.bank_days);
        table.finish();
    }

    void read_attempts(Table& table) {
        if (!table.has("per_day")) table.fail("[attempts] must have 'per_day'");
        table.read("per_day", class_.hand_ins_per_day, 1, 1000);
        table.finish();
    }

    void add(Student student, const Place& place) {
        if (student.student.empty()) throw Error(place, "a student needs a name of a submission in 'student'");
        for (const auto& [kind, value] : {std::pair("student", &student.student),
                                          {"email", &student.email},
                                          {"login", &student.login},
                                          {"canvas_id", &student.canvas_id},
                                          {"sis_id", &student.sis_id}}) {
            if (value->empty()) continue;
            if (std::string(kind) != "student" && defused(*value) != *value)
                throw Error(place, fmt::format("{} '{}' would be a formula in a spreadsheet", kind, printable(*value)));
            const auto [before, is_new] = known_.try_emplace({kind, *value}, place);
            if (!is_new)
                throw Error(place, fmt::format("{} '{}' is there twice: also in line {}{}", kind, printable(*value),
                                               before->second.line,
                                               before->second.file == place.file
                                                   ? ""
                                                   : " of " + printable(before->second.file.filename().string())));
        }
        student.team = composed(student.team);
        if (!student.team.empty()) teams_.try_emplace(student.team, place);
        class_.students.push_back(std::move(student));
    }

    /// Throws Error if a team has the name of a student: a submission of that name could be of either.
    void refuse_ambiguous_teams() const {
        for (const auto& [team, place] : teams_)
            if (known_.contains({"student", team}))
                throw Error(place, fmt::format("the team '{}' has the name of a student: rename it", printable(team)));
    }

    void read_student(Table& table) {
        Student student;
        student.student = composed(table.text("student"));
        table.read("name", student.name);
        table.read("email", student.email);
        table.read("login", student.login);
        table.read("canvas_id", student.canvas_id);
        table.read("sis_id", student.sis_id);
        table.read("section", student.section);
        table.read("team", student.team);
        table.finish();
        add(std::move(student), {file_, table.line("student")});
    }

    void read_roster_table(const fs::path& file) {
        const CsvTable table = read_csv(file);
        table.refuse_columns(Words{"student", "name", "email", "login", "canvas_id", "sis_id", "section", "team"},
                             Words{"student"});
        if (table.rows.empty()) throw Error({file}, "names no student");
        for (const CsvRow& row : table.rows) {
            const auto cell = [&](const char* name) { return table.cell(row, name); };
            add({composed(cell("student")), cell("name"), cell("email"), cell("login"), cell("canvas_id"),
                 cell("sis_id"), cell("section"), cell("team")},
                {file, row.line});
        }
    }

    /// Throws Error at `place` if there is a roster and the student is not on it. With `takes_teams`, a team is as
    /// good.
    void refuse_stranger(const std::string& student, const Place& place, bool takes_teams = false) const {
        if (class_.students.empty() || known_.contains({"student", student})) return;
        if (takes_teams && teams_.contains(student)) return;
        Words names;
        for (const Student& one : class_.students) names.push_back(one.student);
        throw Error(place, fmt::format("'{}' is not on the roster{}", printable(student), suggested(student, names)));
    }

    void read_extension(Table& table) {
        Extension extension{.student = composed(table.text("student")), .lab = {}, .days = 0, .note = {}};
        refuse_stranger(extension.student, {file_, table.line("student")});
        if (table.has("lab")) extension.lab = assigned({file_, table.line("lab")}, lab_of(table));
        if (!table.has("days")) table.fail("[[extension]] must have 'days'");
        table.read("days", extension.days, 1, 366);
        table.read("note", extension.note);
        table.finish();
        for (const Extension& before : class_.extensions)
            if (before.student == extension.student && before.lab == extension.lab)
                table.fail("student", fmt::format("'{}' has two extensions for {}", printable(extension.student),
                                                  extension.lab.empty() ? "all labs" : extension.lab));
        class_.extensions.push_back(std::move(extension));
    }

    std::string assigned(const Place& place, const LabEntry& lab) const {
        if (!class_.lab(lab.folder)) throw Error(place, fmt::format("lab {} is not assigned", lab.two_digits()));
        return lab.folder;
    }

    void read_hand_ins(const fs::path& file) {
        const CsvTable table = read_csv(file);
        table.refuse_columns(Words{"student", "lab", "handed_in"}, Words{"student", "handed_in"});
        std::map<std::pair<std::string, std::string>, int> lines;
        for (const CsvRow& row : table.rows) {
            const Place place{file, row.line};
            const std::string student = composed(table.cell(row, "student"));
            const std::string &lab = table.cell(row, "lab"), &time = table.cell(row, "handed_in");
            refuse_stranger(student, place, true);
            if (time.size() <= std::string("2027-03-01").size())
                throw Error(place,
                            fmt::format("'{}' is no time: write it as 2027-03-01T23:59:00+01:00", printable(time)));
            const std::string folder = lab.empty() ? "" : assigned(place, lab_at(place, lab));
            const auto [before, is_new] = lines.try_emplace({student, folder}, row.line);
            if (!is_new)
                throw Error(place, fmt::format("'{}' has two times{}: also in line {}", printable(student),
                                               lab.empty() ? "" : " for lab " + printable(lab), before->second));
            class_.hand_ins.push_back({student, folder, parse_moment(time, offset_, place)});
        }
    }

    fs::path file_;
    ClassFile class_;
    std::optional<UtcOffset> offset_;
    std::map<std::string, Place> teams_;                          ///< the first place of each
    std::map<std::pair<std::string, std::string>, Place> known_;  ///< kind and value of each identifier
};

std::vector<Adjustment> read_adjustments(const fs::path& file) {
    const CsvTable table = read_csv(file);
    const Words columns{"student", "task", "points", "note"};
    table.refuse_columns(columns, columns);
    std::vector<Adjustment> adjustments;
    for (const CsvRow& row : table.rows) {
        const Place place{file, row.line};
        std::string points = table.cell(row, "points");
        if (points.starts_with('+')) points.erase(0, 1);
        const auto number = parse_number(points);
        if (!number || std::abs(*number) > 1000)
            throw Error(place, fmt::format("'{}' is no number of points from -1000 to 1000, such as 1 or -0.5",
                                           printable(table.cell(row, "points"))));
        adjustments.push_back(
            {composed(table.cell(row, "student")), table.cell(row, "task"), *number, table.cell(row, "note"), place});
        if (adjustments.back().note.empty()) throw Error(place, "an adjustment needs a note: its student reads why");
    }
    return adjustments;
}

}  // namespace

const AssignedLab* ClassFile::lab(const std::string& folder) const {
    for (const AssignedLab& one : labs)
        if (one.folder == folder) return &one;
    return nullptr;
}

ClassFile read_class_file(const fs::path& file, const fs::path& results) {
    ClassFile policy;
    fs::path adjustments;
    if (!file.empty()) {
        ClassFileReader reader(file);
        adjustments = reader.read();
        policy = reader.result();
    }
    if (adjustments.empty()) {
        adjustments = results / "adjustments.csv";
        if (std::error_code unknown; !fs::exists(adjustments, unknown)) return policy;
    }
    policy.adjustments = read_adjustments(adjustments);
    return policy;
}

bool has_teams(const ClassFile& policy) {
    return std::any_of(policy.students.begin(), policy.students.end(),
                       [](const Student& one) { return !one.team.empty(); });
}

bool has_limits(const ClassFile& policy) { return policy.late.bank_days > 0 || policy.hand_ins_per_day > 0; }

fs::path class_file_of(const fs::path& results) {
    std::error_code unknown;
    if (!fs::exists(results / kept_name, unknown)) return {};
    const fs::path file = read_file(results / kept_name, 10'000);
    if (!fs::is_regular_file(file, unknown))
        throw UsageError(fmt::format("there is no class file '{}' any more: name it with --class FILE, or --class none",
                                     printable(file.string(), 1000)));
    return file;
}

void keep_class_file(const fs::path& file, const fs::path& results) {
    std::error_code unknown;
    if (file.empty())
        fs::remove(results / kept_name, unknown);
    else
        write_file(results / kept_name, fs::absolute(file).lexically_normal().string());
}

void refuse_unknown_adjustments(const ClassFile& policy, const std::set<std::string>& students,
                                const std::set<std::string>& tasks) {
    for (const Adjustment& one : policy.adjustments) {
        if (!students.contains(one.student))
            throw Error(one.place, fmt::format("'{}' is not in the class{}", printable(one.student),
                                               suggested(one.student, Words(students.begin(), students.end()))));
        if (!tasks.contains(one.task))
            throw Error(one.place, unknown("task", printable(one.task), Words(tasks.begin(), tasks.end())));
    }
}

}  // namespace relief::grade
