// The wall of lab 17: the errors of its maps, and the methods that each of its patches needs.
#pragma once

#include <compare>
#include <map>
#include <vector>

#include "framework/core/lab/lab.h"

namespace relief::budget {

enum Method { plain, normal_map, parallax, exact, displacement };  ///< as in task.glsl, the cheapest first
constexpr int method_count = 5;
using Methods = unsigned;  ///< a bit for each method
constexpr Methods bit(Method method) { return 1u << method; }
constexpr Methods any_of_a_pixel = bit(plain) | bit(normal_map) | bit(parallax) | bit(exact);

/// Corners of the wall in metres. It lies in the plane z = 0 and faces +z, with the relief behind it. A tile of the
/// maps is a metre wide.
constexpr glm::dvec2 wall_low{-8, -4}, wall_high{248, 12};
constexpr double cell_metres = 0.25;  ///< side of a cell, which the tessellator cuts into up to 64 x 64

/// Errors and ranges of the maps, independent of any frame.
class MapErrors {
public:
    MapErrors(const Image& heights, const Image& normals);

    glm::vec2 range{};          ///< the lowest and the highest height
    std::vector<float> levels;  ///< level_errors(), up to the last level that is better than a plane in the middle
    float flat_level = 0;       ///< of the normal map: all coarser levels are nearly flat, too
    glm::vec3 flat_normal{};    ///< the mean normal of the map
    int texels = 1;             ///< of the height map, per metre
    int normal_texels = 1;

    /// Returns piece_errors(), up to the last piece that is better than a plane in the middle. Computed at the first
    /// call.
    const std::vector<float>& pieces() const;

private:
    Image heights_;
    mutable std::vector<float> pieces_;
};
constexpr size_t most_levels = 12;  ///< capacity of the shaders, for levels and for pieces

/// The error and the costs that a frame allows, the same for all patches.
struct FrameBudget {
    Frame frame;
    double pixels;               ///< the largest error allowed
    double scale;                ///< of the relief, metres
    double thinning, precision;  ///< shares of the budget: for thinning the relief; for the error of a method
    double exact_taps;           ///< heights that a march reads in the time of an exact search
    double triangle_taps;        ///< heights that a march reads in the time of a triangle
};

/// A rectangle of the wall.
struct Patch {
    glm::dvec2 low, high;
    Methods methods;  ///< all methods that its pixels may choose, maybe more; or displacement alone
    bool may_leave;   ///< a view ray that enters here may leave the wall at its border
    /// Also tessellated, besides being drawn by its methods: rays may enter from a displaced neighbour.
    bool behind = false;
};

/// Returns the patches of the whole wall, by rising x. Each reaches from the lower to the upper border. A patch outside
/// of the picture has no methods. Returns no patches if the eye is not in front of the wall.
std::vector<Patch> patches_for(const FrameBudget& budget, const MapErrors& maps);

/// Maximum number of triangles of a picture.
constexpr double most_triangles = 6e6;
/// Returns the distance from the eye up to which displaced cells get the level that the budget asks for, at most 64.
/// Farther cells get a level that falls with distance, so that all cells together have at most most_triangles. Infinity
/// if no cell has to be coarser. `cells` has the four corners of each cell, the lower left one first.
double finest_reach(const FrameBudget& budget, const MapErrors& maps, const std::vector<glm::vec2>& cells);

/// Returns the patches that are drawn, with neighbours merged if they have the same methods. This saves time: along an
/// edge the renderer shades blocks of pixels for both triangles. With twenty pieces in place of one a grazing search
/// takes a third longer.
std::vector<Patch> joined(const std::vector<Patch>& patches);

/// The key of a program: its methods, and whether view rays may leave the wall.
struct Group {
    Methods methods;
    bool may_leave;
    auto operator<=>(const Group&) const = default;
};
/// Returns the corners that each program draws: three for a triangle, or four for a displaced cell. `with_behind`:
/// patches with `behind` are also drawn as cells.
std::map<Group, std::vector<glm::vec2>> groups_of(const std::vector<Patch>& patches, bool with_behind);

/// Returns the level of the normal map whose texels have the area of a pixel that shows a place one metre ahead. It may
/// be negative. At `ahead` metres the level is this + 1.5 log2(ahead), clamped to at least 0. Derivation: let the eye
/// be e metres from the wall, and let a metre be p pixels wide at one metre ahead. Then a pixel covers ahead³ / (p² e)
/// square metres of the wall.
double first_level(const FrameBudget& budget, const MapErrors& maps);

}  // namespace relief::budget
