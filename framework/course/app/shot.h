// The part of `relief shot` that is in the staff's library.
#pragma once

#include <string>

#include "framework/core/base/from_staff.h"
#include "framework/core/lab/registry.h"
#include "framework/core/lab/shot.h"
#include "framework/course/app/command.h"

namespace relief::app {

/// Draws the lab with the known mistake `id` in place of its solution; see draw_shot() for `light`.
inline FromStaff<Image(const LabEntry&, const std::string& id, const Shot&, bool light, ContextChoice)>
    draw_with_mistake;

}  // namespace relief::app
