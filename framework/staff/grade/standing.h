// Where a student stands: the grader's verdict, what people added to it, what lateness took, and what was not handed
// in. Results stay as they are; this follows from them and the class file.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "framework/staff/grade/class_file.h"
#include "framework/staff/grade/results.h"

namespace relief {

struct TaskStanding {
    std::string id, title;
    int of = 0;
    double graded = 0;    ///< by the grader
    double adjusted = 0;  ///< with adjustments: from 0 to `of`
};

struct LabStanding {
    std::string lab;  ///< folder
    bool handed_in = false;
    bool marked = true;  ///< false: the grader's machine failed, so there are no points yet
    std::vector<TaskStanding> tasks;
    std::optional<Moment> due, handed_in_at;  ///< due: with the extension
    int extension_days = 0;
    std::string extension_note;  ///< for instructors
    int days_late = 0;           ///< started days; 0: in time
    double late_share = 1;       ///< of the points, what lateness leaves

    int of() const;
    double graded() const, adjusted() const;
    double points() const { return adjusted() * late_share; }
};

struct Standing {
    std::string name;                      ///< of the submission, or the roster's for who handed nothing in
    Student student;                       ///< of the roster; empty but for `student` if it does not have the name
    bool on_roster = true;                 ///< also if there is none
    const SubmissionMark* mark = nullptr;  ///< null: nothing was handed in, or it is not graded yet
    bool is_waiting = false;               ///< the second of these
    std::vector<LabStanding> labs;         ///< those that count, the same for all
    std::vector<Adjustment> adjustments;

    int of() const;
    double graded() const, adjusted() const, points() const;
    bool is_marked() const;  ///< every lab is
    /// Adjustments or lateness have changed the points.
    bool is_changed() const;
    const LabStanding* lab(const std::string& folder) const;
    /// "graded", "nothing handed in", "not graded yet", "not graded: the machine failed", or the submission's problem
    std::string state() const;
    /// What people and rules did, a sentence each: "2.1: +1 point: a typing error", "lab 02: 2 days late, 20 % less".
    /// Of one lab, or of all.
    std::vector<std::string> remarks(const std::string& lab = {}) const;
};

struct ClassStanding {
    ClassFile policy;
    std::vector<Standing>
        students;  ///< in the order of the submissions, then those of the roster who handed nothing in
    std::vector<std::string> notes;  ///< what an instructor should know, a line each
};

/// `only` are the labs that the grader was asked for; empty: all. `handed_in` has the names of submissions as
/// printable() shows them; those without a mark are not graded yet. Without assigned labs those count that any
/// submission has. The marks must outlive the result. Throws Error for an adjustment of an unknown student or task, and
/// if none of `only` is assigned.
ClassStanding class_standing(const std::vector<SubmissionMark>& marks, ClassFile policy,
                             const std::vector<std::string>& only, const std::set<std::string>& handed_in = {});
ClassStanding class_standing(const std::vector<SubmissionMark>&& temporary, ClassFile policy,
                             const std::vector<std::string>& only,
                             const std::set<std::string>& handed_in = {}) = delete;

/// Of a submission alone, before the class is known.
Standing standing_of(const SubmissionMark& mark);

/// Started days from `due` to `handed_in`; 0 until so many hours after it.
int days_late(Moment due, Moment handed_in, double grace_hours);
/// The share of a lab's points that lateness leaves, from 0 to 1.
double late_share(int days, const LateRule& rule);

}  // namespace relief
