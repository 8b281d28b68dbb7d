#include "surfaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "framework/core/base/error.h"
#include "task.h"

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

bool shows(const Frame& frame, const Surfaces::Look& look, const char* probe) {
    return look.pass == Pass::probe && frame.probe.name == probe;
}

/// Returns whether a piece is in a picture that shows one of its features.
bool is_shown(const Piece& piece, const Frame& frame, const Surfaces::Look& look) {
    if (shows(frame, look, "coverage")) return piece.has(mask_map);
    return look.pass != Pass::filter_error || piece.has(color_map);
}

void draw_triangles(const Piece& piece) {
    glDrawElements(GL_TRIANGLES, GLsizei(piece.index_count), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(uintptr_t(piece.first_index) * sizeof(uint32_t)));
}

}  // namespace

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
    const bool is_light = look.pass == Pass::light, is_blended = is_light || shows(frame, look, "layers");
    const bool is_smooth = is_light && settings_.alpha == Settings::to_coverage && look.target->samples() > 1;
    const std::vector<int> numbers = order_of(drawn.scene, frame.camera.eye());
    const Program* in_use = nullptr;
    glBindVertexArray(drawn.mesh.layout());
    for (size_t rank = 0; rank < numbers.size(); ++rank) {
        const int number = numbers[rank];
        const Piece& piece = drawn.scene.pieces[size_t(number)];
        if (!is_shown(piece, frame, look)) continue;
        const Program& program = program_of(piece, frame, look);
        if (&program != in_use) {
            glUseProgram(program);
            set_frame(program, frame);
            in_use = &program;
        }
        set_material(program, piece);
        set_maps(program, drawn, piece);
        const int alone = settings_.highlight;
        program.set("u_dim", alone == 0 || alone == number + 1 ? 1.0f : 0.15f);
        program.set("u_number", float(shows(frame, look, "order") ? int(rank) : number));
        set_blending(is_blended && piece.is_glass(), frame, look);
        if (is_smooth && piece.has(mask_map)) glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
        draw_triangles(piece);
        glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    }
    set_blending(false, frame, look);
}

/// Returns the indices of a scene's pieces in the order of drawing.
std::vector<int> Surfaces::order_of(const Scene& scene, const glm::dvec3& eye) const {
    if (settings_.order == Settings::sorted) {
        std::vector<Surface> surfaces;
        for (const Piece& piece : scene.pieces) surfaces.push_back({piece.program, piece.is_glass(), piece.centre});
        const std::vector<int> numbers = draw_order(surfaces, eye);
        check_order(numbers, surfaces.size());
        return numbers;
    }
    std::vector<int> numbers(scene.pieces.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    if (settings_.order == Settings::backwards) std::reverse(numbers.begin(), numbers.end());
    if (settings_.is_weighted())
        std::stable_partition(numbers.begin(), numbers.end(),
                              [&](int i) { return !scene.pieces[size_t(i)].is_glass(); });
    return numbers;
}

/// Returns the program that is compiled for the features of a piece, and for no more than the pass needs of them.
const Program& Surfaces::program_of(const Piece& piece, const Frame& frame, const Look& look) const {
    const bool is_light = look.pass == Pass::light, is_flat = look.pass == Pass::flat,
               is_error = look.pass == Pass::filter_error;
    const bool has_branches = settings_.program_kind == Settings::branches && is_light;
    const unsigned features = has_branches ? all_features : piece.features;
    const bool reads_colors = (features & color_map) && (is_light || is_error);
    const bool reads_mask = is_light || is_flat || shows(frame, look, "coverage");
    const int alpha = !reads_mask || !(features & mask_map) ? int(Settings::test)
                      : is_flat                             ? int(Settings::keep)
                                                            : settings_.alpha;
    const Define purpose = is_light ? "" : is_flat ? "FLAT" : is_error ? "MEASURE" : Define(frame.probe);
    return programs_.with({purpose, fmt::format("FEATURES {}", features), has_branches ? "BRANCHES" : "",
                           is_light || shows(frame, look, "lamp") ? lamps.define(settings_.lamp) : "",
                           Settings::filters.define(reads_colors ? look.filter : int(Settings::mips)),
                           Settings::alphas.define(alpha), reads_mask || !piece.has(mask_map) ? "" : "PLAIN_MASK",
                           is_light ? Settings::blend_spaces.define(settings_.blend_in) : "",
                           is_light && piece.is_glass() ? Settings::orders.define(settings_.order) : ""});
}

void Surfaces::set_frame(const Program& program, const Frame& frame) const {
    program.set("u_clip_from_world", frame.camera.clip_from_world());
    program.set("u_eye", frame.camera.eye());
    program.set("u_threshold", settings_.threshold);
    settings_.lights().set(program);
}

void Surfaces::set_material(const Program& program, const Piece& piece) const {
    const Material& material = piece.material;
    program.set("u_diffuse", material.diffuse);
    program.set("u_shine", glm::vec4(material.specular, std::max(material.shininess, 1.0f)));
    program.set("u_emission", material.emission);
    program.set("u_opacity", material.opacity);
    program.set("u_bump", material.bump_scale);
    program.set("u_tiling", piece.has(mask_map) && !piece.has(color_map) ? settings_.fence : 1.0f);
    program.set("u_features", int(piece.features));
    program.set("u_flat", program_color(piece.program));
}

void Surfaces::set_maps(const Program& program, DrawnScene& drawn, const Piece& piece) const {
    if (piece.has(mask_map) && settings_.alpha != Settings::hashed) {
        const std::vector<float>& scales = drawn.textures.scales(piece);
        for (size_t i = 0; i < 12; ++i)
            program.set(fmt::format("u_scales[{}]", i).c_str(), scales[std::min(i, scales.size() - 1)]);
    }
    const auto set = [&](const char* sampler, int unit, const Texture* map) {
        if (map)
            program.set(sampler, unit, *map);
        else if (settings_.program_kind == Settings::branches)
            program.set(sampler, unit, no_map_);
    };
    set("s_colors", 0, drawn.textures.texture(piece.colors, ColorSpace::srgb));
    set("s_highlights", 1, drawn.textures.texture(piece.highlights, ColorSpace::linear));
    set("s_bumps", 2, drawn.textures.texture(piece.bumps, ColorSpace::linear));
    set("s_mask", 3, drawn.textures.mask(piece));
}

/// Switches between glass and opaque surfaces. Glass is blended and writes no depth, so it hides nothing.
void Surfaces::set_blending(bool is_on, const Frame& frame, const Look& look) const {
    glDepthMask(is_on ? GL_FALSE : GL_TRUE);
    (is_on ? glEnable : glDisable)(GL_BLEND);
    if (settings_.is_weighted() && look.pass == Pass::light) look.target->begin(is_on ? 1 : 0, is_on ? 2 : 1);
    if (!is_on) return glBlendFunc(GL_ONE, GL_ZERO);
    if (shows(frame, look, "layers")) return glBlendFunc(GL_ONE, GL_ONE);
    if (!settings_.is_weighted()) return glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glBlendFunci(0, GL_ONE, GL_ONE);
    glBlendFunci(1, GL_ZERO, GL_ONE_MINUS_SRC_COLOR);
}

}  // namespace relief::materials
