#include "assets/garden.h"

#include <fmt/format.h>

#include <glm/glm.hpp>

namespace relief {
namespace {

using glm::dvec2, glm::dvec3;

/// Builds an OBJ text from flat pieces.
class Model {
public:
    Model(const char* title, const char* library)
        : text_(fmt::format("# {}. Written by assets/garden.cpp.\nmtllib {}\ns off\n", title, library)) {}

    void material(const char* name) { text_ += fmt::format("usemtl {}\n", name); }

    /// Visible from the side to which cross(right, up) points. uv runs from `low` to `high`.
    void quad(const dvec3& corner, const dvec3& right, const dvec3& up, const dvec2& low, const dvec2& high) {
        const dvec3 normal = glm::normalize(glm::cross(right, up));
        const dvec3 places[] = {corner, corner + right, corner + right + up, corner + up};
        const dvec2 uvs[] = {low, {high.x, low.y}, high, {low.x, high.y}};
        for (const dvec3& place : places) text_ += fmt::format("v {:.4f} {:.4f} {:.4f}\n", place.x, place.y, place.z);
        for (const dvec2& uv : uvs) text_ += fmt::format("vt {:.4f} {:.4f}\n", uv.x, uv.y);
        text_ += fmt::format("vn {:.0f} {:.0f} {:.0f}\n", normal.x + 0.0, normal.y + 0.0, normal.z + 0.0);
        ++normals_, points_ += 4;
        text_ += "f";
        for (int i = 3; i >= 0; --i) text_ += fmt::format(" {0}/{0}/{1}", points_ - i, normals_);
        text_ += "\n";
    }

    /// Adds a box without its bottom. uv are in metres / `tile`, so that the texture has its true scale on every side.
    void box(const dvec3& low, const dvec3& high, double tile = 1) {
        const dvec3 size = high - low;
        const dvec3 x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
        const auto uv = [&](double u, double v) { return dvec2(u, v) / tile; };
        quad({low.x, low.y, high.z}, x, y, uv(low.x, low.y), uv(high.x, high.y));     // front
        quad({high.x, low.y, low.z}, -x, y, uv(-high.x, low.y), uv(-low.x, high.y));  // back
        quad({high.x, low.y, high.z}, -z, y, uv(-high.z, low.y), uv(-low.z, high.y));
        quad({low.x, low.y, low.z}, z, y, uv(low.z, low.y), uv(high.z, high.y));
        quad({low.x, high.y, high.z}, x, -z, uv(low.x, -high.z), uv(high.x, -low.z));  // top
    }

    const std::string& text() const { return text_; }

private:
    std::string text_;
    int points_ = 0, normals_ = 0;
};

constexpr double posts[] = {-8.8, -6.2, -3.6, -1.0, 1.0, 3.6, 6.2, 8.8};

/// Calls `stretch` with the left and right end of each wall between two posts. The gate stays open.
template <class Stretch>
void each_stretch(Stretch stretch) {
    for (size_t i = 0; i + 1 < std::size(posts); ++i)
        if (i != 3) stretch(posts[i] + 0.2, posts[i + 1] - 0.2);
}

std::string garden_obj() {
    Model model("A garden wall at dusk", "garden.mtl");
    model.material("Grass");
    model.quad({-36, 0, 10}, {72, 0, 0}, {0, 0, -72}, {0, 0}, {30, 30});
    model.material("Path");
    model.quad({-0.65, 0.015, 10}, {1.3, 0, 0}, {0, 0, -40}, {0, 0}, {0.65, 20});

    model.material("Brick");
    for (const double x : posts) model.box({x - 0.2, 0, -0.2}, {x + 0.2, 1.8, 0.2});
    each_stretch([&](double left, double right) { model.box({left, 0, -0.15}, {right, 0.55, 0.15}); });

    model.material("Stone");
    for (const double x : posts) {
        model.box({x - 0.26, 1.8, -0.26}, {x + 0.26, 1.87, 0.26});
        model.box({x - 0.16, 1.87, -0.16}, {x + 0.16, 1.95, 0.16});
    }
    each_stretch([&](double left, double right) { model.box({left, 0.55, -0.2}, {right, 0.61, 0.2}); });

    model.material("Iron");
    each_stretch([&](double left, double right) { model.box({left, 1.68, -0.012}, {right, 1.7, 0.012}); });
    model.box({0.98, 1.66, 0.2}, {1.02, 1.69, 0.66});  // the lantern's arm
    model.box({0.99, 1.6, 0.59}, {1.01, 1.66, 0.61});  // its hook
    model.box({0.9, 1.57, 0.5}, {1.1, 1.6, 0.7});      // its roof
    model.box({0.93, 1.6, 0.53}, {1.07, 1.62, 0.67});
    model.box({0.91, 1.31, 0.51}, {1.09, 1.33, 0.69});  // its floor
    for (const double x : {0.915, 1.07})
        for (const double z : {0.515, 0.67}) model.box({x, 1.33, z}, {x + 0.015, 1.57, z + 0.015});
    constexpr dvec3 panes[] = {{-3.0, 0.42, 0.9}, {-2.55, 0.27, 1.5}, {-2.2, 0.14, 2.1}};  // lower left corners
    for (const dvec3& pane : panes)
        for (const double x : {-0.015, 0.75})
            model.box({pane.x + x, 0, pane.z - 0.008}, {pane.x + x + 0.015, pane.y + 1.05, pane.z + 0.007});

    model.material("Flame");
    model.box({0.965, 1.36, 0.565}, {1.035, 1.53, 0.635});

    model.material("Wire");
    constexpr double mesh = 0.35;
    each_stretch([&](double left, double right) {
        model.quad({left, 0.61, 0}, {right - left, 0, 0}, {0, 1.07, 0}, {left / mesh, 0}, {right / mesh, 1.07 / mesh});
    });
    model.material("Ivy");
    constexpr double ivy = 1.1;
    const auto climb = [&](double left, double right, double z) {
        model.quad({left, 0.3, z}, {right - left, 0, 0}, {0, 1.45, 0}, {left / ivy, 0}, {right / ivy, 1});
    };
    climb(1.25, 3.4, 0.24), climb(-6, -3.85, 0.24), climb(3.85, 5.2, 0.24);

    // Back to front, as seen from the path: this order blends correctly only from there.
    constexpr const char* glasses[] = {"Blue glass", "Amber glass", "Red glass"};
    for (size_t i = 0; i < 3; ++i) {
        model.material(glasses[i]);
        model.quad(panes[i], {0.75, 0, 0}, {0, 1.05, 0}, {0, 0}, {1, 1});
    }
    return model.text();
}

constexpr const char* garden_mtl = R"(# Materials of garden.obj. Written by assets/garden.cpp.
newmtl Grass
map_Kd grass_albedo.png

# A normal map, under the name of a bump map: so write it many programs.
newmtl Brick
map_Kd bricks_albedo.png
map_Ks bricks_specular.png
map_bump bricks_normal.png

# Heights, as the format has it; -bm is their depth, in widths of the map.
newmtl Path
map_Kd paving_albedo.png
map_bump -bm 0.0117 paving_height.png

newmtl Stone
Kd 0.42 0.40 0.37

newmtl Iron
Kd 0.035 0.035 0.04
Ks 0.30 0.30 0.32
Ns 40

newmtl Flame
Kd 0 0 0
Ke 5.0 2.3 0.6

newmtl Wire
Kd 0.20 0.21 0.22
Ks 0.35 0.35 0.35
Ns 24
map_d wire_mask.png

newmtl Ivy
map_Kd leaves_albedo.png
map_d leaves_mask.png

newmtl Blue glass
Kd 0.03 0.10 0.75
Ke 0.004 0.012 0.075
Ks 0.5 0.5 0.5
Ns 90
d 0.55

newmtl Amber glass
Kd 0.85 0.42 0.02
Ke 0.075 0.032 0.002
Ks 0.5 0.5 0.5
Ns 90
d 0.5

newmtl Red glass
Kd 0.75 0.03 0.04
Ke 0.085 0.004 0.006
Ks 0.5 0.5 0.5
Ns 90
Tr 0.55
)";

/// Four plates that differ in the map named by map_bump.
std::string ground_obj() {
    Model model("Four plates on a ground", "ground.mtl");
    model.material("Ground");
    model.quad({-12, 0, 12}, {24, 0, 0}, {0, 0, -24}, {0, 0}, {12, 12});
    constexpr const char* names[] = {"Normals", "Heights", "Colours", "Object space"};
    for (int i = 0; i < 4; ++i) {
        model.material(names[i]);
        model.box({-2.3 + 1.2 * i, 0, -0.5}, {-1.3 + 1.2 * i, 0.12, 0.5});
    }
    return model.text();
}

constexpr const char* ground_mtl = R"(# Materials of ground.obj. Written by assets/garden.cpp.
newmtl Ground
map_Kd grass_albedo.png

newmtl Normals
map_Kd bricks_albedo.png
map_bump bricks_normal.png

newmtl Heights
map_Kd bricks_albedo.png
map_bump -bm 0.0234 bricks_height.png

# Neither heights nor normals of a tangent space.
newmtl Colours
map_Kd bricks_albedo.png
map_bump bricks_albedo.png

newmtl Object space
map_Kd bricks_albedo.png
map_bump quilt_object.png
)";

/// A lawn with a normal map, and a hedge whose mask is in its colours.
std::string lawn_obj() {
    Model model("A lawn with a normal map, and a hedge with alpha in its colours", "lawn.mtl");
    model.material("Lawn");
    model.quad({-12, 0, 12}, {24, 0, 0}, {0, 0, -24}, {0, 0}, {10, 10});
    model.material("Hedge");
    constexpr double ivy = 1.1;
    for (const double z : {-1.2, -1.5, -1.8})
        model.quad({-3 + 0.4 * z, 0, z}, {6, 0, 0}, {0, 1.1, 0}, {z, 0}, {z + 6 / ivy, 1});
    model.material("Brick");
    for (const double x : {-2.6, 1.9}) model.box({x, 0, -0.9}, {x + 0.5, 1.2, -0.4});
    return model.text();
}

constexpr const char* lawn_mtl = R"(# Materials of lawn.obj. Written by assets/garden.cpp.
newmtl Lawn
Ka 1 1 1
illum 2
map_Kd -clamp off grass_albedo.png
norm grass_normal.png

# No map_d: the fourth channel of the colours is the mask.
newmtl Hedge
map_Kd ivy_with_alpha.png

newmtl Brick
Tf 1 1 1
map_Kd bricks_albedo.png
map_Ks bricks_specular.png
map_bump bricks_normal.png
)";

/// Fences one behind the other, and a wet pier; no bump maps.
std::string fence_obj() {
    Model model("Four fences, a pier and a pane", "fence.mtl");
    model.material("Pane");  // first in the file, but must be drawn last
    model.quad({-3.2, 0.3, 0.4}, {1.2, 0, 0}, {0, 1.2, 0}, {0, 0}, {1, 1});
    model.material("Grass");
    model.quad({-36, 0, 10}, {72, 0, 0}, {0, 0, -72}, {0, 0}, {30, 30});
    model.material("Pier");
    model.box({-1.7, 0, -0.3}, {-0.7, 1.7, 0.3});
    model.material("Iron");
    constexpr double left[] = {-0.5, -2.0, -5.0, -14.0}, right[] = {2.2, 4.5, 9.0, 20.0},
                     z[] = {0.5, -5.0, -15.0, -40.0};
    for (size_t i = 0; i < 4; ++i)
        for (const double x : {left[i], right[i]}) model.box({x - 0.03, 0, z[i] - 0.03}, {x + 0.03, 1.5, z[i] + 0.03});
    model.material("Wire");
    constexpr double mesh = 0.35;
    for (size_t i = 0; i < 4; ++i)
        model.quad({left[i], 0, z[i]}, {right[i] - left[i], 0, 0}, {0, 1.4, 0}, {left[i] / mesh, 0},
                   {right[i] / mesh, 1.4 / mesh});
    return model.text();
}

constexpr const char* fence_mtl = R"(# Materials of fence.obj. Written by assets/garden.cpp.
newmtl Pane
Kd 0.1 0.45 0.3
Ks 0.5 0.5 0.5
Ns 90
d 0.4

newmtl Grass
map_Kd grass_albedo.png

newmtl Pier
map_Kd bricks_albedo.png
map_Ks bricks_specular.png

newmtl Iron
Kd 0.035 0.035 0.04

newmtl Wire
Kd 0.45 0.46 0.48
map_d wire_mask.png
)";

/// Faults of files from other programs: a material with another name, a missing map.
std::string broken_obj() {
    Model model("A ground whose material has another name", "broken.mtl");
    model.material("Grass");
    model.quad({-12, 0, 12}, {24, 0, 0}, {0, 0, -24}, {0, 0}, {12, 12});
    model.material("Box");
    model.box({-0.9, 0, -0.4}, {-0.1, 0.8, 0.4});
    model.material("Clear");
    model.box({0.1, 0, -0.4}, {0.9, 0.8, 0.4});
    return model.text();
}

constexpr const char* broken_mtl = R"(# Materials of broken.obj. Written by assets/garden.cpp.
newmtl Ground
map_Kd grass_albedo.png

newmtl Box
Kd 0.6 0.35 0.2
map_Kd no_such_picture.png

# Opaque, said twice. Who reads Tr as d draws nothing.
newmtl Clear
Kd 0.25 0.4 0.6
d 1.0
Tr 0.0
)";

}  // namespace

std::vector<std::pair<std::string, std::string>> make_garden() {
    return {{"garden.obj", garden_obj()}, {"garden.mtl", garden_mtl}, {"ground.obj", ground_obj()},
            {"ground.mtl", ground_mtl},   {"fence.obj", fence_obj()}, {"fence.mtl", fence_mtl},
            {"broken.obj", broken_obj()}, {"broken.mtl", broken_mtl}, {"lawn.obj", lawn_obj()},
            {"lawn.mtl", lawn_mtl}};
}

}  // namespace relief
