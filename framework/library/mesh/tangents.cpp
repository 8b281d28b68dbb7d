#include "framework/library/mesh/tangents.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <mutex>
#include <unordered_map>

#include "framework/core/base/parallel.h"
#include "framework/library/mesh/corners.h"
#include "framework/library/mesh/frame.h"
#include "framework/library/mesh/tangent_groups.h"

namespace relief {
namespace {

/// The minimum sine of the angle between a float tangent and the normal. Floats are accurate to 6e-8, so below it the
/// projection is off by tens of degrees.
constexpr double smallest_sine = 2e-7;

/// All data that is computed before the loop over vertices. `result` holds the triangles' contributions until then.
struct Solver {
    const Mesh& mesh;
    TangentMethod method;
    unsigned threads;
    Buffer<uint32_t> vertex_of;
    CornerLists lists;
    UnitNormals normals;
    std::vector<glm::vec4>& result;

    Solver(const Mesh& all, TangentMethod how, std::vector<glm::vec4>& tangents, unsigned thread_count)
        : mesh(all),
          method(how),
          threads(thread_count),
          vertex_of(welded_vertices(all)),
          lists(all, vertex_of, thread_count),
          normals(all, vertex_of, lists),
          result(tangents) {
        result.resize(mesh.indices.size());
        const double area_unit = method == TangentMethod::area ? largest_area() : 1;
        std::atomic<bool> some_undecided = false;  // some triangle has no handedness yet
        parallel_pieces(mesh.indices.size() / 3, 1 << 12, threads, [&](size_t begin, size_t end) {
            if (tangent_faces(mesh, normals, method, area_unit, begin, end, result)) some_undecided = true;
        });
        if (some_undecided) take_on_handedness(mesh, vertex_of, lists, result);
    }

private:
    /// Returns a unit for areas, so that areas of any magnitude fit in floats.
    double largest_area() const {
        double largest = 0;
        for (size_t i = 0; i < mesh.indices.size(); i += 3) {
            const glm::dvec3 a(mesh.vertices[mesh.indices[i]].position);
            const glm::dvec3 across = glm::cross(glm::dvec3(mesh.vertices[mesh.indices[i + 1]].position) - a,
                                                 glm::dvec3(mesh.vertices[mesh.indices[i + 2]].position) - a);
            const double squared = glm::dot(across, across);
            if (std::isfinite(squared)) largest = std::max(largest, squared);
        }
        return largest > 0 ? std::sqrt(largest) : 1;
    }
};

/// Computes the tangents of all corners at one vertex. One instance per thread, reused from vertex to vertex.
class VertexTangents {
public:
    explicit VertexTangents(const Solver& solver) : solver_(solver), result_(solver.result) {}

    void write(uint32_t vertex) {
        const std::span<const uint32_t> list = solver_.lists.at(vertex);
        if (list.empty()) return;
        normal_ = solver_.normals.at(vertex);
        bad_normal_ = solver_.normals.is_repaired(vertex);
        report.corners += list.size();
        if (!bad_normal_ && write_plain(list)) return;

        gather(list);
        sums_.assign(list.size(), glm::dvec3(0));
        for (size_t i = 0; i < list.size(); ++i) sums_[corners_[i].group] += glm::dvec3(corners_[i].pull);
        for (size_t i = 0; i < list.size(); ++i)
            if (corners_[i].group == i) sums_[i] = tangent_of(sums_[i]);
        const size_t lender = first_with_tangent();
        for (size_t i = 0; i < list.size(); ++i) result_[list[i]] = tangent_of_corner(i, lender);
    }

    TangentReport report;

private:
    static float side(int handedness) { return handedness < 0 ? -1.0f : 1.0f; }

    /// Handles the common vertex: all triangles have tangents of one handedness, and so has their mean. Otherwise
    /// returns false without any effect.
    bool write_plain(std::span<const uint32_t> list) {
        if (solver_.method == TangentMethod::per_face) return false;
        const int8_t handedness = face_of(result_[list[0]]).handedness;
        glm::dvec3 sum(0);
        for (const uint32_t at : list) {
            const TangentFace face = face_of(result_[at]);
            if (face.handedness != handedness || face.why != TangentFallback::none) return false;
            sum += glm::dvec3(result_[at]);
        }
        if (solver_.method == TangentMethod::mikktspace && !are_connected(list)) return false;
        const glm::dvec3 tangent = tangent_of(sum);
        if (handedness == 0 || tangent == glm::dvec3(0)) return false;
        for (const uint32_t at : list) result_[at] = glm::vec4(tangent, side(handedness));
        return true;
    }

    /// Returns the tangent of corner i and counts its fallback in the report. `lender` is the first corner that has a
    /// tangent.
    glm::vec4 tangent_of_corner(size_t i, size_t lender) {
        const CornerAtVertex& corner = corners_[i];
        const bool has_group = sums_[corner.group] != glm::dvec3(0), has_own = corner.face.why == TangentFallback::none;
        const bool can_inherit = solver_.method != TangentMethod::per_face && lender < corners_.size();
        // All corners of a triangle have the same handedness. Only an invisible triangle may inherit it per corner.
        const bool is_invisible = corner.face.in_no_group && corner.face.why != TangentFallback::not_finite;
        const bool has_side = !is_invisible || !can_inherit;
        const float own = side((has_side ? corner : corners_[lender]).face.handedness);
        if (bad_normal_)
            ++report.fell_back[size_t(TangentFallback::bad_normal)];
        else if (!has_group || !has_own)
            ++report.fell_back[size_t(reason(i))];
        if (!bad_normal_ && (has_group ? !has_own : can_inherit)) ++report.inherited;
        if (has_group) return glm::vec4(sums_[corner.group], own);
        if (can_inherit) return glm::vec4(sums_[corners_[lender].group], own);
        return glm::vec4(any_perpendicular(normal_), own);
    }

    /// Returns whether the triangles, all of one handedness, are one group.
    bool are_connected(std::span<const uint32_t> list) {
        if (is_closed_fan(solver_.mesh, solver_.vertex_of, list)) return true;
        gather_corners(solver_.mesh, solver_.vertex_of, result_, list, corners_);
        group_corners(corners_, scratch_);
        return std::all_of(corners_.begin(), corners_.end(),
                           [](const CornerAtVertex& corner) { return corner.group == 0; });
    }

    void gather(std::span<const uint32_t> list) {
        gather_corners(solver_.mesh, solver_.vertex_of, result_, list, corners_);
        if (solver_.method == TangentMethod::mikktspace) return group_corners(corners_, scratch_);
        if (solver_.method == TangentMethod::per_face) return;
        // One group for each handedness; a corner without handedness waits for a lender.
        uint32_t first[2] = {UINT32_MAX, UINT32_MAX};
        for (uint32_t i = 0; i < corners_.size(); ++i) {
            const int8_t handedness = corners_[i].face.handedness;
            if (handedness == 0) continue;
            uint32_t& group = first[handedness < 0];
            if (group == UINT32_MAX) group = i;
            corners_[i].group = group;
        }
    }

    /// Projects onto the tangent plane; zero if the result is below the limit.
    glm::dvec3 projected(const glm::dvec3& v) const {
        const glm::dvec3 along = v - normal_ * glm::dot(normal_, v);
        const bool enough = glm::dot(along, along) > smallest_sine * smallest_sine * glm::dot(v, v);
        return enough ? along : glm::dvec3(0);
    }

    /// Returns a unit vector perpendicular to the normal, or zero. Projects twice: normalising amplifies the first
    /// projection's rounding error by 1 / sine.
    glm::dvec3 tangent_of(const glm::dvec3& v) const {
        const glm::dvec3 unit = direction(projected(v));
        return made_unit(unit - normal_ * glm::dot(normal_, unit));
    }

    size_t first_with_tangent() const {
        for (size_t i = 0; i < corners_.size(); ++i)
            if (sums_[corners_[i].group] != glm::dvec3(0)) return i;
        return corners_.size();
    }

    TangentFallback reason(size_t i) const {
        const TangentFallback why = corners_[i].face.why;
        return why == TangentFallback::none ? TangentFallback::parallel_to_normal : why;
    }

    const Solver& solver_;
    std::vector<glm::vec4>& result_;
    glm::dvec3 normal_{};
    bool bad_normal_ = false;
    std::vector<CornerAtVertex> corners_;
    std::vector<glm::dvec3> sums_;
    std::vector<uint64_t> scratch_;
};

TangentReport solve(const Solver& solver) {
    constexpr size_t ahead = 4;  // vertices whose corners are prefetched
    TangentReport report;
    std::mutex mutex;
    parallel_pieces(solver.mesh.vertices.size(), 1 << 12, solver.threads, [&](size_t begin, size_t end) {
        VertexTangents at(solver);
        for (size_t i = begin; i < end; ++i) {
            if (i + ahead < end)
                for (const uint32_t corner : solver.lists.at(i + ahead)) {
                    __builtin_prefetch(&solver.result[corner]);
                    __builtin_prefetch(&solver.mesh.indices[corner]);
                }
            if (solver.vertex_of[i] == i) at.write(uint32_t(i));
        }
        const std::lock_guard lock(mutex);
        report.corners += at.report.corners, report.inherited += at.report.inherited;
        for (size_t why = 0; why < std::size(report.fell_back); ++why)
            report.fell_back[why] += at.report.fell_back[why];
    });
    return report;
}

struct Split {
    uint32_t vertex;
    std::array<float, 4> tangent;
    bool operator==(const Split&) const = default;
};
struct SplitHash {
    size_t operator()(const Split& split) const {
        size_t hash = split.vertex;
        for (const float value : split.tangent) hash = hash * 0x9e3779b97f4a7c15 + std::hash<float>()(value);
        return hash;
    }
};

}  // namespace

size_t TangentReport::total() const {
    size_t sum = 0;
    for (const size_t one : fell_back) sum += one;
    return sum;
}

std::string TangentReport::text() const {
    if (total() == 0) return fmt::format("{} corners, none fell back", corners);
    constexpr const char* names[] = {"",          "bad normal",    "not finite",
                                     "zero area", "degenerate uv", "parallel to normal"};
    std::string reasons;
    for (size_t i = 1; i < std::size(names); ++i)
        if (fell_back[i] > 0) reasons += fmt::format("{}{} {}", reasons.empty() ? "" : ", ", fell_back[i], names[i]);
    std::string text = fmt::format("{} of {} corners fell back: {}", total(), corners, reasons);
    if (inherited > 0) text += fmt::format("; {} of them took a neighbour's tangent", inherited);
    return text;
}

void corner_tangents(const Mesh& mesh, TangentMethod method, std::vector<glm::vec4>& result, TangentReport* report,
                     unsigned threads) {
    check_indices(mesh);
    const TangentReport made = solve(Solver(mesh, method, result, threads));
    if (report) *report = made;
}

std::vector<glm::vec4> corner_tangents(const Mesh& mesh, TangentMethod method, TangentReport* report,
                                       unsigned threads) {
    std::vector<glm::vec4> result;
    corner_tangents(mesh, method, result, report, threads);
    return result;
}

Mesh with_tangents(const Mesh& mesh, TangentMethod method, TangentReport* report, unsigned threads) {
    check_indices(mesh);
    std::vector<glm::vec4> tangents;
    Mesh result = mesh;
    {
        const Solver solver(mesh, method, tangents, threads);
        const TangentReport made = solve(solver);
        if (report) *report = made;
        for (uint32_t i = 0; i < result.vertices.size(); ++i) {
            glm::vec3& normal = result.vertices[i].normal;
            const bool unit = std::abs(glm::dot(glm::dvec3(normal), glm::dvec3(normal)) - 1) < 1e-6;
            if (!unit) normal = glm::vec3(solver.normals.at(i));
            result.vertices[i].tangent =
                glm::vec4(any_perpendicular(glm::dvec3(normal)), 1);  // for a vertex that no triangle uses
        }
    }
    std::vector<bool> taken(mesh.vertices.size());
    std::unordered_map<Split, uint32_t, SplitHash> splits;
    for (size_t i = 0; i < mesh.indices.size(); ++i) {
        const uint32_t vertex = mesh.indices[i];
        const glm::vec4 tangent = tangents[i];
        if (!taken[vertex]) {
            taken[vertex] = true;
            result.vertices[vertex].tangent = tangent;
        } else if (result.vertices[vertex].tangent != tangent) {
            const auto [at, is_new] = splits.try_emplace({vertex, {tangent.x, tangent.y, tangent.z, tangent.w}},
                                                         uint32_t(result.vertices.size()));
            if (is_new) {
                Vertex copy = result.vertices[vertex];
                copy.tangent = tangent;
                result.vertices.push_back(copy);
            }
            result.indices[i] = at->second;
        }
    }
    return result;
}

}  // namespace relief
