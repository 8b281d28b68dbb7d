// Compares the picture of a check with the expected one.
#pragma once

#include "framework/course/check/verdict.h"

namespace relief::check {

/// Judges a picture: first whether it is usable, then its distance from the expected one. `drawn` may come from an
/// untrusted process: its shape and values are checked. Needs no context.
Verdict judge(const Manifest& manifest, const CheckInfo& check, const Image& drawn, const Image& expected);

}  // namespace relief::check
