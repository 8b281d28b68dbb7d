// The wall of lab 17: the errors of its maps, and which methods each of its patches needs.
#pragma once

#include <vector>

#include "framework/lab/lab.h"

namespace relief::budget {

enum Method { plain, normal_map, parallax, exact, displacement };  ///< as in task.glsl, from cheap to dear
constexpr int method_count = 5;
using Methods = unsigned;  ///< a bit for each
constexpr Methods bit(Method method) { return 1u << method; }
constexpr Methods any_of_a_pixel = bit(plain) | bit(normal_map) | bit(parallax) | bit(exact);

/// In the plane z = 0 and facing +z, metres; a tile of the maps is a metre wide. The relief lies behind it.
constexpr glm::dvec2 wall_low{-8, -4}, wall_high{248, 12};
constexpr double cell_metres = 0.25;  ///< a side of what the tessellator cuts, up to 64 times

/// Errors and ranges of the maps, independent of any frame.
class MapErrors {
public:
    MapErrors(const Image& heights, const Image& normals);

    glm::vec2 range{};          ///< the lowest and the highest height
    std::vector<float> levels;  ///< level_errors() of those that are better than the plane in the middle
    float flat_level = 0;       ///< of the normal map, from which on it is as good as flat
    glm::vec3 flat_normal{};    ///< the mean of its normals
    int texels = 1;             ///< of the height map, a metre
    int normal_texels = 1;

    /// piece_errors(), likewise; found when they are asked for first.
    const std::vector<float>& pieces() const;

private:
    Image heights_;
    mutable std::vector<float> pieces_;
};
constexpr size_t most_levels = 12;  ///< that shaders take, of levels and of pieces

/// What a frame allows and costs, the same for each of its patches.
struct FrameBudget {
    Frame frame;
    double pixels;               ///< the largest error allowed
    double scale;                ///< of the relief, metres
    double thinning, precision;  ///< shares of the budget: to thin the relief, and for what a method is off by
    double exact_taps;           ///< heights that a march reads in the time of an exact search
    double triangle_taps;        ///< and in that of a triangle
};

/// A piece of the wall.
struct Patch {
    glm::dvec2 low, high;
    Methods methods;      ///< that its pixels may choose, and more where that is not known; or displacement alone
    bool may_leave;       ///< a view ray may leave the wall behind it
    bool behind = false;  ///< rays come here from a displaced patch, so it is displaced, too, behind what it is else
};

/// The wall in pieces from its lower to its upper end; those that the picture does not show have no methods.
std::vector<Patch> patches_for(const FrameBudget& budget, const MapErrors& maps);

/// Neighbours with the same methods as one, without those that are not needed. Where two triangles meet, the renderer
/// draws blocks of pixels for both: twenty pieces in place of one cost a third of a grazing search.
std::vector<Patch> joined(const std::vector<Patch>& patches);

/// The level of the normal map whose texels are as wide as a pixel that shows a place a metre ahead, in the mean of
/// both directions; at `ahead` metres it is this + 1.5 log2(ahead), at least 0: a pixel covers ahead³ / (p² e) square
/// metres of a wall that is e metres from the eye, where p pixels are a metre wide a metre ahead.
double first_level(const FrameBudget& budget, const MapErrors& maps);

}  // namespace relief::budget
