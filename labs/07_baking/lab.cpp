// Lab 07: baking.
//
// Normals of a fine model in a map for a coarse one: the ray of a texel, its hit, the frame in which the normal is
// stored, and the padding around it. Your tasks: shaders/07_baking/task.glsl
#include <fmt/format.h>

#include "cut.h"
#include "framework/core/base/error.h"
#include "framework/core/kit/labels.h"
#include "framework/core/kit/light.h"
#include "framework/core/kit/made_map.h"
#include "framework/core/kit/tiles.h"
#include "framework/core/lab/lab.h"
#include "truth.h"

namespace relief::baking {

class Baking final : public Lab, public MapMaker {
public:
    void draw(const Frame& frame) override {
        std::vector<View> views = views_of(frame);
        // Bakes and reads back first: that changes the framebuffer.
        for (View& view : views)
            if (view.needs_map()) view.baked = &baker_.bake(view.sight.recipe);
        std::optional<Baked::Report> report;
        if (!frame.probe && (view_ == map || view_ == rays)) report = baker_.report(*views[0].baked);
        if (!frame.probe && view_ == rays) views[0].cut = &cut_of(*views[0].baked);
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        for (const View& view : views) {
            draw_view(frame, view);
            if (!view.title.empty()) labels_.caption(frame.size, view.tile, 0, view.title);
        }
        if (report) describe(frame.size, views[0].tile, *report);
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        knobs.group("Picture");
        knobs.choice("view", view_, views_,
                     "all models, the cube or a file by every frame, a cut with its rays, the map, or one model");
        knobs.choice_or_file("shape", shape_, own_.coarse, shapes,
                             "the model: an ammonite, one in a mirror, or a cube");
        knobs.choice_or_file("fine", fine_, own_.fine, fines, "the fine model of a file: the file itself");
        knobs.choice("wears", wears_, wears,
                     "for view = one: the coarse model with its map, without, the fine one, or the map in its file");
        knobs.slider("cut", cut_, 0, 1, "for view = rays: where the cut is, in turns");
        knobs.group("Bake");
        knobs.choice("map", space_, spaces, "space of the map's normals");
        knobs.choice("bake_frame", bake_frame_, std::span(frames.names).first(bake_frames),
                     "frame in which the bake stores a normal");
        knobs.choice("frame", frame_, frames.names, "frame in which the renderer reads it");
        knobs.choice("diagonal", diagonal_, diagonals, "the renderer cuts quads as the bake did, or the other way");
        knobs.choice("rays", ray_normals_, ray_normals, "direction of a ray: the interpolated normal, or the face's");
        knobs.choice("take", take_, takes.names,
                     "which hit counts: the nearest to the coarse model, the first, or the last");
        knobs.slider("reach", reach_, 0, 0.6f, "distance of the cage, in radii of the tube");
        knobs.group("Shell");
        knobs.slider("gap", gap_, 0, 0.4f, "free space between the whorls, in radii of the tube");
        knobs.toggle("cord", cord_, "a cord that winds above the last whorl without touching it");
        knobs.group("Sculpting the fine model");
        knobs.slider("ribs", sculpt_.ribs, 0, 2, "height of the shell's ribs: a factor");
        knobs.slider("bulge", sculpt_.bulge, -0.3f, 0.3f, "height of a bulge on the last whorl, in radii of the tube");
        knobs.slider("dents", sculpt_.dents, 0, 0.2f, "depth of rows of dents, in radii of the tube");
        knobs.group("Map");
        knobs.choice("islands", islands_, islands, "strips of the map side by side, or two of them in one place");
        knobs.choice("map_size", size_, sizes, "side of the map, texels");
        knobs.choice("bits", bits_, bit_counts, "bits of each channel of the map");
        knobs.steps("padding", padding_, 0, 16, "texels by which the map goes on around its islands");
        knobs.choice("level", level_, levels, "mip level of the map that is read");
        knobs.group("Models");
        knobs.choice("low", low_, low_names, "triangles of the coarse model");
        knobs.choice("high", high_, high_names, "triangles of the fine model");
        light_.knobs(knobs);
    }

    std::optional<Image> truth(const Frame& frame, const Probe& probe) const override {
        if (Shape(shape_) == Shape::own && fine_ == 0) return {};  // nothing to compare with
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

    /// Returns the baked map of the chosen shape.
    std::optional<Image> made_map() override {
        const Image stored = baker_.bake(recipe(Shape(shape_))).map.read();
        Image normals(stored.width, stored.height, 3);
        for (size_t i = 0; i < stored.pixel_count(); ++i) {
            // The map marks the texels of unfinished tasks.
            if (stored.values[4 * i + 3] < 0.9f) throw Error("the map is not written yet: see the tasks of this lab");
            std::copy_n(&stored.values[4 * i], 3, &normals.values[3 * i]);
        }
        return normals;
    }

private:
    enum ViewKind { compare, cube, rays, map, one };
    static constexpr std::array views_ = {"compare", "cube", "rays", "map", "one"};
    static constexpr std::array shapes = {"ammonite", "mirrored", "cube"};
    static constexpr std::array wears = {"map", "nothing", "high", "file"};
    static constexpr std::array fines = {"itself"};
    static constexpr std::array spaces = {"tangent", "object"};
    static constexpr std::array diagonals = {"same", "other"};
    static constexpr std::array ray_normals = {"smooth", "face"};
    static constexpr std::array islands = {"apart", "overlapping"};
    static constexpr std::array sizes = {"64", "128", "256", "512", "1024"};
    static constexpr std::array levels = {"mip", "0", "1", "2", "3", "4", "5"};

    enum class Draws { model, map, cover, cut };
    struct View {
        Tile tile{};
        Draws draws = Draws::model;
        Sight sight{};
        int frame = interpolated;  ///< the renderer's
        std::string title{};
        bool wears_file = false;  ///< the normal map in the model's file instead of the baked one
        const Baked* baked = nullptr;
        const std::vector<CutLine>* cut = nullptr;

        bool needs_map() const { return (sight.shown == Shown::mapped && !wears_file) || draws != Draws::model; }
    };

    Recipe recipe(Shape shape) const {
        Recipe recipe{.model = {shape, gap_},
                      .high = high_,
                      .low = low_,
                      .cord = cord_,
                      .overlapping = islands_ == 1,
                      .object_space = space_ == 1,
                      .rays_of_face = ray_normals_ == 1,
                      .frame = bake_frame_,
                      .take = take_,
                      .reach = reach_,
                      .size = 64 << size_,
                      .bits = bits_,
                      .padding = padding_,
                      .sculpt = sculpt_};
        // Resets settings without effect on the cube or a file, so that they do not cause a bake.
        if (!recipe.is_ammonite()) {
            recipe.high = 0, recipe.low = 0, recipe.cord = recipe.overlapping = false, recipe.model.gap = 0;
            recipe.sculpt = {};
        }
        if (shape == Shape::own)
            recipe.own = &own_, recipe.has_fine = fine_ == 1,
            recipe.version = own_.coarse.version() + own_.fine.version();
        return recipe;
    }

    static size_t triangles_of(Fineness fineness, int pieces) {
        return size_t(fineness.columns * fineness.sides * 2 * pieces);
    }
    static size_t triangles_of(const OwnMesh& own) { return own.mesh().indices.size() / 3; }
    size_t low_triangles() const {
        return is_own() ? triangles_of(own_.coarse) : triangles_of(low_finenesses[size_t(low_)], whorls);
    }
    size_t high_triangles() const {
        return !is_own() ? triangles_of(high_finenesses[size_t(high_)], 1)
                         : triangles_of(fine_ == 1 ? own_.fine : own_.coarse);
    }
    bool is_own() const { return Shape(shape_) == Shape::own; }
    bool has_file_map() const { return is_own() && own_.coarse.normal_map(); }

    /// Returns the views of the picture, each in its tile. A probe of the map has one view.
    std::vector<View> views_of(const Frame& frame) const {
        const Shape chosen = Shape(shape_);
        std::vector<View> views;
        if (frame.probe && frame.probe.name != "normal")
            views = {{.draws = frame.probe.name == "cover" ? Draws::cover : Draws::map, .sight = {recipe(chosen)}}};
        else if (view_ == one)
            views = {worn_view(chosen)};
        else if (view_ == map)
            views = {{.draws = Draws::map, .sight = {recipe(chosen)}}};
        else if (view_ == rays)
            views = {{.draws = Draws::cut, .sight = {recipe(chosen)}}};
        else
            views = view_ == cube ? cubes() : models(chosen == Shape::cube ? Shape::ammonite : chosen);
        const std::vector<Tile> tiles = tiles_of(frame.size, int(views.size()));
        for (size_t i = 0; i < views.size(); ++i) views[i].tile = tiles[i];
        return views;
    }

    View view_of_model(Shape shape, Shown shown, int read_in, std::string title) const {
        return {.sight = {recipe(shape), shown, diagonal_ == 1}, .frame = read_in, .title = std::move(title)};
    }

    View worn_view(Shape shape) const {
        constexpr std::array shown = {Shown::mapped, Shown::low, Shown::high, Shown::mapped};
        View view = view_of_model(shape, shown[size_t(wears_)], frame_, "");
        view.wears_file = wears_ == 3 && is_own();
        if (view.wears_file && !own_.coarse.normal_map())
            throw Error("wears=file needs a glTF file with a normal map: choose wears=map to bake one");
        return view;
    }

    /// Returns the cube, or a file with its own map, by each of the renderer's frames.
    std::vector<View> cubes() const {
        std::vector<View> views;
        for (size_t i = 0; i < frames.size(); ++i) {
            views.push_back(view_of_model(is_own() ? Shape::own : Shape::cube, Shown::mapped, int(i), frames.names[i]));
            views.back().wears_file = has_file_map();
        }
        return views;
    }

    std::vector<View> models(Shape shape) const {
        const int other_frame = bake_frame_ == gram_schmidt ? interpolated : gram_schmidt;
        std::vector<View> views = {
            view_of_model(shape, Shown::high, interpolated, fmt::format("{} triangles", high_triangles())),
            view_of_model(shape, Shown::low, interpolated, std::to_string(low_triangles())),
            view_of_model(shape, Shown::mapped, frame_, fmt::format("{} and a map", low_triangles())),
            view_of_model(Shape::cube, Shown::mapped, bake_frame_, "flat: one frame"),
            view_of_model(Shape::cube, Shown::mapped, other_frame, "another frame"),
            {.draws = Draws::map, .sight = {recipe(shape), Shown::nothing}, .title = "the map"}};
        if (has_file_map()) {
            views[3] = view_of_model(shape, Shown::mapped, interpolated, "its file's map: interpolated");
            views[4] = view_of_model(shape, Shown::mapped, gram_schmidt, "its file's map: gram-schmidt");
            views[3].wears_file = views[4].wears_file = true;
        }
        return views;
    }

    void draw_view(const Frame& frame, const View& view) {
        if (view.draws == Draws::model) return draw_model(frame_in(frame, view.tile), view);
        if (view.draws == Draws::map) return draw_map(frame, view.tile, *view.baked);
        if (view.draws == Draws::cover) return baker_.draw_cover(view.sight.recipe);
        if (view.cut) cut_drawing_.draw(view.tile, *view.cut);
    }

    void draw_model(const Frame& frame, const View& view) {
        const auto& [recipe, shown, other_diagonal] = view.sight;
        glViewport(view.tile.corner.x, view.tile.corner.y, view.tile.size.x, view.tile.size.y);
        const bool has_map = shown == Shown::mapped, is_cube = recipe.model.shape == Shape::cube;
        const Define space = recipe.object_space ? "OBJECT_SPACE" : frames.define(view.frame);
        const Program& surface =
            surface_.with({frame.probe, is_cube && !frame.probe ? "MIRROR" : "", has_map ? "MAP" : "",
                           has_map && level_ > 0 ? "ONE_LEVEL" : "", has_map ? space : ""});
        glUseProgram(surface);
        surface.set("u_clip_from_world", frame.camera.clip_from_world());
        surface.set("u_eye", frame.camera.eye());
        surface.set("u_to_light", light_.direction());
        if (has_map) {
            surface.set("s_map", 0);
            surface.set("u_level", float(std::max(0, level_ - 1)));
            if (view.wears_file)
                surface.set("s_map", 0, file_map());
            else
                view.baked->map.bind(0);
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
        window_.draw();
    }

    const Texture& file_map() {
        return file_map_.get({own_.coarse.version()}, [this] {
            return Texture("the file's map", [this] { return *own_.coarse.normal_map(); });
        });
    }

    const std::vector<CutLine>& cut_of(const Baked& baked) {
        return cut_lines_.get({baked.recipe, baked.programs, cut_}, [&] {
            return cut_lines(baked.recipe, baker_.high(baked.recipe).mesh, baked.texels.read(1), cut_);
        });
    }

    /// Writes the results of the rays, and which settings make them wrong.
    void describe(glm::ivec2 size, const Tile& tile, const Baked::Report& report) {
        const Recipe recipe = this->recipe(Shape(shape_));
        labels_.caption(size, tile, 0,
                        report.unwritten > 0
                            ? fmt::format("task 7.{} is not written yet: no ray has a hit", report.unwritten)
                            : fmt::format("{:.1f} % of the texels meet nothing, {:.1f} % another part",
                                          100 * report.missed, 100 * report.wrong));
        const double needed = reach_needed(recipe.model, low_finenesses[size_t(recipe.low)], recipe.sculpt);
        if (double(recipe.reach) < needed)
            labels_.caption(size, tile, -1,
                            fmt::format("a reach of {:.2f} may be too short: {:.2f}", recipe.reach, needed),
                            {1.0f, 0.62f, 0.45f});
        if (report.covered_twice > 0)
            labels_.caption(size, tile, -2, fmt::format("{} texels belong to two triangles", report.covered_twice),
                            {1.0f, 0.62f, 0.45f});
    }

    OwnModels own_;
    Kept<Texture, int> file_map_;  ///< by the coarse model
    Programs surface_{"07_baking/surface.vert", "07_baking/surface.frag"};
    Programs map_{"common/window.vert", "07_baking/map.frag"};
    Baker baker_;
    WindowTriangle window_;
    CutDrawing cut_drawing_;
    Kept<std::vector<CutLine>, Recipe, std::array<GLuint, 3>, float> cut_lines_;
    Labels labels_;

    int view_ = compare, shape_ = 0, fine_ = 0, wears_ = 0, space_ = 0, bake_frame_ = 0, frame_ = 0, diagonal_ = 0;
    int ray_normals_ = 0, take_ = 0, islands_ = 0, size_ = 2, bits_ = 1, padding_ = 8, level_ = 0, low_ = 1, high_ = 0;
    float reach_ = 0.42f, gap_ = 0.12f, cut_ = 0.62f;
    Sculpt sculpt_;
    DistantLight light_{.yaw = -75, .pitch = 30};
    bool cord_ = false;
};

RELIEF_LAB(Baking);

}  // namespace relief::baking
