#include "framework/library/maps/normals.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/core/base/error.h"
#include "framework/core/image/color_profile.h"
#include "framework/library/maps/own_picture.h"

namespace relief {

Image normals_in(const Image& picture, std::vector<std::string>& notes) {
    if (picture.channels < 3) throw Error("is grey: a normal map has three channels");
    Image normals = channels_of(picture, 0, 3);
    const auto is_finite = [](const float* texel) {
        return std::isfinite(texel[0]) && std::isfinite(texel[1]) && std::isfinite(texel[2]);
    };
    size_t not_finite = 0, beyond = 0;
    double sideways = 0;
    for (size_t i = 0; i < normals.values.size(); i += 3) {
        float* const texel = &normals.values[i];
        if (!is_finite(texel)) {
            texel[0] = texel[1] = 0.5f, texel[2] = 1, ++not_finite;
            continue;
        }
        const auto [low, high] = std::minmax({texel[0], texel[1], texel[2]});
        constexpr float rounding = 1e-3f;
        beyond += low < -rounding || high > 1 + rounding;
        sideways += double(texel[0]) + double(texel[1]);
    }
    const auto texels_hold = [](size_t count) {
        return count == 1 ? "1 texel holds" : fmt::format("{} texels hold", count);
    };
    // x and y of many normals have a mean near 0, which is stored as 0.5.
    const bool is_signed = beyond > 0 && std::abs(sideways) < 0.5 * double(normals.pixel_count() - not_finite);
    if (is_signed)
        for (size_t i = 0; i < normals.values.size(); ++i)
            if (is_finite(picture.values.data() + i / 3 * size_t(picture.channels)))
                normals.values[i] = 0.5f * normals.values[i] + 0.5f;
    if (is_signed)
        notes.push_back("its values are normals from -1 to 1, not colours from 0 to 1");
    else if (beyond > 0)
        notes.push_back(fmt::format("{} values beyond 0 and 1: these are no normals", texels_hold(beyond)));
    if (not_finite > 0) notes.push_back(fmt::format("{} NaN or infinity: read as flat", texels_hold(not_finite)));
    const auto differs = [&picture, i = size_t{0}](float value) mutable {
        return i++ % size_t(picture.channels) == 3 && value != picture.values[3];
    };
    if (picture.channels == 4 && std::any_of(picture.values.begin(), picture.values.end(), differs))
        notes.push_back("its fourth channel is not read");
    if (std::string note = profile_note(picture, true); !note.empty()) notes.push_back(std::move(note));
    return normals;
}

}  // namespace relief
