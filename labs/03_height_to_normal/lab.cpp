// Lab 03: height to normal.
//
// A normal map from a height map, by six filters. Heights are exact or rounded to 8 bits, and borders wrap or end.
// Your tasks: shaders/03_height_to_normal/task.glsl
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "differences.h"
#include "framework/base/error.h"
#include "framework/base/text.h"
#include "framework/image/asset.h"
#include "framework/image/compare.h"
#include "framework/image/mips.h"
#include "framework/image/own_picture.h"
#include "framework/image/resample.h"
#include "framework/kit/kept.h"
#include "framework/kit/labels.h"
#include "framework/kit/tiles.h"
#include "framework/lab/lab.h"
#include "heights.h"
#include "map.h"
#include "truth.h"

namespace relief {

class HeightToNormal final : public Lab {
public:
    void draw(const Frame& frame) override {
        const auto tiles = tiles_of_view(frame.size);
        Maps& maps = maps_.get({makers(tiles.size()), inputs()}, [this] { return make_maps(); });
        for (size_t i = 0; i < tiles.size(); ++i) {
            if (!maps.normals.contains(filter_of(i)))
                maps.normals.emplace(filter_of(i), make_normals(filter_of(i), maps.heights));
            if (is_derived() && !frame.probe) derived(maps, filter_of(i));  // reads maps back, which changes bindings
        }
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        for (size_t i = 0; i < tiles.size(); ++i) {
            draw_wall(frame_in(frame, tiles[i]), tiles[i], maps, filter_of(i));
            describe(frame.size, tiles[i], filter_of(i), maps.normals.at(filter_of(i)).error);
        }
        if (has_scale()) labels_.log_scale(frame.size, "0.001~", "10~", 4);
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        knobs.group("Picture");
        knobs.choice("view", view_, views, "every filter, or one of them");
        knobs.choice("filter", filter_, filters, "for view = one: the filter of the wall");
        knobs.choice("show", show_, shows,
                     "the lit relief, the error compared with the exact slope, or half of each; or what else heights "
                     "give: how open "
                     "a place is to the sky, how glossy by its normals' spread");
        knobs.group("Map");
        knobs.choice_or_picture("source", source_, own_, sources,
                                "a known function, the bricks' height map, or the bricks' colours");
        knobs.choice("size", size_, sizes, "texels along each side of the map (source waves)");
        knobs.choice("bits", bits_, bit_counts, "bits per stored height (source waves)");
        knobs.slider("depth", depth_, 0, 64, "depth of the relief: texels of a height of 1");
        knobs.slider("stretch", stretch_, 0.25f, 4, "width of a texel divided by its height");
        knobs.toggle("wrap", wrap_, "continue the map at its other side; off: it ends at its border");
        knobs.choice("where", where_, places,
                     "the map is computed by a fragment shader, or by the framework on the CPU");
        knobs.group("Strength of detail");
        knobs.slider("fine", fine_, 0, 3, "strength of detail of one texel");
        knobs.slider("middle", middle_, 0, 3, "strength of detail of two texels");
        knobs.slider("coarse", coarse_, 0, 3, "strength of detail of four texels");
        knobs.group("Wall and light");
        knobs.steps("repeat", repeat_, 1, 4, "repeats of the map along each side of the wall: look for seams");
        knobs.slider("light_yaw", light_yaw_, -180, 180, "direction of the light around the wall, degrees");
        knobs.slider("light_height", light_height_, -2, 2, "height of the light, metres");
    }

    std::optional<Image> truth(const Frame& frame, const Probe& probe) const override {
        Image map;
        if (probe.name == "normal" && has_known_slope()) map = heights::exact_normals(size(), texels());
        if (probe.name == "height") map = has_colors() ? heights::heights_by_cpu(color_picture()) : stored_heights();
        if (map.values.empty()) return {};
        return truth_in_tiles(frame, tiles_of_view(frame.size),
                              [&](const Frame& part, size_t) { return heights::on_wall(part, map, wall(), repeat_); });
    }

private:
    enum View { every, one };
    enum Show { half_and_half, light, error_map, occlusion, gloss };
    enum Source { waves, bricks, colors, own };
    enum Place { gpu, cpu };
    static constexpr int picture_size = 256;
    static constexpr std::array views = {"every", "one"};
    static constexpr std::array filters = {"forward", "central", "sobel", "scharr", "fourth-order", "spline"};
    static constexpr std::array shows = {"half-and-half", "light", "error", "occlusion", "gloss"};
    static constexpr std::array sources = {"waves", "bricks", "colors"};
    static constexpr std::array sizes = {"32", "64", "128", "256"};
    static constexpr std::array bit_counts = {"float", "16", "8"};
    static constexpr std::array places = {"gpu", "cpu"};

    int size() const { return source_ == waves ? 32 << size_ : picture_size; }
    glm::dvec2 texels() const { return {depth_ / stretch_, depth_}; }
    glm::dvec2 wall() const { return glm::dvec2(std::min(1.0f, stretch_), std::min(1.0f, 1 / stretch_)); }
    bool has_known_slope() const { return source_ == waves && fine_ == 1 && middle_ == 1 && coarse_ == 1; }
    bool shows_error() const { return show_ == half_and_half || show_ == error_map; }
    bool is_derived() const { return show_ == occlusion || show_ == gloss; }
    bool has_scale() const { return shows_error() && has_known_slope(); }
    std::vector<Tile> tiles_of_view(glm::ivec2 frame) const {
        return tiles_of(frame, view_ == one ? 1 : int(filters.size()), has_scale() ? Labels::scale_height(frame) : 0);
    }
    int filter_of(size_t tile) const { return view_ == one ? filter_ : int(tile); }

    /// Returns an asset at a quarter of its size.
    static Image picture(const char* file) {
        const Image whole = read_asset(file);
        Image small = mip_chain(whole, whole.channels == 3 ? ColorSpace::srgb : ColorSpace::linear).at(2);
        small.bits = 32;
        return small;
    }
    /// Returns the user's picture at the same size. A grey picture has one channel and is taken for heights.
    static Image own_picture(Image picture) {
        for (float& value : picture.values) value = std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : 0;
        const Image whole = resampled(picture, picture_size, picture_size);
        return channels_of(whole, 0, is_nearly_grey(whole) ? 1 : 3);
    }
    bool has_colors() const { return source_ == colors || (source_ == own && own_.image().channels == 3); }
    Image color_picture() const { return source_ == own ? own_.image() : picture("bricks_albedo.png"); }
    Image stored_heights() const {
        if (source_ == bricks) return strengthened(picture("bricks_height.png"));
        if (source_ == own) return strengthened(own_.image());
        return strengthened(heights::sample(size(), bits_ == 0 ? 32 : bits_ == 1 ? 16 : 8));
    }
    Image strengthened(Image image) const {
        image.bits = 32;  // stored heights are rounded already; do not round the results
        if (fine_ == 1 && middle_ == 1 && coarse_ == 1) return image;
        return with_level_strengths(image, {fine_, middle_, coarse_}, wrap_, 0);
    }

    static Texture table(std::function<Image()> make) {
        return Texture("table", std::move(make), {.wrap = Wrap::clamp, .mips = false});
    }

    const Program& normals_program(int filter) const {
        return normals_program_.with(SlopeFilter(filter) == SlopeFilter::sobel ? "SOBEL" : "");
    }
    /// Returns the programs that fill the maps. A program changes when its shader is saved, and then its maps are made
    /// again.
    std::vector<GLuint> makers(size_t tiles) const {
        std::vector<GLuint> programs;
        if (has_colors()) programs.push_back(heights_program_.with());
        for (size_t i = 0; i < tiles && where_ == gpu; ++i) programs.push_back(normals_program(filter_of(i)));
        return programs;
    }

    /// The maps for one setting of the knobs in inputs().
    struct Maps {
        heights::Map heights;
        Texture truth;                                        ///< exact normals
        std::map<int, heights::Map> normals;                  ///< by filter; made when they are first shown
        std::map<std::pair<int, int>, Texture> derived = {};  ///< by `show_` and filter
    };
    std::vector<float> inputs() const {
        return {float(source_), float(size_), float(bits_), float(wrap_), float(where_),        depth_,
                stretch_,       fine_,        middle_,      coarse_,      float(own_.version())};
    }

    Maps make_maps() const {
        heights::Map heights(size(), GL_R32F);
        if (has_colors()) {
            const Program& convert = heights_program_.with();
            glUseProgram(convert);
            const Texture colors_of_bricks = table([this] { return color_picture(); });
            convert.set("s_picture", 0, colors_of_bricks);
            heights.fill(nothing_);
        } else {
            heights.fill(stored_heights());
        }
        return {std::move(heights), table([this] { return heights::exact_normals(size(), texels()); }), {}};
    }

    heights::Map make_normals(int filter, const heights::Map& heights) const {
        heights::Map map(size(), GL_RGBA32F);
        const auto option = SlopeFilter(filter);
        if (where_ == cpu) {
            if (!heights::normals_by_cpu)
                throw Error("the CPU's normals are not in this course: they are what task 3.1 asks for");
            const Image normals = heights::normals_by_cpu(
                heights.read(1), {.texels_u = texels().x, .texels_v = texels().y, .filter = option, .wrap = wrap_});
            map.fill(normals);
        } else {
            const Program& convert = normals_program(filter);
            glUseProgram(convert);
            const Texture differences = table([&] { return heights::differences_of_lines(option, size(), wrap_); });
            convert.set("u_differences", option == SlopeFilter::spline ? size() : 4);
            convert.set("u_beside", weight_beside(option));
            convert.set("u_wrap", wrap_);
            convert.set("u_texels", glm::vec2(texels()));
            convert.set("s_differences_u", 1, differences);
            convert.set("s_differences_v", 1, differences);
            glUniform1i(glGetUniformLocation(convert, "s_heights"), 0);
            glActiveTexture(GL_TEXTURE0);
            glBindTexture(GL_TEXTURE_2D, heights);
            map.fill(nothing_);
        }
        if (has_known_slope() && (where_ == cpu || is_written(map)))
            map.error =
                summarize(error_image(map.read(3), heights::exact_normals(size(), texels()), ErrorMetric::angle));
        return map;
    }

    /// Returns whether the student has written the normals: no texel is marked as unfinished.
    static bool is_written(const heights::Map& normals) {
        const Image image = normals.read(4);
        for (size_t i = 3; i < image.values.size(); i += 4)
            if (image.values[i] < 0.5f) return false;
        return true;
    }

    /// Returns the factor on the glossiness of each texel from the length of the mean normal of 3 x 3 texels (Toksvig
    /// 2005). It is 1 where they agree.
    Image gloss_of(const Image& normals) const {
        constexpr double exponent = 64;
        Image made(normals.width, normals.height, 1);
        for (int y = 0; y < normals.height; ++y)
            for (int x = 0; x < normals.width; ++x) {
                glm::dvec3 sum(0);
                for (int i = 0; i < 9; ++i) {
                    const int u = x + i % 3 - 1 + normals.width, v = y + i / 3 - 1 + normals.height;
                    const float* const n = normals.pixel(u % normals.width, v % normals.height);
                    sum += glm::normalize(glm::dvec3(n[0], n[1], n[2])) / 9.0;
                }
                const double length = std::min(1.0, glm::length(sum));
                *made.pixel(x, y) = float(length / (length + exponent * (1 - length)));
            }
        return made;
    }

    /// Returns the occlusion or gloss map of the heights or normals, made when it is first asked for.
    const Texture& derived(Maps& maps, int filter) const {
        const std::pair key(show_, show_ == gloss ? filter : 0);
        if (const auto found = maps.derived.find(key); found != maps.derived.end()) return found->second;
        if (show_ == occlusion && !heights::open_to_the_sky)
            throw Error("how open a place is to the sky is not in this course: it is what task 16.5 asks for");
        Image made = show_ == gloss ? gloss_of(maps.normals.at(filter).read(3))
                                    : heights::open_to_the_sky(maps.heights.read(1), texels().y);
        return maps.derived.emplace(key, table([made = std::move(made)] { return made; })).first->second;
    }

    void draw_wall(const Frame& frame, const Tile& tile, Maps& maps, int filter) const {
        glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y);
        const heights::Map& map = maps.normals.at(filter);
        const bool show_error = shows_error() && map.error.count > 0 && !frame.probe;
        const Program& surface =
            wall_program_.with({frame.probe, show_error ? "ERROR" : "", is_derived() && !frame.probe ? "DERIVED" : ""});
        glUseProgram(surface);
        surface.set("u_clip_from_world", frame.camera.clip_from_world());
        surface.set("u_eye", frame.camera.eye());
        const float yaw_rad = glm::radians(light_yaw_);
        surface.set("u_light", glm::vec3(2 * std::sin(yaw_rad), light_height_, 0.6f + 0.8f * std::cos(yaw_rad)));
        surface.set("u_wall", glm::vec2(wall()));
        surface.set("u_repeat", float(repeat_));
        if (show_error) {
            surface.set("u_split", show_ == half_and_half ? 0.5f : 0.0f);
            surface.set("s_truth", 2, maps.truth);
        }
        if (is_derived() && !frame.probe) surface.set("s_derived", 3, derived(maps, filter));
        glUniform1i(glGetUniformLocation(surface, "s_normals"), 0);
        glUniform1i(glGetUniformLocation(surface, "s_heights"), 1);
        glActiveTexture(GL_TEXTURE1);
        glBindTexture(GL_TEXTURE_2D, maps.heights);
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, map);
        glBindVertexArray(quad_.layout());
        glDrawElements(GL_TRIANGLES, quad_.count(), GL_UNSIGNED_INT, nullptr);
    }

    void describe(glm::ivec2 size, const Tile& tile, int filter, const ErrorSummary& error) {
        labels_.caption(size, tile, 0, filters[size_t(filter)]);
        if (error.count > 0 && !is_derived())
            labels_.caption(size, tile, -1,
                            fmt::format("mean {}~ max {}~", rounded(error.mean, 2), rounded(error.largest, 2)));
    }

    OwnPicture own_{own_picture};
    Programs heights_program_{"03_height_to_normal/map.vert", "03_height_to_normal/heights.frag"};
    Programs normals_program_{"03_height_to_normal/map.vert", "03_height_to_normal/normals.frag"};
    Programs wall_program_{"03_height_to_normal/wall.vert", "03_height_to_normal/wall.frag"};
    GpuMesh quad_ = upload([] { return make_quad({.width = 2, .height = 2}); });
    GpuMesh nothing_ = upload([] { return Mesh{}; });
    Labels labels_;
    Kept<Maps, std::vector<GLuint>, std::vector<float>> maps_;

    int view_ = every, filter_ = 2, show_ = half_and_half, source_ = waves, size_ = 1, bits_ = 0, where_ = gpu,
        repeat_ = 2;
    bool wrap_ = true;
    float depth_ = 14, stretch_ = 1, fine_ = 1, middle_ = 1, coarse_ = 1, light_yaw_ = -50, light_height_ = 1.1f;
};

RELIEF_LAB(HeightToNormal);

}  // namespace relief
