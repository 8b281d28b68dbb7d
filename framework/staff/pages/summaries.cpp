#include "framework/staff/pages/summaries.h"

#include <fmt/format.h>

#include <chrono>
#include <set>

#include "framework/core/base/file.h"
#include "framework/core/base/parallel.h"
#include "framework/core/base/text.h"
#include "framework/staff/class/exports.h"
#include "framework/staff/class/progress.h"
#include "framework/staff/pages/export_pictures.h"
#include "framework/staff/pages/grade_page.h"
#include "framework/staff/pages/record_part.h"

namespace relief::pages {

namespace fs = std::filesystem;

namespace {

/// Returns a student's page with another name as its title.
std::string renamed(std::string page, const std::string& from, const std::string& to) {
    const auto escaped = [](const std::string& name) {
        std::string text = escaped_markup(grade::printable(name));
        for (size_t at = text.find('\''); at != std::string::npos; at = text.find('\'', at))
            text.replace(at, 1, "&#39;");
        return text;
    };
    for (const std::string tag : {"<title>", "<h1><bdi>"}) {
        const std::string before = tag + escaped(from) + "<";
        if (const size_t at = page.find(before); at != std::string::npos)
            page.replace(at, before.size(), tag + escaped(to) + "<");
    }
    return page;
}

/// Returns the pictures of the labs whose marks count.
std::vector<grade::ExportPicture> pictures_of(const grade::StudentRecord& record, const fs::path& folder) {
    if (record.sources.empty()) return read_pictures(folder / pictures_file(record.name));
    std::vector<grade::ExportPicture> all;
    for (const auto& [lab, source] : record.sources)
        for (grade::ExportPicture& one : read_pictures(folder / pictures_file(source)))
            if (one.lab == lab) all.push_back(std::move(one));
    return all;
}

/// Writes the record into a student's page, and creates the page if it does not exist. The page of a student without
/// a submission has nothing else.
void write_record(const grade::StudentRecord& record, grade::UtcOffset offset, const fs::path& folder, PageFor reader) {
    const fs::path file = folder / page_file(record.name, reader);
    grade::SubmissionMark nothing;
    nothing.name = record.name;
    nothing.problem = record.is_waiting ? "This is not graded yet." : "Nothing was handed in.";
    if (record.mark && !record.is_of(record.name)) {  // the mark of the team
        const fs::path source = folder / page_file(record.mark->name, reader);
        grade::SubmissionMark mark = *record.mark;
        mark.name = record.name;
        const bool is_whole = record.is_of(record.mark->name) && fs::exists(source);
        const std::string page =
            is_whole ? renamed(read_file(source), record.mark->name, record.name) : student_page(mark, {}, reader);
        return write_page(file, with_record(page, record, offset, reader));
    }
    // A run that does not name a graded submission keeps its result, and so its page.
    const bool is_kept = fs::exists(file) && (record.mark || fs::exists(grade::result_file(folder, record.name)));
    const std::string page = is_kept ? read_file(file) : student_page(record.mark ? *record.mark : nothing, {}, reader);
    const std::string now = with_record(page, record, offset, reader);
    if (!is_kept || now != page) write_page(file, now);
}

/// Returns the labs for which the folder's class, or a part of it in a subfolder, was graded; empty: all.
std::vector<std::string> labs_of(const fs::path& folder) {
    if (const auto roster = grade::read_roster(folder)) return roster->labs;
    for (const auto& part : fs::directory_iterator(folder))
        if (part.is_directory())
            if (const auto roster = grade::read_roster(part.path())) return roster->labs;
    return {};
}

/// Returns the names of all submissions of the class, graded or not.
std::set<std::string> handed_in(const fs::path& folder) {
    std::set<std::string> names;
    if (const auto roster = grade::read_roster(folder))
        for (const grade::Roster::One& one : roster->submissions) names.insert(grade::printable(one.name));
    return names;
}

/// Returns the students of the roster with a result in the folder whom this run does not name.
std::vector<std::string> left_out(const grade::ClassFile& policy, const std::set<std::string>& named,
                                  const fs::path& folder) {
    std::vector<std::string> names;
    for (const grade::Student& one : policy.students)
        if (!named.contains(one.student) && fs::exists(grade::result_file(folder, one.student)))
            names.push_back(one.student);
    return names;
}

}  // namespace

fs::path page_file(const std::string& name, PageFor reader) {
    return fs::path(reader == PageFor::student ? "students" : "submissions") / (grade::file_name_of(name) + ".html");
}

void write_page(const fs::path& file, const std::string& text) {
    make_folder(file.parent_path());
    write_file(file, text);
}

grade::ClassRecord write_summaries(const grade::ClassReport& report, const fs::path& folder) {
    for (const char* name : {"gradescope", "prairielearn", "surefire"}) make_folder(folder / name);
    const grade::ClassFile policy = grade::read_class_file(grade::class_file_of(folder), folder);
    std::set<std::string> names = handed_in(folder);
    for (const std::string& name : report.doubled) names.insert(grade::printable(name));
    for (const grade::SubmissionMark& mark : report.marks) names.insert(grade::printable(mark.name));
    const std::vector<std::string> absent = left_out(policy, names, folder);
    names.insert(absent.begin(), absent.end());  // waiting for a mark, not 0 points
    grade::ClassRecord record = grade::class_record(report.marks, policy, labs_of(folder), names);
    grade::add_hand_ins(record, folder);
    if (!absent.empty())
        record.notes.push_back(fmt::format(
            "{} handed in before, and this run does not name the submission, so there is no mark: {}. Name all of the "
            "class's: those that have not changed are not graded again",
            amount_of(double(absent.size()), "student"), grade::some_of(absent)));
    parallel_each(record.students.size(), hardware_threads(), [&](size_t i) {
        const grade::StudentRecord& one = record.students[i];
        const std::string name = grade::file_name_of(one.name);
        const std::vector<grade::ExportPicture> pictures = pictures_of(one, folder);
        write_file(folder / "gradescope" / (name + ".json"), grade::to_gradescope(one, pictures));
        write_file(folder / "prairielearn" / (name + ".json"), grade::to_prairielearn(one, pictures));
        write_file(folder / "surefire" / ("TEST-" + name + ".xml"), grade::to_surefire(one));
        for (const PageFor reader : page_readers) write_record(one, record.policy.utc_offset, folder, reader);
    });
    write_file(folder / "results.csv", grade::to_csv(record));
    write_file(folder / "junit.xml",
               grade::to_junit(record, std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now())));
    if (!record.policy.students.empty())
        write_file(folder / "canvas.csv", grade::to_canvas(record));
    else
        fs::remove(folder / "canvas.csv");  // a stale file must not be uploaded
    if (grade::has_limits(record.policy))
        write_file(folder / "late_days.csv", grade::to_late_days(record));
    else
        fs::remove(folder / "late_days.csv");
    for (const grade::AssignedLab& lab : record.policy.labs)
        if (!lab.moodle.empty() && !record.students.empty() && record.students.front().lab(lab.folder)) {
            make_folder(folder / "moodle");
            write_file(folder / "moodle" / (lab.folder + ".csv"), grade::to_moodle(record, lab, record.notes));
        }
    write_file(folder / "report.html", class_page(report, record));
    return record;
}

}  // namespace relief::pages
