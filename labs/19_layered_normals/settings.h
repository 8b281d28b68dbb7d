// The knobs of lab 19. Each choice has one table: its values, their names, and their defines in the shaders.
#pragma once

#include "framework/core/lab/lab.h"
#include "framework/library/kit/choices.h"
#include "framework/library/kit/light.h"

namespace relief::layered_normals {

struct Settings {
    enum View { wall, six_blends, solid, six_mappings, far_walls };
    static constexpr auto views = choices<View>(
        {{wall, "wall"}, {six_blends, "blends"}, {solid, "solid"}, {six_mappings, "mappings"}, {far_walls, "far"}});
    enum Blend { linear, overlay, whiteout, udn, pd, rnm, swizzle };
    static constexpr auto blends = choices<Blend>({{linear, "linear", "BLEND_LINEAR"},
                                                   {overlay, "overlay", "BLEND_OVERLAY"},
                                                   {whiteout, "whiteout", "BLEND_WHITEOUT"},
                                                   {udn, "udn", "BLEND_UDN"},
                                                   {pd, "pd"},
                                                   {rnm, "rnm", "BLEND_RNM"},
                                                   {swizzle, "swizzle", "BLEND_SWIZZLE"}});
    enum Question { heights_add, along_normal, in_frame, shortest_arc };
    static constexpr auto questions = choices<Question>({{heights_add, "heights-add"},
                                                         {along_normal, "along-normal", "ALONG_NORMAL"},
                                                         {in_frame, "in-frame", "IN_FRAME"},
                                                         {shortest_arc, "shortest-arc", "SHORTEST_ARC"}});
    enum Mapping { one_plane, three_udn, three_whiteout, three_rnm, gradient, exact };
    static constexpr auto mappings = choices<Mapping>({{one_plane, "one-plane", "ONE_PLANE"},
                                                       {three_udn, "udn", "UDN"},
                                                       {three_whiteout, "whiteout", "WHITEOUT"},
                                                       {three_rnm, "rnm", "RNM"},
                                                       {gradient, "gradient", "GRADIENT"},
                                                       {exact, "exact"}});
    enum Filter { plain, derivatives, toksvig, lean, samples };
    static constexpr auto filters = choices<Filter>({{plain, "plain"},
                                                     {derivatives, "derivatives", "FILTER_DERIVATIVES"},
                                                     {toksvig, "toksvig", "FILTER_TOKSVIG"},
                                                     {lean, "lean", "FILTER_LEAN"},
                                                     {samples, "samples", "FILTER_SAMPLES"}});
    enum Brdf { blinn_phong, ggx };
    static constexpr auto brdfs = choices<Brdf>({{blinn_phong, "blinn-phong"}, {ggx, "ggx", "GGX"}});
    enum Shape { sphere, rock, cube };
    static constexpr auto shapes = choices<Shape>({{sphere, "sphere"}, {rock, "rock", "ROCK"}, {cube, "cube", "CUBE"}});

    int view = wall, blend = pd, question = heights_add, mapping = exact, filter = lean, brdf = blinn_phong,
        shape = rock;
    float stones = 1, grain = 0.8f, fade = 30, tiles = 5, sharpness = 4, shininess = 400;
    DistantLight light{.yaw = -62, .pitch = 26};

    /// Returns whether a solid is shown, not the wall: in its views, and for a probe that only one of them has.
    bool shows_solid(const Probe& probe) const {
        if (probe.name == "weights" || probe.name == "planes" || probe.name == "gradient") return true;
        if (probe.name == "detail" || probe.name == "variance" || probe.name == "highlight") return false;
        return view == solid || view == six_mappings;
    }

    /// Returns one over the variance of the slopes of a texel. GGX has alpha² = 2 / (shininess + 2), which counts as
    /// twice a variance.
    double precision() const { return double(shininess) + (brdf == ggx ? 2 : 0); }

    /// Returns the strengths of stones and grain. A far wall is worn, or its highlight would cover the whole of it.
    glm::vec2 strengths() const { return glm::vec2(stones, grain) * (view == far_walls ? 0.3f : 1.0f); }
    /// Returns the distance where the grain is gone. On a far wall it never is.
    float fade_end() const { return view == far_walls ? 1e6f : fade; }

    /// Returns the frame with the camera of the view: farther away from a solid, on its bright side; and 12 times as
    /// far from a far wall, near the place that the light is mirrored to.
    Frame seen(const Frame& frame) const {
        Frame moved = frame;
        Orbit orbit = frame.camera.orbit();
        if (shows_solid(frame.probe))
            orbit.distance *= 1.5, orbit.yaw -= 25;
        else if (view == far_walls)
            orbit.distance *= 12, orbit.yaw += 22, orbit.pitch -= 24;
        moved.camera = Camera(orbit, double(frame.size.x) / std::max(1, frame.size.y));
        return moved;
    }

    void knobs(Knobs& knobs) {
        knobs.group("Picture");
        knobs.choice(
            "view", view, views.names,
            "a wall; six blends and their errors; a solid; six mappings and their errors; five filters of a far, "
            "worn wall");
        knobs.group("Layers");
        knobs.choice("blend", blend, blends.names,
                     KnobHelp("how the normals of stones and grain become one").only("view", {"wall"}));
        knobs.choice(
            "question", question, questions.names,
            "what is exact: the sum of heights; grain displaced along the stones' normal; grain in the stones' "
            "frame, or rotated with their normal");
        knobs.slider("stones", stones, 0, 4,
                     KnobHelp("strength of the stones; at 1 their steepest slope is 1.4")
                         .only("view", {"wall", "blends", "far"}));
        knobs.slider("grain", grain, 0, 4, "strength of the grain; 0 does not read it");
        knobs.slider("fade", fade, 0.1f, 1000,
                     KnobHelp("where the grain is gone; it fades from half of it on")
                         .in("metres")
                         .only("view", {"wall", "blends"})
                         .titled("Fade of grain"));
        knobs.slider(
            "tiles", tiles, 1, 16,
            KnobHelp("tiles of the grain on one of the stones, or on two metres of a solid").titled("Tiles of grain"));
        knobs.group("Solids");
        knobs.choice("shape", shape, shapes.names,
                     KnobHelp("a sphere, a rock, or a cube").only("view", {"solid", "mappings"}));
        knobs.choice("mapping", mapping, mappings.names,
                     KnobHelp("how three planes become one normal").only("view", {"solid"}));
        knobs.slider("sharpness", sharpness, 1, 64,
                     KnobHelp("power of the planes' weights").only("view", {"solid", "mappings"}));
        knobs.group("Highlight");
        knobs.choice("filter", filter, filters.names,
                     KnobHelp("what a highlight knows of the slopes within a pixel").only("view", {"wall"}));
        knobs.choice(
            "brdf", brdf, brdfs.names,
            KnobHelp("the highlight of a texel: Blinn-Phong as a Gaussian of slopes, or GGX with its long tail")
                .only("view", {"wall", "blends", "far"})
                .titled("BRDF"));
        knobs.slider(
            "shininess", shininess, 1, 4096,
            KnobHelp("one over the variance of the slopes of a texel").only("view", {"wall", "blends", "far"}));
        light.knobs(knobs);
    }
};

}  // namespace relief::layered_normals
