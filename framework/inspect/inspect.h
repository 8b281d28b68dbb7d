// What a map from elsewhere is: normals or heights, how they are stored, what is wrong with them and where.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "framework/image/image.h"

namespace relief {

enum class Outcome {
    good,
    note,     ///< right in itself, but a program that reads the map must know it
    fault,    ///< wrong for a map that is linear, green-up, of unit vectors, and repeats
    unknown,  ///< the map cannot tell; the reason says why
};

/// What one test found. Names, verdicts and names of numbers are fixed words for scripts.
struct Finding {
    std::string
        name;  ///< "kind", "stored", "length", "side", "zero", "green", "tilt", "seam", "fourth", "heights", ...
    Outcome outcome = Outcome::good;
    std::string verdict;  ///< "down", "sRGB"
    std::string reason;   ///< for people: what was measured, and what to do about it
    std::vector<std::pair<std::string, double>> numbers;
};

/// What is wrong at a texel; a texel can have several.
enum Mark : uint8_t {
    mark_not_finite = 1,
    mark_length = 2,    ///< not of unit length
    mark_side = 4,      ///< points into the surface
    mark_seam = 8,      ///< beside a border at which the map does not repeat
    mark_green = 16,    ///< green points the other way than in the rest of the map
    mark_heights = 32,  ///< far from the normal that the heights give
};

struct Inspection {
    std::vector<Finding> findings;
    std::vector<uint8_t> marks;  ///< of each texel, Mark values added up

    int faults() const;
    /// The finding of this name; null when that test did not apply.
    const Finding* find(const std::string& name) const&;
    const Finding* find(const std::string& name) const&& = delete;
};

/// Any map of 1 to 4 channels, with any values; `heights`, where they are given, are what the normals should be those
/// of. The tests that apply to what the map is, "kind" first. Takes some 30 bytes a texel.
Inspection inspect(const Image& map, const Image* heights = nullptr);

/// The map as a lit relief in grey, with its marks in the colours of mark_colors(). 8 bits, 3 channels.
Image picture_of_marks(const Image& map, const Inspection& inspection);

struct MarkColor {
    Mark mark;
    const char *color, *meaning;
    float red, green, blue;
};
/// In the order in which a texel with several marks takes its colour.
const std::vector<MarkColor>& mark_colors();

}  // namespace relief
