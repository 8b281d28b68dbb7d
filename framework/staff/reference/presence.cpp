// Tells the framework that the staff's half of the course is present.
#include "framework/core/base/from_staff.h"

namespace relief {
namespace {

const decltype(staff_is_here)::Provided said(staff_is_here, [] { return true; });

}  // namespace
}  // namespace relief
