// Lab 07: baking.
//
// Normals of a fine model in a map for a coarse one: the ray of a texel, its hit, the frame in which the normal is
// stored, and the padding around it. Your tasks: shaders/07_baking/task.glsl
#include <fmt/format.h>

#include "cut.h"
#include "framework/kit/labels.h"
#include "framework/kit/light.h"
#include "framework/kit/tiles.h"
#include "framework/lab/lab.h"
#include "truth.h"

namespace relief::baking {

class Baking final : public Lab {
public:
    void draw(const Frame& frame) override {
        const std::vector<View> views = views_of(frame);
        // Bakes first: they change the framebuffer.
        std::vector<const Baked*> baked;
        for (const View& view : views)
            baked.push_back(view.sight.shown == Shown::mapped || view.draws != Draws::model
                                ? &baker_.bake(view.sight.recipe)
                                : nullptr);
        const bool wants_report = !frame.probe && (view_ == map || view_ == rays);
        const Baked::Report report = wants_report ? baker_.report(*baked[0]) : Baked::Report{};
        const bool shows_cut = view_ == rays && !frame.probe;
        const std::vector<CutLine> no_lines, &lines = shows_cut ? cut_of(*baked[0]) : no_lines;
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        for (size_t i = 0; i < views.size(); ++i) {
            const View& view = views[i];
            if (view.draws == Draws::model)
                draw_model(frame_in(frame, view.tile), view, baked[i]);
            else if (view.draws == Draws::map)
                draw_map(frame, view.tile, *baked[i]);
            else if (view.draws == Draws::cover)
                glViewport(0, 0, frame.size.x, frame.size.y), baker_.draw_cover(view.sight.recipe);
            else if (shows_cut)
                draw_cut(view.tile, lines);
            if (!view.title.empty()) labels_.caption(frame.size, view.tile, 0, view.title);
        }
        if (wants_report) describe(frame.size, views[0].tile, report);
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        knobs.group("Picture");
        knobs.choice("view", view_, views_,
                     "all models, the cube by every frame, a cut with its rays, the map, or one model");
        knobs.choice("shape", shape_, shapes, "the model: an ammonite, one in a mirror, or a cube");
        knobs.choice("wears", wears_, wears, "for view = one: the coarse model with its map, without, or the fine one");
        knobs.slider("cut", cut_, 0, 1, "for view = rays: where the cut is, in turns");
        knobs.group("Bake");
        knobs.choice("map", space_, spaces, "space of the map's normals");
        knobs.choice("bake_frame", bake_frame_, bake_frames, "frame in which the bake stores a normal");
        knobs.choice("frame", frame_, frames, "frame in which the renderer reads it");
        knobs.choice("diagonal", diagonal_, diagonals, "the renderer cuts quads as the bake did, or the other way");
        knobs.choice("rays", ray_normals_, ray_normals, "direction of a ray: the interpolated normal, or the face's");
        knobs.choice("take", take_, takes, "which hit counts: the nearest to the coarse model, the first, or the last");
        knobs.slider("reach", reach_, 0, 0.6f, "distance of the cage, in radii of the tube");
        knobs.group("Shell");
        knobs.slider("gap", gap_, 0, 0.4f, "free space between the whorls, in radii of the tube");
        knobs.toggle("cord", cord_, "a cord that winds above the last whorl without touching it");
        knobs.group("Map");
        knobs.choice("islands", islands_, islands, "strips of the map side by side, or two of them in one place");
        knobs.choice("map_size", size_, sizes, "side of the map, texels");
        knobs.choice("bits", bits_, bit_counts, "bits of each channel of the map");
        knobs.steps("padding", padding_, 0, 16, "texels by which the map goes on around its islands");
        knobs.choice("level", level_, levels, "mip level of the map that is read");
        knobs.group("Models");
        knobs.choice("low", low_, lows, "triangles of the coarse model");
        knobs.choice("high", high_, highs, "triangles of the fine model");
        light_.knobs(knobs);
    }

    std::optional<Image> truth(const Frame& frame, const Probe& probe) const override {
        const std::vector<View> views = views_of(frame);
        if (probe.name != "normal") return map_truth(frame, probe, views[0].sight.recipe);
        std::vector<Tile> tiles;
        for (const View& view : views) tiles.push_back(view.tile);
        return truth_in_tiles(frame, tiles, [&](const Frame& part, size_t i) -> std::optional<Image> {
            if (views[i].draws == Draws::model) return normal_truth(part, views[i].sight);
            Image nothing(part.size.x, part.size.y, 4);
            std::fill(nothing.values.begin(), nothing.values.end(), no_surface);
            return nothing;
        });
    }

private:
    enum ViewKind { compare, cube, rays, map, one };
    static constexpr std::array views_ = {"compare", "cube", "rays", "map", "one"};
    static constexpr std::array shapes = {"ammonite", "mirrored", "cube"};
    static constexpr std::array wears = {"map", "nothing", "high"};
    static constexpr std::array spaces = {"tangent", "object"};
    static constexpr std::array bake_frames = {"interpolated", "each-unit", "gram-schmidt"};
    static constexpr std::array frames = {"interpolated", "each-unit", "gram-schmidt", "vertex-bitangent"};
    static constexpr std::array diagonals = {"same", "other"};
    static constexpr std::array ray_normals = {"smooth", "face"};
    static constexpr std::array takes = {"nearest", "first", "last"};
    static constexpr std::array islands = {"apart", "overlapping"};
    static constexpr std::array sizes = {"64", "128", "256", "512", "1024"};
    static constexpr std::array bit_counts = {"8", "16", "float"};
    static constexpr std::array levels = {"mip", "0", "1", "2", "3", "4", "5"};
    static constexpr std::array lows = {"100", "500", "2000"};
    static constexpr std::array highs = {"16k", "131k", "1M"};

    enum class Draws { model, map, cover, cut };
    struct View {
        Tile tile;
        Draws draws = Draws::model;
        Sight sight;
        int frame = 0;
        std::string title;
    };

    Recipe recipe(Shape shape) const {
        Recipe recipe;
        recipe.model = {shape, gap_};
        recipe.high = high_, recipe.low = low_, recipe.cord = cord_;
        recipe.overlapping = islands_ == 1, recipe.object_space = space_ == 1, recipe.rays_of_face = ray_normals_ == 1;
        recipe.frame = bake_frame_, recipe.take = take_, recipe.reach = reach_;
        recipe.size = 64 << size_, recipe.bits = bits_, recipe.padding = padding_;
        if (shape == Shape::cube) {  // resets settings without effect on the cube, so that they do not cause a bake
            recipe.high = 0, recipe.low = 0, recipe.cord = recipe.overlapping = false, recipe.model.gap = 0;
        }
        return recipe;
    }

    static int triangles_of(Fineness fineness, int pieces) { return fineness.columns * fineness.sides * 2 * pieces; }
    int low_triangles() const { return triangles_of(low_finenesses[size_t(low_)], whorls); }
    int high_triangles() const { return triangles_of(high_finenesses[size_t(high_)], 1); }

    /// Returns the views of the picture, each in its tile. A probe of the map has one view.
    std::vector<View> views_of(const Frame& frame) const {
        const Shape chosen = Shape(shape_);
        const Tile whole{{0, 0}, frame.size};
        if (frame.probe && frame.probe.name != "normal")
            return {{whole, frame.probe.name == "cover" ? Draws::cover : Draws::map, {recipe(chosen)}, 0, ""}};
        if (view_ == one)
            return {{whole, Draws::model, {recipe(chosen), Shown(2 - wears_), diagonal_ == 1}, frame_, ""}};
        if (view_ == map) return {{whole, Draws::map, {recipe(chosen)}, 0, ""}};
        if (view_ == rays) return {{whole, Draws::cut, {recipe(chosen)}, 0, ""}};
        std::vector<View> views;
        const auto add = [&](Draws draws, Shape shape, Shown shown, int read_in, std::string title) {
            views.push_back({{}, draws, {recipe(shape), shown, diagonal_ == 1}, read_in, std::move(title)});
        };
        if (view_ == cube) {
            for (size_t i = 0; i < frames.size(); ++i) add(Draws::model, Shape::cube, Shown::mapped, int(i), frames[i]);
        } else {
            const Shape shape = chosen == Shape::cube ? Shape::ammonite : chosen;
            add(Draws::model, shape, Shown::high, 0, fmt::format("{} triangles", high_triangles()));
            add(Draws::model, shape, Shown::low, 0, std::to_string(low_triangles()));
            add(Draws::model, shape, Shown::mapped, frame_, fmt::format("{} and a map", low_triangles()));
            add(Draws::model, Shape::cube, Shown::mapped, bake_frame_, "flat: one frame");
            add(Draws::model, Shape::cube, Shown::mapped, bake_frame_ == 2 ? 0 : 2, "another frame");
            add(Draws::map, shape, Shown::nothing, 0, "the map");
        }
        const std::vector<Tile> tiles = tiles_of(frame.size, int(views.size()));
        for (size_t i = 0; i < views.size(); ++i) views[i].tile = tiles[i];
        return views;
    }

    void draw_model(const Frame& frame, const View& view, const Baked* baked) {
        const auto& [recipe, shown, other_diagonal] = view.sight;
        glViewport(view.tile.corner.x, view.tile.corner.y, view.tile.size.x, view.tile.size.y);
        const bool has_map = shown == Shown::mapped, is_cube = recipe.model.shape == Shape::cube;
        const Define mirror = is_cube && !frame.probe ? "MIRROR" : "";
        const Program& surface =
            !has_map ? surface_.with({frame.probe, mirror})
            : recipe.object_space
                ? surface_.with({frame.probe, mirror, "MAP", level_ > 0 ? "ONE_LEVEL" : "", "OBJECT_SPACE"})
                : surface_.with(
                      {frame.probe, mirror, "MAP", level_ > 0 ? "ONE_LEVEL" : "", frame_defines[size_t(view.frame)]});
        glUseProgram(surface);
        surface.set("u_clip_from_world", frame.camera.clip_from_world());
        surface.set("u_eye", frame.camera.eye());
        surface.set("u_to_light", light_.direction());
        if (has_map) {
            surface.set("s_map", 0);
            surface.set("u_level", float(std::max(0, level_ - 1)));
            baked->map.bind(0);
        }
        const GpuMesh& mesh = shown == Shown::high ? baker_.high(recipe).uploaded : baker_.low(recipe, other_diagonal);
        glBindVertexArray(mesh.layout());
        glDrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
    }

    /// Draws the map: over the whole frame for a probe, and otherwise in the largest square of the tile.
    void draw_map(const Frame& frame, const Tile& tile, const Baked& baked) {
        if (frame.probe.name == "normal") return;
        glm::vec4 window(0, 0, frame.size);
        if (!frame.probe) {
            const float side = float(std::min(tile.size.x, tile.size.y));
            window = glm::vec4(glm::vec2(tile.corner) + (glm::vec2(tile.size) - side) / 2.0f, side, side);
        }
        const glm::ivec4 pixels(window);
        glViewport(pixels.x, pixels.y, pixels.z, pixels.w);
        const Program& program = map_.with(frame.probe);
        glUseProgram(program);
        program.set("s_map", 0);
        program.set("s_texels", 1);
        program.set("s_hits", 2);
        program.set("u_window", window);
        program.set("u_level", float(std::max(0, level_ - 1)));
        baked.texels.bind(2, 1);
        baked.texels.bind(1, 0);
        baked.map.bind(0);
        draw_triangles(nothing_, 3);
    }

    static void draw_triangles(std::optional<VertexArrayName>& layout, GLsizei count) {
        if (!layout) layout.emplace();
        glDisable(GL_DEPTH_TEST);
        glBindVertexArray(*layout);
        glDrawArrays(GL_TRIANGLES, 0, count);
        glEnable(GL_DEPTH_TEST);
    }

    const std::vector<CutLine>& cut_of(const Baked& baked) {
        return cut_lines_.get({baked.recipe, baked.programs, cut_}, [&] {
            return cut_lines(baked.recipe, baker_.high(baked.recipe).mesh, baked.texels.read(1), cut_);
        });
    }

    void draw_cut(const Tile& tile, const std::vector<CutLine>& lines) {
        struct Corner {
            glm::vec2 place;
            glm::vec4 color;
        };
        // Centres the whole section in the tile.
        glm::vec2 low(INFINITY), high(-INFINITY);
        for (const CutLine& line : lines)
            low = glm::min(low, glm::min(line.from, line.to)), high = glm::max(high, glm::max(line.from, line.to));
        const glm::vec2 size(tile.size), extent = glm::max(high - low, 1e-6f);
        const float scale = 0.84f * std::min(size.x / extent.x, size.y / extent.y);
        const float line_width = std::max(1.0f, 0.003f * std::min(size.x, size.y));
        std::vector<Corner> corners;
        for (const CutLine& line : lines) {
            const glm::vec2 a = (line.from - (low + high) / 2.0f) * scale, b = (line.to - (low + high) / 2.0f) * scale;
            const float length = glm::length(b - a);
            if (!(length > 0)) continue;
            const glm::vec2 aside = glm::vec2(a.y - b.y, b.x - a.x) / length * (0.5f * line_width * line.width);
            const glm::vec2 places[] = {a - aside, b - aside, b + aside, a - aside, b + aside, a + aside};
            for (const glm::vec2 place : places) corners.push_back({place / size * 2.0f, glm::vec4(line.color, 1)});
        }
        if (corners.empty()) return;
        if (!lines_) {
            lines_.emplace();
            glBindVertexArray(lines_->layout);
            glBindBuffer(GL_ARRAY_BUFFER, lines_->corners);
            for (const GLuint location : {0u, 1u}) glEnableVertexAttribArray(location);
            glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(Corner), nullptr);
            glVertexAttribPointer(1, 4, GL_FLOAT, GL_FALSE, sizeof(Corner),
                                  reinterpret_cast<const void*>(offsetof(Corner, color)));
        }
        glBindBuffer(GL_ARRAY_BUFFER, lines_->corners);
        glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(corners.size() * sizeof(Corner)), corners.data(), GL_STREAM_DRAW);
        glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y);
        glUseProgram(line_program_.with());
        glDisable(GL_DEPTH_TEST);
        glBindVertexArray(lines_->layout);
        glDrawArrays(GL_TRIANGLES, 0, GLsizei(corners.size()));
        glEnable(GL_DEPTH_TEST);
    }

    /// Writes the results of the rays, and which settings make them wrong.
    void describe(glm::ivec2 size, const Tile& tile, const Baked::Report& report) {
        const Recipe recipe = this->recipe(Shape(shape_));
        labels_.caption(size, tile, 0,
                        report.unwritten > 0
                            ? fmt::format("task 7.{} is not written yet: no ray has a hit", report.unwritten)
                            : fmt::format("{:.1f} % of the texels meet nothing, {:.1f} % another part",
                                          100 * report.missed, 100 * report.wrong));
        const double needed = reach_needed(recipe.model, low_finenesses[size_t(recipe.low)]);
        if (double(recipe.reach) < needed)
            labels_.caption(size, tile, -1,
                            fmt::format("a reach of {:.2f} may be too short: {:.2f}", recipe.reach, needed),
                            {1.0f, 0.62f, 0.45f});
        if (report.covered_twice > 0)
            labels_.caption(size, tile, -2, fmt::format("{} texels belong to two triangles", report.covered_twice),
                            {1.0f, 0.62f, 0.45f});
    }

    struct Lines {
        VertexArrayName layout;
        BufferName corners;
    };
    Programs surface_{"07_baking/surface.vert", "07_baking/surface.frag"};
    Programs map_{"07_baking/window.vert", "07_baking/map.frag"};
    Programs line_program_{"07_baking/lines.vert", "07_baking/lines.frag"};
    Baker baker_;
    std::optional<VertexArrayName> nothing_;
    std::optional<Lines> lines_;
    Kept<std::vector<CutLine>, Recipe, std::array<GLuint, 3>, float> cut_lines_;
    Labels labels_;

    int view_ = compare, shape_ = 0, wears_ = 0, space_ = 0, bake_frame_ = 0, frame_ = 0, diagonal_ = 0;
    int ray_normals_ = 0, take_ = 0, islands_ = 0, size_ = 2, bits_ = 1, padding_ = 8, level_ = 0, low_ = 1, high_ = 0;
    float reach_ = 0.42f, gap_ = 0.12f, cut_ = 0.62f;
    DistantLight light_{.yaw = -75, .pitch = 30};
    bool cord_ = false;
};

RELIEF_LAB(Baking);

}  // namespace relief::baking
