// The part of `relief explain` that is in the staff's library.
#pragma once

#include <memory>
#include <string>

#include "framework/base/from_staff.h"
#include "framework/lab/manifest.h"

namespace relief {

/// While the result lives, the course has other task files: those of a known mistake, or those found in a submission
/// (a folder, an archive). One of the two is empty.
inline FromStaff<std::shared_ptr<void>(const Manifest&, const std::string& mistake, const std::string& submission)>
    course_with;

}  // namespace relief
