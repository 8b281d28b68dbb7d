// The part of `relief shot` that is in the staff's library.
#pragma once

#include <string>

#include "framework/app/command.h"
#include "framework/base/from_staff.h"
#include "framework/lab/registry.h"
#include "framework/lab/shot.h"

namespace relief {

/// Draws the lab with the known mistake `id` in place of its solution; see draw_shot() for `light`.
inline FromStaff<Image(const LabEntry&, const std::string& id, const Shot&, bool light, ContextChoice)>
    draw_with_mistake;

}  // namespace relief
