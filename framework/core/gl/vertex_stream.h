// Data of each vertex, or of each instance, on the GPU.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "framework/core/gl/object.h"

namespace relief {

/// One attribute of a stream's elements.
struct StreamAttribute {
    GLuint location;
    GLint count;    ///< number of components, 1 to 4
    GLenum type;    ///< GL_FLOAT, or an integer type, which stays an integer in the shader (ivec4, uint, ...)
    size_t offset;  ///< bytes from the start of an element
};

/// Elements that a vertex array reads: one per vertex, or one per `divisor` instances if `divisor` is not 0. The buffer
/// is created by the first fill(). Locations by convention: 0 to 3 as of GpuMesh, 4 bones, 5 bone weights, 6 and up
/// per-instance data.
class VertexStream {
public:
    VertexStream(std::vector<StreamAttribute> attributes, GLuint divisor = 0)
        : attributes_(std::move(attributes)), divisor_(divisor) {}

    /// Replaces the content. Vertex arrays that were attached stay attached.
    template <class Element>
    void fill(std::span<const Element> elements) {
        fill(elements.data(), sizeof(Element), elements.size());
    }
    GLsizei count() const { return count_; }  ///< number of elements

    /// Adds the stream's attributes to a vertex array. Keeps the current vertex array binding. Throws Error before the
    /// first fill().
    void attach(GLuint layout) const;

private:
    void fill(const void* elements, size_t stride, size_t count);

    std::vector<StreamAttribute> attributes_;
    GLuint divisor_;
    std::optional<BufferName> buffer_;
    GLsizei stride_ = 0, count_ = 0;
};

}  // namespace relief
