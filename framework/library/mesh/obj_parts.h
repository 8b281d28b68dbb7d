// The parts of the OBJ reader: statements of a text, the faces of an OBJ text, the materials of an MTL text.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "framework/core/base/error.h"
#include "framework/library/mesh/obj.h"

namespace relief::obj {

/// Keeps the first 20 notes, because a file of junk would give one per line.
class Notes {
public:
    void add(const Place& place, const std::string& message);
    /// Adds a line that names its place already.
    void add(std::string line);
    const std::vector<std::string>& lines() const { return lines_; }

private:
    std::vector<std::string> lines_;
};

/// Reads a text statement by statement: a keyword, and the rest of its line without surrounding blanks. Lines end in
/// LF, CR LF or CR. A backslash at the end continues a line in the next one. Comments and empty lines are skipped.
/// Throws Error at a zero byte, which no text contains.
class Statements {
public:
    Statements(std::string_view text, std::filesystem::path file) : text_(text), file_(std::move(file)) {}

    bool next();
    std::string_view keyword() const { return keyword_; }
    std::string_view rest() const { return rest_; }
    const std::filesystem::path& file() const { return file_; }
    int line() const { return line_; }
    [[noreturn]] void fail(const std::string& message) const;

private:
    std::string_view next_line();

    std::string_view text_;
    std::filesystem::path file_;
    int line_ = 0, next_line_ = 1;
    std::string joined_;
    std::string_view keyword_, rest_;
};

/// Takes the next word off the front, up to a blank. Returns an empty word at the end or before a comment.
std::string_view take_word(std::string_view& rest);
/// As take_word(), but '#' does not begin a comment.
std::string_view take_name(std::string_view& rest);
std::string_view trimmed(std::string_view text);
/// Parses a finite decimal number in the range of a float. Returns nothing for other words.
std::optional<double> number_of(std::string_view word);
/// Returns a word as it may appear in a message: short, and without control characters.
std::string excerpt(std::string_view word);

struct Corner {
    int32_t position, uv, normal;  ///< from 0; uv and normal are -1 if missing
    bool operator==(const Corner&) const = default;
};

struct Face {
    uint32_t first = 0, count = 0;  ///< range in Faces::corners
    uint32_t smoothing = 0;         ///< 0: off
    int32_t material = -1;          ///< an index into Faces::materials
    int32_t line = 0;
};

constexpr uint32_t smooth_by_default = 0xffffffff;  ///< Face::smoothing before the first `s`

/// A name, and the line of its first use.
struct Named {
    std::string name;
    int line;
};

struct Faces {
    std::vector<glm::vec3> positions, normals;
    glm::dvec3 origin{0};  ///< see ObjModel::origin
    std::vector<glm::vec2> uvs;
    std::vector<Corner> corners;  ///< with indices in range
    std::vector<Face> faces;
    std::vector<Named> materials, libraries;
};

/// Reads the faces of an OBJ text. Throws as read_obj() does.
Faces read_faces(std::string_view text, const std::filesystem::path& file, const ObjLimits& limits, Notes& notes);

/// Reads the materials of an MTL text. `folder` is put in front of the paths of maps.
std::vector<Material> read_materials(std::string_view text, const std::filesystem::path& file,
                                     const std::filesystem::path& folder, Notes& notes);

/// Returns a path of an OBJ or MTL file for this system. Backslashes become slashes. If an absolute path, with a drive
/// letter or without, names no file, it was another machine's: then the file is looked for in `folder`.
std::filesystem::path path_in(const std::filesystem::path& folder, std::string name);

/// Computes a normal for every corner without one.
void add_missing_normals(Faces& faces);

/// Spreads the bits of a key over a hash (the finaliser of SplitMix64, Steele et al. 2014).
constexpr uint64_t mix(uint64_t bits) {
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
    return bits ^ (bits >> 31);
}

}  // namespace relief::obj
