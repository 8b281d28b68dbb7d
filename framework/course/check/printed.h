// The output of a process with a student's code: its own text, and the report of a fault.
#pragma once

#include <string>

namespace relief::check {

struct Printed {
    std::string text = {};  ///< the text outside of a report
    /// What a report says, in one sentence without a subject: "reads past the end of an array"; empty without a report.
    std::string fault = {};
    std::string place = {};      ///< the line of a task in the report, "labs/05_tangent_basis/task.cpp:32"; or empty
    bool has_no_memory = false;  ///< the limit of memory was exceeded
};

/// Finds the first report in a process's output: of the address sanitizer or the undefined-behaviour sanitizer of
/// GCC and Clang, or of an assertion of GCC's C++ library (_GLIBCXX_ASSERTIONS). Other text is the task's own.
Printed read_printed(const std::string& text);

}  // namespace relief::check
