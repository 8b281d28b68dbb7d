#include "framework/staff/class/record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <utility>

#include "framework/core/base/text.h"
#include "framework/staff/class/hand_in_log.h"
#include "framework/staff/grade/strangers_text.h"

namespace relief::grade {
namespace {

/// A lab that counts, and its tasks.
struct CountedLab {
    std::string folder;
    std::vector<TaskInfo> tasks;
};

std::vector<CountedLab> counted_labs(const std::vector<SubmissionMark>& marks, const ClassFile& policy,
                                     const std::vector<std::string>& only) {
    const auto wanted = [&](const std::string& folder) {
        return only.empty() || std::find(only.begin(), only.end(), folder) != only.end();
    };
    std::vector<CountedLab> labs;
    for (const AssignedLab& lab : policy.labs)
        if (wanted(lab.folder)) labs.push_back({lab.folder, lab.tasks});
    if (!policy.labs.empty()) {
        if (labs.empty()) throw Error({policy.file}, "assigns none of the labs that were graded");
        return labs;
    }
    std::map<std::string, std::vector<TaskInfo>> graded;
    for (const SubmissionMark& mark : marks)
        for (const LabMark& lab : mark.labs)
            if (const auto [entry, is_new] = graded.try_emplace(lab.lab); is_new)
                for (const check::TaskVerdict& task : lab.tasks)
                    entry->second.push_back({.id = task.id,
                                             .title = task.title,
                                             .file = task.file,
                                             .points = task.of,
                                             .optional = task.optional});
    for (auto& [folder, tasks] : graded) labs.push_back({folder, std::move(tasks)});
    return labs;
}

std::string lab_number(const std::string& folder) { return folder.substr(0, folder.find('_')); }

/// Returns the members of each team, in the order of the roster.
std::map<std::string, std::vector<std::string>> members_of(const ClassFile& policy) {
    std::map<std::string, std::vector<std::string>> teams;
    for (const Student& one : policy.students)
        if (!one.team.empty()) teams[one.team].push_back(one.student);
    return teams;
}

class ClassOf {
public:
    ClassOf(const ClassFile& policy, std::vector<CountedLab> labs) : policy_(policy), labs_(std::move(labs)) {
        for (const CountedLab& lab : labs_)
            for (const TaskInfo& task : lab.tasks) tasks_.insert(task.id);
        for (const Student& student : policy.students) students_.emplace(student.student, &student);
        for (const Adjustment& one : policy.adjustments) adjustments_[one.student].push_back(one);
        for (const Extension& one : policy.extensions) extensions_[{one.student, one.lab}] = &one;
        for (const HandInTime& one : policy.hand_ins) hand_ins_.emplace(std::pair(one.student, one.lab), one.time);
    }

    /// Chooses the mark of each lab among the submissions of a team. `marks` is not empty.
    void add_team(const std::string& name, const std::vector<std::string>& members,
                  const std::vector<const SubmissionMark*>& marks, ClassRecord& result) {
        Team team{.members = members, .mark = marks.front(), .sources = {}, .remarks = {}};
        auto all = std::make_shared<SubmissionMark>(*marks.front());
        all->labs.clear();
        all->remarks.clear();
        for (const SubmissionMark* one : marks) {
            if (one->problem.empty()) all->problem.clear();
            all->remarks.insert(all->remarks.end(), one->remarks.begin(), one->remarks.end());
            for (const LabMark& lab : one->labs)
                if (!team.sources.contains(lab.lab)) all->labs.push_back(chosen(name, lab.lab, marks, team));
        }
        if (marks.size() > 1) {
            team.mark = all.get();
            result.team_marks.push_back(all);
        }
        result.notes.insert(result.notes.end(), team.remarks.begin(), team.remarks.end());
        for (const std::string& member : members) teams_[member] = std::make_shared<Team>(team);
    }

    StudentRecord of(const std::string& name, const SubmissionMark* mark) const {
        const std::string key = printable(name);
        const auto student = students_.find(key);
        StudentRecord record{.name = name,
                             .student = {.student = key},
                             .on_roster = students_.empty() || student != students_.end(),
                             .mark = mark,
                             .labs = {},
                             .adjustments = {}};
        if (student != students_.end()) record.student = *student->second;
        if (const Team* const team = team_of(key)) {
            mark = record.mark = team->mark;
            record.sources = team->sources;
            record.team_remarks = team->remarks;
            if (team->remarks.empty() && mark->name != name)
                record.team_remarks.push_back(fmt::format("the submission '{}' counts for team {}",
                                                          printable(mark->name), printable(record.student.team)));
        }
        if (const auto adjusted = adjustments_.find(key); adjusted != adjustments_.end())
            for (const Adjustment& one : adjusted->second)
                if (tasks_.contains(one.task)) record.adjustments.push_back(one);
        for (const CountedLab& lab : labs_) record.labs.push_back(of(lab, key, mark, record.adjustments));
        use_bank(record, key);
        return record;
    }

    /// Returns whether a lab with a due date was handed in at an unknown time.
    static bool lacks_time(const StudentRecord& record) {
        return std::any_of(record.labs.begin(), record.labs.end(),
                           [](const LabRecord& lab) { return lab.handed_in && lab.due && !lab.handed_in_at; });
    }

private:
    struct Team {
        std::vector<std::string> members;
        const SubmissionMark* mark = nullptr;
        std::map<std::string, std::string> sources;  ///< see StudentRecord
        std::vector<std::string> remarks;
    };

    const Team* team_of(const std::string& student) const {
        const auto found = teams_.find(student);
        return found == teams_.end() ? nullptr : found->second.get();
    }

    /// Returns the mark of a lab that counts for a team, and remarks why.
    LabMark chosen(const std::string& team_name, const std::string& lab,
                   const std::vector<const SubmissionMark*>& marks, Team& team) const {
        std::vector<const SubmissionMark*> with;
        bool all_timed = true;
        for (const SubmissionMark* one : marks)
            if (one->lab(lab)) {
                with.push_back(one);
                all_timed &= time_of(printable(one->name), lab).has_value();
            }
        const auto is_better = [&](const SubmissionMark* a, const SubmissionMark* b) {
            return all_timed ? *time_of(printable(a->name), lab) > *time_of(printable(b->name), lab)
                             : a->lab(lab)->points() > b->lab(lab)->points();
        };
        std::stable_sort(with.begin(), with.end(), is_better);
        team.sources[lab] = with.front()->name;
        if (with.size() > 1) {
            std::vector<std::string> others;
            for (size_t i = 1; i < with.size(); ++i) others.push_back(printable(with[i]->name));
            const bool is_clear = is_better(with[0], with[1]);
            team.remarks.push_back(
                fmt::format("lab {}: the submission '{}' counts for team {}, and not '{}': {}", lab_number(lab),
                            printable(with.front()->name), printable(team_name), join(others, "', '"),
                            !is_clear   ? "it comes first, and both are equal"
                            : all_timed ? "it was handed in last"
                                        : "it has the most points, since not all have a time in hand_ins"));
        }
        return *with.front()->lab(lab);
    }

    /// Returns when a submission of this name was handed in.
    std::optional<Moment> time_of(const std::string& student, const std::string& lab) const {
        for (const std::string& scope : {lab, std::string()})
            if (const auto found = hand_ins_.find({student, scope}); found != hand_ins_.end()) return found->second;
        return {};
    }

    /// Returns the record of a student in a lab. Sets the points of each adjustment to the points that it adds.
    LabRecord of(const CountedLab& counted, const std::string& student, const SubmissionMark* mark,
                 std::vector<Adjustment>& adjustments) const {
        const LabMark* const graded = mark ? mark->lab(counted.folder) : nullptr;
        LabRecord lab{.lab = counted.folder,
                      .handed_in = graded != nullptr,
                      .tasks = {},
                      .due = {},
                      .handed_in_at = {},
                      .extension_note = {},
                      .kept = graded ? graded->kept : "",
                      .last_day = {}};
        lab.marked = !graded || graded->graded();
        for (const TaskInfo& info : counted.tasks) {
            TaskRecord task{.id = info.id, .title = info.title, .of = info.points, .optional = info.optional};
            if (graded && lab.marked)
                for (const check::TaskVerdict& one : graded->tasks)
                    if (one.id == info.id) task.graded = one.points(), task.of = one.of;
            task.adjusted = task.graded;
            double asked = task.graded;
            for (Adjustment& one : adjustments) {
                if (one.task != info.id) continue;
                asked += one.points;
                const double before = std::exchange(task.adjusted, std::clamp(asked, 0.0, double(task.of)));
                one.points = task.adjusted - before;
            }
            lab.tasks.push_back(std::move(task));
        }
        add_lateness(lab, student);
        return lab;
    }

    void add_lateness(LabRecord& lab, const std::string& student) const {
        const AssignedLab* const assigned = policy_.lab(lab.lab);
        if (!assigned || !assigned->due) return;
        // Takes the longest of the extensions: for this lab and for all labs, and of all members of the team.
        const Team* const team = team_of(student);
        for (const std::string& one : team ? team->members : std::vector<std::string>{student})
            for (const std::string& scope : {lab.lab, std::string()})
                if (const auto found = extensions_.find({one, scope});
                    found != extensions_.end() && found->second->days > lab.extension_days) {
                    lab.extension_days = found->second->days;
                    lab.extension_note = found->second->note;
                }
        lab.due = *assigned->due + std::chrono::days(lab.extension_days);
        if (!lab.handed_in) return;
        const auto source = team ? team->sources.find(lab.lab) : std::map<std::string, std::string>::const_iterator();
        const std::optional<Moment> time =
            time_of(team && source != team->sources.end() ? printable(source->second) : student, lab.lab);
        if (!time) return;
        lab.handed_in_at = *time;
        lab.days_late = days_late(*lab.due, *time, policy_.late.grace_hours);
        lab.late_share = late_share(lab.days_late, policy_.late);
    }

    /// Lets the bank pay for late days, in the order of the due dates, so that a later lab changes no earlier mark. An
    /// assigned lab that this run does not count uses days if hand_ins.csv has a time of its own for it.
    void use_bank(StudentRecord& record, const std::string& student) const {
        record.bank_days = policy_.late.bank_days;
        if (record.bank_days == 0) return;
        std::vector<const AssignedLab*> by_date;
        for (const AssignedLab& lab : policy_.labs)
            if (lab.due) by_date.push_back(&lab);
        std::stable_sort(by_date.begin(), by_date.end(),
                         [](const AssignedLab* a, const AssignedLab* b) { return *a->due < *b->due; });
        for (const AssignedLab* assigned : by_date) {
            const auto counted = std::find_if(record.labs.begin(), record.labs.end(),
                                              [&](const LabRecord& lab) { return lab.lab == assigned->folder; });
            LabRecord elsewhere{.lab = assigned->folder,
                                .handed_in = hand_ins_.contains({student, assigned->folder}),
                                .tasks = {},
                                .due = {},
                                .handed_in_at = {},
                                .extension_note = {},
                                .kept = {},
                                .last_day = {}};
            if (counted == record.labs.end()) add_lateness(elsewhere, student);
            LabRecord& lab = counted == record.labs.end() ? elsewhere : *counted;
            lab.bank_days =
                std::min({lab.days_late, policy_.late.bank_days_per_lab, record.bank_days - record.bank_used});
            lab.late_share = late_share(lab.days_late - lab.bank_days, policy_.late);
            record.bank_used += lab.bank_days;
        }
    }

    using OfLab = std::pair<std::string, std::string>;  // a student, and a lab or an empty text
    const ClassFile& policy_;
    std::vector<CountedLab> labs_;
    std::set<std::string> tasks_;
    std::map<std::string, const Student*> students_;
    std::map<std::string, std::vector<Adjustment>> adjustments_;
    std::map<OfLab, const Extension*> extensions_;
    std::map<OfLab, Moment> hand_ins_;
    std::map<std::string, std::shared_ptr<const Team>> teams_;  ///< with a submission, by member
};

/// Adds a note, such as "3 submissions are not on the roster: jane, joe, jim". Adds nothing if `names` is empty.
void note(std::vector<std::string>& notes, const std::vector<std::string>& names, const char* one, const char* many) {
    constexpr size_t shown = 5;
    if (names.empty()) return;
    const std::vector<std::string> first(names.begin(), names.begin() + std::ptrdiff_t(std::min(names.size(), shown)));
    notes.push_back(fmt::format("{} {}: {}{}", names.size(), names.size() == 1 ? one : many, join(first, ", "),
                                names.size() > shown ? fmt::format(" and {} more", names.size() - shown) : ""));
}

template <class One, class Part>
double sum_of(const std::vector<One>& all, Part part) {
    double sum = 0;
    for (const One& one : all) sum += double(std::invoke(part, one));
    return sum;
}

}  // namespace

int LabRecord::of() const {
    int sum = 0;
    for (const TaskRecord& task : tasks) sum += task.optional ? 0 : task.of;
    return sum;
}
double LabRecord::graded() const { return std::min(sum_of(tasks, &TaskRecord::graded), double(of())); }
double LabRecord::adjusted() const { return std::min(sum_of(tasks, &TaskRecord::adjusted), double(of())); }

int StudentRecord::of() const { return int(sum_of(labs, &LabRecord::of)); }
double StudentRecord::graded() const { return sum_of(labs, &LabRecord::graded); }
double StudentRecord::adjusted() const { return sum_of(labs, &LabRecord::adjusted); }
double StudentRecord::points() const { return sum_of(labs, &LabRecord::points); }
bool StudentRecord::is_of(const std::string& submission) const {
    return mark && mark->name == submission &&
           std::all_of(sources.begin(), sources.end(), [&](const auto& one) { return one.second == submission; });
}
bool StudentRecord::is_marked() const {
    return !is_waiting && (!mark || mark->graded()) &&
           std::all_of(labs.begin(), labs.end(), [](const LabRecord& lab) { return lab.marked; });
}
bool StudentRecord::is_changed() const {
    return !adjustments.empty() ||
           std::any_of(labs.begin(), labs.end(), [](const LabRecord& lab) { return lab.days_late > lab.bank_days; });
}
const LabRecord* StudentRecord::lab(const std::string& folder) const {
    for (const LabRecord& one : labs)
        if (one.lab == folder) return &one;
    return nullptr;
}

std::string StudentRecord::state() const {
    if (!mark) return is_waiting ? "not graded yet" : "nothing handed in";
    if (!is_marked()) return "not graded: the machine failed";
    return mark->problem.empty() ? "graded" : mark->problem;
}

std::vector<std::string> StudentRecord::remarks(const std::string& lab) const {
    std::vector<std::string> remarks;
    for (const LabRecord& one : labs) {
        if (!lab.empty() && one.lab != lab) continue;
        for (const Adjustment& adjustment : adjustments)
            if (std::any_of(one.tasks.begin(), one.tasks.end(),
                            [&](const TaskRecord& task) { return task.id == adjustment.task; }))
                remarks.push_back(fmt::format("{}: {}{}: {}", adjustment.task, adjustment.points > 0 ? "+" : "",
                                              amount_of(adjustment.points, "point"), printable(adjustment.note, 1000)));
        if (one.days_late > 0) remarks.push_back(fmt::format("lab {}: {}", lab_number(one.lab), lateness_text(one)));
        if (!one.kept.empty()) remarks.push_back(fmt::format("lab {}: {}", lab_number(one.lab), one.kept));
    }
    // Sentences about files name the lab's folder.
    const auto is_of_lab = [&](const std::string& sentence) {
        return lab.empty() || sentence.find(lab) != std::string::npos ||
               sentence.starts_with("lab " + lab_number(lab) + ":");
    };
    if (mark) std::copy_if(mark->remarks.begin(), mark->remarks.end(), std::back_inserter(remarks), is_of_lab);
    std::copy_if(team_remarks.begin(), team_remarks.end(), std::back_inserter(remarks), is_of_lab);
    if (lab.empty() && bank_used > 0)
        remarks.push_back(fmt::format("late days of the term: {} of {} used", bank_used, bank_days));
    return remarks;
}

std::string lateness_text(const LabRecord& lab) {
    std::string text = amount_of(lab.days_late, "day") + " late";
    if (lab.bank_days > 0)
        text += lab.bank_days == lab.days_late ? ", which cost nothing"
                                               : fmt::format(", of which {} cost nothing", lab.bank_days);
    if (lab.days_late > lab.bank_days) text += fmt::format(", {} % less", rounded(100 * (1 - lab.late_share)));
    return text;
}

ClassRecord class_record(const std::vector<SubmissionMark>& marks, ClassFile policy,
                         const std::vector<std::string>& only, const std::set<std::string>& handed_in) {
    ClassRecord result{.policy = std::move(policy), .students = {}, .notes = {}};
    std::vector<CountedLab> labs = counted_labs(marks, result.policy, only);
    std::set<std::string> names, tasks;
    for (const CountedLab& lab : labs)
        for (const TaskInfo& task : lab.tasks) tasks.insert(task.id);
    // Another run into the folder may have graded these labs.
    for (const AssignedLab& lab : result.policy.labs)
        for (const TaskInfo& task : lab.tasks) tasks.insert(task.id);
    for (const SubmissionMark& mark : marks) names.insert(printable(mark.name));
    std::set<std::string> known = names;
    for (const Student& student : result.policy.students) known.insert(student.student);
    refuse_unknown_adjustments(result.policy, known, tasks);
    ClassOf all(result.policy, std::move(labs));
    const std::map<std::string, std::vector<std::string>> teams = members_of(result.policy);
    for (const auto& [team, members] : teams) {
        std::vector<const SubmissionMark*> own;
        for (const SubmissionMark& mark : marks)
            if (const std::string name = printable(mark.name);
                name == team || std::find(members.begin(), members.end(), name) != members.end())
                own.push_back(&mark);
        if (!own.empty()) all.add_team(team, members, own, result);
    }
    std::vector<std::string> strangers, without_time, absent, beyond;
    for (const SubmissionMark& mark : marks) {
        if (teams.contains(printable(mark.name))) continue;  // it has no student of its own
        const StudentRecord& record = result.students.emplace_back(all.of(mark.name, &mark));
        if (!record.on_roster) strangers.push_back(record.student.student);
        if (ClassOf::lacks_time(record)) without_time.push_back(record.student.student);
        if (std::any_of(record.labs.begin(), record.labs.end(), [](const auto& lab) { return !lab.kept.empty(); }))
            beyond.push_back(record.student.student);
    }
    for (const Student& student : result.policy.students)
        if (!names.contains(student.student)) {
            StudentRecord& record = result.students.emplace_back(all.of(student.student, nullptr));
            if (record.mark) continue;  // of the team
            std::vector<std::string> own{student.student};
            if (const auto team = teams.find(student.team); team != teams.end()) {
                own = team->second;
                own.push_back(team->first);
            }
            record.is_waiting =
                std::any_of(own.begin(), own.end(), [&](const std::string& one) { return handed_in.contains(one); });
            for (LabRecord& lab : record.labs) lab.marked = !record.is_waiting;
            if (!record.is_waiting) absent.push_back(student.student);
        }
    std::vector<std::string> nobody;
    if (result.policy.students.empty())  // with a roster, extensions were checked when the class file was read
        for (const Extension& one : result.policy.extensions)
            if (!known.contains(one.student)) nobody.push_back(printable(one.student));
    note(result.notes, nobody, "extension is for nobody who handed in", "extensions are for nobody who handed in");
    note(result.notes, absent, "student of the roster handed nothing in", "students of the roster handed nothing in");
    note(result.notes, strangers, "submission is not on the roster", "submissions are not on the roster");
    note(result.notes, beyond, "submission is beyond the limit of hand-ins and keeps an earlier mark",
         "submissions are beyond the limit of hand-ins and keep an earlier mark");
    if (!result.policy.hand_ins.empty())
        note(result.notes, without_time, "submission has no time in hand_ins and counts as in time",
             "submissions have no time in hand_ins and count as in time");
    return result;
}

std::string hand_ins_text(const LabRecord& lab) {
    const std::string all = amount_of(lab.hand_ins, "hand-in") + " graded";
    return lab.hand_ins == lab.on_last_day ? fmt::format("{}, on {}", all, lab.last_day)
                                           : fmt::format("{}, {} of them on {}", all, lab.on_last_day, lab.last_day);
}

void add_hand_ins(ClassRecord& record, const std::filesystem::path& folder) {
    if (record.policy.hand_ins_per_day == 0) return;
    const UtcOffset offset = record.policy.utc_offset;
    for (StudentRecord& one : record.students) {
        const std::vector<GradedHandIn> log = read_hand_in_log(folder, one.name);
        for (LabRecord& lab : one.labs) {
            const GradedHandIn* const last = last_hand_in(log, lab.lab);
            if (!last) continue;
            lab.hand_ins =
                int(std::count_if(log.begin(), log.end(), [&](const auto& row) { return row.lab == lab.lab; }));
            lab.last_day = moment_text(last->graded_at, offset).substr(0, 10);
            lab.on_last_day = hand_ins_on_day(log, lab.lab, last->graded_at, offset);
        }
    }
}

StudentRecord record_of(const SubmissionMark& mark) {
    const ClassFile none;
    return ClassOf(none, counted_labs({mark}, none, {})).of(mark.name, &mark);
}

int days_late(Moment due, Moment handed_in, double grace_hours) {
    const double late = std::chrono::duration<double>(handed_in - due).count();
    if (late <= 0 || late <= 3600 * grace_hours) return 0;
    return int(std::ceil(late / 86400));
}

double late_share(int days, const LateRule& rule) {
    if (days <= 0) return 1;
    return std::max(1 - 0.01 * rule.percent_per_day * days, 0.01 * rule.floor_percent);
}

}  // namespace relief::grade
