// Other libraries' methods, to be measured beside ours: a separate module, opened when it is needed and
// if it was built (Debian packages libassimp-dev and libopenimageio-dev).
#pragma once

#include <memory>
#include <vector>

#include "framework/image/image.h"
#include "framework/mesh/mesh.h"

namespace relief {

/// Whether the module was built.
bool has_peers();

/// Tangents as Assimp makes them (aiProcess_CalcTangentSpace) of a mesh that it holds in its own form.
class PeerTangents {
public:
    virtual ~PeerTangents() = default;
    /// Makes them anew.
    virtual void run() = 0;
    /// Three a triangle, in the order of the mesh's indices.
    virtual std::vector<glm::vec4> tangents() const = 0;
};
std::unique_ptr<PeerTangents> assimp_tangents(const Mesh& mesh);
using AssimpTangents = std::unique_ptr<PeerTangents>(const Mesh& mesh);

/// The slopes that OpenImageIO writes into a texture for bump mapping (`maketx --bumpslopes`): dh/du and dh/dv a texel,
/// v downwards. It writes a file, which is removed, and that is part of what it takes.
Image openimageio_slopes(const Image& heights);
using OpenImageIOSlopes = void(const Image& heights, Image& slopes);

}  // namespace relief
