// The part of `relief explain` that is in the staff's library.
#pragma once

#include <memory>
#include <string>

#include "framework/core/base/from_staff.h"
#include "framework/course/manifest/manifest.h"

namespace relief::app {

/// Replaces task files of the course for the lifetime of the result: by a known mistake, or by a submission (a folder
/// or an archive). Exactly one of `mistake` and `submission` is not empty.
inline FromStaff<std::shared_ptr<void>(const Manifest&, const std::string& mistake, const std::string& submission)>
    course_with;

}  // namespace relief::app
