// A class file: who is in the class, which labs count, when they are due, what lateness costs; and the adjustments that
// people make. An example with all keys is in labs/staff/README.md.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "framework/lab/manifest.h"
#include "framework/staff/grade/moment.h"

namespace relief {

struct Student {
    std::string student;  ///< the name of the submission, as results.csv shows it, composed()
    std::string name, email, login, canvas_id, sis_id, section;  ///< each may be empty
};

struct AssignedLab {
    std::string folder;
    std::vector<TaskInfo> tasks;
    std::optional<Moment> due;     ///< nothing is late without
    std::string canvas;            ///< the column in Canvas's gradebook
    std::filesystem::path moodle;  ///< the grading worksheet that Moodle made, or empty
};

/// Lateness takes a share of what a lab has earned.
struct LateRule {
    double grace_hours = 0;      ///< so long after the due date nothing is late
    double percent_per_day = 0;  ///< for each started day since the due date
    double floor_percent = 0;    ///< so much is left, however late
};

struct Extension {
    std::string student, lab;  ///< no lab: for all labs
    int days = 0;
    std::string note;  ///< for instructors
};

struct HandIn {
    std::string student, lab;  ///< no lab: for all labs that have no time of their own
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
    std::filesystem::path file;     ///< empty: there is none
    std::vector<AssignedLab> labs;  ///< by number; empty: those that were graded
    std::vector<Student> students;  ///< the roster; empty: there is none
    UtcOffset utc_offset{0};        ///< in which times are shown
    LateRule late;
    std::vector<Extension> extensions;
    std::vector<HandIn> hand_ins;
    std::vector<Adjustment> adjustments;

    /// Nothing if it does not count.
    const AssignedLab* lab(const std::string& folder) const;
};

/// Reads a class file, and the tables that it names, relative to its folder. Adjustments are those of the file that it
/// names, else of adjustments.csv in `results`, if there is one. If `file` is empty, there are only those. Throws Error
/// with file and line for an unknown key, lab or task, a wrong date, a doubled student or identifier, and a student
/// whom the roster does not have.
ClassFile read_class_file(const std::filesystem::path& file, const std::filesystem::path& results);

/// The class file that was kept for a folder of results, or nothing. Throws UsageError if it does not exist any more.
std::filesystem::path class_file_of(const std::filesystem::path& results);
/// Keeps it for later runs into the folder; an empty path: none.
void keep_class_file(const std::filesystem::path& file, const std::filesystem::path& results);

/// Throws Error at the first adjustment whose student or task is none of these. Without a roster only the submissions
/// tell who is in the class.
void refuse_unknown_adjustments(const ClassFile& policy, const std::set<std::string>& students,
                                const std::set<std::string>& tasks);

}  // namespace relief
