// The scene of lab 16 on the GPU: a mesh and maps for each material.
#pragma once

#include "framework/core/lab/lab.h"
#include "framework/library/kit/choices.h"
#include "framework/library/kit/kept.h"
#include "framework/library/kit/uniforms.h"
#include "scene.h"

namespace relief::court {

class Stage {
public:
    static constexpr auto places = choices<Place>(
        {{Place::court, "court"}, {Place::groove, "groove"}, {Place::plane, "plane"}, {Place::board, "board"}});
    int place = int(Place::court);
    float tilt = 30;       ///< degrees
    bool displace = true;  ///< the court's floor

    Scene scene() const { return make_scene(Place(place), double(tilt)); }
    bool is_court() const { return Place(place) == Place::court; }
    bool is_displaced() const { return displace && is_court(); }
    Define displaced(Material material) const {
        return is_displaced() && material == Material::floor ? "DISPLACED" : "";
    }
    /// Returns a number that changes with the meshes.
    int version() { return meshes(), meshes_.version(); }

    /// Draws the triangles of each material by the program that program_of(material) returns and that is in use.
    /// Occluders come first, the floor last.
    template <class ProgramOf>
    void draw(const glm::dmat4& clip_from_world, ProgramOf program_of) {
        const auto& all = meshes();
        for (size_t i = all.size(); i-- > 0;) {
            if (!all[i]) continue;
            const Program& program = program_of(Material(i));
            program.set("u_clip_from_world", clip_from_world);
            set_each<glm::vec4>(program, "u_ground", ground_terms);
            program.set("u_water", water);
            program.set("u_rise", rise);
            glBindVertexArray(all[i]->layout());
            glDrawElements(GL_TRIANGLES, all[i]->count(), GL_UNSIGNED_INT, nullptr);
        }
    }

private:
    using Meshes = std::array<std::optional<GpuMesh>, materials>;

    /// Returns the meshes, none for a material that the scene does not have.
    const Meshes& meshes() {
        return meshes_.get({place, is_court() ? 0 : tilt, is_displaced()}, [this] {
            Meshes made;
            for (size_t i = 0; i < made.size(); ++i)
                if (Mesh mesh = mesh_of(scene(), Material(i), is_displaced()); !mesh.indices.empty())
                    made[i] = upload([mesh = std::move(mesh)] { return mesh; });
            return made;
        });
    }

    Kept<Meshes, int, float, bool> meshes_;
};

/// The colour, the normals, and gloss, height and occlusion of each material.
class MaterialMaps {
public:
    void set(const Program& program, Material material) const {
        const Maps& maps = maps_[size_t(material)];
        program.set("s_albedo", 0, maps.albedo);
        program.set("s_normals", 1, maps.normals);
        program.set("s_packed", 2, maps.packed);
    }

private:
    struct Maps {
        Texture albedo, normals, packed;
    };
    static Maps maps_of(const std::string& name) {
        return {load_texture((name + "_albedo.png").c_str(), ColorSpace::srgb),
                load_texture((name + "_normal.png").c_str(), ColorSpace::linear),
                load_texture((name + "_packed.png").c_str(), ColorSpace::linear)};
    }
    static Texture even(const char* title, const glm::vec3& value) {
        return Texture(title, [value] {
            Image texel(1, 1, 3);
            for (int c = 0; c < 3; ++c) texel.values[size_t(c)] = value[c];
            return texel;
        });
    }
    std::array<Maps, materials> maps_ = {
        maps_of("paving"), maps_of("bricks"), maps_of("paving"),
        Maps{load_texture("marble_albedo.png", ColorSpace::srgb), even("flat normal", {0.5f, 0.5f, 1}),
             even("polish", {float(marble_gloss), 1, 1})}};
};

}  // namespace relief::court
