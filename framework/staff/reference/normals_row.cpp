#include "framework/staff/reference/normals_row.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#ifdef __SSE2__
    #include <emmintrin.h>
#endif

namespace relief {
namespace {

// One source for two instruction sets: the functions below are compiled for the baseline and for AVX2. Without fused
// multiply-adds both give the same bits. Vectors of eight use the compilers' own extension, in two halves on machines
// with four lanes. Without it compilers write three-channel texels one by one.
#define RELIEF_INLINE [[gnu::always_inline]] inline
constexpr int lanes = 8;
typedef float Floats __attribute__((vector_size(4 * lanes), aligned(4)));
typedef int32_t Ints __attribute__((vector_size(4 * lanes), aligned(4)));
typedef float Half __attribute__((vector_size(16), aligned(4)));

/// Correctly rounded, unlike the processors' own estimates, so the bits are the same everywhere.
RELIEF_INLINE Floats square_root(Floats v) {
#ifdef __SSE2__
    const __m128 low = _mm_sqrt_ps(__builtin_shufflevector(v, v, 0, 1, 2, 3)),
                 high = _mm_sqrt_ps(__builtin_shufflevector(v, v, 4, 5, 6, 7));
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
#else
    for (int i = 0; i < lanes; ++i) v[i] = std::sqrt(v[i]);
    return v;
#endif
}

RELIEF_INLINE void store(Half low, Half high, float* to, [[maybe_unused]] bool uncached) {
#ifdef __SSE2__
    if (uncached) {
        _mm_stream_ps(to, low);
        _mm_stream_ps(to + 4, high);
        return;
    }
#endif
    *reinterpret_cast<Half*>(to) = low;
    *reinterpret_cast<Half*>(to + 4) = high;
}

/// Writes the normals of eight slopes. Clears the bits of `usable` where a slope is NaN or its square too large.
RELIEF_INLINE void write_normals(Floats du, Floats dv, float* result, bool uncached, Ints& usable) {
    const Floats squared = du * du + dv * dv + 1;
    usable &= squared < 1e37f;
    const Floats half = 0.5f / square_root(squared);
    const Floats x = 0.5f - du * half, y = 0.5f - dv * half, z = 0.5f + half;
    // Four texels per half: x0 y0 z0 x1 | y1 z1 x2 y2 | z2 x3 y3 z3, by shuffles within the half.
    const Floats xy = __builtin_shufflevector(x, y, 0, 8, 1, 9, 4, 12, 5, 13);     // x0 y0 x1 y1
    const Floats zx = __builtin_shufflevector(z, x, 0, 0, 9, 9, 4, 4, 13, 13);     // z0 z0 x1 x1
    const Floats yz = __builtin_shufflevector(y, z, 1, 1, 9, 9, 5, 5, 13, 13);     // y1 y1 z1 z1
    const Floats xy2 = __builtin_shufflevector(x, y, 2, 10, 3, 11, 6, 14, 7, 15);  // x2 y2 x3 y3
    const Floats zx2 = __builtin_shufflevector(z, x, 2, 2, 11, 11, 6, 6, 15, 15);  // z2 z2 x3 x3
    const Floats yz2 = __builtin_shufflevector(y, z, 3, 3, 11, 11, 7, 7, 15, 15);  // y3 y3 z3 z3
    const Floats a = __builtin_shufflevector(xy, zx, 0, 1, 8, 10, 4, 5, 12, 14);
    const Floats b = __builtin_shufflevector(yz, xy2, 0, 2, 8, 9, 4, 6, 12, 13);
    const Floats c = __builtin_shufflevector(zx2, yz2, 0, 2, 8, 10, 4, 6, 12, 14);
    store(__builtin_shufflevector(a, a, 0, 1, 2, 3), __builtin_shufflevector(b, b, 0, 1, 2, 3), result, uncached);
    store(__builtin_shufflevector(c, c, 0, 1, 2, 3), __builtin_shufflevector(a, a, 4, 5, 6, 7), result + 8, uncached);
    store(__builtin_shufflevector(b, b, 4, 5, 6, 7), __builtin_shufflevector(c, c, 4, 5, 6, 7), result + 16, uncached);
}

/// The slopes of eight texels starting at x. The weights are copies: the compiler cannot know that results do not
/// overwrite them.
template <SlopeFilter filter>
struct Slopes {
    const float *up2, *up, *here, *down, *down2;
    Floats u, v, u_side, v_side;

    RELIEF_INLINE explicit Slopes(const HeightRows& rows)
        : up2(rows.up2), up(rows.up), here(rows.here), down(rows.down), down2(rows.down2) {
        u = Floats{} + rows.u, v = Floats{} + rows.v, u_side = Floats{} + rows.u_side, v_side = Floats{} + rows.v_side;
    }
    RELIEF_INLINE void at(int x, Floats& du, Floats& dv) const {
        const auto get = [x](const float* row, int k) __attribute__((always_inline)) {
            return *reinterpret_cast<const Floats*>(row + x + k);
        };
        if constexpr (filter == SlopeFilter::forward) {
            du = u * (get(here, 1) - get(here, 0));
            dv = v * (get(up, 0) - get(here, 0));
        } else if constexpr (filter == SlopeFilter::central) {
            du = u * (get(here, 1) - get(here, -1));
            dv = v * (get(up, 0) - get(down, 0));
        } else if constexpr (filter == SlopeFilter::fourth_order) {
            du = u * (get(here, 1) - get(here, -1)) + u_side * (get(here, 2) - get(here, -2));
            dv = v * (get(up, 0) - get(down, 0)) + v_side * (get(up2, 0) - get(down2, 0));
        } else {  // the diagonals serve both
            const Floats rising = get(up, 1) - get(down, -1), falling = get(up, -1) - get(down, 1);
            du = u * (get(here, 1) - get(here, -1)) + u_side * (rising - falling);
            dv = v * (get(up, 0) - get(down, 0)) + v_side * (rising + falling);
        }
    }
};

template <SlopeFilter filter>
RELIEF_INLINE bool row(const HeightRows& rows, int begin, int end, float* result, bool uncached) {
    const Slopes<filter> slopes(rows);
    Ints usable = ~Ints{};
    const auto eight = [&](int x, bool past_caches) __attribute__((always_inline)) {
        Floats du, dv;
        slopes.at(x, du, dv);
        write_normals(du, dv, result + 3 * (x - begin), past_caches, usable);
    };
    // Unaligned batches of eight at both ends; between them, batches aligned to 16 bytes.
    eight(begin, false), eight(end - lanes, false);
    int x = begin;
    while (uncached && reinterpret_cast<uintptr_t>(result + 3 * (x - begin)) % 16 != 0) ++x;
    if (uncached)
        for (; x + lanes <= end; x += lanes) eight(x, true);
    else
        for (; x + lanes <= end; x += lanes) eight(x, false);
    int all = -1;
    for (int i = 0; i < lanes; ++i) all &= usable[i];
    return all != 0;
}

RELIEF_INLINE bool any_row(SlopeFilter filter, const HeightRows& rows, int begin, int end, float* result,
                           bool uncached) {
    switch (filter) {
        case SlopeFilter::forward:
            return row<SlopeFilter::forward>(rows, begin, end, result, uncached);
        case SlopeFilter::central:
            return row<SlopeFilter::central>(rows, begin, end, result, uncached);
        case SlopeFilter::fourth_order:
            return row<SlopeFilter::fourth_order>(rows, begin, end, result, uncached);
        default:
            return row<SlopeFilter::sobel>(rows, begin, end, result, uncached);
    }
}

#ifdef __x86_64__
[[gnu::target("avx2")]] bool row_avx2(SlopeFilter filter, const HeightRows& rows, int begin, int end, float* result,
                                      bool uncached) {
    return any_row(filter, rows, begin, end, result, uncached);
}
#endif

}  // namespace

bool normals_of_row(SlopeFilter filter, const HeightRows& rows, int begin, int end, float* result, bool uncached) {
#ifdef __x86_64__
    static const bool has_avx2 = __builtin_cpu_supports("avx2");
    if (has_avx2) return row_avx2(filter, rows, begin, end, result, uncached);
#endif
    return any_row(filter, rows, begin, end, result, uncached);
}

void normal_of_slope(float du, float dv, float* result) {
    constexpr float limit = 1e18f;  // its square fits in a float
    const auto usable = [](float slope) { return std::isnan(slope) ? 0 : std::clamp(slope, -1e38f, 1e38f); };
    du = usable(du), dv = usable(dv);
    // Scale both by one factor: scaling each by itself would turn the normal around the vertical.
    if (const float larger = std::max(std::abs(du), std::abs(dv)); larger > limit)
        du = du / larger * limit, dv = dv / larger * limit;
    const float half = 0.5f / std::sqrt(du * du + dv * dv + 1);
    result[0] = 0.5f - du * half, result[1] = 0.5f - dv * half, result[2] = 0.5f + half;
}

}  // namespace relief
