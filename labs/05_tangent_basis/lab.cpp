// Lab 05: the tangent basis.
//
// Bricks on a coarse mesh, by the tangents of each method, with the angle to dP/du as a heat map, and frames as
// lines; or by ways to complete T and N to a frame. Your tasks: labs/05_tangent_basis/task.cpp and
// shaders/05_tangent_basis/task.glsl
#include <fmt/format.h>

#include <map>

#include "framework/core/base/error.h"
#include "framework/core/base/text.h"
#include "framework/core/gl/vertex_stream.h"
#include "framework/core/image/compare.h"
#include "framework/core/lab/lab.h"
#include "framework/library/kit/drawn_numbers.h"
#include "framework/library/kit/kept.h"
#include "framework/library/kit/labels.h"
#include "framework/library/kit/light.h"
#include "framework/library/kit/own_mesh.h"
#include "framework/library/kit/studio.h"
#include "framework/library/kit/tiles.h"
#include "framework/library/maps/own_picture.h"
#include "shapes.h"
#include "truth.h"
#include "vertex_tangents.h"

namespace relief::basis {

class TangentBasis final : public Lab {
public:
    void draw(const Frame& frame) override {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        const auto tiles = tiles_of_view(frame.size);
        for (size_t i = 0; i < tiles.size(); ++i) {
            if (view_ == frames) {
                draw_frame_kind(frame, tiles[i], frame_kind_of(i));
            } else {
                const int method = method_of(i);
                draw_surface(frame_in(frame, tiles[i]), tiles[i], method);
                labels_.caption(frame.size, tiles[i], 0, methods.names[size_t(method)] + distance_from_file(method));
            }
            studio_.draw(frame_in(frame, tiles[i]), tiles[i],
                         {double(shape_), double(columns_), double(rows_), jitter_, double(own_.version())},
                         [this] { return plain_mesh(); });
        }
        labels_.notes(notes_of_files(*this));
        if (has_scale()) labels_.scale(frame.size, "0.01~", "100~", 4);
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        knobs.group("Picture");
        knobs.choice("view", view_, views.names,
                     "the methods side by side, or one of them, or ways to complete T and N to a frame");
        knobs.choice("method", method_, methods.names,
                     KnobHelp("source of the tangent; file: of a glTF file, else as analytic").only("view", {"one"}));
        knobs.choice("frame", frame_, frame_kinds.names,
                     KnobHelp("B by w and a cross product, averaged as T, the three made orthogonal in the "
                              "shader, or a frame by the normal alone")
                         .only("view", {"frames"}));
        knobs.choice_or_file("shape", shape_, own_, shapes.names, "shape with the bricks");
        knobs.choice("show", show_, shows.names,
                     "the light, the angle to the exact dP/du (frames: of B to dP/dv), or half of each");
        knobs.toggle(
            "lines", lines_,
            KnobHelp("draw the frames: tangent red, bitangent green, normal blue; a file of many vertices has none")
                .titled("Lines of frames"));
        knobs.slider("line_length", line_length_, 2, 60, KnobHelp("length of the drawn axes").in("pixels"));
        knobs.group("Mesh");
        knobs.steps("columns", columns_, 3, 64, "cells of the mesh around the shape");
        knobs.steps("rows", rows_, 2, 64, "cells of the mesh from bottom to top");
        knobs.slider("jitter", jitter_, 0, 1, "random shift of the vertices");
        knobs.slider("shear", shear_, -1, 1,
                     KnobHelp("shear of its texture: how much v grows along x").only("shape", {"quad"}));
        knobs.toggle("collapsed", collapsed_,
                     KnobHelp("set all u to 0: no triangle has an area in uv").titled("Collapsed u"));
        knobs.group("Light");
        knobs.slider("light_yaw", light_yaw_, -180, 180,
                     KnobHelp("direction of the light around the shape").in("degrees"));
    }

    std::optional<Image> truth(const Frame& frame) const override {
        if (shape() == Shape::urn || is_own() || collapsed_) return {};
        const CoarseMesh mesh = coarse();
        return truth_in_tiles(frame, tiles_of_view(frame.size),
                              [&](const Frame& part, size_t) { return basis::truth(part, mesh, shape(), shear_); });
    }

private:
    enum View { every, one, frames };
    static constexpr auto views = choices<View>({{every, "every"}, {one, "one"}, {frames, "frames"}});
    enum FrameKind { every_frame, by_w, averaged, orthogonal, normal_alone };
    enum Show { half_and_half, light, error_map };
    static constexpr auto frame_kinds = choices<FrameKind>({{every_frame, "every"},
                                                            {by_w, "w"},
                                                            {averaged, "averaged", "AVERAGED"},
                                                            {orthogonal, "orthogonal", "ORTHOGONAL"},
                                                            {normal_alone, "normal-alone", "NORMAL_ALONE"}});
    static constexpr auto shows =
        choices<Show>({{half_and_half, "half-and-half"}, {light, "light"}, {error_map, "error"}});
    /// The last is not of an own model, which may have tangents in its file instead.
    static constexpr std::array side_by_side = {per_face, uniform, area, angle, derivatives, analytic};

    static constexpr size_t most_lined_vertices = 1000;  ///< of an own model; more frames would hide it

    Shape shape() const { return Shape(shape_); }
    /// An own model has no formula: neither an analytic tangent nor an error.
    bool is_own() const { return shape() == Shape::own; }
    bool shows_light_only() const { return show_ == light || is_own() || (view_ == frames && !has_frame_formula()); }
    /// B of the urn has no formula, and collapsed uv have no direction.
    bool has_frame_formula() const { return !is_own() && shape() != Shape::urn && !collapsed_; }
    CoarseMesh coarse() const { return coarse_mesh(shape(), columns_, rows_, jitter_, shear_); }
    bool has_scale() const { return !shows_light_only(); }
    std::vector<Tile> tiles_of_view(glm::ivec2 size) const {
        const int count = view_ == frames ? (frame_ == every_frame ? int(frame_kinds.size()) - 1 : 1)
                          : view_ == one  ? 1
                                          : int(side_by_side.size()) - (is_own() && !own_.has_tangents());
        return tiles_of(size, count, has_scale() ? Labels::scale_height(size) : 0);
    }
    FrameKind frame_kind_of(size_t tile) const { return FrameKind(frame_ == every_frame ? int(tile) + 1 : frame_); }
    int method_of(size_t tile) const {
        const int method = view_ == one ? method_ : side_by_side[tile];
        return view_ == every && is_own() && method == analytic ? of_file : method;
    }

    /// Returns how far a method is from the tangents of an own model's file, on average over all corners.
    std::string distance_from_file(int method) {
        if (!is_own() || !own_.has_tangents() || method == of_file || method == derivatives || collapsed_) return "";
        auto& distances = distances_.get({own_.version()}, [] { return std::map<int, std::string>(); });
        if (const auto found = distances.find(method); found != distances.end()) return found->second;
        const auto [degrees, mirrored] = difference_of(own_.mesh(), make(method));
        std::string text = fmt::format(": {} degrees from the file", rounded(degrees));
        if (mirrored > 0) text += fmt::format(", {} corners mirrored", mirrored);
        return distances.try_emplace(method, std::move(text)).first->second;
    }

    Mesh plain_mesh() const {
        Mesh mesh = is_own() ? own_.mesh() : coarse().mesh;
        if (collapsed_)
            for (Vertex& vertex : mesh.vertices) vertex.uv.x = 0;
        return mesh;
    }
    Mesh make(int method, Axis axis = Axis::tangent) const {
        if (is_own() && method == analytic)
            throw Error("method=analytic needs a shape with a formula: an own model has none");
        if (is_own() && method == of_file && !own_.has_tangents())
            throw Error("method=file needs a glTF file with tangents and uv: export them, or choose another");
        return with_tangents(plain_mesh(), Method(method), axis);
    }
    using MeshInputs = std::tuple<int, int, int, float, float, bool, int>;
    MeshInputs mesh_inputs() const { return {shape_, columns_, rows_, jitter_, shear_, collapsed_, own_.version()}; }
    const GpuMesh& mesh_of(int method) {
        auto& meshes = meshes_.get({mesh_inputs()}, [] { return std::map<int, GpuMesh>(); });
        return meshes.try_emplace(method, upload([this, method] { return make(method); })).first->second;
    }

    /// Gives the mesh of method angle a B at each vertex: the mean of the triangles' B with the weights of T.
    void attach_bitangents() {
        const GpuMesh& mesh = mesh_of(angle);
        bitangents_.get({meshes_.version()}, [&] {
            std::vector<glm::vec3> directions;
            for (const Vertex& vertex : make(angle, Axis::bitangent).vertices) directions.emplace_back(vertex.tangent);
            VertexStream stream({{4, 3, GL_FLOAT, 0}});
            stream.fill(std::span<const glm::vec3>(directions));
            stream.attach(mesh.layout());
            return stream;
        });
    }

    void draw_frame_kind(const Frame& frame, const Tile& tile, FrameKind kind) {
        constexpr std::array titles = {"", "B = w (N x T)", "T and B averaged", "made orthogonal", "by N alone"};
        labels_.caption(frame.size, tile, 0, titles[size_t(kind)]);
        attach_bitangents();
        if (!frame.probe && has_frame_formula() && tile.size.x > 0 && tile.size.y > 0) {
            constexpr Tile measured{{0, 0}, {256, 256}};
            const Image drawn = draw_numbers(measured.size, [&] {
                draw_surface(frame_in(frame, measured), measured, angle, frame_kinds.define(kind), "MEASURE");
            });
            const auto mean = [&](int channel) {
                const double degrees = summarize(channels_of(drawn, channel, 1)).mean;
                return rounded(degrees < 5e-4 ? 0 : degrees);
            };
            labels_.caption(frame.size, tile, -1, fmt::format("T {}~ B {}~ off", mean(0), mean(1)));
        }
        draw_surface(frame_in(frame, tile), tile, angle, frame_kinds.define(kind));
    }

    void draw_surface(const Frame& frame, const Tile& tile, int method, const Define& kind = "",
                      const char* purpose = "") {
        glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y);
        const bool shows_solved = method == per_face && frame.probe.name == "dp_dv";
        const GpuMesh& mesh = mesh_of(shows_solved ? solved_bitangent : method);
        const bool is_round = shape() == Shape::sphere || shape() == Shape::mirrored;
        const Program& surface =
            surface_.with({frame.probe, shows_solved ? "SOLVED_BITANGENT" : methods.define(method),
                           exact_define(frame.probe), view_ == frames ? "FRAMES" : "",
                           view_ == frames && is_round && !frame.probe ? "ROUND" : "", kind, purpose});
        glUseProgram(surface);
        surface.set("u_clip_from_world", frame.camera.clip_from_world());
        surface.set("u_eye", frame.camera.eye());
        surface.set("u_light", lamp_at(light_yaw_, 3, 2.4f));
        surface.set("u_repeat", shape() == Shape::quad              ? glm::vec2(2)
                                : shape() == Shape::box || is_own() ? glm::vec2(1)
                                                                    : glm::vec2(4, 2));
        const float split = shows_light_only() ? 2.0f : show_ == half_and_half ? 0.5f : -1.0f;
        surface.set("u_split", float(tile.corner.x) + float(tile.size.x) * split);
        surface.set("u_shear", shear_);
        surface.set("s_albedo", 0, albedo_);
        surface.set("s_normals", 1, normals_);
        glBindVertexArray(mesh.layout());
        glDrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);

        const bool are_too_many = is_own() && own_.mesh().vertices.size() > most_lined_vertices;
        if (lines_ && !are_too_many && method != derivatives && view_ != frames && !frame.probe) {
            // Lines would hide the colours of the half with errors.
            const bool is_half = show_ == half_and_half && !shows_light_only();
            glEnable(GL_SCISSOR_TEST);
            glScissor(tile.corner.x, tile.corner.y, is_half ? tile.size.x / 2 : tile.size.x, tile.size.y);
            draw_lines(frame.camera, tile, mesh);
            glDisable(GL_SCISSOR_TEST);
        }
    }

    /// Returns the definition of the surface with which the shader compares. A probe shows no error.
    Define exact_define(const Probe& probe) const {
        if (probe || is_own() || (view_ != frames && shape() == Shape::torus)) return "";
        return shapes.define(shape_);
    }

    /// Draws the frames at the vertices of a mesh as lines, three instances of a vertex.
    void draw_lines(const Camera& camera, const Tile& tile, const GpuMesh& mesh) {
        const Program& lines = frames_.with();
        glUseProgram(lines);
        lines.set("u_clip_from_world", camera.clip_from_world());
        lines.set("u_size", glm::vec2(tile.size));
        lines.set("u_length", line_length_);
        lines.set("u_focal_pixels", tile.size.y / (2 * std::tan(glm::radians(camera.orbit().field_of_view) / 2)));
        const auto read_attributes_every = [](GLuint instances) {
            for (const GLuint attribute : {0, 1, 2}) glVertexAttribDivisor(attribute, instances);
        };
        glBindVertexArray(mesh.layout());
        read_attributes_every(3);
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, 3 * mesh.vertices());
        read_attributes_every(0);
    }

    Programs surface_{"05_tangent_basis/surface.vert", "05_tangent_basis/surface.frag"};
    Programs frames_{"05_tangent_basis/lines.vert", "05_tangent_basis/lines.frag"};
    Texture albedo_ = load_texture("bricks_albedo.png", ColorSpace::srgb);
    Texture normals_ = load_texture("bricks_normal.png", ColorSpace::linear);
    Kept<std::map<int, GpuMesh>, MeshInputs> meshes_;  ///< by method
    Kept<VertexStream, int> bitangents_;               ///< by the version of meshes_, to one of which it is attached
    Kept<std::map<int, std::string>, int> distances_;  ///< by method
    OwnMesh own_{box_half * std::sqrt(3.0)};
    Studio studio_;
    Labels labels_;

    int view_ = every, method_ = angle, frame_ = every_frame, shape_ = int(Shape::torus), show_ = half_and_half,
        columns_ = 24, rows_ = 12;
    bool lines_ = true, collapsed_ = false;
    float line_length_ = 14, jitter_ = 0.7f, shear_ = 0, light_yaw_ = 35;
};

RELIEF_LAB(TangentBasis);

}  // namespace relief::basis
