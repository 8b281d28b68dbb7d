// Marks in the formats that other programs read. Each is what the class file made of the grader's verdict, but for
// JUnit's, which has the verdict check by check. tests/staff/grade/exports_test.cpp tests each against the rules of its
// format.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "framework/staff/grade/standing.h"

namespace relief {

/// results.csv: a line for each student with identifiers, state and points; then points of each lab, and of each task
/// before lateness. Column names have the maxima. Defused for spreadsheets.
std::string to_csv(const ClassStanding& standing);

/// Canvas's gradebook, to be imported: a column for each assigned lab, named as the class file says. Canvas finds
/// students by ID, SIS user ID or SIS login ID. A cell without points leaves the grade as it is. Source: Instructure,
/// Canvas Instructor Guide, "How do I import grades in the Gradebook?", and the importer of instructure/canvas-lms
/// (lib/gradebook_importer.rb).
std::string to_canvas(const ClassStanding& standing);

/// The grading worksheet that Moodle made for an assignment, with grades and feedback for one lab. Everything else in
/// it stays. Finds students by email address, username or ID number. Grades are scaled to Maximum Grade: Moodle ignores
/// what is above. `notes` gets what an instructor should know. Throws Error if it is no worksheet in English.
/// Source: MoodleDocs, "Using Assignment", "Upload grading worksheet"; moodle/moodle (mod/assign/feedback/offline).
std::string to_moodle(const ClassStanding& standing, const AssignedLab& lab, std::vector<std::string>& notes);

/// PrairieLearn's results.json of an external grader. Its student reads all of it: so it says of a hidden check only
/// how it went. At most 1 MB. Source: PrairieLearn, "External grading", "Grading results".
std::string to_prairielearn(const Standing& standing);

/// Gradescope's results.json; hidden checks are hidden from the student there, and Gradescope then shows him no total.
/// Source: Gradescope, "Autograder Specifications", "Output format".
std::string to_gradescope(const Standing& standing);

/// JUnit XML, a suite for each submission and a case for each check, as Ant's JUnitReport task and Jenkins read it.
/// `written`: JUnit wants a time, and results have none. Sources: windyroad/JUnit-Schema (Ant); jenkinsci/xunit-plugin,
/// junit-10.xsd.
std::string to_junit(const ClassStanding& standing, Moment written);
/// One suite as Maven's Surefire writes it, to be stored as TEST-NAME.xml. Source: Apache Maven Surefire,
/// surefire-test-report.xsd.
std::string to_surefire(const Standing& standing);

/// A table for a terminal.
std::string to_table(const ClassStanding& standing);

}  // namespace relief
