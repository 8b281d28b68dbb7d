#include "framework/library/mesh/gltf_elements.h"

#include <fmt/format.h>

#include <cstring>

#include "framework/core/base/error.h"

namespace relief {
namespace {

enum ComponentType { int8 = 5120, uint8 = 5121, int16 = 5122, uint16 = 5123, uint32 = 5125, float32 = 5126 };

size_t bytes_of_component(int type) {
    switch (type) {
        case int8:
        case uint8:
            return 1;
        case int16:
        case uint16:
            return 2;
        case uint32:
        case float32:
            return 4;
        default:
            return 0;
    }
}

size_t components_of(const std::string& type) {
    constexpr std::pair<std::string_view, size_t> types[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                                                             {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
    for (const auto& [name, count] : types)
        if (name == type) return count;
    return 0;
}

template <class Number>
double read_number(const char* place, bool normalized, double one) {
    Number value;
    std::memcpy(&value, place, sizeof value);
    return normalized ? std::max(double(value) / one, -1.0) : double(value);
}

}  // namespace

GltfElements::GltfElements(std::span<const char> bytes, size_t offset, int component_type, size_t components,
                           size_t stride, size_t count, bool normalized, const std::string& name)
    : count_(count), components_(components), component_type_(component_type), normalized_(normalized) {
    const size_t element = bytes_of_component(component_type) * components;
    if (element == 0) throw Error(fmt::format("{}: glTF has no numbers of type {}", name, component_type));
    stride_ = stride == 0 ? element : stride;
    if (stride_ < element) throw Error(fmt::format("{}: its elements overlap", name));
    if (offset > bytes.size() ||
        (count > 0 && (bytes.size() - offset < element || (bytes.size() - offset - element) / stride_ < count - 1)))
        throw Error(fmt::format("{}: {} elements do not fit in their {} bytes", name, count, bytes.size()));
    first_ = bytes.data() + offset;
}

GltfElements::GltfElements(GltfDocument& file, int index, const char* type, const std::string& name) {
    const GltfObject accessor = file.element("accessors", index, "accessor");
    if (accessor.text("type") != type)
        throw Error(
            fmt::format("{}: its elements are {} instead of {}", name, quoted_in_message(accessor.text("type")), type));
    const int component_type = accessor.index("componentType"), view = accessor.index("bufferView");
    const size_t components = components_of(type), count = accessor.whole("count", 0);
    const bool normalized = accessor.flag("normalized");
    if (view >= 0) {
        const size_t stride = file.element("bufferViews", view, "buffer view").whole("byteStride", 0);
        *this = GltfElements(file.view(view), accessor.whole("byteOffset", 0), component_type, components, stride,
                             count, normalized, name);
    }
    const bool is_sparse = accessor.has("sparse");
    if (view >= 0 && !is_sparse) return;
    if (count > file.most_elements())
        throw Error(fmt::format("too large: {} has more than {} elements", name, file.most_elements()));
    const size_t element = bytes_of_component(component_type) * components;
    std::string bytes(element * count, '\0');
    for (size_t i = 0; view >= 0 && i < count; ++i) std::memcpy(&bytes[i * element], first_ + i * stride_, element);
    *this = GltfElements(bytes, 0, component_type, components, 0, count, normalized, name);
    own_ = std::move(bytes), first_ = nullptr;
    if (is_sparse) set_sparse(file, accessor.object("sparse"), name);
}

void GltfElements::set_sparse(GltfDocument& file, const GltfObject& sparse, const std::string& name) {
    const GltfObject at = sparse.object("indices"), values = sparse.object("values");
    const size_t count = sparse.whole("count", 0);
    const GltfElements places(file.view(at.index("bufferView")), at.whole("byteOffset", 0), at.index("componentType"),
                              1, 0, count, false, name + ", sparse indices");
    if (!places.is_index()) throw Error(name + ": its sparse indices are no whole numbers from 0 on");
    const GltfElements read(file.view(values.index("bufferView")), values.whole("byteOffset", 0), component_type_,
                            components_, 0, count, false, name + ", sparse values");
    for (size_t i = 0; i < count; ++i) {
        const double place = places.at(i);
        if (place >= double(count_))
            throw Error(fmt::format("{}: there is no element {:.0f}, but {} of them", name, place, count_));
        std::memcpy(&own_[size_t(place) * stride_], read.first_ + i * read.stride_, stride_);
    }
}

bool GltfElements::is_index() const {
    return !normalized_ && (component_type_ == uint8 || component_type_ == uint16 || component_type_ == uint32);
}

double GltfElements::at(size_t element, size_t component) const {
    const char* const place =
        (first_ ? first_ : own_.data()) + element * stride_ + component * bytes_of_component(component_type_);
    switch (component_type_) {
        case int8:
            return read_number<int8_t>(place, normalized_, 127);
        case uint8:
            return read_number<uint8_t>(place, normalized_, 255);
        case int16:
            return read_number<int16_t>(place, normalized_, 32767);
        case uint16:
            return read_number<uint16_t>(place, normalized_, 65535);
        case uint32:
            return read_number<uint32_t>(place, normalized_, 4294967295.0);
        default:
            return read_number<float>(place, false, 1);
    }
}

glm::dmat4 GltfElements::mat4(size_t i) const {
    glm::dmat4 matrix;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) matrix[column][row] = at(i, size_t(4 * column + row));
    return matrix;
}

}  // namespace relief
