#include "framework/library/mesh/tangent_faces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#ifdef __SSE2__
    #include <emmintrin.h>
#endif

namespace relief {
namespace {

// One source for two instruction sets: the functions below are compiled for the baseline and for AVX2. Without fused
// multiply-adds both give the same bits. Vectors of four use the compilers' own extension: compilers do not vectorise
// so long a loop.
#define RELIEF_INLINE [[gnu::always_inline]] inline
constexpr int lanes = 4, batch = 32, pieces = batch / lanes;
typedef double Doubles __attribute__((vector_size(8 * lanes)));
typedef int64_t Masks __attribute__((vector_size(8 * lanes)));

/// The minimum sine of the angle between dP/du (in double precision) and the normal. Below it, the projection has an
/// error of a thousandth of a degree or more.
constexpr double smallest_sine = 1e-11;

constexpr double pi = 3.14159265358979323846;

/// One number for each triangle of a batch.
union Row {
    Doubles four[pieces];
    double one[batch];
};

/// A batch of triangles in structure-of-arrays layout.
struct alignas(64) Batch {
    Row position[3][3], uv[3][2], normal[3][3];
    Row along[3];   ///< dP/du, unit length or zero
    Row across[3];  ///< cross product of two edges
    Row twice_area;
    Row handedness;          ///< 1, 0 or -1
    Row finite, separate;    ///< 1 or 0: all numbers are finite; no two corners coincide
    Row on_plane[3][3];      ///< for mikktspace, per corner: `along` projected onto the tangent plane
    Row square[3];           ///< squared length of `on_plane`; 0 if it is below the limit
    Row sine[3], cosine[3];  ///< of the corners' angles, times a common length
    float angle[3][batch];
    float pull[3][3][batch];
};

/// Correctly rounded.
RELIEF_INLINE Doubles square_root(Doubles v) {
#ifdef __SSE2__
    const __m128d low = _mm_sqrt_pd(__builtin_shufflevector(v, v, 0, 1)),
                  high = _mm_sqrt_pd(__builtin_shufflevector(v, v, 2, 3));
    return __builtin_shufflevector(low, high, 0, 1, 2, 3);
#else
    for (int i = 0; i < lanes; ++i) v[i] = std::sqrt(v[i]);
    return v;
#endif
}
RELIEF_INLINE Doubles size_of(Doubles v) { return v < 0 ? -v : v; }
RELIEF_INLINE Doubles all(double value) { return Doubles{} + value; }

struct Vector {
    Doubles x, y, z;
};
RELIEF_INLINE Vector at(const Row (&rows)[3], int i) { return {rows[0].four[i], rows[1].four[i], rows[2].four[i]}; }
RELIEF_INLINE void set(Row (&rows)[3], int i, Vector v) {
    rows[0].four[i] = v.x, rows[1].four[i] = v.y, rows[2].four[i] = v.z;
}
RELIEF_INLINE Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
RELIEF_INLINE Vector operator*(Vector a, Doubles s) { return {a.x * s, a.y * s, a.z * s}; }
RELIEF_INLINE Doubles dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
RELIEF_INLINE Vector cross(Vector a, Vector b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
RELIEF_INLINE Vector either(Masks first, Vector a, Vector b) {
    return {first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z};
}

// Double precision can hold the fourth power of any float, so nothing needs scaling. Differences of floats are exact
// except for extreme magnitudes. Products use the triangle's two shorter edges, so that slivers keep precision. At a
// sphere's pole one edge is 1e-17 long, and any other two edges leave only rounding errors.
RELIEF_INLINE void solve(Batch& b, int i) {
    // Edge k runs from corner k to the next.
    const Vector p0 = at(b.position[0], i), p1 = at(b.position[1], i), p2 = at(b.position[2], i);
    const Vector e0 = p1 - p0, e1 = p2 - p1, e2 = p0 - p2;
    const Doubles l0 = dot(e0, e0), l1 = dot(e1, e1), l2 = dot(e2, e2);
    const Masks is_0 = (l0 > l1) & (l0 > l2), is_1 = ~(l0 > l1) & (l1 > l2);  // the longest edge
    const Vector one = either(is_0, e1, either(is_1, e2, e0)), two = either(is_0, e2, either(is_1, e0, e1));
    const auto uv = [&](int k, int c) __attribute__((always_inline)) { return b.uv[k][c].four[i]; };
    const Doubles u0 = uv(1, 0) - uv(0, 0), u1 = uv(2, 0) - uv(1, 0), u2 = uv(0, 0) - uv(2, 0),
                  v0 = uv(1, 1) - uv(0, 1), v1 = uv(2, 1) - uv(1, 1), v2 = uv(0, 1) - uv(2, 1);
    const Doubles one_u = is_0   ? u1
                          : is_1 ? u2
                                 : u0,
                  one_v = is_0   ? v1
                          : is_1 ? v2
                                 : v0,
                  two_u = is_0   ? u2
                          : is_1 ? u0
                                 : u1,
                  two_v = is_0   ? v2
                          : is_1 ? v0
                                 : v1;
    const Vector across = cross(one, two);
    set(b.across, i, across);
    const Doubles twice_area = square_root(dot(across, across));
    // A sum is finite only if all its terms are; fifteen floats cannot overflow a double.
    Doubles sum{};
    for (int k = 0; k < 3; ++k) sum += uv(k, 0) + uv(k, 1);
    for (const Vector& p : {p0, p1, p2}) sum += p.x + p.y + p.z;
    const Doubles finite = sum - sum == 0 ? all(1) : all(0);  // NOLINT(misc-redundant-expression): NaN otherwise
    const Doubles separate = ((l0 > 0) & (l1 > 0) & (l2 > 0)) ? all(1) : all(0);
    const Doubles uv_area = one_u * two_v - one_v * two_u;
    const Doubles side = (uv_area > 0 ? all(1) : uv_area < 0 ? all(-1) : all(0)) * separate * finite;
    const Vector along = (one * two_v - two * one_v) * side;
    const Doubles squared = dot(along, along);
    set(b.along, i, along * (squared > 0 ? 1 / square_root(squared) : all(0)));
    b.twice_area.four[i] = twice_area, b.handedness.four[i] = side;
    b.finite.four[i] = finite, b.separate.four[i] = separate;
    // The angle at corner k, between the leaving and the arriving edge.
    b.cosine[0].four[i] = -dot(e0, e2), b.cosine[1].four[i] = -dot(e1, e0), b.cosine[2].four[i] = -dot(e2, e1);
    for (int k = 0; k < 3; ++k) b.sine[k].four[i] = twice_area;
}

RELIEF_INLINE Vector unit_normal(Vector n) {
    const Doubles squared = dot(n, n);
    const Masks near = size_of(squared - 1) < 1e-6;
    Doubles scale = 1.5 - 0.5 * squared;  // one Newton step
    if ((near[0] & near[1] & near[2] & near[3]) == 0) scale = near ? scale : 1 / square_root(squared);
    return n * scale;
}

/// Projects dP/du and the edges of each corner's angle onto its tangent plane.
RELIEF_INLINE void project(Batch& b, int i) {
    for (int k = 0; k < 3; ++k) {
        const Vector n = unit_normal(at(b.normal[k], i)), here = at(b.position[k], i),
                     leaving = at(b.position[(k + 1) % 3], i) - here, arriving = here - at(b.position[(k + 2) % 3], i);
        // The cross product of the projected edges is the component of `across` along the normal. Their dot product
        // excludes the components along the normal.
        b.sine[k].four[i] = size_of(dot(n, at(b.across, i)));
        b.cosine[k].four[i] += dot(n, leaving) * dot(n, arriving);
        const Vector along = at(b.along, i), flat = along - n * dot(n, along);
        const Doubles squared = dot(flat, flat);
        set(b.on_plane[k], i, flat);
        b.square[k].four[i] = squared > smallest_sine * smallest_sine ? squared : all(0);
    }
}

RELIEF_INLINE void find_angles(const double* __restrict y, const double* __restrict x, float* __restrict angles,
                               int count) {
    for (int i = 0; i < count; ++i) {
        const double size = std::abs(x[i]), low = y[i] < size ? y[i] : size, high = y[i] < size ? size : y[i];
        const float a = float(low / (high > 0 ? high : 1)), s = a * a;
        // Chebyshev polynomial for atan(a) / a over s = a² in [0, 1], with a maximum error of 7.5e-8.
        float p = -0.0046687733f;
        p = p * s + 0.02416619f;
        p = p * s - 0.0593671f;
        p = p * s + 0.09906097f;
        p = p * s - 0.14016585f;
        p = p * s + 0.19969235f;
        p = p * s - 0.3333196f;
        p = (p * s + 0.9999999f) * a;
        const float first = y[i] > size ? float(pi / 2) - p : p;
        angles[i] = x[i] < 0 ? float(pi) - first : first;
    }
}

RELIEF_INLINE void work(Batch& b, TangentMethod method, double area_unit) {
    const bool on_plane = method == TangentMethod::mikktspace, by_angle = on_plane || method == TangentMethod::angle;
    for (int i = 0; i < pieces; ++i) solve(b, i);
    if (on_plane)
        for (int i = 0; i < pieces; ++i) project(b, i);
    if (by_angle)
        for (int k = 0; k < 3; ++k) find_angles(b.sine[k].one, b.cosine[k].one, b.angle[k], batch);
    for (int k = 0; k < 3; ++k) {
        float weight[batch];
        for (int i = 0; i < batch; ++i) {
            const float squared = float(b.square[k].one[i]);  // float precision suffices for the length
            if (on_plane)
                weight[i] = squared > 0 ? b.angle[k][i] / std::sqrt(squared) : 0;
            else if (by_angle)
                weight[i] = b.angle[k][i];
            else
                weight[i] = method == TangentMethod::area ? float(b.twice_area.one[i] / area_unit) : 1;
        }
        for (int c = 0; c < 3; ++c) {
            const Row& direction = on_plane ? b.on_plane[k][c] : b.along[c];
            for (int i = 0; i < batch; ++i) b.pull[k][c][i] = float(direction.one[i] * double(weight[i]));
        }
    }
}

// Not on Windows: GCC aligns no stack there to the 32 bytes of these vectors.
#if defined(__x86_64__) && !defined(_WIN32)
    #define RELIEF_HAS_AVX2
[[gnu::target("avx2")]] void work_avx2(Batch& b, TangentMethod method, double area_unit) { work(b, method, area_unit); }
#endif

void work_best(Batch& b, TangentMethod method, double area_unit) {
#ifdef RELIEF_HAS_AVX2
    static const bool has_avx2 = __builtin_cpu_supports("avx2");
    if (has_avx2) return work_avx2(b, method, area_unit);
#endif
    work(b, method, area_unit);
}

void read(Batch& b, int i, const Mesh& mesh, const uint32_t* at) {
    for (int k = 0; k < 3; ++k) {
        const Vertex& vertex = mesh.vertices[at[k]];
        for (int c = 0; c < 3; ++c) b.position[k][c].one[i] = double(vertex.position[c]);
        for (int c = 0; c < 2; ++c) b.uv[k][c].one[i] = double(vertex.uv[c]);
    }
}

void read_normals(Batch& b, int i, const Mesh& mesh, const UnitNormals& normals, const uint32_t* at) {
    for (int k = 0; k < 3; ++k) {
        const glm::dvec3 normal = normals.are_all_good() ? glm::dvec3(mesh.vertices[at[k]].normal) : normals.at(at[k]);
        for (int c = 0; c < 3; ++c) b.normal[k][c].one[i] = normal[c];
    }
}

TangentFace face_of(const Batch& b, int i) {
    TangentFace face{};
    if (b.finite.one[i] == 0) {
        face.why = TangentFallback::not_finite, face.in_no_group = true;
        return face;
    }
    face.in_no_group = b.separate.one[i] == 0;
    face.handedness = int8_t(b.handedness.one[i]);
    if (b.along[0].one[i] == 0 && b.along[1].one[i] == 0 && b.along[2].one[i] == 0)
        face.why =
            face.in_no_group || b.twice_area.one[i] == 0 ? TangentFallback::zero_area : TangentFallback::degenerate_uv;
    return face;
}

bool is_usable(const glm::vec3& normal) {
    const double squared = glm::dot(glm::dvec3(normal), glm::dvec3(normal));
    return squared > 0 && std::isfinite(squared);
}

glm::dvec3 normal_of_faces(const Mesh& mesh, std::span<const uint32_t> corners) {
    glm::dvec3 sum(0);
    for (const uint32_t corner : corners) {
        const uint32_t* const face = &mesh.indices[corner - corner % 3];
        const glm::dvec3 a(mesh.vertices[face[0]].position), b(mesh.vertices[face[1]].position),
            c(mesh.vertices[face[2]].position);
        const glm::dvec3 across = glm::cross(b - a, c - a);
        if (std::isfinite(glm::dot(across, across))) sum += across;
    }
    const glm::dvec3 normal = direction(sum);
    return normal == glm::dvec3(0) ? glm::dvec3(0, 0, 1) : normal;
}

}  // namespace

UnitNormals::UnitNormals(const Mesh& mesh, const Buffer<uint32_t>& vertex_of, const CornerLists& lists)
    : mesh_(mesh), vertex_of_(vertex_of) {
    for (size_t i = 0; i < mesh.vertices.size(); ++i)
        if (!is_usable(mesh.vertices[i].normal) && vertex_of[i] == i)
            repaired_.emplace(uint32_t(i), normal_of_faces(mesh, lists.at(i)));
}

glm::dvec3 UnitNormals::at(uint32_t vertex) const {
    if (!repaired_.empty())
        if (const auto found = repaired_.find(vertex_of_[vertex]); found != repaired_.end()) return found->second;
    const glm::dvec3 n(mesh_.vertices[vertex].normal);
    const double squared = glm::dot(n, n);
    return std::abs(squared - 1) < 1e-6 ? made_unit(n) : n * (1 / std::sqrt(squared));
}

bool tangent_faces(const Mesh& mesh, const UnitNormals& normals, TangentMethod method, double area_unit, size_t begin,
                   size_t end, std::vector<Contribution>& corners) {
    Batch b{};
    bool some_undecided = false;
    for (size_t first = begin; first < end; first += batch) {
        const int count = int(std::min(end - first, size_t(batch)));
        for (int i = 0; i < count; ++i) read(b, i, mesh, &mesh.indices[3 * (first + size_t(i))]);
        if (method == TangentMethod::mikktspace)
            for (int i = 0; i < count; ++i) read_normals(b, i, mesh, normals, &mesh.indices[3 * (first + size_t(i))]);
        work_best(b, method, area_unit);
        for (int i = 0; i < count; ++i) {
            const TangentFace face = face_of(b, i);
            some_undecided |= face.handedness == 0 && !face.in_no_group;
            for (int k = 0; k < 3; ++k) {
                Contribution& corner = corners[3 * (first + size_t(i)) + size_t(k)];
                corner = {b.pull[k][0][i], b.pull[k][1][i], b.pull[k][2][i], bits_of(face)};
                if (face.why == TangentFallback::not_finite) corner.x = corner.y = corner.z = 0;
            }
        }
    }
    return some_undecided;
}

void angles_of(const double* y, const double* x, float* angles, int count) { find_angles(y, x, angles, count); }

}  // namespace relief
