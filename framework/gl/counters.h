// Counters of GL objects and calls. They are behind the GL function pointers themselves, so they also
// count a lab's raw calls.
#pragma once

#include <array>
#include <cstdint>

namespace relief {

enum class GlKind {
    buffer,
    vertex_array,
    texture,
    sampler,
    framebuffer,
    renderbuffer,
    shader,
    program,
    pipeline,
    query,
    transform_feedback
};
constexpr int gl_kinds = 11;

struct Counters {
    std::array<int64_t, gl_kinds> live{};  ///< GL objects by GlKind
    int64_t draw_calls = 0;                ///< since the process began; a multi-draw counts once
    int64_t links = 0;                     ///< of programs, since the process began
    int64_t texture_bytes = 0;             ///< in textures that are live, all mip levels, as the course uploaded them
    int64_t shared_bytes = 0;              ///< of live textures when one more asks for them: not uploaded again

    int64_t live_objects() const {
        int64_t sum = 0;
        for (const int64_t count : live) sum += count;
        return sum;
    }
};

Counters& counters();

}  // namespace relief
