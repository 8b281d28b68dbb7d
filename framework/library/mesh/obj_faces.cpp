// Faces of an OBJ text.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "framework/core/base/text.h"
#include "framework/library/mesh/obj_parts.h"

namespace relief::obj {
namespace {

constexpr uint32_t most_corners_of_a_face = 1024;

/// Parses "7", "7/2", "7//3" or "7/2/3": indices of a position, a uv and a normal that fit into an int and are not 0; 0
/// for none. The first must not be empty.
std::optional<std::array<int, 3>> parse_corner(std::string_view word) {
    std::array<int, 3> indices = {};
    for (size_t part = 0; part < 3; ++part) {
        const size_t length = std::min(word.find('/'), word.size());
        const std::string_view digits = word.substr(0, length);
        indices[part] = parse_int(digits).value_or(0);
        if (indices[part] == 0 && (part == 0 || !digits.empty())) return {};
        if (length == word.size()) return indices;
        word.remove_prefix(length + 1);
    }
    return {};
}

class Reader {
public:
    Reader(std::string_view text, const std::filesystem::path& file, const ObjLimits& limits, Notes& notes)
        : statements_(text, file), limits_(limits), notes_(notes) {}

    Faces read() {
        while (statements_.next()) {
            const std::string_view keyword = statements_.keyword();
            if (keyword == "v") {
                read_position();
            } else if (keyword == "vt") {
                const auto [numbers, count] = take_numbers(1, 3);
                faces_.uvs.emplace_back(numbers[0], numbers[1]);
            } else if (keyword == "vn") {
                const auto [numbers, count] = take_numbers(3, 3);
                faces_.normals.emplace_back(numbers[0], numbers[1], numbers[2]);
            } else if (keyword == "f") {
                add_face();
            } else {
                change_state(keyword, statements_.rest());
            }
        }
        if (faces_.faces.empty()) throw Error({statements_.file()}, "has no faces");
        check_indices();
        round_positions();
        drop_normals_without_length();
        return std::move(faces_);
    }

private:
    /// The first four numbers of a statement, 0 for those that are missing, and the count of all.
    struct Numbers {
        std::array<double, 4> values = {};
        int count = 0;
    };
    Numbers take_numbers(int min, int max) {
        Numbers result;
        auto& [numbers, count] = result;
        std::string_view rest = statements_.rest();
        for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
            const std::optional<double> number = number_of(word);
            if (!number) statements_.fail(fmt::format("'{}' is not a finite number", excerpt(word)));
            if (count < 4) numbers[size_t(count)] = *number;
            ++count;
        }
        if (count < min || count > max)
            statements_.fail(fmt::format("'{}' takes {} numbers, here are {}", statements_.keyword(), min, count));
        return result;
    }

    /// Reads x y z, x y z w, or x y z red green blue with alpha or without.
    void read_position() {
        const auto [numbers, count] = take_numbers(3, 7);
        positions_.emplace_back(numbers[0], numbers[1], numbers[2]);
        if (count == 4 && numbers[3] != 1) note_once("the weight w of a vertex is not read");
        if (count >= 6) note_once("the colours of vertices are not read");
    }

    /// Adds a note for the first statement that it applies to.
    void note_once(std::string message) {
        if (unread_.size() < 20 && unread_.insert(message).second)
            notes_.add({statements_.file(), statements_.line()}, message);
    }

    /// Rounds the positions to float. Those far from the origin lose digits that the surface needs, so they are moved
    /// before.
    void round_positions() {
        glm::dvec3 low(INFINITY), high(-INFINITY);
        for (const Corner& corner : faces_.corners) {
            const glm::dvec3& position = positions_[size_t(corner.position)];
            low = glm::min(low, position), high = glm::max(high, position);
        }
        const glm::dvec3 middle = 0.5 * low + 0.5 * high;
        if (glm::length(middle) > glm::length(high - low)) faces_.origin = middle;
        faces_.positions.reserve(positions_.size());
        for (const glm::dvec3& position : positions_) faces_.positions.emplace_back(position - faces_.origin);
        positions_ = {};
    }

    void add_face() {
        Face face = {.first = uint32_t(faces_.corners.size()),
                     .smoothing = smoothing_,
                     .material = material_,
                     .line = statements_.line()};
        std::string_view rest = statements_.rest();
        for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
            const auto corner = parse_corner(word);
            if (!corner)
                statements_.fail(
                    fmt::format("'{}' is not a corner of a face, such as 7, 7/2, 7//3 or 7/2/3, with "
                                "whole numbers other than 0",
                                excerpt(word)));
            if (++face.count > most_corners_of_a_face)
                statements_.fail(fmt::format("a face of more than {} corners", most_corners_of_a_face));
            if (faces_.corners.size() == limits_.corners)
                statements_.fail(fmt::format("the faces have more than {} corners", limits_.corners));
            const auto [position, uv, normal] = *corner;
            faces_.corners.push_back({.position = resolve(position, positions_.size(), "v"),
                                      .uv = resolve(uv, faces_.uvs.size(), "vt"),
                                      .normal = resolve(normal, faces_.normals.size(), "vn")});
        }
        if (face.count < 3) statements_.fail(fmt::format("a face of {} corners; it takes 3 at least", face.count));
        faces_.faces.push_back(face);
    }

    void change_state(std::string_view keyword, std::string_view rest) {
        if (keyword == "s") {
            const std::string_view word = take_word(rest);
            const std::optional<int> group = parse_int(word);
            smoothing_ = word == "on" ? smooth_by_default : uint32_t(std::max(0, group.value_or(0)));
            if (!group && word != "on" && word != "off")
                notes_.add({statements_.file(), statements_.line()},
                           fmt::format("'s {}' is not a smoothing group; taken as off", excerpt(word)));
        } else if (keyword == "usemtl") {
            material_ = index_of(rest, material_indices_, faces_.materials);
        } else if (keyword == "mtllib") {
            index_of(rest, library_indices_, faces_.libraries);
        } else if (keyword != "g" && keyword != "o") {
            note_once(fmt::format("'{}' is not read", excerpt(keyword)));
        }
    }

    int32_t index_of(std::string_view name, std::map<std::string, int32_t>& indices, std::vector<Named>& names) {
        const auto [found, is_new] = indices.try_emplace(std::string(name), int32_t(names.size()));
        if (is_new) names.push_back({found->first, statements_.line()});
        return found->second;
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
                check(face, faces_.corners[i].position, positions_.size(), "v");
                check(face, faces_.corners[i].uv, faces_.uvs.size(), "vt");
                check(face, faces_.corners[i].normal, faces_.normals.size(), "vn");
            }
    }

    void drop_normals_without_length() {
        for (const Face& face : faces_.faces)
            for (uint32_t i = face.first; i < face.first + face.count; ++i) {
                int32_t& normal = faces_.corners[i].normal;
                if (normal < 0 || faces_.normals[size_t(normal)] != glm::vec3(0)) continue;
                notes_.add({statements_.file(), face.line}, "a normal of length 0; one is made from the faces");
                normal = -1;
            }
    }

    Statements statements_;
    const ObjLimits& limits_;
    Notes& notes_;
    Faces faces_;
    std::vector<glm::dvec3> positions_;
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
