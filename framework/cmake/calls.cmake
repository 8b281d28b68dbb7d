# The public calls of tasks in C++, whose values `relief check` compares with the solution's.
#
# relief_write_calls(FOLDER FILE) writes FILE, a source file with the calls of the [[example]] of FOLDER/lab.toml that
# belong to tasks in task.cpp. FOLDER/task.h declares the functions that they call, in its namespace.
function(relief_write_calls folder file)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${folder}/lab.toml)
  file(READ ${folder}/task.h header)
  string(REGEX MATCH "\nnamespace ([a-z0-9_:]+)" found "${header}")
  set(namespace ${CMAKE_MATCH_1})
  file(READ ${folder}/lab.toml text)
  # A list of CMake gives a meaning to these characters.
  string(REPLACE ";" "<semicolon>" text "${text}")
  string(REPLACE "[" "<open>" text "${text}")
  string(REPLACE "]" "<close>" text "${text}")
  string(REPLACE "\n" ";" lines "${text}")
  set(table)
  set(cpp_tasks)
  set(cases)
  foreach(line IN LISTS lines)
    if(line MATCHES "^<open><open>([a-z]+)<close><close>")
      set(table ${CMAKE_MATCH_1})
    elseif(line MATCHES "^(id|task) = \"([0-9.]+)\"")
      set(task ${CMAKE_MATCH_2})
    elseif("${table}" STREQUAL "task" AND line MATCHES "^file = \".*task.cpp\"")
      list(APPEND cpp_tasks ${task})
    elseif("${table}" STREQUAL "example" AND task IN_LIST cpp_tasks
        AND line MATCHES "^(calls = <open>|  )\"(.*)\"(,|<close>)$")
      set(call "${CMAKE_MATCH_2}")
      string(REPLACE "<open>" "[" call "${call}")
      string(REPLACE "<close>" "]" call "${call}")
      string(REPLACE "<semicolon>" ";" call "${call}")
      string(APPEND cases "    if (call == R\"call(${call})call\") return as_pixel(${call});\n")
    endif()
  endforeach()
  file(CONFIGURE OUTPUT ${file} @ONLY CONTENT "// Made from lab.toml by framework/cmake/calls.cmake.
#include \"framework/course/check/calls.h\"

#include <algorithm>
#include <cmath>

#include \"task.h\"

namespace @namespace@ {
namespace {
std::optional<glm::dvec4> value_of_public_call([[maybe_unused]] const std::string& call) {
    using relief::check::as_pixel;
@cases@    return {};
}
const relief::check::ProvidedCalls provided(&value_of_public_call);
}  // namespace
}  // namespace @namespace@
")
endfunction()
