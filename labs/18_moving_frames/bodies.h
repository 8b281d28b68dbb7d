// Bodies of lab 18 on the graphics card: triangles, the bones of their vertices, and the attributes of instances.
#pragma once

#include <memory>
#include <span>

#include "framework/core/gl/gpu_mesh.h"
#include "framework/core/gl/vertex_stream.h"
#include "framework/library/kit/kept.h"
#include "skin.h"

namespace relief::moving_frames {

class Bodies {
public:
    /// Uploads the skin and its weights, if they changed, and the instances.
    void fill(const Body& body, Fineness fineness, const Pose& pose, std::span<const Instance> instances) {
        const Skin& skin = *skin_.get({body.is_serpent, fineness}, [&] {
            return std::make_unique<Skin>(make_skin(body, fineness.rings, fineness.sides));
        });
        bound_by_.get({skin_.version(), pose.over, pose.uneven}, [&] {
            bound_.fill<Bound>(bind_skin(body, skin.mesh, pose.over * body.radius, pose.uneven));
            bound_.attach(skin.uploaded.layout());
            return true;
        });
        std::vector<Placed> placed;
        for (const Instance& instance : instances) {
            const glm::mat4 rows(glm::transpose(instance.world_from_model));
            const glm::mat3 texture(glm::transpose(instance.texture));
            placed.push_back({{rows[0], rows[1], rows[2]}, {texture[0], texture[1]}, instance.material});
        }
        instances_.fill<Placed>(placed);
        instances_.attach(skin.uploaded.layout());
        layout_ = skin.uploaded.layout(), index_count_ = skin.uploaded.count();
    }

    /// Draws all instances with one draw call.
    void draw() const {
        glBindVertexArray(layout_);
        glDrawElementsInstanced(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr, instances_.count());
    }

private:
    struct Skin {
        Mesh mesh;
        GpuMesh uploaded{[this] { return mesh; }};
        explicit Skin(Mesh made) : mesh(std::move(made)) {}
        Skin(const Skin&) = delete;  // `uploaded` refers to it
    };
    /// An instance, in the layout of its vertex attributes.
    struct Placed {
        glm::vec4 rows[3];  ///< of world_from_model
        glm::vec3 texture[2];
        int32_t material;
    };

    Kept<std::unique_ptr<Skin>, bool, Fineness> skin_;  ///< by shape and fineness
    Kept<bool, int, double, bool> bound_by_;            ///< version of the skin, length of a joint, uneven weights
    VertexStream bound_{{{4, 4, GL_UNSIGNED_BYTE, offsetof(Bound, bones)}, {5, 4, GL_FLOAT, offsetof(Bound, weights)}}};
    VertexStream instances_{{{6, 4, GL_FLOAT, 0},
                             {7, 4, GL_FLOAT, sizeof(glm::vec4)},
                             {8, 4, GL_FLOAT, 2 * sizeof(glm::vec4)},
                             {9, 3, GL_FLOAT, offsetof(Placed, texture)},
                             {10, 3, GL_FLOAT, offsetof(Placed, texture) + sizeof(glm::vec3)},
                             {11, 1, GL_INT, offsetof(Placed, material)}},
                            1};  // they advance once for each instance
    GLuint layout_ = 0;
    GLsizei index_count_ = 0;
};

}  // namespace relief::moving_frames
