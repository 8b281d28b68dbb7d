// Exports marks in the formats of other programs. Every export applies the class file to the grader's verdict. Only the
// JUnit export contains the verdict itself. tests/staff/class/exports_test.cpp tests each export
// against the rules of its format.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "framework/staff/class/record.h"

namespace relief::grade {

/// Returns results.csv: a line for each student with identifiers, state and points, then points of each lab, and of
/// each task before lateness. Column names contain the maxima. Formulas are disabled: see defused().
std::string to_csv(const ClassRecord& record);

/// Returns late_days.csv: a line for each student and lab, with the late days, how many of them the bank of the term
/// pays, the rest of the bank, and the number of graded hand-ins.
std::string to_late_days(const ClassRecord& record);

/// Returns a gradebook for import into Canvas, with a column for each assigned lab, named as the class file says.
/// Canvas finds students by ID, SIS user ID or SIS login ID. A cell without points leaves the grade unchanged. Source:
/// Instructure, Canvas Instructor Guide, "How do I import grades in the Gradebook?", and the importer of
/// instructure/canvas-lms (lib/gradebook_importer.rb).
std::string to_canvas(const ClassRecord& record);

/// Returns Moodle's grading worksheet for an assignment, with grades and feedback for one lab. Everything else in it is
/// unchanged. Finds students by email address, username or ID number. Scales grades to Maximum Grade, since Moodle
/// ignores higher ones. Adds remarks for the instructor to `notes`. Throws Error if the file is not a worksheet in
/// English. Source: MoodleDocs, "Using Assignment", "Upload grading worksheet"; moodle/moodle
/// (mod/assign/feedback/offline).
std::string to_moodle(const ClassRecord& record, const AssignedLab& lab, std::vector<std::string>& notes);

/// A picture of a failed check, which its student may see: see pages::export_pictures().
struct ExportPicture {
    std::string lab, task, check;
    std::string label;  ///< "yours", "expected", "where they differ"
    std::string uri;    ///< a PNG as data:image/png;base64,
};

/// Returns PrairieLearn's results.json of an external grader. The student reads all of it, so it reveals only the
/// outcome of a hidden check, and has no picture of a hidden check or view. At most 1 MB: without pictures if they make
/// it larger. Source: PrairieLearn, "External grading", "Grading results".
std::string to_prairielearn(const StudentRecord& record, const std::vector<ExportPicture>& pictures = {});

/// Returns Gradescope's results.json. Gradescope hides hidden checks from the student, and then shows no total. Source:
/// Gradescope, "Autograder Specifications", "Output format". Pictures stand in the HTML of their check, whose text is
/// escaped; everything else is plain text.
std::string to_gradescope(const StudentRecord& record, const std::vector<ExportPicture>& pictures = {});

/// Returns JUnit XML with a suite for each submission and a case for each check, as Ant's JUnitReport task and Jenkins
/// read it. `written` is the time that JUnit requires, since results have none. Sources: windyroad/JUnit-Schema (Ant);
/// jenkinsci/xunit-plugin, junit-10.xsd.
std::string to_junit(const ClassRecord& record, Moment written);
/// Returns one suite in the format of Maven's Surefire, for a file TEST-NAME.xml. Source: Apache Maven Surefire,
/// surefire-test-report.xsd.
std::string to_surefire(const StudentRecord& record);

/// Returns a table for a terminal.
std::string to_table(const ClassRecord& record);

}  // namespace relief::grade
