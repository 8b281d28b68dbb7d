#include "settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/core/image/asset.h"
#include "framework/core/image/color_profile.h"
#include "framework/core/image/mips.h"
#include "framework/library/maps/heights.h"
#include "framework/library/maps/resample.h"
#include "heights.h"

namespace relief::heights {

void Settings::knobs(Knobs& knobs) {
    knobs.group("Picture");
    knobs.choice("view", view, views.names, "every filter, or one of them");
    knobs.choice("filter", filter, filters.names, KnobHelp("the filter of the wall").only("view", {"one"}));
    knobs.choice("show", show, shows.names,
                 "the lit relief, the error compared with the exact slope, or half of each; or what else heights give: "
                 "how open a place is to the sky, how glossy by its normals' spread");
    knobs.group("Map");
    knobs.choice_or_file(
        "source", map.source, own, MapSettings::sources.names,
        KnobHelp("a known function, the bricks' height map, or the bricks' colours").titled("Height source"));
    knobs.choice("size", map.size_choice, MapSettings::sizes,
                 KnobHelp("texels along each side of the map (source waves)").titled("Map size"));
    knobs.choice("bits", map.bits_choice, MapSettings::bit_counts,
                 KnobHelp("bits per stored height (source waves)").titled("Bits per height"));
    knobs.slider("depth", map.depth, 0, 64, "depth of the relief: texels of a height of 1");
    knobs.slider("stretch", map.stretch, 0.25f, 4, "width of a texel divided by its height");
    knobs.toggle("wrap", map.wrap,
                 KnobHelp("continue the map at its other side; off: it ends at its border").titled("Wrap at border"));
    knobs.choice(
        "where", map.where, MapSettings::places.names,
        KnobHelp("the map is computed by a fragment shader, or by the framework on the CPU").titled("Where computed"));
    knobs.group("Strength of detail");
    knobs.slider("fine", map.fine, 0, 3, KnobHelp("strength of detail of one texel").titled("Fine detail"));
    knobs.slider("middle", map.middle, 0, 3, KnobHelp("strength of detail of two texels").titled("Middle detail"));
    knobs.slider("coarse", map.coarse, 0, 3, KnobHelp("strength of detail of four texels").titled("Coarse detail"));
    knobs.group("Wall and light");
    knobs.steps("repeat", repeat, 1, 4, "repeats of the map along each side of the wall: look for seams");
    knobs.slider("light_yaw", light_yaw, -180, 180, KnobHelp("direction of the light around the wall").in("degrees"));
    knobs.slider("light_height", light_height, -2, 2, KnobHelp("height of the light").in("metres"));
}

Image own_picture(const Image& picture, std::vector<std::string>& notes) {
    const auto fitting = [](const Image& image) {
        return resampled(image, MapSettings::picture_size, MapSettings::picture_size);
    };
    if (is_nearly_grey(picture)) {
        Heights found = heights_in(picture);
        notes = std::move(found.notes);
        return fitting(found.image);
    }
    Image colors = channels_of(picture, 0, 3);
    size_t beyond = 0;
    for (float& value : colors.values) {
        if (value >= 0 && value <= 1) continue;
        value = std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : 0, ++beyond;
    }
    if (beyond > 0) notes.push_back(fmt::format("{} values are beyond 0 and 1, or NaN: they are clamped", beyond));
    if (std::string note = profile_note(picture, false); !note.empty()) notes.push_back(std::move(note));
    return fitting(colors);
}

namespace {

/// Returns an asset at a quarter of its size.
Image asset(const char* file) {
    const Image whole = read_asset(file);
    Image small = mip_chain(whole, whole.channels == 3 ? ColorSpace::srgb : ColorSpace::linear).at(2);
    small.bits = 32;
    return small;
}

}  // namespace

Image Settings::color_picture() const {
    return map.source == MapSettings::own ? own.image() : asset("bricks_albedo.png");
}

Image Settings::stored_heights() const {
    Image heights = map.source == MapSettings::bricks ? asset("bricks_height.png")
                    : map.source == MapSettings::own  ? own.image()
                                                      : sample(map.size(), map.bits());
    heights.bits = 32;  // stored heights are rounded already; do not round the results
    return map.keeps_strengths() ? heights
                                 : with_level_strengths(heights, {map.fine, map.middle, map.coarse}, map.wrap, 0);
}

}  // namespace relief::heights
