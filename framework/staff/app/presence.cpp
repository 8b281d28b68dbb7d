// Tells the students' library that the staff's library is present.
#include "framework/base/from_staff.h"

namespace relief {

static const decltype(staff_is_here)::Provided said(staff_is_here, [] { return true; });

}  // namespace relief
