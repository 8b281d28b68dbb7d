// Lab 04: object space.
//
// One quilted column and three maps of its normals, in world, object and tangent space. Twist it, rotate it or move it,
// and see which map follows. Your tasks: shaders/04_object_space/task.glsl
#include <glm/gtc/matrix_transform.hpp>

#include "framework/core/kit/choices.h"
#include "framework/core/kit/labels.h"
#include "framework/core/kit/light.h"
#include "framework/core/kit/tiles.h"
#include "framework/core/kit/window_triangle.h"
#include "framework/core/lab/lab.h"
#include "quilt.h"
#include "truth.h"

namespace relief {

class ObjectSpace final : public Lab {
public:
    void draw(const Frame& frame) override {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        const auto tiles = tiles_of_view(frame.size);
        for (size_t i = 0; i < tiles.size(); ++i) {
            draw_column(frame_in(frame, tiles[i]), tiles[i], map_of(i));
            if (!frame.probe) describe(frame.size, tiles[i], map_of(i));
        }
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        knobs.choice("view", view_, views, "every map, or one of them");
        knobs.choice("map", map_, maps.names, "for view = one: the map of the column");
        knobs.slider("twist", twist_, -180, 180, "twist of the column from its foot to its top, degrees");
        knobs.slider("rotate", rotate_, -180, 180, "rotation of the column about the vertical, degrees");
        knobs.slider("translate", translate_, -1, 1, "movement of the column to the side, metres");
        knobs.slider("light_yaw", light_yaw_, -180, 180, "direction of the light around the column, degrees");
        knobs.toggle("show_map", show_map_, "show the map in a corner");
    }

    std::optional<Image> truth(const Frame& frame, const Probe& probe) const override {
        return truth_in_tiles(frame, tiles_of_view(frame.size), [&](const Frame& part, size_t) {
            return quilt::truth(part, probe, rate(), world_from_model());
        });
    }

private:
    enum View { every, one };
    enum Map { world, object, tangent };
    static constexpr std::array views = {"every", "one"};
    static constexpr auto maps = choices<Map>(
        {{world, "world", "WORLD_MAP"}, {object, "object", "OBJECT_MAP"}, {tangent, "tangent", "TANGENT_MAP"}});

    std::vector<Tile> tiles_of_view(glm::ivec2 size) const {
        return tiles_of(size, view_ == one ? 1 : int(maps.size()));
    }
    int map_of(size_t tile) const { return view_ == one ? map_ : int(tile); }

    double rate() const { return glm::radians(double(twist_)) / quilt::column.height; }
    glm::dmat4 world_from_model() const {
        const glm::dmat4 moved = glm::translate(glm::dmat4(1), glm::dvec3(translate_, 0, 0));
        const glm::dmat4 turned = glm::rotate(moved, glm::radians(double(rotate_)), glm::dvec3(0, 1, 0));
        return glm::translate(turned * quilt::rest(), glm::dvec3(0, -quilt::column.height / 2, 0));
    }

    const Texture& texture(int map) const { return map == world ? world_ : map == object ? object_ : tangent_; }

    void draw_column(const Frame& frame, const Tile& tile, int map) const {
        glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y);
        const Program& surface = surface_.with({frame.probe, maps.define(map)});
        glUseProgram(surface);
        surface.set("u_clip_from_world", frame.camera.clip_from_world());
        surface.set("u_world_from_model", world_from_model());
        surface.set("u_rate", rate());
        surface.set("u_eye", frame.camera.eye());
        surface.set("u_light", lamp_at(light_yaw_, 3, 2.2f));
        surface.set("s_normals", 0, texture(map));
        glBindVertexArray(column_.layout());
        glDrawElements(GL_TRIANGLES, column_.count(), GL_UNSIGNED_INT, nullptr);
    }

    void describe(glm::ivec2 size, const Tile& tile, int map) {
        labels_.caption(size, tile, 0, std::string(maps.names[size_t(map)]) + " space");
        if (!show_map_) return;
        const int side = std::min(tile.size.x, tile.size.y) / 5, gap = side / 8;
        glViewport(tile.corner.x + gap, tile.corner.y + gap, side, side);
        const Program& inset = inset_.with();
        glUseProgram(inset);
        inset.set("s_normals", 0, texture(map));
        window_.draw();
    }

    Programs surface_{"04_object_space/column.vert", "04_object_space/column.frag"};
    Programs inset_{"04_object_space/map.vert", "04_object_space/map.frag"};
    Texture world_ = load_texture("quilt_world.png", ColorSpace::linear);
    Texture object_ = load_texture("quilt_object.png", ColorSpace::linear);
    Texture tangent_ = load_texture("quilt_tangent.png", ColorSpace::linear);
    GpuMesh column_ = upload([] { return make_column(quilt::column); });
    WindowTriangle window_;
    Labels labels_;

    int view_ = every, map_ = tangent;
    float twist_ = 90, rotate_ = 0, translate_ = 0, light_yaw_ = 40;
    bool show_map_ = true;
};

RELIEF_LAB(ObjectSpace);

}  // namespace relief
