// Lab 06: tangent space.
//
// A frame at every pixel. Light is computed in world space or in tangent space, on models that are scaled and mirrored,
// with rotated textures. Your tasks: shaders/06_tangent_space/task.glsl
#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>

#include "framework/core/base/error.h"
#include "framework/core/base/text.h"
#include "framework/core/image/compare.h"
#include "framework/core/lab/lab.h"
#include "framework/library/kit/choices.h"
#include "framework/library/kit/difference_map.h"
#include "framework/library/kit/drawn_numbers.h"
#include "framework/library/kit/kept.h"
#include "framework/library/kit/labels.h"
#include "framework/library/kit/light.h"
#include "framework/library/kit/own_maps.h"
#include "framework/library/kit/studio.h"
#include "framework/library/kit/tiles.h"
#include "framework/library/maps/normals.h"
#include "framework/library/maps/own_picture.h"
#include "framework/library/mesh/shapes.h"
#include "scene.h"
#include "truth.h"

namespace relief {

class TangentSpace final : public Lab {
public:
    void draw(const Frame& frame) override {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        const auto tiles = tiles_of_view(frame.size);
        for (size_t i = 0; i < tiles.size(); ++i) {
            const Way way = way_of(i);
            draw_surface(frame_in(frame, tiles[i]), tiles[i], way);
            studio_.draw(
                frame_in(frame, tiles[i]), tiles[i], {double(shape()), double(own_mesh_.version())},
                [this] { return mesh(); }, world_from_model(way));
            if (view_ != one) labels_.caption(frame.size, tiles[i], 0, way.title);
            if (i > 0 && has_differences(frame.probe)) draw_difference(frame, tiles[i], i);
        }
        if (has_differences(frame.probe)) labels_.scale(frame.size, "0.1~", "100~", 3);
        labels_.notes(notes_of_files(*this));
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        knobs.group("Picture");
        knobs.choice("view", view_, views,
                     "the right way and four mistakes, one picture by the knobs, or a cube that is turned");
        knobs.choice("show", show_, shows,
                     KnobHelp("half of each mistake as the angle to the right normal, or the light alone")
                         .only("view", {"compare"}));
        knobs.choice_or_file(
            "shape", shape_, own_mesh_, shapes,
            KnobHelp("shape of the model; the wall's left half is mirrored").only("view", {"compare", "one"}));
        knobs.group("Normals");
        knobs.choice("normals", normals_from_, sources, "normals from the map, or from the vertices only");
        knobs.choice_or_file(
            "map", map_, own_, maps,
            KnobHelp("the normal map: bricks, one flat texel, or that of a glTF model").titled("Normal map"));
        knobs.slider("strength", strength_, 0, 2, "strength of the normal map; 0 is flat");
        knobs.choice("light_in", light_in_, spaces, KnobHelp("space of the lighting").titled("Light in space"));
        knobs.toggle("gram_schmidt", gram_schmidt_,
                     KnobHelp("make each pixel's frame orthonormal").only("view", {"one"}).titled("Gram-Schmidt"));
        knobs.toggle("inverse_transpose", inverse_transpose_,
                     KnobHelp("transform normals by the inverse transpose").only("view", {"one"}));
        knobs.choice("tangent_by", tangent_by_, tangent_matrices,
                     KnobHelp("transform tangents by the model's matrix, or by the inverse transpose, as normals")
                         .only("view", {"one"})
                         .titled("Tangent by"));
        knobs.choice("order", order_, orders,
                     KnobHelp("the model's matrices multiplied first, or the normal transformed by one after the other")
                         .titled("Matrix order"));
        knobs.toggle("turn_tangent", turn_tangent_,
                     KnobHelp("rotate the tangent with the texture").only("view", {"one"}).titled("Turn tangent"));
        knobs.slider("turn", turn_, -180, 180,
                     KnobHelp("rotation of the texture")
                         .in("degrees")
                         .only("view", {"compare", "one"})
                         .titled("Turn of texture"));
        knobs.group("Model");
        knobs.slider("scale_x", scale_.x, -2, 2,
                     KnobHelp("scale of the model along x").only("view", {"compare", "one"}));
        knobs.slider("scale_y", scale_.y, -2, 2,
                     KnobHelp("scale of the model along y").only("view", {"compare", "one"}));
        knobs.slider("scale_z", scale_.z, -2, 2,
                     KnobHelp("scale of the model along z").only("view", {"compare", "one"}));
        knobs.steps(
            "size", size_, -6, 6,
            KnobHelp("size of the model, a power of ten").only("view", {"compare", "one"}).titled("Size: power of 10"));
        knobs.slider("rotate", rotate_, -180, 180,
                     KnobHelp("rotation of the model about the vertical").in("degrees").titled("Rotation"));
        knobs.group("Light");
        knobs.slider("light_yaw", light_yaw_, -180, 180, KnobHelp("direction of the light").in("degrees"));
        knobs.slider("light_height", light_height_, -3, 3, KnobHelp("height of the light").in("metres"));
        knobs.slider("light_distance", light_distance_, 0, 5,
                     KnobHelp("distance of the light from the axis").in("metres"));
        knobs.group("Faults");
        knobs.choice("trouble", trouble_, troubles.names,
                     KnobHelp("faults in the tangents of the vertices").titled("Tangent trouble"));
    }

    std::optional<Image> truth(const Frame& frame) const override {
        if (shape() == frames::Shape::own) return {};
        if (normals_from_ == from_map && (map_ == own || has_model_maps())) return {};
        const bool has_map = normals_from_ == from_map && map_ == bricks;
        // Without a tangent, the direction of the bumps is undefined.
        if (has_map && strength_ != 0 && (trouble_ == along_normal || trouble_ == missing)) return {};
        return truth_in_tiles(frame, tiles_of_view(frame.size), [&](const Frame& part, size_t tile) {
            const frames::Pose pose{shape(), world_from_model(way_of(tile)), has_map ? double(strength_) : 0.0,
                                    glm::radians(double(turn()))};
            return frames::truth(part, pose);
        });
    }

private:
    /// The definitions of a variant. Empty ones are the correct choice.
    struct Way {
        const char *title, *frame, *normals, *tangent, *turn;
        double degrees;  ///< by which the model turns, beside `rotate`
    };
    static constexpr const char* as_normal = "TANGENT_AS_NORMAL";
    static constexpr std::array<Way, 5> comparisons = {{{"right", "", "", "", "", 0},
                                                        {"frame as interpolated", "AS_INTERPOLATED", "", "", "", 0},
                                                        {"normal by the matrix", "", "MODEL_MATRIX", "", "", 0},
                                                        {"tangent as a normal", "", "", as_normal, "", 0},
                                                        {"tangent not turned", "", "", "", "TANGENT_STAYS", 0}}};
    static constexpr std::array<Way, 3> turned_cubes = {{{"as it was made", "", "", "", "", 0},
                                                         {"turned by 90 degrees", "", "", "", "", -90},
                                                         {"normals not turned", "", "MODEL_SPACE", "", "", -90}}};
    enum View { compare, one, turned };
    enum Show { half_and_half, light };
    enum NormalsFrom { from_map, from_vertices };
    enum Map { bricks, one_texel, of_model, own };
    enum LightIn { world_space, tangent_space };
    enum TangentBy { by_matrix, by_inverse_transpose };
    enum Trouble { none, leaning, along_normal, missing };
    static constexpr std::array views = {"compare", "one", "turned"};
    static constexpr std::array shows = {"half-and-half", "light"};
    static constexpr std::array shapes = {"sphere", "column", "wall"};
    static constexpr std::array sources = {"map", "vertices"};
    static constexpr std::array maps = {"bricks", "one-texel", "model"};
    static constexpr std::array spaces = {"world", "tangent"};
    static constexpr std::array tangent_matrices = {"matrix", "inverse-transpose"};
    static constexpr std::array orders = {"product", "one-by-one"};
    static constexpr auto troubles = choices<Trouble>({{none, "none"},
                                                       {leaning, "leaning", "TANGENT_LEANING"},
                                                       {along_normal, "along-normal", "TANGENT_ALONG_NORMAL"},
                                                       {missing, "missing", "NO_TANGENT"}});

    Way way_of(size_t tile) const {
        return view_ == compare ? comparisons[tile] : view_ == turned ? turned_cubes[tile] : chosen();
    }
    Way chosen() const {
        return {"",
                gram_schmidt_ ? "" : "AS_INTERPOLATED",
                inverse_transpose_ ? "" : "MODEL_MATRIX",
                tangent_by_ == by_matrix ? "" : as_normal,
                turn_tangent_ ? "" : "TANGENT_STAYS",
                0};
    }
    std::vector<Tile> tiles_of_view(glm::ivec2 size) const {
        constexpr std::array counts = {int(comparisons.size()), 1, int(turned_cubes.size())};
        if (view_ != compare) return tiles_of(size, counts[size_t(view_)]);
        const int below = show_ == half_and_half ? Labels::scale_height(size) : 0;
        return Labels::with_feet(size, tiles_of(size, counts[compare], below), 2, 28);
    }
    bool has_differences(const Probe& probe) const { return view_ == compare && show_ == half_and_half && !probe; }

    frames::Shape shape() const { return view_ == turned ? frames::Shape::cube : frames::Shape(shape_); }
    float turn() const { return view_ == turned ? 0 : turn_; }
    glm::dvec3 scaling() const { return view_ == turned ? glm::dvec3(1) : glm::dvec3(scale_) * std::pow(10.0, size_); }
    glm::dmat4 rotation(const Way& way) const {
        return glm::rotate(glm::dmat4(1), glm::radians(double(rotate_) + way.degrees), glm::dvec3(0, 1, 0));
    }
    glm::dmat4 world_from_model(const Way& way) const {
        const glm::dmat4 scaled = glm::scale(rotation(way), scaling());
        return shape() == frames::Shape::column ? glm::translate(scaled, glm::dvec3(0, -frames::column.height / 2, 0))
                                                : scaled;
    }

    void draw_surface(const Frame& frame, const Tile& tile, const Way& way) const {
        glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y);
        const bool map = normals_from_ == from_map;
        // Without a scaling, both orders apply the rotation alone.
        const Define order = order_ == 1 && scaling() != glm::dvec3(1) ? "ONE_BY_ONE" : "";
        const Program& surface =
            map ? surface_.with({frame.probe, "NORMAL_MAP", way.frame, way.normals, way.tangent, way.turn,
                                 turn() != 0 ? "TURNED" : "", light_in_ == tangent_space ? "IN_TANGENT_SPACE" : "",
                                 troubles.define(trouble_), order})
                : surface_.with({frame.probe, way.normals, order});
        glUseProgram(surface);
        surface.set("u_clip_from_world", frame.camera.clip_from_world());
        surface.set("u_world_from_model", world_from_model(way));
        surface.set("u_scaling", scaling());
        surface.set("u_rotation", glm::mat3(rotation(way)));
        surface.set("u_eye", frame.camera.eye());
        surface.set("u_light", lamp_at(light_yaw_, light_distance_, light_height_));
        surface.set("u_strength", strength_);
        surface.set("u_turn", glm::radians(turn()));
        surface.set("s_normals", 0,
                    map_ == bricks     ? bricks_
                    : map_ == own      ? own_texture()
                    : has_model_maps() ? own_maps_.first()
                                       : texel_);
        const GpuMesh& mesh = uploaded_mesh();
        glBindVertexArray(mesh.layout());
        if (map && has_model_maps() && shape() == frames::Shape::own)
            own_maps_.draw();
        else
            glDrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
    }

    std::vector<double> inputs_of_normals() const {
        return {double(shape_),
                double(normals_from_),
                double(map_),
                double(trouble_),
                double(order_),
                strength_,
                turn_,
                rotate_,
                scale_.x,
                scale_.y,
                scale_.z,
                double(size_),
                double(own_mesh_.version()),
                double(own_.version())};
    }

    /// Shows on half of a mistake's tile how far its normals are from those of the right way, and writes their mean.
    void draw_difference(const Frame& frame, const Tile& tile, size_t i) {
        Frame numbers = frame_in(frame, tile);
        numbers.probe = {"normal", MissingTask::told};
        const auto draw = [&](const Frame& part, const Way& way) { draw_surface(part, {{0, 0}, part.size}, way); };
        difference_.draw(
            frame, tile, tile.size.x / 2, [&] { draw(numbers, comparisons[i]); },
            [&] { draw(numbers, comparisons[0]); });
        const ErrorSummary& off = off_[i].get({inputs_of_normals(), frame.camera.orbit(), surface_.renewals()}, [&] {
            Frame small = frame_in(numbers, {{0, 0}, {128, 128}});
            const auto normals = [&](const Way& way) { return draw_numbers(small.size, [&] { draw(small, way); }); };
            return summarize(error_image(normals(comparisons[i]), normals(comparisons[0]), ErrorMetric::angle));
        });
        if (off.count > 0) labels_.caption(frame.size, tile, -1, fmt::format("{}~ off", rounded(off.mean)));
    }

    Mesh mesh() const {
        switch (shape()) {
            case frames::Shape::sphere:
                return make_sphere(frames::sphere);
            case frames::Shape::column:
                return make_column(frames::column);
            case frames::Shape::wall:
                return frames::make_mirrored_wall();
            case frames::Shape::cube:
                return make_box(frames::cube);
            case frames::Shape::own:
                break;
        }
        return own_mesh_.mesh_with_tangents();
    }
    const GpuMesh& uploaded_mesh() const {
        return meshes_[size_t(shape())].get({own_mesh_.version()},
                                            [this] { return upload([this] { return mesh(); }); });
    }

    const Texture& own_texture() const {
        return own_texture_.get({own_.version()},
                                [this] { return Texture("own map", [this] { return own_.image(); }); });
    }
    bool has_model_maps() const { return map_ == of_model && !own_mesh_.normal_maps().empty(); }
    static Image flat_texel() {
        Image image(1, 1, 3);
        image.values = {0.5f, 0.5f, 1};
        return image;
    }

    Programs surface_{"06_tangent_space/surface.vert", "06_tangent_space/surface.frag"};
    Texture bricks_ = load_texture("bricks_normal.png", ColorSpace::linear);
    Texture texel_{"a flat texel", flat_texel};
    OwnPicture own_{normals_in};
    mutable Kept<Texture, int> own_texture_;  ///< by the picture
    OwnMesh own_mesh_{1.25};
    OwnMaps own_maps_{own_mesh_};
    mutable std::array<Kept<GpuMesh, int>, 5> meshes_;  ///< for each shape, by the version of the own model
    DifferenceMap difference_{ErrorMetric::angle, -1, 2};
    /// One for each tile. The inputs are inputs_of_normals(), camera, and how often programs were renewed.
    std::array<Kept<ErrorSummary, std::vector<double>, Orbit, int>, comparisons.size()> off_;
    Studio studio_;
    Labels labels_;

    int view_ = compare, show_ = half_and_half, shape_ = 0, normals_from_ = from_map, map_ = bricks,
        light_in_ = world_space, size_ = 0, trouble_ = none, order_ = 0, tangent_by_ = by_matrix;
    bool gram_schmidt_ = true, inverse_transpose_ = true, turn_tangent_ = true;
    glm::vec3 scale_{1.35f, 0.75f, 0.9f};
    float strength_ = 1, turn_ = 60, rotate_ = 0, light_yaw_ = -40, light_height_ = 2.2f, light_distance_ = 3;
};

RELIEF_LAB(TangentSpace);

}  // namespace relief
