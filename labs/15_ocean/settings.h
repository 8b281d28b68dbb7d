// The knobs of lab 15. Each choice has one table: its values, their names, and their defines in the shaders.
#pragma once

#include "framework/library/kit/choices.h"
#include "framework/library/kit/light.h"
#include "water.h"

namespace relief::ocean {

struct Settings {
    enum View { halves, far_seas, one, four_maps };
    static constexpr auto views =
        choices<View>({{halves, "halves"}, {far_seas, "far"}, {one, "one"}, {four_maps, "maps"}});
    enum Combine { mean, slopes };
    static constexpr auto combines =
        choices<Combine>({{mean, "mean", "COMBINE MEAN"}, {slopes, "slopes", "COMBINE SLOPES"}});
    enum Source { maps, heights, analytic };
    static constexpr auto sources = choices<Source>(
        {{maps, "maps"}, {heights, "heights", "NORMALS_BY_HEIGHTS"}, {analytic, "analytic", "NORMALS_ANALYTIC"}});
    enum Far { plain, toksvig, lean, samples };
    static constexpr auto fars = choices<Far>({{plain, "plain"},
                                               {toksvig, "toksvig", "FAR_TOKSVIG"},
                                               {lean, "lean", "FAR_LEAN"},
                                               {samples, "samples", "FAR_SAMPLES"}});
    enum SampleCount { samples_64, samples_256, samples_1024 };
    static constexpr auto sample_counts = choices<SampleCount>(
        {{samples_64, "64", "SIDE 8"}, {samples_256, "256", "SIDE 16"}, {samples_1024, "1024", "SIDE 32"}});
    enum Fresnel { schlick, exact };
    static constexpr auto fresnels = choices<Fresnel>({{schlick, "schlick"}, {exact, "exact", "EXACT_FRESNEL"}});
    enum Material { water_itself, blue };
    static constexpr auto materials = choices<Material>({{water_itself, "water"}, {blue, "blue", "BLUE_MATERIAL"}});
    enum Sky { by_formula, by_cube };
    static constexpr auto skies = choices<Sky>({{by_formula, "formula"}, {by_cube, "cube", "SKY_CUBE"}});
    static constexpr std::array levels = {"mip", "0", "1", "2", "3", "4", "5", "6", "7", "8"};

    int view = halves, combine = slopes, source = maps, far = lean, sample_count = samples_1024, fresnel = schlick,
        level = 0, material = water_itself, sky = by_formula;
    float shininess = 512, budget = 3;
    bool lock = true, displace = true, wire = false;
    Water water;
    DistantLight light{.yaw = 0, .pitch = 7};

    void knobs(Knobs& knobs) {
        knobs.group("Picture");
        knobs.choice("view", view, views.names,
                     "two rules for the normal and their errors; four far seas; one picture; or the four maps");
        knobs.group("Normals");
        knobs.choice("combine", combine, combines.names,
                     KnobHelp("how the normals of two maps become one").only("view", {"one"}));
        knobs.choice("waves", water.maps, Water::choices_of_maps, "both maps, or one of them");
        knobs.choice("normals", source, sources.names,
                     "slopes out of normal maps, out of height maps, or by the formula");
        knobs.choice("far", far, fars.names,
                     KnobHelp("what the highlight knows of the waves within a pixel").titled("Far highlight"));
        knobs.choice("samples", sample_count, sample_counts.names,
                     KnobHelp("places within a pixel").only("far", {"samples"}));
        knobs.choice("fresnel", fresnel, fresnels.names,
                     "share of the mirrored light: Schlick's approximation, or exact");
        knobs.choice("material", material, materials.names, "water, or blue paint with the same mirrored sky");
        knobs.choice("sky", sky, skies.names, "the sky by a formula, or a cube map, whose sun stands still");
        knobs.group("Waves");
        knobs.slider("tiles_1", water.tiles[0], 0.02f, 8, "how often the first map lies on 16 metres");
        knobs.slider("tiles_2", water.tiles[1], 0.02f, 8, "how often the second map lies on 16 metres");
        knobs.slider("amplitude_1", water.amplitudes[0], 0, 4,
                     KnobHelp("significant wave height of the first map").in("metres"));
        knobs.slider("amplitude_2", water.amplitudes[1], 0, 4,
                     KnobHelp("significant wave height of the second map").in("metres"));
        knobs.slider(
            "wind", water.wind, 0, 20,
            KnobHelp("metres a second: scales both amplitudes by Cox and Munk's law; 0 does not").titled("Wind speed"));
        knobs.slider("shininess", shininess, 1, 4096, "exponent of the highlight of a single slope");
        knobs.toggle("lock", lock,
                     KnobHelp("normal maps lie as the height maps do; else they are tiled three times as often")
                         .titled("Lock the maps"));
        knobs.choice("level", level, levels, KnobHelp("mip level of the maps that a pixel reads").titled("Mip level"));
        knobs.group("Waves of your own");
        water.file_knobs(knobs);
        knobs.group("Raised waves");
        knobs.toggle("displace", displace, KnobHelp("raise the waves near the eye").titled("Displace waves"));
        knobs.slider("budget", budget, 0.25f, 16,
                     KnobHelp("error of the raised waves").in("pixels").titled("Error budget"));
        knobs.toggle("wire", wire, KnobHelp("draw the triangles' edges").titled("Wireframe"));
        light.knobs(knobs, -5, 90);
    }
};

}  // namespace relief::ocean
