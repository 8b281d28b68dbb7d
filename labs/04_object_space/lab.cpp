// Lab 04: object space.
//
// One quilted column and three maps of its normals, in world, object and tangent space. Twist it, rotate it or move it,
// and see which map follows. Or light that was baked into colours, beside two of the maps. Your tasks:
// shaders/04_object_space/task.glsl
#include <glm/gtc/matrix_transform.hpp>
#include <memory>

#include "framework/core/gl/texel_target.h"
#include "framework/core/lab/lab.h"
#include "framework/library/kit/choices.h"
#include "framework/library/kit/kept.h"
#include "framework/library/kit/labels.h"
#include "framework/library/kit/light.h"
#include "framework/library/kit/studio.h"
#include "framework/library/kit/tiles.h"
#include "framework/library/kit/window_triangle.h"
#include "framework/library/mesh/shapes.h"
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
            const bool is_baked = view_ == baked && i == 0 && !frame.probe;
            if (is_baked)
                draw_baked(frame_in(frame, tiles[i]), tiles[i]);
            else
                draw_column(frame_in(frame, tiles[i]), tiles[i], map_of(i));
            studio_.draw(
                frame_in(frame, tiles[i]), tiles[i], {}, [] { return make_column(quilt::column); }, world_from_model());
            if (!frame.probe) describe(frame.size, tiles[i], is_baked ? baked_map : map_of(i));
        }
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        knobs.choice("view", view_, views, "every map, one of them, or baked light beside two of them");
        knobs.choice("map", map_, maps.names,
                     KnobHelp("the map of the column").only("view", {"one"}).titled("Normal map"));
        knobs.slider("twist", twist_, -180, 180,
                     KnobHelp("twist of the column from its foot to its top").in("degrees"));
        knobs.slider("rotate", rotate_, -180, 180,
                     KnobHelp("rotation of the column about the vertical").in("degrees").titled("Rotation"));
        knobs.slider("translate", translate_, -1, 1,
                     KnobHelp("movement of the column to the side").in("metres").titled("Translation"));
        knobs.slider("light_yaw", light_yaw_, -180, 180,
                     KnobHelp("direction of the light around the column").in("degrees"));
        knobs.toggle("show_map", show_map_, "show the map in a corner");
    }

    std::optional<Image> truth(const Frame& frame) const override {
        return truth_in_tiles(frame, tiles_of_view(frame.size), [&](const Frame& part, size_t) {
            return quilt::truth(part, rate(), world_from_model());
        });
    }

private:
    enum View { every, one, baked };
    /// The last is no map of normals, but light.
    enum Map { world, object, tangent, baked_map };
    static constexpr std::array views = {"every", "one", "baked"};
    static constexpr float baked_yaw = 40;  ///< of the lamp, degrees
    static constexpr glm::ivec2 baked_size{1024, 512};
    static constexpr auto maps = choices<Map>(
        {{world, "world", "WORLD_MAP"}, {object, "object", "OBJECT_MAP"}, {tangent, "tangent", "TANGENT_MAP"}});

    std::vector<Tile> tiles_of_view(glm::ivec2 size) const {
        if (view_ == one) return tiles_of(size, 1);
        return size.x >= size.y ? tile_grid(size, int(maps.size()), 1) : tile_grid(size, 1, int(maps.size()));
    }
    /// Baked light has the normals of the world-space map: they do not follow the model, either.
    int map_of(size_t tile) const {
        constexpr std::array beside_baked = {world, world, tangent};
        return view_ == one ? map_ : view_ == baked ? beside_baked[tile] : int(tile);
    }

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
        place(frame, surface);
        surface.set("u_eye", frame.camera.eye());
        surface.set("u_light", lamp_at(light_yaw_, 3, 2.2f));
        surface.set("s_normals", 0, texture(map));
        draw_triangles();
    }
    void place(const Frame& frame, const Program& surface) const {
        surface.set("u_clip_from_world", frame.camera.clip_from_world());
        surface.set("u_world_from_model", world_from_model());
        surface.set("u_rate", rate());
    }
    void draw_triangles() const {
        glBindVertexArray(column_.layout());
        glDrawElements(GL_TRIANGLES, column_.count(), GL_UNSIGNED_INT, nullptr);
    }

    /// Returns the light of the column at rest as colours, over its uv: for one lamp, one pose and one eye.
    const TexelTarget& baked_light() {
        const Program& surface = surface_.with({"BAKE", maps.define(tangent)});
        return *baked_.get({surface}, [&] {
            auto light = std::make_unique<TexelTarget>(baked_size, std::initializer_list<GLenum>{GL_RGBA8}, true);
            light->begin();
            glUseProgram(surface);
            surface.set("u_world_from_model",
                        glm::translate(quilt::rest(), glm::dvec3(0, -quilt::column.height / 2, 0)));
            surface.set("u_rate", 0.0);
            surface.set("u_eye", Camera({.yaw = 0, .pitch = 8, .distance = 3.4}, 1).eye());
            surface.set("u_light", lamp_at(baked_yaw, 3, 2.2f));
            surface.set("s_normals", 0, tangent_);
            draw_triangles();
            light->make_mips();
            return light;
        });
    }

    void draw_baked(const Frame& frame, const Tile& tile) {
        const TexelTarget& light = baked_light();
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y);
        const Program& surface = colored_.with();
        glUseProgram(surface);
        place(frame, surface);
        light.bind(0);
        surface.set("s_normals", 0);
        draw_triangles();
    }

    void describe(glm::ivec2 size, const Tile& tile, int map) {
        labels_.caption(size, tile, 0,
                        map == baked_map ? "baked light" : std::string(maps.names[size_t(map)]) + " space");
        if (!show_map_) return;
        const int side = std::min(tile.size.x, tile.size.y) / 5, gap = side / 8;
        glViewport(tile.corner.x + gap, tile.corner.y + gap, side, side);
        const Program& inset = inset_.with();
        glUseProgram(inset);
        if (map == baked_map) {
            baked_light().bind(0);
            inset.set("s_normals", 0);
        } else {
            inset.set("s_normals", 0, texture(map));
        }
        window_.draw();
    }

    Programs surface_{"04_object_space/column.vert", "04_object_space/column.frag"};
    Programs colored_{"04_object_space/column.vert", "04_object_space/map.frag"};
    Programs inset_{"04_object_space/map.vert", "04_object_space/map.frag"};
    Texture world_ = load_texture("quilt_world.png", ColorSpace::linear);
    Texture object_ = load_texture("quilt_object.png", ColorSpace::linear);
    Texture tangent_ = load_texture("quilt_tangent.png", ColorSpace::linear);
    GpuMesh column_ = upload([] { return make_column(quilt::column); });
    Kept<std::unique_ptr<TexelTarget>, GLuint> baked_;
    WindowTriangle window_;
    Studio studio_;
    Labels labels_;

    int view_ = every, map_ = tangent;
    float twist_ = 90, rotate_ = 0, translate_ = 0, light_yaw_ = baked_yaw;
    bool show_map_ = true;
};

RELIEF_LAB(ObjectSpace);

}  // namespace relief
