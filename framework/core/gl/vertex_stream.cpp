#include "framework/core/gl/vertex_stream.h"

#include "framework/core/base/error.h"

namespace relief {

void VertexStream::fill(const void* elements, size_t stride, size_t count) {
    if (!buffer_) buffer_.emplace();
    stride_ = GLsizei(stride), count_ = GLsizei(count);
    glBindBuffer(GL_ARRAY_BUFFER, *buffer_);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(stride * count), elements, GL_STATIC_DRAW);
}

void VertexStream::attach(GLuint layout) const {
    if (!buffer_) throw Error("a vertex stream is attached before it is filled");
    GLint bound = 0;
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &bound);
    glBindVertexArray(layout);
    glBindBuffer(GL_ARRAY_BUFFER, *buffer_);
    for (const auto& [location, count, type, offset] : attributes_) {
        const void* const from = reinterpret_cast<const void*>(offset);
        glEnableVertexAttribArray(location);
        if (type == GL_FLOAT)
            glVertexAttribPointer(location, count, type, GL_FALSE, stride_, from);
        else
            glVertexAttribIPointer(location, count, type, stride_, from);
        glVertexAttribDivisor(location, divisor_);
    }
    glBindVertexArray(GLuint(bound));
}

}  // namespace relief
