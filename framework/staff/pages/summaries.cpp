#include "framework/staff/pages/summaries.h"

#include "framework/base/file.h"
#include "framework/staff/pages/grade_page.h"
#include "framework/staff/pages/student_page.h"

namespace relief {

namespace fs = std::filesystem;

fs::path student_page_file(const std::string& name) { return fs::path("students") / (file_name_of(name) + ".html"); }

void write_summaries(const ClassReport& report, const fs::path& folder) {
    make_folder(folder / "gradescope");
    make_folder(folder / "students");
    for (const SubmissionMark& mark : report.marks) {
        write_file(folder / "gradescope" / (file_name_of(mark.name) + ".json"), to_gradescope(mark));
        if (const fs::path page = folder / student_page_file(mark.name); !fs::exists(page))
            write_file(page, student_page(mark, {}));
    }
    write_file(folder / "results.csv", to_csv(report.marks));
    write_file(folder / "junit.xml", to_junit(report.marks));
    write_file(folder / "report.html", class_page(report));
}

}  // namespace relief
