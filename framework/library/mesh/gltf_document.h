// A glTF 2.0 file: its JSON, and the bytes of its buffers.
//
// TinyGLTF 2.7 of Debian 12 read these before. It refuses skins without inverse bind matrices, and data URIs of other
// media types, both of which are valid, and its messages print the file's data. It checks no index, offset or count.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "framework/library/mesh/obj.h"

namespace relief {

/// An object of the JSON, with its name for messages: "accessor 3". A getter returns its second argument where the key
/// is missing, and throws Error where its value has another type.
class GltfObject {
public:
    GltfObject(const nlohmann::json& json, std::string name) : json_(&json), name_(std::move(name)) {}

    const std::string& name() const { return name_; }
    bool has(const char* key) const { return json_->contains(key); }
    /// Returns an index, or -1 where the key is missing.
    int index(const char* key) const;
    size_t whole(const char* key, size_t otherwise) const;
    double number(const char* key, double otherwise) const;
    bool flag(const char* key) const;
    std::string text(const char* key) const;
    std::vector<std::string> texts(const char* key) const;
    /// Returns as many numbers as `count`, or none where the key is missing.
    std::vector<double> numbers(const char* key, size_t count) const;
    /// Returns any count of numbers.
    std::vector<double> numbers(const char* key) const;
    std::vector<int> indices(const char* key) const;
    /// Returns the object of a key, which is empty where the key is missing.
    GltfObject object(const char* key) const;
    std::vector<GltfObject> objects(const char* key) const;
    /// Returns an object of "extensions"; empty where there is none.
    GltfObject extension(const char* key) const { return object("extensions").object(key); }
    bool has_extension(const char* key) const { return has("extensions") && object("extensions").has(key); }
    std::vector<std::string> keys() const;

private:
    /// Returns null where the key is missing.
    const nlohmann::json* find(const char* key) const;
    const nlohmann::json& array(const char* key) const;
    [[noreturn]] void refuse(const char* key, const char* what) const;

    const nlohmann::json* json_;
    std::string name_;
};

/// Notes about a file. The same note about several parts becomes one line, which names the first. A note about the
/// whole file has no part.
class GltfNotes {
public:
    void add(const std::string& part, const std::string& message);
    std::vector<std::string> lines() const;

private:
    struct Note {
        std::string part, message;
        std::string last = part;  ///< the part that was added last
        size_t count = 1;
    };
    std::vector<Note> notes_;
};

/// Throws Error without a place for damage, for other versions of glTF, and for a required extension that is not read.
class GltfDocument {
public:
    GltfDocument(const std::string& bytes, std::filesystem::path folder, const ObjLimits& limits);
    GltfDocument(const GltfDocument&) = delete;
    GltfDocument& operator=(const GltfDocument&) = delete;

    const GltfObject& root() const { return root_; }
    /// Returns an element of a list of the root: element("meshes", 3, "mesh").
    GltfObject element(const char* list, int index, const char* kind) const;
    size_t count(const char* list) const;

    /// Returns the bytes of a buffer view. They live as long as the file.
    std::span<const char> view(int index);
    /// Returns the bytes of a picture's file.
    std::string picture(int image);
    size_t most_elements() const { return limits_.corners; }

    GltfNotes notes;

private:
    std::span<const char> buffer(int index);
    std::string read_uri(const std::string& uri, const std::string& name);
    void check_extensions();

    const std::filesystem::path folder_;
    const ObjLimits limits_;
    size_t bytes_left_;  ///< of files that it names
    nlohmann::json json_;
    GltfObject root_{json_, "the file"};
    std::optional<std::string> chunk_;    ///< the binary chunk of a .glb
    std::map<int, std::string> buffers_;  ///< that were read from elsewhere
};

/// Returns a text of a file for a message: its first 60 characters, without control characters.
std::string quoted_in_message(const std::string& text);

}  // namespace relief
