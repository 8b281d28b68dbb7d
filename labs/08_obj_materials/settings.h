// The knobs of lab 08. The table of lamps is in lights.h.
#pragma once

#include "framework/library/kit/light.h"
#include "framework/library/kit/obj_scene.h"
#include "lights.h"

namespace relief::materials {

struct Settings {
    enum View { garden, one, ground, levels, lamp_cut };
    static constexpr auto views =
        choices<View>({{garden, "garden"}, {one, "one"}, {ground, "ground"}, {levels, "levels"}, {lamp_cut, "lamp"}});
    enum File { garden_file, fence_file, ground_file, broken_file, thousand, lawn, own_file };
    static constexpr auto files = choices<File>({{garden_file, "garden"},
                                                 {fence_file, "fence"},
                                                 {ground_file, "ground"},
                                                 {broken_file, "broken"},
                                                 {thousand, "thousand"},
                                                 {lawn, "lawn"}});
    enum Maps { maps_on, maps_off, wipe, wipe_normals };
    static constexpr auto map_choices =
        choices<Maps>({{maps_on, "on"}, {maps_off, "off"}, {wipe, "wipe"}, {wipe_normals, "wipe-normals"}});
    enum ProgramKind { by_features, branches };
    static constexpr auto program_kinds =
        choices<ProgramKind>({{by_features, "compiled"}, {branches, "branches", "BRANCHES"}});
    enum Filter { nearest, mips, taps_2, taps_4, taps_8, taps_16, samples };
    static constexpr auto filters = choices<Filter>({{nearest, "nearest", "NEAREST_TEXEL"},
                                                     {mips, "mips", "MIP_LEVELS"},
                                                     {taps_2, "2", "TAPS 2"},
                                                     {taps_4, "4", "TAPS 4"},
                                                     {taps_8, "8", "TAPS 8"},
                                                     {taps_16, "16", "TAPS 16"},
                                                     {samples, "samples"}});
    enum Order { sorted, of_file, backwards, weighted };
    static constexpr auto orders = choices<Order>(
        {{sorted, "sorted"}, {of_file, "file"}, {backwards, "backwards"}, {weighted, "weighted", "WEIGHTED"}});
    enum BlendIn { light, stored };
    static constexpr auto blend_spaces = choices<BlendIn>({{light, "light"}, {stored, "stored", "STORED"}});
    enum Alpha { test, keep, to_coverage, hashed };
    static constexpr auto alphas = choices<Alpha>({{test, "test", "ALPHA_TEST"},
                                                   {keep, "keep", "ALPHA_KEEP"},
                                                   {to_coverage, "to-coverage", "ALPHA_TO_COVERAGE"},
                                                   {hashed, "hashed", "ALPHA_HASHED"}});

    int view = garden, file = garden_file, maps = maps_on, program_kind = by_features, filter = mips;
    int order = sorted, blend_in = light, alpha = to_coverage, lamp = spot_lamp;
    int highlight = 0;     ///< a surface that is shown alone in its light, from 1 on; 0: all
    MapSwitches switches;  ///< for Maps other than maps_off
    float threshold = 0.5f, fence = 1, range = 7, cone = 2, lamp_height = 1.45f;
    DistantLight distant{.yaw = 165, .pitch = 4};
    OwnObj own{{-0.6, 1, 0}, 1.4};  ///< in the middle of the picture

    bool is_wipe() const { return maps == wipe || maps == wipe_normals; }
    bool shows_notes() const { return file == ground_file || file == broken_file || file == lawn || file == own_file; }
    bool is_weighted() const { return order == weighted; }

    Lights lights() const {
        Lights lights{.lamp = Lamp(lamp),
                      .to_sun = distant.direction<double>(),
                      .axis = glm::normalize(glm::dvec3(-0.32, -1, -0.22)),
                      .range = double(range),
                      .cone = lamp == point_lamp ? 0 : double(cone)};
        lights.place.y = double(lamp_height);
        if (lamp == sun) {
            lights.sun = {1.0, 0.9, 0.74}, lights.sky = {0.26, 0.32, 0.42}, lights.ground = {0.10, 0.10, 0.07};
        } else {
            lights.sun = {0.34, 0.13, 0.05}, lights.sky = {0.075, 0.095, 0.175}, lights.ground = {0.032, 0.026, 0.028};
            lights.light = {15, 8, 2.8};
        }
        return lights;
    }

    void knobs(Knobs& knobs) {
        knobs.group("Picture");
        knobs.choice("view", view, views.names,
                     "the garden and its programs; or one picture, filters, mip levels, the lamp");
        knobs.choice_or_file("file", file, own, files.names, KnobHelp("the model").titled("Model file"));
        knobs.choice(
            "maps", maps, map_choices.names,
            KnobHelp("read the maps that materials name; with and without them side by side; or without normals only")
                .titled("Maps read"));
        knobs.toggle("normal_maps", switches.normals,
                     KnobHelp("read normals and heights").only("maps", {"on", "wipe", "wipe-normals"}));
        knobs.toggle("specular_maps", switches.highlights,
                     KnobHelp("read highlights").only("maps", {"on", "wipe", "wipe-normals"}));
        knobs.toggle("mask_maps", switches.masks, KnobHelp("read masks").only("maps", {"on", "wipe", "wipe-normals"}));
        knobs.choice("programs", program_kind, program_kinds.names,
                     "a program for each set of features, or one with branches");
        knobs.steps("highlight", highlight, 0, 12,
                    KnobHelp("show this material alone in its light; 0: all").titled("Highlight one"));
        knobs.choice("filter", filter, filters.names,
                     KnobHelp("how the colours of maps are read").titled("Colour filter"));
        knobs.group("Glass and masks");
        knobs.choice("order", order, orders.names,
                     KnobHelp("order of the surfaces; weighted: glass in any order, blended by weights")
                         .titled("Surface order"));
        knobs.choice("blend_in", blend_in, blend_spaces.names, "blend light, or the values that sRGB stores");
        knobs.choice("alpha", alpha, alphas.names, KnobHelp("what a mask does with a pixel").titled("Alpha masks"));
        knobs.slider("threshold", threshold, 0.05f, 0.95f, KnobHelp("what is above it stays").only("alpha", {"test"}));
        knobs.slider("fence", fence, 0.5f, 8, KnobHelp("tiles of wire to one of the file's").titled("Fence tiles"));
        knobs.group("Lantern");
        knobs.choice("lamp", lamp, lamps.names, "the lantern with its cone, without it, or daylight");
        knobs.slider("range", range, 0, 20, KnobHelp("how far the lantern reaches").in("metres").titled("Lamp range"));
        knobs.slider("cone", cone, 0, 64,
                     KnobHelp("exponent of the lantern's cone; 0 shines all around").titled("Lamp cone"));
        knobs.slider("lamp_height", lamp_height, 0, 3,
                     KnobHelp("height of the lantern's light above the ground").in("metres"));
        distant.knobs(knobs, -5, 90);
    }
};

}  // namespace relief::materials
