#include "surfaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "framework/core/base/error.h"
#include "framework/core/image/asset.h"
#include "framework/core/image/coverage.h"
#include "framework/core/image/mips.h"
#include "framework/core/image/own_picture.h"

namespace relief::materials {
namespace {

/// Throws Error unless each number is the index of a surface, and there are no more numbers than surfaces.
void check_order(const std::vector<int>& numbers, size_t surfaces) {
    if (numbers.size() > surfaces)
        throw Error(fmt::format("draw_order() returns {} indices for {} surfaces: each of them once", numbers.size(),
                                surfaces));
    for (const int i : numbers)
        if (i < 0 || size_t(i) >= surfaces)
            throw Error(fmt::format("draw_order() returns the index {}: the surfaces are 0 to {}", i, surfaces - 1));
}

Image mask_of(const std::string& asset, bool is_alpha) {
    const Image picture = read_asset(asset);
    return is_alpha ? channels_of(picture, 3, 1) : picture;
}

bool shows(const Frame& frame, const Surfaces::Look& look, const char* probe) {
    return look.pass == Pass::probe && frame.probe.name == probe;
}

}  // namespace

const Texture& DrawnScene::texture(const std::string& asset, ColorSpace space) {
    const std::string key = (space == ColorSpace::srgb ? "color " : "") + asset;
    const auto found = textures_.find(key);
    return found != textures_.end() ? found->second
                                    : textures_.emplace(key, load_texture(asset.c_str(), space)).first->second;
}

const Texture& DrawnScene::mask_texture(const Piece& piece) {
    if (!piece.mask_is_alpha) return texture(piece.mask, ColorSpace::linear);
    const std::string key = "alpha " + piece.mask;
    const auto found = textures_.find(key);
    if (found != textures_.end()) return found->second;
    return textures_.emplace(key, Texture(key, [mask = piece.mask] { return mask_of(mask, true); })).first->second;
}

const std::vector<float>& DrawnScene::scales(const Piece& piece) {
    std::vector<float>& scales = scales_[piece.mask];
    if (scales.empty()) scales = scales_of(piece.mask, piece.mask_is_alpha);
    return scales;
}

std::vector<float> scales_of(const std::string& mask, bool is_alpha) {
    std::vector<Image> levels = mip_chain(mask_of(mask, is_alpha), ColorSpace::linear);
    for (Image& level : levels)
        for (float& alpha : level.values) alpha = std::round(alpha * 255) / 255;
    return coverage_scales(levels);
}

glm::vec3 program_color(int program) {
    static constexpr std::array<glm::vec3, 8> colors = {{{0.20f, 0.62f, 0.25f},
                                                         {0.55f, 0.55f, 0.75f},
                                                         {0.85f, 0.32f, 0.16f},
                                                         {0.75f, 0.72f, 0.62f},
                                                         {0.16f, 0.55f, 0.85f},
                                                         {0.85f, 0.72f, 0.12f},
                                                         {0.75f, 0.22f, 0.62f},
                                                         {0.20f, 0.70f, 0.65f}}};
    return colors[size_t(program) % colors.size()];
}

void Surfaces::draw(const Frame& frame, DrawnScene& drawn, const Look& look) {
    const bool is_light = look.pass == Pass::light, is_count = shows(frame, look, "layers");
    const std::vector<int> numbers = order_of(drawn.scene, frame.camera.eye());
    const Program* in_use = nullptr;
    glBindVertexArray(drawn.mesh.layout());
    for (size_t rank = 0; rank < numbers.size(); ++rank) {
        const int number = numbers[rank];
        const Piece& piece = drawn.scene.pieces[size_t(number)];
        if (shows(frame, look, "coverage") && !piece.has(mask_map)) continue;
        if (look.pass == Pass::filter_error && !piece.has(color_map)) continue;
        const Program& program = program_of(piece, frame, look);
        if (&program != in_use) {
            glUseProgram(program);
            set_frame(program, frame, look.lights);
            in_use = &program;
        }
        set_material(program, piece);
        set_maps(program, drawn, piece);
        program.set("u_dim", highlight == 0 || highlight == number + 1 ? 1.0f : 0.15f);
        program.set("u_number", float(shows(frame, look, "order") ? int(rank) : number));
        set_blending(piece.is_glass() && (is_light || is_count), frame, look);
        if (is_light && alpha == to_coverage && piece.has(mask_map) && look.target->samples() > 1)
            glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
        glDrawElements(GL_TRIANGLES, GLsizei(piece.index_count), GL_UNSIGNED_INT,
                       reinterpret_cast<const void*>(uintptr_t(piece.first_index) * sizeof(uint32_t)));
        glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    }
    set_blending(false, frame, look);
}

/// Returns the indices of a scene's pieces in the order of drawing.
std::vector<int> Surfaces::order_of(const Scene& scene, const glm::dvec3& eye) const {
    if (order == sorted) {
        std::vector<Surface> surfaces;
        for (const Piece& piece : scene.pieces) surfaces.push_back({piece.program, piece.is_glass(), piece.centre});
        const std::vector<int> numbers = draw_order(surfaces, eye);
        check_order(numbers, surfaces.size());
        return numbers;
    }
    std::vector<int> numbers(scene.pieces.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    if (order == backwards) std::reverse(numbers.begin(), numbers.end());
    if (order == weighted)
        std::stable_partition(numbers.begin(), numbers.end(),
                              [&](int i) { return !scene.pieces[size_t(i)].is_glass(); });
    return numbers;
}

/// Returns the program that is compiled for the features of a piece, and for no more than the pass needs of them.
const Program& Surfaces::program_of(const Piece& piece, const Frame& frame, const Look& look) const {
    const bool is_light = look.pass == Pass::light, is_flat = look.pass == Pass::flat,
               is_error = look.pass == Pass::filter_error;
    const bool has_branches = program_kind == branches && is_light;
    const unsigned features = has_branches ? all_features : piece.features;
    const bool reads_colors = (features & color_map) && (is_light || is_error);
    const bool reads_mask = is_light || is_flat || shows(frame, look, "coverage");
    const Define purpose = is_light ? "" : is_flat ? "FLAT" : is_error ? "MEASURE" : Define(frame.probe);
    return programs_.with({purpose, fmt::format("FEATURES {}", features), has_branches ? "BRANCHES" : "",
                           is_light || shows(frame, look, "lamp") ? lamps.define(look.lights.lamp) : "",
                           filters.define(reads_colors ? look.filter : int(mips)),
                           alphas.define(!(reads_mask && (features & mask_map)) ? int(test)
                                         : is_flat                              ? int(keep)
                                                                                : alpha),
                           reads_mask || !piece.has(mask_map) ? "" : "PLAIN_MASK",
                           is_light ? blend_spaces.define(blend_in) : "",
                           is_light && order == weighted && piece.is_glass() ? "WEIGHTED" : ""});
}

void Surfaces::set_frame(const Program& program, const Frame& frame, const Lights& lights) const {
    program.set("u_clip_from_world", frame.camera.clip_from_world());
    program.set("u_eye", frame.camera.eye());
    program.set("u_threshold", threshold);
    program.set("u_to_sun", lights.to_sun);
    program.set("u_sun", lights.sun);
    program.set("u_sky", lights.sky);
    program.set("u_ground", lights.ground);
    set_lamp(program, lights);
}

void set_lamp(const Program& program, const Lights& lights) {
    program.set("u_lamp", lights.place);
    program.set("u_lamp_light", lights.light);
    program.set("u_axis", lights.axis);
    program.set("u_range", lights.range);
    program.set("u_cone", lights.cone);
    program.set("u_attenuation", lights.attenuation);
}

void Surfaces::set_material(const Program& program, const Piece& piece) const {
    const Material& material = piece.material;
    program.set("u_diffuse", material.diffuse);
    program.set("u_shine", glm::vec4(material.specular, std::max(material.shininess, 1.0f)));
    program.set("u_emission", material.emission);
    program.set("u_opacity", material.opacity);
    program.set("u_bump", material.bump_scale);
    program.set("u_tiling", piece.has(mask_map) && !piece.has(color_map) ? fence : 1.0f);
    program.set("u_features", int(piece.features));
    program.set("u_flat", program_color(piece.program));
}

void Surfaces::set_maps(const Program& program, DrawnScene& drawn, const Piece& piece) const {
    if (piece.has(mask_map) && alpha != hashed) {
        const std::vector<float>& scales = drawn.scales(piece);
        for (size_t i = 0; i < 12; ++i)
            program.set(fmt::format("u_scales[{}]", i).c_str(), scales[std::min(i, scales.size() - 1)]);
    }
    const auto set = [&](const char* sampler, int unit, const std::string& asset, ColorSpace space) {
        if (!asset.empty())
            program.set(sampler, unit, &asset == &piece.mask ? drawn.mask_texture(piece) : drawn.texture(asset, space));
        else if (program_kind == branches)
            program.set(sampler, unit, no_map_);
    };
    set("s_colors", 0, piece.colors, ColorSpace::srgb);
    set("s_highlights", 1, piece.highlights, ColorSpace::linear);
    set("s_bumps", 2, piece.bumps, ColorSpace::linear);
    set("s_mask", 3, piece.mask, ColorSpace::linear);
}

/// Switches between glass and opaque surfaces. Glass is blended and writes no depth, so it hides nothing.
void Surfaces::set_blending(bool is_on, const Frame& frame, const Look& look) const {
    glDepthMask(is_on ? GL_FALSE : GL_TRUE);
    (is_on ? glEnable : glDisable)(GL_BLEND);
    if (order == weighted && look.pass == Pass::light) look.target->begin(is_on ? 1 : 0, is_on ? 2 : 1);
    if (!is_on) return glBlendFunc(GL_ONE, GL_ZERO);
    if (shows(frame, look, "layers")) return glBlendFunc(GL_ONE, GL_ONE);
    if (order != weighted) return glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glBlendFunci(0, GL_ONE, GL_ONE);
    glBlendFunci(1, GL_ZERO, GL_ONE_MINUS_SRC_COLOR);
}

}  // namespace relief::materials
