// Arbitrary task files of a student or a teacher.
#include "framework/course/task/starter.h"
#include "framework/course/task/task_text.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t count) {
    return relief::fuzz(bytes, count, [](const std::string& text) {
        const relief::TaskInfo task{.id = "1.1", .title = "", .file = "t", .functions = {"f(float, float)"}};
        relief::check::is_unfinished(text, task);
        relief::check::task_at_line(text, {task}, "t", 3);
        // Marks are lines of their own, so removing them makes no text longer.
        if (relief::check::starter_of(text, "task.glsl").size() > text.size()) __builtin_trap();
        relief::check::solution_lines(text, "task.glsl");
    });
}
