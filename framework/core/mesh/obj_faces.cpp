// Faces of an OBJ text, read by tinyobjloader.
//
// tinyobjloader skips errors silently: it reads "v 1 x 3" as (1, 0, 3), and does not check that an index exists. So it
// gets one statement at a time, checked beforehand. Its callbacks handle the result while the line number is still
// known.
#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <streambuf>

#include "framework/core/base/text.h"
#include "framework/core/mesh/obj_parts.h"

namespace relief::obj {
namespace {

constexpr int most_corners_of_a_face = 1024;

/// Accepts "7", "7/2", "7//3" or "7/2/3": integers other than 0 that fit into an int. The first must not be empty.
bool is_corner(std::string_view word) {
    for (int part = 0; part < 3; ++part) {
        const size_t length = std::min(word.find('/'), word.size());
        const std::string_view digits = word.substr(0, length);
        if (parse_int(digits).value_or(0) == 0 && (part == 0 || !digits.empty())) return false;
        if (length == word.size()) return true;
        word.remove_prefix(length + 1);
    }
    return false;
}

/// The stream that tinyobjloader reads, and the state that its callbacks fill.
class Reader : public std::streambuf {
public:
    Reader(std::string_view text, const std::filesystem::path& file, const ObjLimits& limits, Notes& notes)
        : statements_(text, file), limits_(limits), notes_(notes) {}

    Faces read() {
        tinyobj::callback_t callbacks;
        callbacks.vertex_cb = [](void* reader, float x, float y, float z, float) {
            Reader& self = *static_cast<Reader*>(reader);
            self.faces_.positions.push_back(self.finite({x, y, z}));
        };
        callbacks.normal_cb = [](void* reader, float x, float y, float z) {
            Reader& self = *static_cast<Reader*>(reader);
            self.faces_.normals.push_back(self.finite({x, y, z}));
        };
        callbacks.texcoord_cb = [](void* reader, float u, float v, float) {
            Reader& self = *static_cast<Reader*>(reader);
            self.faces_.uvs.push_back(self.finite({u, v, 0}));
        };
        callbacks.index_cb = [](void* reader, tinyobj::index_t* corners, int count) {
            static_cast<Reader*>(reader)->add_face({corners, size_t(count)});
        };
        std::istream stream(this);
        stream.exceptions(std::ios::badbit);  // lets an Error of underflow() propagate
        tinyobj::LoadObjWithCallback(stream, callbacks, this);
        if (faces_.faces.empty()) throw Error({statements_.file()}, "has no faces");
        check_indices();
        drop_normals_without_length();
        return std::move(faces_);
    }

private:
    int_type underflow() override {
        while (statements_.next()) {
            const std::string_view keyword = statements_.keyword();
            if (keyword == "v")
                show_numbers(3, 3, 7);  // x y z [w], or x y z red green blue [alpha]
            else if (keyword == "vt")
                show_numbers(1, 2, 3);
            else if (keyword == "vn")
                show_numbers(3, 3, 3);
            else if (keyword == "f")
                show_face();
            else {
                change_state(keyword, statements_.rest());
                continue;
            }
            setg(shown_.data(), shown_.data(), shown_.data() + shown_.size());
            return traits_type::to_int_type(shown_.front());
        }
        return traits_type::eof();
    }

    void show_numbers(int min, int wanted, int max) {
        shown_ = statements_.keyword();
        std::string_view rest = statements_.rest();
        int count = 0;
        for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
            if (!is_number(word)) statements_.fail(fmt::format("'{}' is not a finite number", excerpt(word)));
            if (++count <= wanted) shown_.append(" ").append(word);
        }
        if (count < min || count > max)
            statements_.fail(fmt::format("'{}' takes {} numbers, here are {}", statements_.keyword(), min, count));
        shown_ += '\n';
    }

    void show_face() {
        shown_ = "f";
        std::string_view rest = statements_.rest();
        int count = 0;
        for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
            if (!is_corner(word))
                statements_.fail(
                    fmt::format("'{}' is not a corner of a face, such as 7, 7/2, 7//3 or 7/2/3, with "
                                "whole numbers other than 0",
                                excerpt(word)));
            if (++count > most_corners_of_a_face)
                statements_.fail(fmt::format("a face of more than {} corners", most_corners_of_a_face));
            // Drop slashes at the end: after "7/", tinyobjloader would read the next corner as the uv.
            shown_.append(" ").append(word.substr(0, word.find_last_not_of('/') + 1));
        }
        if (count < 3) statements_.fail(fmt::format("a face of {} corners; it takes 3 at least", count));
        shown_ += '\n';
    }

    void change_state(std::string_view keyword, std::string_view rest) {
        if (keyword == "s") {
            const std::string_view word = take_word(rest);
            const std::optional<int> group = parse_int(word);
            smoothing_ = word == "on" ? smooth_by_default : uint32_t(std::max(0, group.value_or(0)));
            if (!group && word != "on" && word != "off")
                notes_.add(statements_.file(), statements_.line(),
                           fmt::format("'s {}' is not a smoothing group; taken as off", excerpt(word)));
        } else if (keyword == "usemtl") {
            material_ = index_of(rest, material_indices_, faces_.materials);
        } else if (keyword == "mtllib") {
            index_of(rest, library_indices_, faces_.libraries);
        } else if (keyword != "g" && keyword != "o" && unread_.size() < 20 &&
                   unread_.insert(std::string(keyword)).second) {
            notes_.add(statements_.file(), statements_.line(), fmt::format("'{}' is not read", excerpt(keyword)));
        }
    }

    int32_t index_of(std::string_view name, std::map<std::string, int32_t>& indices, std::vector<Named>& names) {
        const auto [found, is_new] = indices.try_emplace(std::string(name), int32_t(names.size()));
        if (is_new) names.push_back({found->first, statements_.line()});
        return found->second;
    }

    /// Rejects valid numbers that tinyobjloader reads as non-finite, such as 0e999.
    glm::vec3 finite(const glm::vec3& value) const {
        if (!std::isfinite(value.x) || !std::isfinite(value.y) || !std::isfinite(value.z))
            statements_.fail("a number has an exponent out of range");
        return value;
    }

    void add_face(std::span<const tinyobj::index_t> corners) {
        if (faces_.corners.size() + corners.size() > limits_.corners)
            statements_.fail(fmt::format("the faces have more than {} corners", limits_.corners));
        faces_.faces.push_back({.first = uint32_t(faces_.corners.size()),
                                .count = uint32_t(corners.size()),
                                .smoothing = smoothing_,
                                .material = material_,
                                .line = statements_.line()});
        for (const tinyobj::index_t& corner : corners)
            faces_.corners.push_back({.position = resolve(corner.vertex_index, faces_.positions.size(), "v"),
                                      .uv = resolve(corner.texcoord_index, faces_.uvs.size(), "vt"),
                                      .normal = resolve(corner.normal_index, faces_.normals.size(), "vn")});
    }

    /// Returns the zero-based index, or -1 for none. In the file, 1 is the first, -1 the latest so far, and 0 means
    /// none.
    int32_t resolve(int index, size_t count, const char* kind) const {
        if (index >= 0) return index - 1;
        if (size_t(-int64_t(index)) > count)
            statements_.fail(fmt::format("index {} is out of range: {} '{}' so far", index, count, kind));
        return int32_t(int64_t(count) + index);
    }

    /// Checks upper bounds at the end, because a face may refer to later statements.
    void check_indices() const {
        const auto check = [&](const Face& face, int32_t index, size_t count, const char* kind) {
            if (index >= 0 && size_t(index) >= count)
                throw Error({statements_.file(), face.line},
                            fmt::format("index {} is out of range: the file has {} '{}'", index + 1, count, kind));
        };
        for (const Face& face : faces_.faces)
            for (uint32_t i = face.first; i < face.first + face.count; ++i) {
                check(face, faces_.corners[i].position, faces_.positions.size(), "v");
                check(face, faces_.corners[i].uv, faces_.uvs.size(), "vt");
                check(face, faces_.corners[i].normal, faces_.normals.size(), "vn");
            }
    }

    void drop_normals_without_length() {
        for (const Face& face : faces_.faces)
            for (uint32_t i = face.first; i < face.first + face.count; ++i) {
                int32_t& normal = faces_.corners[i].normal;
                if (normal < 0 || faces_.normals[size_t(normal)] != glm::vec3(0)) continue;
                notes_.add(statements_.file(), face.line, "a normal of length 0; one is made from the faces");
                normal = -1;
            }
    }

    Statements statements_;
    const ObjLimits& limits_;
    Notes& notes_;
    std::string shown_;
    Faces faces_;
    std::map<std::string, int32_t> material_indices_, library_indices_;
    std::set<std::string> unread_;
    int32_t material_ = -1;
    uint32_t smoothing_ = smooth_by_default;
};

}  // namespace

Faces read_faces(std::string_view text, const std::filesystem::path& file, const ObjLimits& limits, Notes& notes) {
    return Reader(text, file, limits, notes).read();
}

}  // namespace relief::obj
