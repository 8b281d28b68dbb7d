// The pictures that a lab's checks compare with.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "framework/course/check/relation.h"
#include "framework/course/check/verdict.h"

namespace relief {
struct LabEntry;
}

namespace relief::check {

class KeptLab;

/// Returns the picture that a check compares with. It is the file in the lab's folder `expected`, if a handout put it
/// there; else the exact values, or the picture that this course's files draw. Empty for a check that compares with
/// another check. Drawing needs a current context.
std::optional<Image> expectation(const LabEntry& lab, const CheckInfo& check);
std::optional<Image> expectation(KeptLab& kept, const CheckInfo& check);
/// Returns the path of the file in `expected`; it may not exist.
std::filesystem::path expectation_file(const LabEntry& lab, const CheckInfo& check);

/// Returns whether expectation() draws the solution's picture with the files under test. This is so in the staff's
/// course, where these files are the solution: such a check cannot find a mistake.
bool is_compared_with_itself(const LabEntry& lab, const CheckInfo& check);
/// Makes a passed check unproven, and says why, if is_compared_with_itself().
void tell_unproven(const LabEntry& lab, const CheckInfo& check, Verdict& said);
void tell_unproven(const LabEntry& lab, const Manifest& manifest, std::vector<TaskVerdict>& tasks);

/// Returns the picture of a check's shot without relief, see ProbeInfo::without. It is the file in the lab's folder
/// `expected`, if a handout put it there; else the exact values. Empty if there is neither.
std::optional<Image> base_of(const LabEntry& lab, const Manifest& manifest, const CheckInfo& check);
std::filesystem::path base_file(const LabEntry& lab, const CheckInfo& check);

/// Returns how a wrong picture relates to the expected one. Nothing if there is no simple relation, or if the picture
/// is better than the task asks for. Calls `base`, which returns base_of(), only if there is no relation without it.
std::optional<Relation> relation_of(const Manifest& manifest, const CheckInfo& check, const Image& drawn,
                                    const Image& expected, const std::function<std::optional<Image>()>& base);

}  // namespace relief::check
