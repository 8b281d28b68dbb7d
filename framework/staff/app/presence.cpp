// Says that the staff's library is here.
#include "framework/base/from_staff.h"

namespace relief {

static const decltype(staff_is_here)::Provided said(staff_is_here, [] { return true; });

}  // namespace relief
