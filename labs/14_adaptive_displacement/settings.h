// The knobs of lab 14. Each choice has one table: its values, their names, and their defines in the shaders.
#pragma once

#include <algorithm>
#include <cmath>

#include "framework/library/kit/choices.h"
#include "framework/library/kit/displaced_surface.h"
#include "framework/library/kit/light.h"

namespace relief::adaptive {

struct Settings {
    enum View { both, eye_only, above };
    static constexpr auto views = choices<View>({{both, "both"}, {eye_only, "eye"}, {above, "above"}});
    enum Method { uniform, by_distance, by_size, by_error };
    static constexpr auto methods = choices<Method>({{uniform, "uniform"},
                                                     {by_distance, "distance", "BY_DISTANCE"},
                                                     {by_size, "size", "BY_SIZE"},
                                                     {by_error, "error", "BY_ERROR"}});
    enum LevelsOf { edges, patches };
    static constexpr auto levels_ofs = choices<LevelsOf>({{edges, "edge"}, {patches, "patch", "LEVELS_OF_PATCH"}});
    enum Mip { mip_base, mip_of_patch };
    static constexpr auto mips = choices<Mip>({{mip_base, "base"}, {mip_of_patch, "patch", "MIP_OF_PATCH"}});
    enum Cull { cull_none, cull_outside, cull_all };
    static constexpr auto culls = choices<Cull>({{cull_none, "none"}, {cull_outside, "outside"}, {cull_all, "all"}});
    enum Shadow { no_shadow, shadow_of_all, shadow_of_drawn };
    static constexpr auto shadows =
        choices<Shadow>({{no_shadow, "none"}, {shadow_of_all, "all", "SHADOW"}, {shadow_of_drawn, "drawn", "SHADOW"}});

    enum LostSlopes { slopes_lost, leadr };
    static constexpr auto lost_slopes_choices = choices<LostSlopes>({{slopes_lost, "none"}, {leadr, "leadr", "LEADR"}});

    int view = both, method = by_error, levels_of = edges, spacing = 1, mip = mip_base, cull = cull_all,
        shadow = no_shadow, lost_slopes = slopes_lost;
    float level = 8, nearest = 1, farthest = 16, finest = 5, coarsest = 0, segment = 8, budget = 4;
    bool fade = false, wire = false;
    float fade_begin = 6, fade_end = 12, shininess = 24;
    DistantLight light{-60, 30};

    bool may_crack() const { return levels_of == patches || mip == mip_of_patch; }
    /// Returns the maximum level of an edge.
    float highest_level() const {
        return method == uniform       ? level
               : method == by_distance ? std::exp2(std::max(finest, coarsest))
                                       : DisplacedSurface::finest_level;
    }
    /// Return `nearest` and `farthest`, and the ends of the fade, each with the second above the first.
    glm::vec2 distances() const { return {nearest, std::max(farthest, nearest + 1e-3f)}; }
    glm::vec2 fade_range() const { return {fade_begin, std::max(fade_end, fade_begin + 1e-3f)}; }

    void knobs(Knobs& knobs) {
        knobs.group("Picture");
        knobs.choice("view", view, views.names, "the eye's picture, its patches from above, or both");
        knobs.toggle("wire", wire, KnobHelp("draw the triangles' edges").titled("Wireframe"));
        knobs.group("Levels");
        knobs.choice("method", method, methods.names, KnobHelp("rule for the levels").titled("Level method"));
        knobs.choice("levels_of", levels_of, levels_ofs.names,
                     KnobHelp("a level per edge, or per patch, which opens cracks").titled("Levels of"));
        knobs.slider("level", level, 1, 64,
                     KnobHelp("level of every edge").only("method", {"uniform"}).titled("Edge level"));
        knobs.slider("nearest", nearest, 0.1f, 32,
                     KnobHelp("where edges have the finest level")
                         .in("metres")
                         .only("method", {"distance"})
                         .titled("Nearest distance"));
        knobs.slider("farthest", farthest, 0.1f, 64,
                     KnobHelp("where edges have the coarsest level")
                         .in("metres")
                         .only("method", {"distance"})
                         .titled("Farthest distance"));
        knobs.slider(
            "finest", finest, 0, 6,
            KnobHelp("the finest level, an exponent of 2").only("method", {"distance"}).titled("Finest level"));
        knobs.slider(
            "coarsest", coarsest, 0, 6,
            KnobHelp("the coarsest level, an exponent of 2").only("method", {"distance"}).titled("Coarsest level"));
        knobs.slider("segment", segment, 1, 64,
                     KnobHelp("pixels per segment").only("method", {"size"}).titled("Segment length"));
        knobs.slider("budget", budget, 0.125f, 8,
                     KnobHelp("tolerated error").in("pixels").only("method", {"error"}).titled("Error budget"));
        knobs.choice("spacing", spacing, DisplacedSurface::spacings, "positions of the vertices at a fractional level");
        knobs.choice(
            "mip", mip, mips.names,
            KnobHelp("mip level that a vertex reads: the finest, or by its patch's own level, which opens cracks")
                .titled("Mip level"));
        knobs.group("Culling and fading");
        knobs.choice("cull", cull, culls.names,
                     KnobHelp("cull no patches, those outside of the picture, or also those that face away")
                         .titled("Cull patches"));
        knobs.toggle("fade", fade, KnobHelp("let the displacement fade into the normal map").titled("Fade relief"));
        knobs.slider("fade_begin", fade_begin, 0, 64,
                     KnobHelp("where the fade begins, metres from the eye").only("fade", {"on"}));
        knobs.slider("fade_end", fade_end, 0, 64,
                     KnobHelp("where the fade ends, metres from the eye").only("fade", {"on"}));
        light.knobs(knobs);
        knobs.slider("shininess", shininess, 1, 1000,
                     KnobHelp("exponent of the highlight").only("view", {"both", "eye"}));
        knobs.choice("lost_slopes", lost_slopes, lost_slopes_choices.names,
                     KnobHelp("what slopes smaller than a pixel do to the highlight: nothing, or LEADR: they widen it")
                         .only("view", {"both", "eye"}));
        knobs.choice("shadow", shadow, shadows.names,
                     "patches that cast a shadow on the surface: none, all, or only those that are not culled");
    }
};

}  // namespace relief::adaptive
