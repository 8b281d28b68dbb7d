// The record of a student: the grader's verdict, adjustments by people, the penalty for lateness, and missing labs.
// It is derived from the results and the class file; results never change.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "framework/staff/class/class_file.h"
#include "framework/staff/grade/results.h"

namespace relief::grade {

struct TaskRecord {
    std::string id, title;
    int of = 0;
    bool optional = false;  ///< not part of the lab's maximum
    double graded = 0;      ///< by the grader
    double adjusted = 0;    ///< including adjustments, in [0, `of`]
};

struct LabRecord {
    std::string lab;  ///< folder
    bool handed_in = false;
    bool marked = true;  ///< false: the grader's machine failed, so there are no points yet
    std::vector<TaskRecord> tasks;
    std::optional<Moment> due, handed_in_at;  ///< `due` includes the extension
    int extension_days = 0;
    std::string extension_note;  ///< for instructors
    int days_late = 0;           ///< started days; 0: on time
    int bank_days = 0;           ///< of these, days that the bank of the term pays
    double late_share = 1;       ///< share of the points that remains after lateness
    std::string kept;            ///< see LabMark
    int hand_ins = 0;            ///< graded hand-ins in the log, see add_hand_ins()
    std::string last_day;        ///< "2027-03-01", the day of the last one
    int on_last_day = 0;         ///< graded hand-ins on that day

    /// Optional tasks are not part of the maximum. Their points make up for lost ones, up to it.
    int of() const;
    double graded() const, adjusted() const;
    double points() const { return adjusted() * late_share; }
};

struct StudentRecord {
    std::string name;                      ///< of the submission; from the roster if nothing was handed in
    Student student;                       ///< from the roster; if not on it, only `student` is set
    bool on_roster = true;                 ///< also true without a roster
    const SubmissionMark* mark = nullptr;  ///< of the student or the team; null: nothing was handed in, or it is not
                                           ///< graded yet
    std::map<std::string, std::string> sources = {};  ///< of a team: the submission whose mark counts, by lab
    std::vector<std::string> team_remarks = {};       ///< which of a team's submissions counts, and why
    bool is_waiting = false;                          ///< handed in, but not graded yet
    std::vector<LabRecord> labs;                      ///< the labs that count, the same for all students
    std::vector<Adjustment> adjustments;
    int bank_days = 0, bank_used = 0;  ///< free late days of the term; how many of them are used

    int of() const;
    double graded() const, adjusted() const, points() const;
    /// Returns whether all labs have the marks of this submission.
    bool is_of(const std::string& submission) const;
    bool is_marked() const;  ///< whether every lab is
    /// Returns whether adjustments or lateness have changed the points.
    bool is_changed() const;
    const LabRecord* lab(const std::string& folder) const;
    /// Returns "graded", "nothing handed in", "not graded yet", "not graded: the machine failed", or the submission's
    /// problem.
    std::string state() const;
    /// Returns the adjustments by people and rules to one lab, or to all if `lab` is empty. One sentence each: "2.1: +1
    /// point: a typing error", "lab 02: 2 days late, 20 % less".
    std::vector<std::string> remarks(const std::string& lab = {}) const;
};

struct ClassRecord {
    ClassFile policy;
    /// In the order of the submissions, then students of the roster without one. A team's own submission is none.
    std::vector<StudentRecord> students;
    std::vector<std::shared_ptr<const SubmissionMark>> team_marks = {};  ///< of teams with several submissions
    std::vector<std::string> notes;                                      ///< remarks for the instructor, one per line
};

/// Computes the record of each student. One submission of any member of a team, or of the team's name, counts for all
/// members. If several have a lab, the one that was handed in last counts; without all times, the one with most points.
/// The longest extension of a member counts, too. Late days of the term and adjustments remain each member's own.
/// `only`: the labs that the grader was asked for; empty: all. `handed_in`: the names of all submissions as printable()
/// shows them; a submission without a mark is not graded yet. Without assigned labs, the labs of any submission count.
/// The marks must outlive the result. Throws Error for an adjustment of an unknown student or task, and if none of
/// `only` is assigned.
ClassRecord class_record(const std::vector<SubmissionMark>& marks, ClassFile policy,
                         const std::vector<std::string>& only, const std::set<std::string>& handed_in = {});
ClassRecord class_record(const std::vector<SubmissionMark>&& temporary, ClassFile policy,
                         const std::vector<std::string>& only, const std::set<std::string>& handed_in = {}) = delete;

/// Returns "3 days late, of which 2 cost nothing, 10 % less".
std::string lateness_text(const LabRecord& lab);

/// Returns "5 hand-ins graded, 2 of them on 2027-03-01".
std::string hand_ins_text(const LabRecord& lab);

/// Reads the number of graded hand-ins of each lab from the logs in the folder of results.
void add_hand_ins(ClassRecord& record, const std::filesystem::path& folder);

/// Returns the record of a submission alone, without the class.
StudentRecord record_of(const SubmissionMark& mark);

/// Returns the number of started days from `due` to `handed_in`; 0 during the first `grace_hours` hours.
int days_late(Moment due, Moment handed_in, double grace_hours);
/// Returns the share of a lab's points that remains after lateness, in [0, 1].
double late_share(int days, const LateRule& rule);

}  // namespace relief::grade
