// Data of vertices, or of instances, beside the four attributes of a mesh.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "framework/gl/object.h"

namespace relief {

/// One attribute of the elements of a stream.
struct StreamAttribute {
    GLuint location;
    GLint count;    ///< of numbers, 1 to 4
    GLenum type;    ///< GL_FLOAT; or a type of whole numbers, which stay whole numbers in the shader (ivec4, uint, ...)
    size_t offset;  ///< bytes from the beginning of an element
};

/// Elements that a vertex array reads beside those of its mesh: one a vertex or, with a divisor, one for every so many
/// instances. The buffer is made when it is first filled. By convention 4 are bones, 5 their weights, and what belongs
/// to instances begins at 6.
class VertexStream {
public:
    VertexStream(std::vector<StreamAttribute> attributes, GLuint divisor = 0)
        : attributes_(std::move(attributes)), divisor_(divisor) {}

    /// In place of what was in it. A vertex array that reads it goes on reading it.
    template <class Element>
    void fill(std::span<const Element> elements) {
        fill(elements.data(), sizeof(Element), elements.size());
    }
    GLsizei count() const { return count_; }  ///< of elements

    /// Lets a vertex array read it, which must be filled. The vertex array that is bound stays bound.
    void attach(GLuint layout) const;

private:
    void fill(const void* elements, size_t stride, size_t count);

    std::vector<StreamAttribute> attributes_;
    GLuint divisor_;
    std::optional<BufferName> buffer_;
    GLsizei stride_ = 0, count_ = 0;
};

}  // namespace relief
