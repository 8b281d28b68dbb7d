// Inspection of a map from another program: normals or heights, how they are stored, and which texels are faulty.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "framework/core/image/image.h"

namespace relief::inspect {

enum class Outcome {
    good,
    note,     ///< correct, but a program that reads the map must know it
    fault,    ///< wrong for a linear, green-up, repeating map of unit vectors
    unknown,  ///< the map does not show it; `reason` says why
};

/// The result of one test. Scripts read names, verdicts and names of numbers: these never change.
struct Finding {
    std::string name;  ///< "kind", "order", "stored", "length", "side", "zero", "green", "tilt", "seam", "fourth",
                       ///< "heights", ...
    Outcome outcome = Outcome::good;
    std::string verdict;  ///< "down", "sRGB"
    std::string reason;   ///< for people: the measurement, and the remedy
    std::vector<std::pair<std::string, double>> numbers;
};

/// A fault of a texel; a texel can have several.
enum Mark : uint8_t {
    mark_not_finite = 1,
    mark_length = 2,    ///< not of unit length
    mark_side = 4,      ///< points into the surface
    mark_seam = 8,      ///< next to a border where the map does not repeat
    mark_green = 16,    ///< green points the opposite way to the rest of the map
    mark_heights = 32,  ///< far from the normal that the heights give
};

struct Inspection {
    std::vector<Finding> findings;
    std::vector<uint8_t> marks;  ///< for each texel, the sum of its Mark values

    int faults() const;
    /// Returns the finding of this name; null if that test did not apply.
    const Finding* find(const std::string& name) const&;
    const Finding* find(const std::string& name) const&& = delete;
};

/// Runs the tests that apply to this kind of map; "kind" comes first. The map has 1 to 4 channels and any values.
/// `heights`, if given, is the height map that the normals should come from. Takes about 30 bytes per texel.
Inspection inspect(const Image& map, const Image* heights = nullptr);

/// Returns the map as a lit relief in grey, with its marks in the colours of mark_colors(). 8 bits, 3 channels.
Image picture_of_marks(const Image& map, const Inspection& inspection);

struct MarkColor {
    Mark mark;
    const char *color, *meaning;
    float red, green, blue;
};
/// Sorted by priority: a texel with several marks takes the first colour that applies.
const std::vector<MarkColor>& mark_colors();

}  // namespace relief::inspect
