#include "framework/library/mesh/gltf.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/log.h"
#include "framework/core/base/own_file.h"
#include "framework/library/mesh/frame.h"
#include "framework/library/mesh/gltf_primitive.h"
#include "framework/library/mesh/gltf_scene.h"

namespace relief {
namespace {

/// A matrix for positions, with those for directions that follow from it.
struct Motion {
    glm::dmat4 matrix;
    glm::dmat3 linear, of_normals;
    double side;  ///< -1 if it mirrors, else 1

    explicit Motion(const glm::dmat4& world_from_mesh) : matrix(world_from_mesh), linear(world_from_mesh) {
        // Directions need no length, and the products below would leave the range of doubles without this.
        double largest = 0;
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k) largest = std::max(largest, std::abs(linear[i][k]));
        if (largest > 0 && std::isfinite(largest)) linear /= largest;
        side = glm::determinant(linear) < 0 ? -1 : 1;
        // The inverse transpose, times the determinant: it exists for each matrix.
        of_normals = {side * glm::cross(linear[1], linear[2]), side * glm::cross(linear[2], linear[0]),
                      side * glm::cross(linear[0], linear[1])};
    }
};

GltfWrap wrap_of(GltfDocument& file, const GltfObject& sampler, const char* key) {
    switch (const size_t wrap = sampler.whole(key, 10497)) {
        case 33071:
            return GltfWrap::clamp;
        case 33648:
            return GltfWrap::mirror;
        default:
            if (wrap != 10497) file.notes.add(sampler.name(), fmt::format("glTF has no {} {}: it repeats", key, wrap));
            return GltfWrap::repeat;
    }
}

class Merged {
public:
    Merged(GltfDocument& file, const ObjLimits& limits) : file_(file), limits_(limits) {}

    GltfModel all(const std::vector<GltfPlacedMesh>& meshes) {
        for (const GltfPlacedMesh& placed : meshes) ++uses_[placed.mesh];
        for (const GltfPlacedMesh& placed : meshes) add(placed);
        return finish();
    }

private:
    void add(const GltfPlacedMesh& placed) {
        const GltfObject mesh = file_.element("meshes", placed.mesh, "mesh"),
                         node = file_.element("nodes", placed.node, "node");
        const bool has_own_weights = node.has("weights");
        const std::vector<double> weights = (has_own_weights ? node : mesh).numbers("weights");
        const std::vector<GltfObject> primitives = mesh.objects("primitives");
        for (size_t i = 0; i < primitives.size(); ++i) {
            const std::string name = fmt::format("mesh {}, primitive {}", placed.mesh, i);
            const auto read = [&] {
                const size_t most = limits_.corners - std::max(model_.mesh.indices.size(), world_.size());
                return read_primitive(file_, primitives[i], name, weights, most);
            };
            // Instances of a mesh share its primitives.
            if (has_own_weights || uses_[placed.mesh] < 2) {
                add(read(), primitives[i], name, placed);
                continue;
            }
            auto found = read_.find({placed.mesh, i});
            if (found == read_.end()) found = read_.emplace(std::pair(placed.mesh, i), read()).first;
            add(found->second, primitives[i], name, placed);
        }
    }

    GltfModel finish() {
        if (model_.mesh.indices.empty()) throw Error("has no triangles in its scene");
        if (model_.has_uvs)
            for (const std::string& name : without_uvs_) file_.notes.add(name, "no uv: (0, 0) everywhere");
        model_.has_tangents = has_tangents_ && model_.has_uvs;
        centre_and_round();
        sort_parts();
        model_.notes = file_.notes.lines();
        return std::move(model_);
    }

    void add(const GltfPrimitive& primitive, const GltfObject& object, const std::string& name,
             const GltfPlacedMesh& placed) {
        const Mesh& mesh = primitive.mesh;
        if (mesh.indices.empty()) return;
        if (mesh.indices.size() > limits_.corners - model_.mesh.indices.size() ||
            mesh.vertices.size() > limits_.corners - world_.size())
            throw Error(fmt::format("too large: more than {} corners or vertices", limits_.corners));
        model_.has_uvs |= primitive.has_uvs, has_tangents_ &= primitive.has_tangents;
        if (!primitive.has_uvs) without_uvs_.push_back(name);
        const bool is_skinned = !placed.world_from_bound.empty() && !primitive.influences.empty();
        if (!placed.world_from_bound.empty() && !is_skinned)
            file_.notes.add(name, "no joints and weights: its skin does not move it");
        const uint32_t first_vertex = uint32_t(world_.size());
        const Motion of_node(placed.world_from_mesh);
        double sides = 0;
        for (size_t i = 0; i < mesh.vertices.size(); ++i) {
            const std::optional<Motion> of_joints =
                is_skinned ? std::optional(Motion(blended(primitive.influences[i], placed, name))) : std::nullopt;
            const Motion& motion = of_joints ? *of_joints : of_node;
            sides += motion.side;
            add(mesh.vertices[i], motion, name, i);
        }
        const uint32_t first_index = uint32_t(model_.mesh.indices.size());
        for (size_t i = 0; i < mesh.indices.size(); ++i) {
            const size_t corner = i % 3, place = sides < 0 ? i - corner + (3 - corner) % 3 : i;  // 0, 2, 1
            model_.mesh.indices.push_back(first_vertex + mesh.indices[place]);
        }
        model_.parts.push_back({first_index, uint32_t(mesh.indices.size()), map_of(object, primitive.has_uvs, name)});
    }

    void add(const Vertex& vertex, const Motion& motion, const std::string& name, size_t index) {
        const glm::dvec3 position(motion.matrix * glm::dvec4(vertex.position, 1)),
            normal = motion.of_normals * glm::dvec3(vertex.normal), along = motion.linear * glm::dvec3(vertex.tangent);
        const double length = glm::length(normal), length_along = glm::length(along);
        const glm::vec3 rounded(position);
        if (!std::isfinite(rounded.x + rounded.y + rounded.z) || !std::isfinite(length + length_along))
            throw Error(fmt::format("{}: vertex {} has a number that is not finite", name, index));
        world_.push_back(position);
        Vertex moved = vertex;
        moved.normal = length > 0 ? normal / length : glm::dvec3(0, 0, 1);
        moved.tangent = length_along > 0 ? glm::dvec4(along / length_along, double(vertex.tangent.w) * motion.side)
                                         : glm::dvec4(any_perpendicular(glm::normalize(glm::dvec3(moved.normal))), 1);
        model_.mesh.vertices.push_back(moved);
    }

    glm::dmat4 blended(const std::vector<GltfInfluence>& influences, const GltfPlacedMesh& placed,
                       const std::string& name) {
        glm::dmat4 sum(0);
        double weights = 0;
        for (const GltfInfluence& one : influences)
            for (int k = 0; k < 4; ++k) {
                const uint32_t joint = one.joint[size_t(k)];
                if (one.weight[k] == 0) continue;
                if (joint >= placed.world_from_bound.size())
                    throw Error(
                        fmt::format("damaged: {} names joint {} of {}", name, joint, placed.world_from_bound.size()));
                sum += one.weight[k] * placed.world_from_bound[joint], weights += one.weight[k];
            }
        if (weights > 0) return sum / weights;  // small integers rarely add up to 1
        file_.notes.add(name, "vertices without weights follow the first joint");
        return placed.world_from_bound[0];
    }

    /// Returns the index of a primitive's normal map, or -1.
    int map_of(const GltfObject& primitive, bool has_uvs, const std::string& name) {
        if (!primitive.has("material")) return -1;
        const GltfObject material = file_.element("materials", primitive.index("material"), "material");
        if (material.extension("KHR_materials_clearcoat").has("clearcoatNormalTexture"))
            file_.notes.add(material.name(), "the normal map of its clear coat is not read");
        const GltfObject info = material.object("normalTexture");
        if (info.index("index") < 0) return -1;
        if (!has_uvs) {
            file_.notes.add(name, "a normal map, but no uv for it: it is smooth");
            return -1;
        }
        const std::pair key(info.index("index"), info.number("scale", 1));
        const auto found = maps_.find(key);
        if (found != maps_.end()) return found->second;
        const GltfObject texture = file_.element("textures", key.first, "texture");
        if (!texture.has("source"))
            throw Error(
                fmt::format("{}: its normal map is in a format that is not read: use PNG or JPEG", material.name()));
        GltfNormalMap map{file_.picture(texture.index("source")), key.second};
        if (texture.has("sampler")) {
            const GltfObject sampler = file_.element("samplers", texture.index("sampler"), "sampler");
            map.wrap_u = wrap_of(file_, sampler, "wrapS"), map.wrap_v = wrap_of(file_, sampler, "wrapT");
            constexpr size_t nearest = 9728;
            if (sampler.whole("magFilter", 0) == nearest)
                file_.notes.add(sampler.name(), "nearest filtering is not read: the map is filtered linearly");
        }
        model_.normal_maps.push_back(std::move(map));
        return maps_[key] = int(model_.normal_maps.size()) - 1;
    }

    /// Rounds the positions to floats, after moving the model to the origin if it is farther from there than it is
    /// large.
    void centre_and_round() {
        glm::dvec3 low(INFINITY), high(-INFINITY);
        for (const uint32_t index : model_.mesh.indices)
            low = glm::min(low, world_[index]), high = glm::max(high, world_[index]);
        const glm::dvec3 middle = 0.5 * (low + high);
        if (glm::length(middle) > glm::length(high - low)) model_.centre = middle;
        for (size_t i = 0; i < world_.size(); ++i) model_.mesh.vertices[i].position = world_[i] - model_.centre;
    }

    /// Makes one part of the triangles of each map.
    void sort_parts() {
        if (std::is_sorted(model_.parts.begin(), model_.parts.end(), has_lower_map)) return join_parts();
        std::stable_sort(model_.parts.begin(), model_.parts.end(), has_lower_map);
        std::vector<uint32_t> sorted;
        sorted.reserve(model_.mesh.indices.size());
        for (GltfPart& part : model_.parts) {
            const auto first = model_.mesh.indices.begin() + part.first_index;
            part.first_index = uint32_t(sorted.size());
            sorted.insert(sorted.end(), first, first + part.index_count);
        }
        model_.mesh.indices = std::move(sorted);
        join_parts();
    }
    void join_parts() {
        std::vector<GltfPart> joined;
        for (const GltfPart& part : model_.parts)
            if (!joined.empty() && joined.back().normal_map == part.normal_map)
                joined.back().index_count += part.index_count;
            else
                joined.push_back(part);
        model_.parts = std::move(joined);
    }
    static bool has_lower_map(const GltfPart& a, const GltfPart& b) { return a.normal_map < b.normal_map; }

    GltfDocument& file_;
    const ObjLimits& limits_;
    GltfModel model_;
    bool has_tangents_ = true;
    std::vector<glm::dvec3> world_;  ///< positions, which become floats at the end
    std::vector<std::string> without_uvs_;
    std::map<std::pair<int, double>, int> maps_;            ///< by texture and scale
    std::map<int, int> uses_;                               ///< of each mesh
    std::map<std::pair<int, size_t>, GltfPrimitive> read_;  ///< by mesh and place in it, if the mesh has several uses
};

}  // namespace

GltfModel parse_gltf(const std::string& bytes, const std::filesystem::path& folder, const ObjLimits& limits) {
    GltfDocument file(bytes, folder, limits);
    return Merged(file, limits).all(placed_meshes(file));
}

GltfModel read_gltf(const std::filesystem::path& file, const ObjLimits& limits) {
    const std::string bytes = read_file(file, limits.bytes);
    try {
        GltfModel model = parse_gltf(bytes, file.parent_path(), limits);
        for (std::string& note : model.notes) note = note_about({file}, note);
        return model;
    } catch (const Error& error) {
        throw Error({file}, error.what());
    }
}

bool is_named_as_gltf(const std::filesystem::path& file) {
    const std::string ending = lower_ending(file);
    return ending == ".gltf" || ending == ".glb";
}

}  // namespace relief
