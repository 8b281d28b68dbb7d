// Provides the staff's lines of `relief info`.
#include <fmt/format.h>

#include "framework/core/base/from_staff.h"
#include "framework/staff/grade/sandbox.h"

namespace relief::app {
namespace {

const decltype(staff_info)::Provided told(staff_info, [] {
    const grade::IsolationReport isolation = grade::probe_isolation();
    return fmt::format("grading  submissions run with {}, and system calls are filtered{}\n{}",
                       grade::name_of(isolation.level), isolation.reason.empty() ? "" : "; " + isolation.reason,
                       isolation.remedy);
});

}  // namespace
}  // namespace relief::app
