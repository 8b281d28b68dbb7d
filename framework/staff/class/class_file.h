// A class file: the students, the labs that count with their due dates, the penalty for lateness, and the adjustments
// that people make. An example with all keys is in labs/staff/README.md.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "framework/course/manifest/manifest.h"
#include "framework/staff/class/point_in_time.h"

namespace relief::grade {

struct Student {
    std::string student = {};  ///< the name of the submission, as results.csv shows it, composed()
    std::string name = {}, email = {}, login = {}, canvas_id = {}, sis_id = {}, section = {};  ///< each may be empty
    std::string team = {};  ///< students of one team have one mark; empty: none
};

struct AssignedLab {
    std::string folder;
    std::vector<TaskInfo> tasks;   ///< none is optional if the class file lets the optional ones count
    std::optional<Moment> due;     ///< without it, nothing is late
    std::string canvas;            ///< the column in Canvas's gradebook
    std::filesystem::path moodle;  ///< Moodle's grading worksheet, or empty
};

/// Lateness takes a share of a lab's earned points.
struct LateRule {
    double grace_hours = 0;      ///< time after the due date during which nothing is late
    double percent_per_day = 0;  ///< percentage lost for each started day after the due date
    double floor_percent = 0;    ///< lower bound of the remaining percentage
    int bank_days = 0;           ///< late days of the whole term that cost nothing
    int bank_days_per_lab = 0;   ///< upper bound of these days in one lab
};

struct Extension {
    std::string student, lab;  ///< no lab: for all labs
    int days = 0;
    std::string note;  ///< for instructors
};

struct HandInTime {
    std::string student, lab;  ///< or a team; no lab: for all labs without a time of their own
    Moment time;
};

/// Points that a person adds to a task, or takes away.
struct Adjustment {
    std::string student, task;
    double points = 0;
    std::string note;  ///< for the student, too
    Place place;
};

struct ClassFile {
    std::filesystem::path file;     ///< empty: no class file
    std::vector<AssignedLab> labs;  ///< by number; empty: the graded labs
    std::vector<Student> students;  ///< the roster; empty: no roster
    UtcOffset utc_offset{0};        ///< for showing times
    LateRule late;
    int hand_ins_per_day = 0;  ///< graded hand-ins per student, lab and day; 0: any number
    std::vector<Extension> extensions;
    std::vector<HandInTime> hand_ins;
    std::vector<Adjustment> adjustments;

    /// Returns the assigned lab; null if it does not count.
    const AssignedLab* lab(const std::string& folder) const;
};

/// Reads a class file and the tables that it names, relative to its folder. Adjustments come from the file that it
/// names, else from adjustments.csv in `results`, if that exists. If `file` is empty, the result has adjustments only.
/// Throws Error with file and line for an unknown key, lab or task, an invalid date, a duplicate student or identifier,
/// and a student who is not on the roster.
ClassFile read_class_file(const std::filesystem::path& file, const std::filesystem::path& results);

/// Returns whether a student of the roster has a team.
bool has_teams(const ClassFile& policy);

/// Returns whether the class has late days or a limit of hand-ins. If it has, late_days.csv is written.
bool has_limits(const ClassFile& policy);

/// Returns the class file kept for a folder of results, or an empty path. Throws UsageError if it no longer exists.
std::filesystem::path class_file_of(const std::filesystem::path& results);
/// Records the class file for later runs into the folder; an empty path removes the record.
void keep_class_file(const std::filesystem::path& file, const std::filesystem::path& results);

/// Throws Error at the first adjustment whose student is not in `students`, or whose task is not in `tasks`. Without a
/// roster, only the submissions tell who is in the class.
void refuse_unknown_adjustments(const ClassFile& policy, const std::set<std::string>& students,
                                const std::set<std::string>& tasks);

}  // namespace relief::grade
