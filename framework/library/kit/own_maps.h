// The normal maps of a user's model as textures, and draws of the model's parts with them.
#pragma once

#include <vector>

#include "framework/core/gl/texture.h"
#include "framework/library/kit/kept.h"
#include "framework/library/kit/own_mesh.h"

namespace relief {

/// Textures of the normal maps of an OwnMesh, which must outlive it. They are loaded when a draw first needs them.
class OwnMaps {
public:
    explicit OwnMaps(const OwnMesh& model) : model_(model) {}

    /// Draws the mesh whose layout is bound, part by part of OwnMesh::parts(). Each part has its normal map on texture
    /// unit 0; a part without a map has a flat one.
    void draw() const;
    /// Returns the first normal map, for a surface that is not the model's. Precondition: the model has one.
    const Texture& first() const { return textures()[0]; }

private:
    const std::vector<Texture>& textures() const;

    const OwnMesh& model_;
    mutable Kept<std::vector<Texture>, int> textures_;  ///< by the model
    Texture flat_{"a flat texel", [] {
                      Image image(1, 1, 3);
                      image.values = {0.5f, 0.5f, 1};
                      return image;
                  }};
};

}  // namespace relief
