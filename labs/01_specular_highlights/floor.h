// The floor of lab 01, by hand: these are the calls that GpuMesh, Texture and Program::set make for everything else.
#pragma once

#include <cstddef>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "framework/core/gl/object.h"
#include "framework/core/image/asset.h"
#include "framework/library/mesh/shapes.h"
#include "scene.h"

namespace relief::colonnade {

/// A vertex array and a texture. Construct it when a context is current.
class Floor {
public:
    Floor() {
        make_vertex_array(make_quad(ground));
        make_texture(read_asset_chain("paving_albedo.png", ColorSpace::srgb));
    }

    // Precondition of both: the program is in use. A uniform that it does not use has the location -1, which GL
    // ignores.
    void bind_albedo(GLuint program) const {
        glUniform1i(glGetUniformLocation(program, "s_albedo"), 0);  // a sampler is the number of a texture unit
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, albedo_);
    }
    /// Precondition: the textures are bound.
    void draw(GLuint program) const {
        const glm::mat4 world_from_model = glm::rotate(glm::mat4(1), glm::radians(-90.0f), {1, 0, 0});
        glUniformMatrix4fv(glGetUniformLocation(program, "u_world_from_model"), 1, GL_FALSE,
                           glm::value_ptr(world_from_model));
        glBindVertexArray(layout_);
        glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
    }

private:
    void make_vertex_array(const Mesh& mesh) {
        index_count_ = GLsizei(mesh.indices.size());
        glBindVertexArray(layout_);  // remembers the index buffer, and for each attribute its buffer and layout
        glBindBuffer(GL_ARRAY_BUFFER, vertices_);
        glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(mesh.vertices.size() * sizeof(Vertex)), mesh.vertices.data(),
                     GL_STATIC_DRAW);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(mesh.indices.size() * sizeof(uint32_t)), mesh.indices.data(),
                     GL_STATIC_DRAW);
        attribute(0, 3, offsetof(Vertex, position));  // location 0 of surface.vert: three floats
        attribute(1, 3, offsetof(Vertex, normal));
        attribute(2, 4, offsetof(Vertex, tangent));
        attribute(3, 2, offsetof(Vertex, uv));
    }
    static void attribute(GLuint location, GLint floats, size_t offset) {
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, floats, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                              reinterpret_cast<const void*>(offset));
    }

    void make_texture(const Texels& texels) {
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, albedo_);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);  // rows of three bytes a texel end anywhere
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        if (GLAD_GL_EXT_texture_filter_anisotropic && !is_software_renderer())  // there it takes too long
            glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 8);
        GLint i = 0;
        for (const Texels::Level& level : texels.levels)  // each level is half as large as the one before
            glTexImage2D(GL_TEXTURE_2D, i++, GL_SRGB8, level.width, level.height, 0, GL_RGB, GL_UNSIGNED_BYTE,
                         level.rows);
    }

    VertexArrayName layout_;
    BufferName vertices_, indices_;
    TextureName albedo_;
    GLsizei index_count_ = 0;
};

}  // namespace relief::colonnade
