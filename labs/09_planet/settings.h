// The knobs of lab 09. The tables of Levels and Cull are in patches.h, those of a map's recipe in globe.h.
#pragma once

#include <cmath>

#include "framework/library/kit/light.h"
#include "globe.h"

namespace relief::planet {

struct Settings {
    enum View { compare, planet, pole, patches, faces, mountains, frames };
    static constexpr auto views = choices<View>({{compare, "compare"},
                                                 {planet, "planet"},
                                                 {pole, "pole"},
                                                 {patches, "patches"},
                                                 {faces, "faces"},
                                                 {mountains, "mountains"},
                                                 {frames, "frames"}});
    enum SlopesFrom { by_map, by_formula };
    static constexpr auto slope_sources = choices<SlopesFrom>({{by_map, "map"}, {by_formula, "formula"}});
    enum LitBy { lit_by_map, lit_by_vertices, lit_by_bumps };
    static constexpr auto normal_sources = choices<LitBy>(
        {{lit_by_map, "map"}, {lit_by_vertices, "vertices", "VERTEX_NORMALS"}, {lit_by_bumps, "bumps", "BUMPS"}});
    enum EyeAt { at_camera, on_ground };
    static constexpr auto eyes = choices<EyeAt>({{at_camera, "camera"}, {on_ground, "ground"}});
    enum Precision { camera_relative, single };
    static constexpr auto precisions = choices<Precision>({{camera_relative, "camera-relative"}, {single, "float"}});
    enum Depth { logarithm, usual };
    static constexpr auto depths = choices<Depth>({{logarithm, "logarithm", "LOG_DEPTH"}, {usual, "usual"}});
    static constexpr std::array quad_counts = {"8", "16", "32"};                  // 8 << quads
    static constexpr std::array texel_counts = {"16", "32", "64", "128", "256"};  // 16 << texels

    int view = compare, mapping = int(SphereMapping::equal_angle), normals = int(Normals::metric), slopes_from = by_map,
        lit_by = lit_by_map, strength = int(Strength::doubling);
    int levels = int(Levels::error), level = 0, quads = 1, texels = 3, cull = int(Cull::horizon);
    int eye = at_camera, precise = camera_relative, depth = logarithm, detail = 4, seed = 3;
    float budget = 1.5f, altitude = -2, longitude = 0, latitude = 20, heading = 0, tilt = -10, radius = 6.804f,
          height = 1;
    bool gutter = true, skirts = true;
    DistantLight sun{.yaw = -52, .pitch = 16};

    Shape shape() const { return {{seed, detail, height}, SphereMapping(mapping), 8 << quads}; }
    double radius_metres() const { return std::pow(10.0, double(radius)); }

    void knobs(Knobs& knobs) {
        knobs.group("Picture");
        knobs.choice("view", view, views.names,
                     "the planet, its pole and its patches; one of them; mountains by the map and by their vertices; "
                     "the grid's frames where patches meet; or the faces spread out");
        knobs.group("Grid and normals");
        knobs.choice("mapping", mapping, mappings.names,
                     "where the grid lies: equal angles, the cube, latitude and longitude");
        knobs.choice("normals", normals, normal_rules.names, "normals by the metric, or by what is commonly written");
        knobs.choice("slopes_from", slopes_from, slope_sources.names,
                     KnobHelp("slopes by a filter in the map, or from the heights' formula").only("view", {"faces"}));
        knobs.choice("lit_by", lit_by, normal_sources.names,
                     "normals of the map, those at the vertices, interpolated, or the map's with bricks on each face");
        knobs.toggle(
            "gutter", gutter,
            KnobHelp("maps go on beyond the border of their patch, or repeat its last texel").titled("Gutter of maps"));
        knobs.choice("strength", strength, strengths.names, "by what a level multiplies its slopes");
        knobs.group("Patches");
        knobs.choice("levels", levels, level_rules.names,
                     KnobHelp("all patches alike, by distance, or by their error on the screen").titled("Levels by"));
        knobs.steps("level", level, 0, 5, "for levels = uniform, and of the faces: level of every patch");
        knobs.slider("budget", budget, 0.25f, 16, KnobHelp("tolerated error").in("pixels").titled("Error budget"));
        knobs.choice("quads", quads, quad_counts, KnobHelp("quads along a patch's side").titled("Quads per side"));
        knobs.choice("texels", texels, texel_counts, KnobHelp("texels along a patch's side").titled("Texels per side"));
        knobs.toggle("skirts", skirts, "borders reach down, so that no gap opens between two levels");
        knobs.choice(
            "cull", cull, culls.names,
            KnobHelp("leave out no patches, those outside of the picture, or also hidden ones").titled("Cull patches"));
        knobs.group("Eye");
        knobs.choice("eye", eye, eyes.names, "the camera, or above a place on the ground");
        knobs.slider("altitude", altitude, -6, 1,
                     KnobHelp("height above it, as a power of 10 of the radius").only("eye", {"ground"}));
        knobs.slider("longitude", longitude, -180, 180,
                     KnobHelp("longitude of the place").in("degrees").only("eye", {"ground"}));
        knobs.slider("latitude", latitude, -90, 90,
                     KnobHelp("latitude of the place").in("degrees").only("eye", {"ground"}));
        knobs.slider("heading", heading, -180, 180,
                     KnobHelp("direction from north to the right").in("degrees").only("eye", {"ground"}));
        knobs.slider("tilt", tilt, -90, 90,
                     KnobHelp("elevation of the view").in("degrees").only("eye", {"ground"}).titled("View tilt"));
        knobs.group("Planet");
        knobs.slider("radius", radius, 0, 7, "radius of the planet, as a power of 10 in metres; 6.804 is the Earth");
        knobs.choice("precise", precise, precisions.names,
                     KnobHelp("subtract the eye before rounding to float, or after").titled("Precise by"));
        knobs.choice("depth", depth, depths.names,
                     KnobHelp("depth by a logarithm, or as usual").titled("Depth buffer"));
        knobs.slider("height", height, 0, 2, KnobHelp("height of mountains and craters").titled("Mountain height"));
        knobs.steps("detail", detail, 0, 5, KnobHelp("octaves of the mountains' ridges").titled("Detail octaves"));
        knobs.steps("seed", seed, 0, 99, "another planet");
        sun.knobs(knobs);
    }
};

}  // namespace relief::planet
