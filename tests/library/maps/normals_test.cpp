// Normal maps of the user: which values are normals, and what the notes say.
#include "framework/library/maps/normals.h"

#include <gtest/gtest.h>

#include <cmath>

#include "framework/core/base/error.h"
#include "tests/support.h"

namespace relief {
namespace {

using NoteLines = std::vector<std::string>;

/// Normals of a dome, from -1 to 1.
Image dome(int channels) {
    Image image(8, 8, channels);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
            const float slope_x = float(2 * x - 7) / 10, slope_y = float(7 - 2 * y) / 10;
            const float length = std::sqrt(slope_x * slope_x + slope_y * slope_y + 1);
            float* const texel = image.pixel(x, y);
            texel[0] = slope_x / length, texel[1] = slope_y / length, texel[2] = 1 / length;
        }
    return image;
}

TEST(OwnNormals, FromMinusOneToOneAreThoseFromZeroToOne) {
    Image encoded = dome(3);
    for (float& value : encoded.values) value = 0.5f * value + 0.5f;
    NoteLines notes;
    EXPECT_EQ(normals_in(encoded, notes).values, encoded.values);
    EXPECT_TRUE(notes.empty());
    EXPECT_EQ(normals_in(dome(3), notes).values, encoded.values);
    EXPECT_EQ(notes, NoteLines{"its values are normals from -1 to 1, not colours from 0 to 1"});
}

TEST(OwnNormals, ThatASharpeningFilterTookBeyondZeroAreStillColors) {
    Image encoded = dome(3);
    for (float& value : encoded.values) value = 0.5f * value + 0.5f;
    encoded.values[0] = -0.01f, encoded.values[5] = 1.02f;
    NoteLines notes;
    EXPECT_EQ(normals_in(encoded, notes).values, encoded.values);
    EXPECT_EQ(notes, NoteLines{"2 texels hold values beyond 0 and 1: these are no normals"});
}

TEST(OwnNormals, AreFlatWhereATexelHoldsNaN) {
    Image holes = dome(3);
    for (float& value : holes.values) value = 0.5f * value + 0.5f;
    holes.values[4] = NAN, holes.values[9] = INFINITY;
    NoteLines notes;
    const Image read = normals_in(holes, notes);
    for (const size_t i : {3u, 9u}) {
        EXPECT_EQ(read.values[i], 0.5f);
        EXPECT_EQ(read.values[i + 1], 0.5f);
        EXPECT_EQ(read.values[i + 2], 1);
    }
    EXPECT_EQ(notes, NoteLines{"2 texels hold NaN or infinity: read as flat"});
}

TEST(OwnNormals, HaveAFourthChannelThatIsNotedOnlyIfItVaries) {
    Image four(2, 1, 4, 8);
    four.values = {0.5f, 0.5f, 1, 1, 0.5f, 0.5f, 1, 1};
    NoteLines notes;
    EXPECT_EQ(normals_in(four, notes).channels, 3);
    EXPECT_TRUE(notes.empty());
    four.values[7] = 0;
    normals_in(four, notes);
    EXPECT_EQ(notes, NoteLines{"its fourth channel is not read"});
    EXPECT_THROW(normals_in(Image(2, 2, 1), notes), Error);
}

}  // namespace
}  // namespace relief
