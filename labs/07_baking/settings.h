// The knobs of lab 07. The tables of shapes and meshes are in models.h, the tables of a bake in baker.h.
#pragma once

#include "baker.h"
#include "framework/library/kit/light.h"

namespace relief::baking {

struct Settings {
    enum View { compare, cube, rays, map, one };
    static constexpr auto views =
        choices<View>({{compare, "compare"}, {cube, "cube"}, {rays, "rays"}, {map, "map"}, {one, "one"}});
    enum Wears { baked_map, no_map, fine_model, map_of_file };
    static constexpr auto wears_choices =
        choices<Wears>({{baked_map, "map"}, {no_map, "nothing"}, {fine_model, "high"}, {map_of_file, "file"}});
    enum Fine { itself, fine_file };
    static constexpr auto fines = choices<Fine>({{itself, "itself"}});
    enum Space { tangent, object };
    static constexpr auto spaces = choices<Space>({{tangent, "tangent"}, {object, "object"}});
    enum Diagonal { same, other };
    static constexpr auto diagonals = choices<Diagonal>({{same, "same"}, {other, "other"}});
    enum RaysAlong { smooth, face };
    static constexpr auto ray_normals = choices<RaysAlong>({{smooth, "smooth"}, {face, "face"}});
    enum Islands { apart, overlapping };
    static constexpr auto island_choices = choices<Islands>({{apart, "apart"}, {overlapping, "overlapping"}});
    static constexpr auto bit_counts = names_of(formats);
    static constexpr auto low_names = names_of(low_finenesses), high_names = names_of(high_finenesses);
    static constexpr std::array sizes = {"64", "128", "256", "512", "1024"};     // 64 << size
    static constexpr std::array levels = {"mip", "0", "1", "2", "3", "4", "5"};  // level - 1

    int view = compare, shape = int(Shape::ammonite), fine = itself, wears = baked_map, space = tangent;
    int bake_frame = interpolated, frame = interpolated, diagonal = same, rays_along = smooth;
    int take = int(Take::nearest), islands = apart, size = 2, bits = 1, padding = 8, level = 0, low = 1, high = 0;
    float reach = 0.42f, gap = 0.12f, cut = 0.62f;
    bool cord = false;
    Sculpt sculpt;
    DistantLight light{.yaw = -75, .pitch = 30};
    OwnModels own;

    bool is_own() const { return Shape(shape) == Shape::own; }
    bool has_file_map() const { return is_own() && !own.coarse.normal_maps().empty(); }

    size_t low_triangles() const {
        return is_own() ? own.coarse.mesh().indices.size() / 3 : low_finenesses[size_t(low)].triangles(whorls);
    }
    size_t high_triangles() const {
        if (!is_own()) return high_finenesses[size_t(high)].triangles();
        return (fine == fine_file ? own.fine : own.coarse).mesh().indices.size() / 3;
    }

    /// Returns the inputs of a bake of a shape. A knob without effect on the shape has a constant value there, so that
    /// it causes no bake.
    Recipe recipe(Shape of) const {
        Recipe recipe{.model = {of, 0},
                      .high = 0,
                      .low = 0,
                      .object_space = space == object,
                      .rays_of_face = rays_along == face,
                      .frame = bake_frame,
                      .take = take,
                      .reach = reach,
                      .size = 64 << size,
                      .bits = bits,
                      .padding = padding};
        if (recipe.is_ammonite()) {
            recipe.model.gap = gap, recipe.high = high, recipe.low = low, recipe.cord = cord;
            recipe.overlapping = islands == overlapping, recipe.sculpt = sculpt;
        }
        if (of == Shape::own) {
            recipe.own = &own, recipe.has_fine = fine == fine_file;
            recipe.version = own.coarse.version() + own.fine.version();
        }
        return recipe;
    }
    Recipe recipe() const { return recipe(Shape(shape)); }

    void knobs(Knobs& knobs) {
        knobs.group("Picture");
        knobs.choice("view", view, views.names,
                     "all models, the cube or a file by every frame, a cut with its rays, the map, or one model");
        knobs.choice_or_file("shape", shape, own.coarse, shapes.names,
                             KnobHelp("the model: an ammonite, one in a mirror, or a cube").titled("Model"));
        knobs.choice_or_file("fine", fine, own.fine, fines.names,
                             KnobHelp("the fine model of a file: the file itself").titled("Fine model"));
        knobs.choice("wears", wears, wears_choices.names,
                     KnobHelp("the coarse model with its map, without, the fine one, or the map in its file")
                         .only("view", {"one"})
                         .titled("Model wears"));
        knobs.slider("cut", cut, 0, 1,
                     KnobHelp("where the cut is").in("turns").only("view", {"rays"}).titled("Cut at"));
        knobs.group("Bake");
        knobs.choice("map", space, spaces.names, KnobHelp("space of the map's normals").titled("Map space"));
        knobs.choice("bake_frame", bake_frame, std::span(frames.names).first(bake_frames),
                     "frame in which the bake stores a normal");
        knobs.choice("frame", frame, frames.names, "frame in which the renderer reads it");
        knobs.choice("diagonal", diagonal, diagonals.names,
                     KnobHelp("the renderer cuts quads as the bake did, or the other way").titled("Quad diagonal"));
        knobs.choice("rays", rays_along, ray_normals.names,
                     "direction of a ray: the interpolated normal, or the face's");
        knobs.choice("take", take, takes.names,
                     KnobHelp("which hit counts: the nearest to the coarse model, the first, or the last")
                         .titled("Hit to take"));
        knobs.slider("reach", reach, 0, 0.6f,
                     KnobHelp("distance of the cage, in radii of the tube").titled("Reach of cage"));
        knobs.group("Shell");
        knobs.slider("gap", gap, 0, 0.4f,
                     KnobHelp("free space between the whorls, in radii of the tube").titled("Gap of whorls"));
        knobs.toggle("cord", cord, "a cord that winds above the last whorl without touching it");
        knobs.group("Sculpting the fine model");
        knobs.slider("ribs", sculpt.ribs, 0, 2, "height of the shell's ribs: a factor");
        knobs.slider("bulge", sculpt.bulge, -0.3f, 0.3f, "height of a bulge on the last whorl, in radii of the tube");
        knobs.slider("dents", sculpt.dents, 0, 0.2f, "depth of rows of dents, in radii of the tube");
        knobs.group("Map");
        knobs.choice("islands", islands, island_choices.names,
                     "strips of the map side by side, or two of them in one place");
        knobs.choice("map_size", size, sizes, KnobHelp("side of the map").in("texels"));
        knobs.choice("bits", bits, bit_counts, KnobHelp("bits of each channel of the map").titled("Bits per channel"));
        knobs.steps("padding", padding, 0, 16, "texels by which the map goes on around its islands");
        knobs.choice("level", level, levels, KnobHelp("mip level of the map that is read").titled("Mip level"));
        knobs.group("Models");
        knobs.choice("low", low, low_names, KnobHelp("triangles of the coarse model").titled("Low: triangles"));
        knobs.choice("high", high, high_names, KnobHelp("triangles of the fine model").titled("High: triangles"));
        light.knobs(knobs);
    }
};

}  // namespace relief::baking
