// Counters of GL objects and calls. They wrap the GL function pointers, so they also count a lab's raw calls.
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
    std::array<int64_t, gl_kinds> live{};  ///< live GL objects, by GlKind
    int64_t draw_calls = 0;                ///< since the process started; a multi-draw call counts once
    int64_t links = 0;                     ///< program links since the process started
    int64_t texture_bytes = 0;             ///< in live textures, all mip levels, as uploaded by the course
    int64_t shared_bytes = 0;              ///< not uploaded again, because a live texture was shared

    int64_t live_objects() const {
        int64_t sum = 0;
        for (const int64_t count : live) sum += count;
        return sum;
    }
};

Counters& counters();

}  // namespace relief
