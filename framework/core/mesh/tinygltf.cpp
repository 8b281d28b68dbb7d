// The only file that includes TinyGLTF. Built as a module of its own.
//
// TinyGLTF reads the JSON, base64 and the chunks of a .glb. It does not check that an index, an offset or a count
// exists. So each element is read through Elements, which checks them.
#include "framework/core/mesh/tinygltf.h"

#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <fmt/format.h>
#include <tiny_gltf.h>

#include <cctype>
#include <cstring>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <optional>
#include <span>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/mesh/frame.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

/// Returns the first line of a message, short and without control characters.
std::string first_line(const std::string& message) {
    std::string line = message.substr(0, message.find('\n'));
    if (line.size() > 160) line = line.substr(0, 160) + "...";
    for (char& c : line)
        if (static_cast<unsigned char>(c) < ' ' || c == 127) c = '?';
    return line;
}

/// TinyGLTF calls itself for each level of the JSON, so deep ones would exhaust the stack.
void refuse_deep_json(std::string_view json) {
    int depth = 0;
    bool is_string = false;
    for (size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (is_string && c == '\\')
            ++i;
        else if (c == '"')
            is_string = !is_string;
        else if (!is_string && (c == '[' || c == '{') && ++depth > 64)
            throw Error("damaged: its JSON has more than 64 levels");
        else if (!is_string && (c == ']' || c == '}'))
            --depth;
    }
}

/// The files that a model names, within one limit for all of them.
struct Files {
    size_t bytes_left;
};
std::string read_within(const fs::path& file, Files& files) {
    std::string bytes = read_file(file, files.bytes_left);
    files.bytes_left -= bytes.size();
    return bytes;
}

/// Later releases of TinyGLTF also ask for a file's size.
template <class Callbacks>
Callbacks file_callbacks(Callbacks callbacks, Files& files) {
    callbacks.FileExists = [](const std::string& file, void*) {
        std::error_code ignored;
        return fs::exists(file, ignored);
    };
    callbacks.ExpandFilePath = [](const std::string& file, void*) { return file; };
    callbacks.ReadWholeFile = [](std::vector<unsigned char>* out, std::string* why, const std::string& file,
                                 void* user_data) {
        try {
            const std::string read = read_within(file, *static_cast<Files*>(user_data));
            out->assign(read.begin(), read.end());
            return true;
        } catch (const Error& error) {
            *why = error.what();
            return false;
        }
    };
    callbacks.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
        return false;
    };
    if constexpr (requires { callbacks.GetFileSizeInBytes; })
        callbacks.GetFileSizeInBytes = [](size_t* size, std::string*, const std::string& file, void*) {
            std::error_code error;
            *size = fs::file_size(file, error);
            return !error;
        };
    callbacks.user_data = &files;
    return callbacks;
}

tinygltf::Model parse(const std::string& bytes, const std::string& folder, Files& files) {
    constexpr size_t header = 20;  // of a .glb: magic, version, size; size and kind of the JSON
    const bool is_binary = bytes.starts_with("glTF");
    uint32_t json_size = uint32_t(bytes.size());
    if (is_binary && bytes.size() >= header) std::memcpy(&json_size, bytes.data() + 12, 4);
    refuse_deep_json(std::string_view(bytes).substr(is_binary ? std::min(header, bytes.size()) : 0, json_size));

    tinygltf::TinyGLTF reader;
    const auto keep = [](tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* start,
                         int size, void*) {
        // Bytes of a buffer are read through bytes_of_view(): here, their place is not checked.
        if (image->bufferView < 0) image->image.assign(start, start + size);
        return true;
    };
    reader.SetImageLoader(keep, nullptr);
    reader.SetFsCallbacks(file_callbacks(tinygltf::FsCallbacks{}, files));
    tinygltf::Model model;
    std::string why, ignored;
    bool is_read = false;
    try {
        const auto size = static_cast<unsigned int>(bytes.size());
        is_read = is_binary ? reader.LoadBinaryFromMemory(&model, &why, &ignored,
                                                          reinterpret_cast<const unsigned char*>(bytes.data()), size,
                                                          folder, tinygltf::REQUIRE_VERSION)
                            : reader.LoadASCIIFromString(&model, &why, &ignored, bytes.data(), size, folder,
                                                         tinygltf::REQUIRE_VERSION);
    } catch (const std::exception& error) {
        why = error.what();
    }
    // It reports some faults and goes on without the part.
    if (!is_read || !why.empty()) throw Error("damaged: " + first_line(why));
    return model;
}

template <class All>
const auto& element_of(const All& all, int index, const char* kind) {
    if (index < 0 || size_t(index) >= all.size())
        throw Error(fmt::format("damaged: there is no {} {}, but {} of them", kind, index, all.size()));
    return all[size_t(index)];
}

std::span<const unsigned char> bytes_of_view(const tinygltf::Model& model, int index) {
    const tinygltf::BufferView& view = element_of(model.bufferViews, index, "buffer view");
    const std::vector<unsigned char>& data = element_of(model.buffers, view.buffer, "buffer").data;
    if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset)
        throw Error(fmt::format("damaged: buffer view {} ends behind its buffer of {} bytes", index, data.size()));
    return std::span(data).subspan(view.byteOffset, view.byteLength);
}

/// The elements of an accessor. All of them lie in its buffer.
class Elements {
public:
    /// `type` is TINYGLTF_TYPE_VEC3, for example.
    Elements(const tinygltf::Model& model, int index, int type, const std::string& name) {
        const tinygltf::Accessor& accessor = element_of(model.accessors, index, "accessor");
        const auto refuse = [&](const std::string& why) { throw Error(fmt::format("{}: {}", name, why)); };
        if (accessor.type != type) refuse("its elements have another number of components than glTF demands");
        if (accessor.sparse.isSparse) refuse("sparse accessors are not read: export without them");
        component_type_ = accessor.componentType;
        normalized_ = accessor.normalized;
        const int component = tinygltf::GetComponentSizeInBytes(uint32_t(component_type_));
        const int components = tinygltf::GetNumComponentsInType(uint32_t(type));
        if (component <= 0 || component_type_ == TINYGLTF_COMPONENT_TYPE_DOUBLE ||
            component_type_ == TINYGLTF_COMPONENT_TYPE_INT)
            refuse(fmt::format("glTF has no numbers of type {}", component_type_));
        const size_t element = size_t(component) * size_t(components);
        const std::span<const unsigned char> bytes = bytes_of_view(model, accessor.bufferView);
        stride_ = model.bufferViews[size_t(accessor.bufferView)].byteStride;
        if (stride_ == 0) stride_ = element;
        if (stride_ < element) refuse("its elements overlap");
        count_ = accessor.count;
        const size_t offset = accessor.byteOffset;
        if (offset > bytes.size() || (count_ > 0 && (bytes.size() - offset < element ||
                                                     (bytes.size() - offset - element) / stride_ < count_ - 1)))
            refuse(fmt::format("{} elements do not fit in their {} bytes", count_, bytes.size()));
        first_ = bytes.data() + offset;
    }

    size_t count() const { return count_; }
    bool is_index() const {
        return !normalized_ && (component_type_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                                component_type_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                                component_type_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
    }
    double at(size_t element, size_t component = 0) const {
        const unsigned char* const place = first_ + element * stride_;
        switch (component_type_) {
            case TINYGLTF_COMPONENT_TYPE_BYTE:
                return number<int8_t>(place, component, 127);
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
                return number<uint8_t>(place, component, 255);
            case TINYGLTF_COMPONENT_TYPE_SHORT:
                return number<int16_t>(place, component, 32767);
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
                return number<uint16_t>(place, component, 65535);
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
                return number<uint32_t>(place, component, 4294967295.0);
            default:
                return number<float>(place, component, 1);
        }
    }
    glm::dvec2 vec2(size_t i) const { return {at(i, 0), at(i, 1)}; }
    glm::dvec3 vec3(size_t i) const { return {at(i, 0), at(i, 1), at(i, 2)}; }
    glm::dvec4 vec4(size_t i) const { return {vec3(i), at(i, 3)}; }

private:
    template <class Number>
    double number(const unsigned char* place, size_t component, double one) const {
        Number value;
        std::memcpy(&value, place + component * sizeof value, sizeof value);
        return normalized_ ? std::max(double(value) / one, -1.0) : double(value);
    }

    const unsigned char* first_ = nullptr;
    size_t count_ = 0, stride_ = 0;
    int component_type_ = 0;
    bool normalized_ = false;
};

glm::dmat4 matrix_of(const tinygltf::Node& node, int index) {
    const auto has = [&](const std::vector<double>& numbers, size_t count) {
        if (!numbers.empty() && numbers.size() != count)
            throw Error(fmt::format("damaged: the transform of node {} has {} numbers", index, numbers.size()));
        return !numbers.empty();
    };
    if (has(node.matrix, 16)) return glm::make_mat4(node.matrix.data());
    glm::dmat4 matrix(1);
    if (has(node.rotation, 4)) {
        const std::vector<double>& q = node.rotation;
        matrix = glm::mat4_cast(glm::dquat(q[3], q[0], q[1], q[2]));
    }
    if (has(node.scale, 3))
        for (int i = 0; i < 3; ++i) matrix[i] *= node.scale[size_t(i)];
    if (has(node.translation, 3)) matrix[3] = glm::dvec4(glm::make_vec3(node.translation.data()), 1);
    return matrix;
}

struct PlacedMesh {
    int mesh;
    glm::dmat4 world_from_mesh;
};

/// Returns the meshes of the default scene's nodes.
std::vector<PlacedMesh> placed_meshes(const tinygltf::Model& model) {
    std::vector<int> roots;
    if (!model.scenes.empty()) {
        roots = element_of(model.scenes, std::max(0, model.defaultScene), "scene").nodes;
    } else {
        std::vector<bool> is_child(model.nodes.size());
        for (const tinygltf::Node& node : model.nodes)
            for (const int child : node.children)
                if (child >= 0 && size_t(child) < is_child.size()) is_child[size_t(child)] = true;
        for (size_t i = 0; i < is_child.size(); ++i)
            if (!is_child[i]) roots.push_back(int(i));
    }
    std::vector<PlacedMesh> placed;
    std::vector<bool> is_seen(model.nodes.size());
    struct Open {
        int node;
        glm::dmat4 parent;
    };
    std::vector<Open> open;
    for (auto root = roots.rbegin(); root != roots.rend(); ++root) open.push_back({*root, glm::dmat4(1)});
    while (!open.empty()) {
        const auto [index, parent] = open.back();
        open.pop_back();
        const tinygltf::Node& node = element_of(model.nodes, index, "node");
        if (is_seen[size_t(index)]) throw Error(fmt::format("damaged: node {} has two parents", index));
        is_seen[size_t(index)] = true;
        const glm::dmat4 matrix = parent * matrix_of(node, index);
        if (node.mesh >= 0) placed.push_back({node.mesh, matrix});
        for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
            open.push_back({*child, matrix});
    }
    return placed;
}

bool is_finite(const glm::dvec4& v) {
    const glm::vec4 stored(v);
    return std::isfinite(stored.x) && std::isfinite(stored.y) && std::isfinite(stored.z) && std::isfinite(stored.w);
}

glm::dvec3 face_normal(const Mesh& mesh, size_t first_index) {
    const auto corner = [&](size_t i) { return glm::dvec3(mesh.vertices[mesh.indices[first_index + i]].position); };
    const glm::dvec3 area = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
    const double length = glm::length(area);
    return length > 0 ? area / length : glm::dvec3(0, 0, 1);
}

class Merged {
public:
    Merged(const tinygltf::Model& model, const ObjLimits& limits) : model_(model), limits_(limits) {}

    void add(const PlacedMesh& placed) {
        const std::vector<tinygltf::Primitive>& all = element_of(model_.meshes, placed.mesh, "mesh").primitives;
        for (size_t i = 0; i < all.size(); ++i)
            add(all[i], placed.world_from_mesh, fmt::format("mesh {}, primitive {}", placed.mesh, i));
    }

    Mesh mesh;
    bool has_uvs = true, has_tangents = true;
    const tinygltf::NormalTextureInfo* normal_map = nullptr;  ///< of the first material that has one

private:
    void add(const tinygltf::Primitive& primitive, const glm::dmat4& matrix, const std::string& name) {
        const auto refuse = [&](const std::string& why) { throw Error(fmt::format("{}: {}", name, why)); };
        if (primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP || primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN)
            refuse("strips and fans are not read: export a list of triangles");
        if (primitive.mode != TINYGLTF_MODE_TRIANGLES) return;  // points or lines
        const tinygltf::NormalTextureInfo* own_map = nullptr;
        if (primitive.material >= 0) {
            const auto& info = element_of(model_.materials, primitive.material, "material").normalTexture;
            if (info.index >= 0) own_map = &info;
        }
        if (!normal_map) normal_map = own_map;

        const auto elements = [&](const std::string& attribute, int type) -> std::optional<Elements> {
            const auto found = primitive.attributes.find(attribute);
            if (found == primitive.attributes.end()) return {};
            return Elements(model_, found->second, type, fmt::format("{}, {}", name, attribute));
        };
        const auto positions = elements("POSITION", TINYGLTF_TYPE_VEC3);
        if (!positions) refuse("it has no positions");
        const auto normals = elements("NORMAL", TINYGLTF_TYPE_VEC3);
        auto tangents = elements("TANGENT", TINYGLTF_TYPE_VEC4);
        const auto uvs = elements(fmt::format("TEXCOORD_{}", own_map ? own_map->texCoord : 0), TINYGLTF_TYPE_VEC2);
        if (!normals) tangents.reset();
        const auto refuse_other_count = [&](const std::optional<Elements>& others, const char* what) {
            if (others && others->count() != positions->count())
                refuse(fmt::format("{} positions, but {} {}", positions->count(), others->count(), what));
        };
        refuse_other_count(normals, "normals");
        refuse_other_count(tangents, "tangents");
        refuse_other_count(uvs, "uv");
        std::optional<Elements> indices;
        if (primitive.indices >= 0) {
            indices.emplace(model_, primitive.indices, TINYGLTF_TYPE_SCALAR, name + ", indices");
            if (!indices->is_index()) refuse("its indices are no whole numbers from 0 on");
        }
        const size_t corners = indices ? indices->count() : positions->count();
        if (corners % 3 != 0) refuse(fmt::format("{} corners make no whole triangles", corners));
        if (const size_t most = limits_.corners; corners > most - std::min(most, mesh.indices.size()) ||
                                                 positions->count() > most - std::min(most, mesh.vertices.size()))
            throw Error(fmt::format("too large: more than {} corners or vertices", most));
        has_uvs &= uvs.has_value(), has_tangents &= tangents.has_value();

        const glm::dmat3 linear(matrix);
        const double sign = glm::determinant(linear) < 0 ? -1 : 1;
        // The inverse transpose, times the determinant: it exists for each matrix.
        const glm::dmat3 of_normals(sign * glm::cross(linear[1], linear[2]), sign * glm::cross(linear[2], linear[0]),
                                    sign * glm::cross(linear[0], linear[1]));
        const uint32_t first_vertex = uint32_t(mesh.vertices.size());
        const size_t first_index = mesh.indices.size();
        for (size_t i = 0; i < positions->count(); ++i) {
            const glm::dvec3 normal = normals ? of_normals * normals->vec3(i) : glm::dvec3(0);
            const glm::dvec4 tangent = tangents ? tangents->vec4(i) : glm::dvec4(0, 0, 0, 1);
            const glm::dvec3 along = linear * glm::dvec3(tangent);
            const double length = glm::length(normal), length_along = glm::length(along);
            const glm::dvec2 uv = uvs ? glm::dvec2(uvs->vec2(i).x, 1 - uvs->vec2(i).y) : glm::dvec2(0);
            const glm::dvec4 position = matrix * glm::dvec4(positions->vec3(i), 1);
            if (!is_finite(position) || !is_finite({uv, length, length_along}) || !is_finite({along, tangent.w}))
                refuse(fmt::format("vertex {} has a number that is not finite", i));
            mesh.vertices.push_back({.position = position,
                                     .normal = length > 0 ? normal / length : glm::dvec3(0),
                                     .tangent = glm::dvec4(length_along > 0 ? along / length_along : glm::dvec3(0),
                                                           tangent.w * sign < 0 ? -1 : 1),
                                     .uv = uv});
        }
        for (size_t i = 0; i < corners; ++i) {
            const size_t of_triangle = i % 3;
            const size_t place = sign < 0 ? i - of_triangle + (3 - of_triangle) % 3 : i;  // 0, 2, 1 where mirrored
            const double index = indices ? indices->at(place) : double(place);
            if (index >= double(positions->count()))
                refuse(fmt::format("there is no vertex {:.0f}, but {} of them", index, positions->count()));
            mesh.indices.push_back(first_vertex + uint32_t(index));
        }
        if (normals)
            complete_normals(first_index);
        else
            separate_faces(first_vertex, first_index);
        for (size_t i = first_vertex; i < mesh.vertices.size(); ++i) {
            Vertex& vertex = mesh.vertices[i];
            if (vertex.normal == glm::vec3(0)) vertex.normal = {0, 0, 1};  // of no triangle
            if (glm::vec3(vertex.tangent) == glm::vec3(0))
                vertex.tangent = glm::vec4(any_perpendicular(glm::normalize(glm::dvec3(vertex.normal))), 1);
        }
    }

    /// Gives a vertex whose normal has no length that of a triangle.
    void complete_normals(size_t first_index) {
        for (size_t i = first_index; i < mesh.indices.size(); ++i) {
            Vertex& vertex = mesh.vertices[mesh.indices[i]];
            if (vertex.normal == glm::vec3(0)) vertex.normal = face_normal(mesh, i - (i - first_index) % 3);
        }
    }

    /// Gives each corner a vertex of its own, with the normal of its triangle.
    void separate_faces(uint32_t first_vertex, size_t first_index) {
        std::vector<Vertex> corners;
        corners.reserve(mesh.indices.size() - first_index);
        for (size_t i = first_index; i < mesh.indices.size(); ++i) {
            corners.push_back(mesh.vertices[mesh.indices[i]]);
            corners.back().normal = face_normal(mesh, i - (i - first_index) % 3);
        }
        if (first_vertex + corners.size() > limits_.corners)
            throw Error(fmt::format("too large: more than {} corners or vertices", limits_.corners));
        mesh.vertices.resize(first_vertex);
        mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
        for (size_t i = first_index; i < mesh.indices.size(); ++i)
            mesh.indices[i] = first_vertex + uint32_t(i - first_index);
    }

    const tinygltf::Model& model_;
    const ObjLimits& limits_;
};

/// Returns the name of a file, in which %20 stands for a blank.
std::string file_name(const std::string& uri) {
    constexpr std::string_view digits = "0123456789abcdef";
    const auto digit = [&](size_t i) {
        return i < uri.size() ? digits.find(char(std::tolower(static_cast<unsigned char>(uri[i])))) : digits.npos;
    };
    std::string name;
    for (size_t i = 0; i < uri.size(); ++i) {
        const size_t high = digit(i + 1), low = digit(i + 2);
        if (uri[i] == '%' && high != digits.npos && low != digits.npos)
            name += char(16 * high + low), i += 2;
        else
            name += uri[i];
    }
    return name;
}

/// Returns the file of a texture's picture.
std::string picture_of(const tinygltf::Model& model, int texture, const fs::path& folder, Files& files) {
    const int source = element_of(model.textures, texture, "texture").source;
    if (source < 0) throw Error("its normal map is in a format that is not read: use PNG or JPEG");
    const tinygltf::Image& image = element_of(model.images, source, "image");
    if (image.bufferView >= 0) {
        const auto bytes = bytes_of_view(model, image.bufferView);
        return {bytes.begin(), bytes.end()};
    }
    if (!image.uri.empty()) return read_within(folder / file_name(image.uri), files);
    return {image.image.begin(), image.image.end()};
}

void refuse_other_formats(const tinygltf::Model& model) {
    if (!model.asset.version.starts_with("2."))
        throw Error(fmt::format("is glTF {}: export glTF 2.0", first_line(model.asset.version)));
    for (const std::string& extension : model.extensionsRequired)
        if (extension != "KHR_mesh_quantization" && !extension.starts_with("KHR_materials_"))
            throw Error(fmt::format("needs {}, which is not read: export without it", first_line(extension)));
}

}  // namespace
}  // namespace relief

relief::GltfModel relief_parse_gltf(const std::string& bytes, const std::filesystem::path& folder,
                                    const relief::ObjLimits& limits) {
    using namespace relief;
    if (bytes.size() > limits.bytes) throw Error(fmt::format("{} bytes, the limit is {}", bytes.size(), limits.bytes));
    Files files{limits.bytes};
    const tinygltf::Model model = parse(bytes, folder.empty() ? "." : folder.string(), files);
    refuse_other_formats(model);
    Merged merged(model, limits);
    for (const PlacedMesh& placed : placed_meshes(model)) merged.add(placed);
    if (merged.mesh.indices.empty()) throw Error("has no triangles in its scene");
    GltfModel result{std::move(merged.mesh), merged.has_uvs, merged.has_tangents};
    if (!result.has_tangents)
        for (Vertex& vertex : result.mesh.vertices)
            vertex.tangent = glm::vec4(any_perpendicular(glm::normalize(glm::dvec3(vertex.normal))), 1);
    if (merged.normal_map) {
        result.normal_map = picture_of(model, merged.normal_map->index, folder, files);
        result.normal_scale = merged.normal_map->scale;
    }
    return result;
}
