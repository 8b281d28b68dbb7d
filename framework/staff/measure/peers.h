// Methods of other libraries, measured for comparison. They are in a separate module that is opened on demand. It is
// built if libassimp-dev, libembree-dev and libopenimageio-dev are installed.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "framework/core/base/mesh.h"
#include "framework/core/base/ray.h"
#include "framework/core/image/image.h"

namespace relief::measure {

/// Returns whether the module was built.
bool has_peers();

/// Assimp's tangents (aiProcess_CalcTangentSpace) for a mesh, which it stores in its own format.
class PeerTangents {
public:
    virtual ~PeerTangents() = default;
    /// Computes the tangents again.
    virtual void run() = 0;
    /// Returns three tangents per triangle, in the order of the mesh's indices.
    virtual std::vector<glm::vec4> tangents() const = 0;
};
std::unique_ptr<PeerTangents> assimp_tangents(const Mesh& mesh);
using AssimpTangents = std::unique_ptr<PeerTangents>(const Mesh& mesh);

/// Returns the mesh as the text of an OBJ file: `v`, `vt` and `vn` for each vertex, and one `f` for each triangle.
std::string obj_text(const Mesh& mesh);

/// Reads a model of triangles as Assimp does, with identical vertices joined, on one thread; drops it.
void assimp_model(const std::filesystem::path& path);
using AssimpModel = void(const std::filesystem::path& path);

/// Reads a picture to 32-bit floats as OpenImageIO does, on one thread; drops it.
void openimageio_pixels(const std::filesystem::path& path);
using OpenImageIOPixels = void(const std::filesystem::path& path);

/// Computes the slopes that OpenImageIO stores for bump mapping (`maketx --bumpslopes`): (dh/du, dh/dv) per texel, v
/// downwards. It writes a temporary file, which is part of its time.
Image openimageio_slopes(const Image& heights);
using OpenImageIOSlopes = void(const Image& heights, Image& slopes);

/// Embree's first hits of a mesh, which it stores in its own format, in single precision on one thread. `robust` sets
/// RTC_SCENE_FLAG_ROBUST. Then no rays slip through edges, and few through vertices: 1 to 4 in 1000 that aim at one
/// (Embree 3.13). `any_machine` restricts it to instructions that every machine has, so that the hits are the same on
/// all.
class PeerHits {
public:
    virtual ~PeerHits() = default;
    /// Sets hits[i] to t of the first hit of ray i with t in [0, 2], in multiples of its direction; -1 for a miss.
    virtual void run(const std::vector<Ray>& rays, std::vector<double>& hits) = 0;
};
std::unique_ptr<PeerHits> embree_hits(const Mesh& mesh, bool robust, bool any_machine);
using EmbreeHits = std::unique_ptr<PeerHits>(const Mesh& mesh, bool robust, bool any_machine);

}  // namespace relief::measure
