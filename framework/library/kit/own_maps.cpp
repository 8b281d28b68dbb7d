#include "framework/library/kit/own_maps.h"

#include "framework/core/gl/gl.h"

namespace relief {
namespace {

Wrap texture_wrap(GltfWrap wrap) {
    return wrap == GltfWrap::repeat ? Wrap::repeat : wrap == GltfWrap::clamp ? Wrap::clamp : Wrap::mirror;
}

}  // namespace

const std::vector<Texture>& OwnMaps::textures() const {
    return textures_.get({model_.version()}, [this] {
        std::vector<Texture> textures;
        for (const OwnNormalMap& map : model_.normal_maps())
            textures.emplace_back(
                "the model's map", [&map] { return map.normals; },
                TextureOptions{.wrap = texture_wrap(map.wrap_u), .wrap_v = texture_wrap(map.wrap_v)});
        return textures;
    });
}

void OwnMaps::draw() const {
    for (const auto& [first, count, map] : model_.parts()) {
        bind(0, map < 0 ? flat_ : textures()[size_t(map)]);
        glDrawElements(GL_TRIANGLES, GLsizei(count), GL_UNSIGNED_INT,
                       reinterpret_cast<const void*>(first * sizeof(uint32_t)));
    }
}

}  // namespace relief
