// Methods of other libraries, measured for comparison. They are in a module of their own, opened when needed; it is
// built if libassimp-dev and libopenimageio-dev are installed.
#pragma once

#include <memory>
#include <vector>

#include "framework/image/image.h"
#include "framework/mesh/mesh.h"

namespace relief {

/// Whether the module was built.
bool has_peers();

/// Assimp's tangents (aiProcess_CalcTangentSpace) for a mesh, which it keeps in its own form.
class PeerTangents {
public:
    virtual ~PeerTangents() = default;
    /// Computes the tangents again.
    virtual void run() = 0;
    /// Three per triangle, in the order of the mesh's indices.
    virtual std::vector<glm::vec4> tangents() const = 0;
};
std::unique_ptr<PeerTangents> assimp_tangents(const Mesh& mesh);
using AssimpTangents = std::unique_ptr<PeerTangents>(const Mesh& mesh);

/// The slopes that OpenImageIO stores for bump mapping (`maketx --bumpslopes`): (dh/du, dh/dv) per texel, v downwards.
/// It writes a temporary file; that is part of its time.
Image openimageio_slopes(const Image& heights);
using OpenImageIOSlopes = void(const Image& heights, Image& slopes);

}  // namespace relief
