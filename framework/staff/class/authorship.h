// Which hand-in is whose. A student's file arrives under the name that the student, a browser, Moodle or Canvas gave
// it. This is the only place that compares such names with the roster.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "framework/staff/class/class_file.h"
#include "framework/staff/grade/submission.h"

namespace relief::grade {

/// The name of a folder or file in the archive with all submissions of an assignment.
///
/// Moodle: "Gina Rossi_12345_assignsubmission_file_" is a folder, followed by the file's name if the teacher downloads
/// no folders. The full name lacks & < > " ` | ' : \ / and has a blank for each underscore; 12345 is the participant's
/// number in the assignment; a group has its name and the number of the group. With anonymous submissions the name is
/// "Participant". Source: moodle/moodle, mod/assign/classes/downloader.php.
///
/// Canvas: "rossigina_LATE_12345_67890_task.glsl" is a file. The name that Canvas sorts by ("Rossi, Gina") lacks all
/// but letters, digits and underscores, in lower case; 12345 is the ID of the user, 67890 that of the upload, which
/// grows with time. With anonymous submissions "anon_" and five letters stand in place of name and ID. Canvas appends
/// -1 to the name of a file that a student uploads again. Source: instructure/canvas-lms, lib/content_zipper.rb.
struct DownloadName {
    enum class From { nowhere, moodle, canvas };
    From from = From::nowhere;  ///< nowhere: `author` is the whole name
    std::string author = {};    ///< "Gina Rossi", "rossigina"; empty if it is anonymous
    std::string number = {};    ///< of the author; empty if there is none
    std::string file = {};      ///< the name of the uploaded file; empty for a folder
    long long upload = 0;       ///< Canvas's number of the upload
    bool is_text = false;       ///< text written in the browser, which is never a task file
};
/// Parses the name of a folder, or of a file with its ending.
DownloadName parse_download_name(const std::string& name);

/// All that one author handed in.
struct HandIn {
    std::string name;                   ///< `student` or `team` of the roster; without one, the file's name
    std::string team;                   ///< of the roster, or empty
    std::vector<SubmissionPart> parts;  ///< which count
    std::vector<std::string> remarks;   ///< printable sentences: which of several versions counts, and why
};

struct HandIns {
    std::vector<HandIn> all;         ///< in the order of their first paths
    std::vector<std::string> notes;  ///< printable sentences for the instructor
    /// Several hand-ins of one name, of which nothing tells the latest. These are not in `all`.
    struct Doubled {
        std::string name;
        std::vector<std::filesystem::path> paths;
        std::string message;  ///< printable
    };
    std::vector<Doubled> doubled;
};

/// Assigns paths to the students of a roster, in this order: by `student` or `team`; by Canvas's ID or the number in a
/// Moodle worksheet of the class file; by the name, login, email or sis_id, folded(), the words of a name in any
/// rotation ("Rossi, Gina" and "Gina Rossi"); by any of these without the mark of a copy ("gina (1)"). A name that fits
/// several students fits none, and a note says so. Without a roster, a name remains as it is, without what Moodle and
/// Canvas append.
///
/// Of several hand-ins of an author, those from Moodle are parts of one submission, and so are those from Canvas: they
/// are several files, or several assignments. Else the latest copy counts. If copies have equal numbers, none counts.
HandIns hand_ins_of(const std::vector<std::filesystem::path>& paths, const ClassFile& policy);

}  // namespace relief::grade
