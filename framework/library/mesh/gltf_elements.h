// The elements of a glTF file's accessors, as numbers.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>

#include "framework/library/mesh/gltf_document.h"

namespace relief {

/// The elements of an accessor. All of them lie in its buffer. A sparse accessor, and one without a buffer view, whose
/// elements are zeros, has bytes of its own.
class GltfElements {
public:
    /// `type` is "VEC3", for example. `name` is for messages. Throws Error for damage, and for an accessor of another
    /// type.
    GltfElements(GltfDocument& file, int accessor, const char* type, const std::string& name);

    size_t count() const { return count_; }
    /// Returns whether the elements are whole numbers from 0 on.
    bool is_index() const;
    /// Returns a component; a normalised integer becomes a number in [-1, 1].
    double at(size_t element, size_t component = 0) const;
    glm::dvec2 vec2(size_t i) const { return {at(i, 0), at(i, 1)}; }
    glm::dvec3 vec3(size_t i) const { return {at(i, 0), at(i, 1), at(i, 2)}; }
    glm::dvec4 vec4(size_t i) const { return {vec3(i), at(i, 3)}; }
    glm::dmat4 mat4(size_t i) const;

private:
    GltfElements(std::span<const char> bytes, size_t offset, int component_type, size_t components, size_t stride,
                 size_t count, bool normalized, const std::string& name);
    void set_sparse(GltfDocument& file, const GltfObject& sparse, const std::string& name);

    std::string own_;
    const char* first_ = nullptr;  ///< null: own_
    size_t count_ = 0, stride_ = 0, components_ = 0;
    int component_type_ = 0;
    bool normalized_ = false;
};

}  // namespace relief
