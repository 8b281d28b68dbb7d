#include "framework/staff/pages/summaries.h"

#include "framework/base/file.h"
#include "framework/staff/pages/grade_page.h"

namespace relief {

namespace fs = std::filesystem;

fs::path page_file(const std::string& name, PageFor reader) {
    return fs::path(reader == PageFor::student ? "students" : "submissions") / (file_name_of(name) + ".html");
}

void write_page(const fs::path& file, const std::string& text) {
    make_folder(file.parent_path());
    write_file(file, text);
}

void write_summaries(const ClassReport& report, const fs::path& folder) {
    make_folder(folder / "gradescope");
    for (const SubmissionMark& mark : report.marks) {
        write_file(folder / "gradescope" / (file_name_of(mark.name) + ".json"), to_gradescope(mark));
        for (const PageFor reader : page_readers)
            if (const fs::path page = folder / page_file(mark.name, reader); !fs::exists(page))
                write_page(page, student_page(mark, {}, reader));
    }
    write_file(folder / "results.csv", to_csv(report.marks));
    write_file(folder / "junit.xml", to_junit(report.marks));
    write_file(folder / "report.html", class_page(report));
}

}  // namespace relief
