// A model of the user, which a knob accepts in addition to its named shapes: --set shape=FILE.obj, or a glTF file.
#pragma once

#include <string>
#include <vector>

#include "framework/core/base/own_file.h"
#include "framework/core/image/image.h"
#include "framework/library/mesh/model.h"

namespace relief {

/// Prepares a model for a lab:
/// - moves it so that the middle of its bounding box is the origin, and scales the box's half diagonal to `radius`;
/// - makes uv if it has none: each triangle is projected along the axis that its normal is nearest to, so that u
///   grows to the right and v up, and the longest side of the bounding box is one unit.
/// Normals and tangents stay. Throws Error without a place if no triangle has an area.
Mesh prepared_model(Mesh mesh, bool has_uvs, double radius);

/// Where a file's positions are in a lab: scale * (position - middle).
struct Placement {
    glm::dvec3 middle{};
    double scale = 1;
};
/// Returns the placement that prepared_model() applies to a mesh. Throws as it does.
Placement placement_of(const Mesh& mesh, double radius);

/// Returns a place in the lab that one placement has given, as another placement gives it.
inline glm::dvec3 placed(const glm::dvec3& place, const Placement& from, const Placement& to) {
    return to.scale * (place / from.scale + from.middle - to.middle);
}

/// Returns the side, in metres, of the square that a unit of u and v covers on average: the square root of the mesh's
/// area divided by its area in uv. 1 if either is 0.
double metres_per_uv(const Mesh& mesh);

/// A normal map of a model, and how it goes on beyond its border.
struct OwnNormalMap {
    Image normals;
    GltfWrap wrap_u = GltfWrap::repeat, wrap_v = wrap_u;
};

class OwnMesh final : public OwnFile {
public:
    /// `radius` of the lab's view, metres: see prepared_model().
    explicit OwnMesh(double radius) : radius_(radius) {}

    const char* kind() const override { return "an OBJ or glTF file"; }
    bool accepts(const std::filesystem::path& file) const override { return is_named_as_model(file); }
    /// Returns the prepared model. Empty until a file has been read. Its tangents are of use if has_tangents().
    const Mesh& mesh() const { return mesh_; }
    /// Returns whether all tangents are those of the file. Only glTF has them.
    bool has_tangents() const { return has_tangents_; }
    /// Returns the model with the file's tangents, or else with MikkTSpace's.
    Mesh mesh_with_tangents() const;
    /// Returns the normal maps of the file's materials. Only glTF has them.
    const std::vector<OwnNormalMap>& normal_maps() const { return normal_maps_; }
    /// Returns the parts of mesh() and of mesh_with_tangents() with one map each; together all of their triangles.
    const std::vector<GltfPart>& parts() const { return parts_; }
    const Placement& placement() const { return placement_; }

private:
    std::vector<std::string> load(const std::filesystem::path& file) override;

    const double radius_;
    Mesh mesh_;
    Placement placement_;
    bool has_tangents_ = false, tangents_follow_uv_ = false;
    std::vector<OwnNormalMap> normal_maps_;
    std::vector<GltfPart> parts_;
};

}  // namespace relief
