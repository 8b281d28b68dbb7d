// The studio around the objects of labs: only in pictures that ask for it, and only behind the objects.
#include "framework/library/kit/studio.h"

#include <gtest/gtest.h>

#include "shots.h"

namespace relief {
namespace {

struct StudioView {
    const char* lab;
    std::vector<Knob> knobs;
    const char* probe;
};

const StudioView studio_views[] = {
    {"03", {{"view", "one"}, {"show", "light"}, {"size", "32"}}, "normal"},
    {"04", {{"view", "one"}, {"show_map", "false"}}, "normal"},
    {"05", {{"view", "one"}, {"show", "light"}, {"shape", "sphere"}, {"lines", "false"}}, "tangent"},
    {"06", {{"view", "one"}}, "normal"},
    {"11", {{"view", "one"}, {"surface", "urn"}}, "uv"},
    {"12", {{"view", "one"}, {"surface", "column"}, {"shadow", "none"}}, "uv"},
    {"13", {{"view", "one"}, {"show", "light"}}, "normal"}};

std::vector<PictureWord> no_words;

/// Returns the picture without words, small and from farther away than the lab opens.
Image picture_of(const StudioView& view, bool studio, const char* probe = "") {
    Shot shot = shot_of(view.lab, view.knobs, probe, {96, 96});
    shot.camera.distance *= 1.5;
    shot.words = &no_words, shot.studio = studio;
    return drawn(view.lab, shot);
}

/// Returns whether `is` holds at a pixel and all of its neighbours.
template <class Is>
bool around(const Image& image, int x, int y, Is is) {
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            const int column = std::clamp(x + dx, 0, image.width - 1), row = std::clamp(y + dy, 0, image.height - 1);
            if (!is(image.pixel(column, row))) return false;
        }
    return true;
}

TEST(Studio, ChangesNoPixelOfAnObjectAndEveryOneBesideIt) {
    for (const StudioView& view : studio_views) {
        const Image bare = picture_of(view, false), standing = picture_of(view, true),
                    probe = picture_of(view, false, view.probe);
        size_t inside = 0, outside = 0, changed_inside = 0, same_outside = 0;
        for (int y = 0; y < probe.height; ++y)
            for (int x = 0; x < probe.width; ++x) {
                const bool is_same = std::equal(bare.pixel(x, y), bare.pixel(x, y) + 3, standing.pixel(x, y));
                if (around(probe, x, y, [](const float* value) { return value[0] != no_surface; }))
                    ++inside, changed_inside += !is_same;
                if (around(probe, x, y, [](const float* value) { return value[0] == no_surface; }))
                    ++outside, same_outside += is_same;
            }
        EXPECT_GT(inside, probe.pixel_count() / 40) << view.lab;
        EXPECT_GT(outside, probe.pixel_count() / 20) << view.lab;
        EXPECT_EQ(changed_inside, 0u) << view.lab;
        EXPECT_LE(same_outside, outside / 200) << view.lab;  // a colour of the floor may equal that of the bare picture
    }
}

TEST(Studio, IsNotInAProbe) {
    for (const StudioView& view : studio_views)
        EXPECT_EQ(picture_of(view, true, view.probe).values, picture_of(view, false, view.probe).values) << view.lab;
}

TEST(Studio, IsNotInACheck) {
    for (const LabEntry& lab : registry()) {
        const Manifest manifest = load_manifest(lab);
        for (const CheckInfo& check : manifest.checks)
            EXPECT_FALSE(check.shot.studio) << lab.folder << ": " << check.name;
    }
}

}  // namespace
}  // namespace relief
