// relief handout: the student's course.
#include "framework/grade/handout.h"

#include <fmt/format.h>

#include "framework/app/commands.h"
#include "framework/base/error.h"

namespace relief {

int make_handout(const std::string& folder) {
    if (folder.empty()) throw UsageError("handout needs a folder for the students' course: -o FOLDER");
    pin_software_renderer();
    const auto context = open_any_context();
    const HandoutReport report = write_handout(folder);
    fmt::print("{}: {} labs, {} tasks, {} files, {} of them expected pictures\n", folder, report.labs, report.tasks,
               report.files, report.expected);
    return 0;
}

}  // namespace relief
