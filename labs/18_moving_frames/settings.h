// The knobs of lab 18. Each choice has one table: its values, their names, and their defines in the shaders.
#pragma once

#include "framework/library/kit/choices.h"
#include "framework/library/kit/light.h"
#include "skin.h"

namespace relief::moving_frames {

struct Settings {
    enum View { the_flock, four_ways, unrolled_skin, one_body };
    static constexpr auto views =
        choices<View>({{the_flock, "flock"}, {four_ways, "four"}, {unrolled_skin, "skin"}, {one_body, "one"}});
    enum Shape { tube_shape, serpent_shape };
    static constexpr auto shapes = choices<Shape>({{tube_shape, "tube"}, {serpent_shape, "serpent", "SERPENT"}});
    enum Way { matrix, inverse_transpose, unit_cofactors, gradient };
    static constexpr auto ways = choices<Way>({{matrix, "matrix"},
                                               {inverse_transpose, "inverse-transpose", "INVERSE_TRANSPOSE"},
                                               {unit_cofactors, "unit-cofactors", "UNIT_COFACTORS"},
                                               {gradient, "gradient", "GRADIENT"}});
    enum Blend { linear, dual_quaternion };
    static constexpr auto blends = choices<Blend>({{linear, "linear"}, {dual_quaternion, "dual-quaternion", "DUAL"}});
    enum Sum { even, not_even };
    static constexpr auto sums = choices<Sum>({{even, "even"}, {not_even, "uneven", "UNEVEN"}});
    enum Signs { alike, opposite };
    static constexpr auto signs_of = choices<Signs>({{alike, "alike"}, {opposite, "opposite"}});
    static constexpr std::array triangle_counts = {"288", "3072", "6144", "12288"};  // of `finenesses`
    static constexpr std::array<Fineness, 4> finenesses = {{{24, 6}, {96, 16}, {128, 24}, {192, 32}}};

    int view = the_flock, shape = serpent_shape, way = gradient, blend = linear, weights = even, signs = alike;
    int instances = 50, triangles = 2, flock_triangles = 0, material = 0;
    float bend = 90, twist = 0, stretch = 1, over = 4, scale_y = 1, instance_turn = 0, instance_scale = 1,
          material_turn = 0, material_scale = 1, relief = 1;
    bool folds = false, textured = true;
    DistantLight light{.yaw = 35, .pitch = 24};

    const Body& body() const { return shape == serpent_shape ? serpent : tube; }
    const Fineness& fineness() const { return finenesses[size_t(triangles)]; }
    const Fineness& flock_fineness() const { return finenesses[size_t(flock_triangles)]; }
    Pose pose() const {
        return {.bend = double(bend),
                .twist = double(twist),
                .stretch = double(stretch),
                .over = double(over),
                .dual = blend == dual_quaternion,
                .uneven = weights == not_even,
                .opposite = signs == opposite};
    }

    void knobs(Knobs& knobs) {
        knobs.group("Picture");
        knobs.choice("view", view, views.names,
                     "a serpent and its flock; four normals of a bent tube; one skin unrolled, and its errors; or one "
                     "body");
        knobs.choice("shape", shape, shapes.names, "a tube with one joint, or a serpent with thirteen");
        knobs.group("Skin");
        knobs.choice("normal_by", way, ways.names, "how the skin moves its normals");
        knobs.choice("blend", blend, blends.names,
                     "bones blended as matrices, or as dual quaternions (which do not stretch)");
        knobs.slider("bend", bend, 0, 150,
                     "bend of the tube's joint, degrees; a serpent's joints take a third at most");
        knobs.slider("twist", twist, -180, 180, "twist of the tube's joint, degrees; a sixth for each of a serpent's");
        knobs.slider("stretch", stretch, 0, 2,
                     "stretch of a bone along itself: the tube's second, the serpent's middle one");
        knobs.slider("weights_over", over, 0, 6, KnobHelp("length of a joint, over which weights change").in("radii"));
        knobs.choice("weights", weights, sums.names, "weights that sum to 1, or do not");
        knobs.choice("signs", signs, signs_of.names,
                     KnobHelp("dual quaternions of neighbours alike, or opposite (the same motions)")
                         .titled("Quaternion signs"));
        knobs.toggle("folds", folds, KnobHelp("paint blue where the skin folds over itself").titled("Paint folds"));
        knobs.group("Bodies");
        knobs.steps("instances", instances, 1, most_instances, "bodies, the first one included");
        knobs.choice("triangles", triangles, triangle_counts, "triangles of the first body");
        knobs.choice("flock_triangles", flock_triangles, triangle_counts, "triangles of each other body");
        knobs.slider("scale_y", scale_y, -2, 2, "scale of the first body along y; below 0 it is mirrored");
        knobs.group("Texture");
        knobs.toggle("textured", textured,
                     "place the texture by instance and material; else by the body's own u and v");
        knobs.slider("instance_turn", instance_turn, -180, 180,
                     KnobHelp("turn of the first instance's texture").in("degrees"));
        knobs.slider("instance_scale", instance_scale, -4, 4, "scale of the first instance's texture along u");
        knobs.slider("material_turn", material_turn, -180, 180,
                     KnobHelp("turn of the materials' textures").in("degrees"));
        knobs.slider("material_scale", material_scale, 0, 4, "scale of the materials' textures");
        knobs.steps("material", material, 0, material_count - 1, "material of the first body");
        knobs.slider("relief", relief, 0, 2,
                     KnobHelp("strength of the scales; 0 is smooth").titled("Relief of scales"));
        light.knobs(knobs);
    }
};

}  // namespace relief::moving_frames
