#include "framework/library/mesh/corners.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <glm/common.hpp>

#include "framework/core/base/error.h"
#include "framework/core/base/parallel.h"

namespace relief {
namespace {

/// The bits of a vertex that are compared.
using Key = std::array<uint32_t, 8>;

Key key_of(const Vertex& vertex) {
    const float values[8] = {vertex.position.x, vertex.position.y, vertex.position.z, vertex.normal.x,
                             vertex.normal.y,   vertex.normal.z,   vertex.uv.x,       vertex.uv.y};
    Key key;
    for (size_t i = 0; i < key.size(); ++i) key[i] = glm::floatBitsToUint(values[i] + 0.0f);  // -0 becomes 0
    return key;
}

uint64_t hash_of(const Key& key) {
    uint64_t words[4], hash = 0;
    std::memcpy(words, key.data(), sizeof words);
    // Multiplication mixes each word into the upper bits most, so the shift brings these down again.
    for (const uint64_t word : words) {
        hash = (hash ^ word) * 0x9e3779b97f4a7c15;
        hash ^= hash >> 32;
    }
    return hash;
}

}  // namespace

void check_indices(const Mesh& mesh) {
    if (mesh.indices.size() % 3 != 0)
        throw Error(fmt::format("a mesh of triangles has three indices for each; this has {}", mesh.indices.size()));
    uint32_t largest = 0;
    for (const uint32_t index : mesh.indices) largest = std::max(largest, index);
    if (!mesh.indices.empty() && largest >= mesh.vertices.size())
        throw Error(fmt::format("index {} of a mesh with {} vertices", largest, mesh.vertices.size()));
}

Buffer<uint32_t> welded_vertices(const Mesh& mesh) {
    const size_t count = mesh.vertices.size();
    const size_t slots = std::bit_ceil(count + count / 4 + 1);
    // The upper half of the hash avoids reading vertices that only share the slot.
    struct Slot {
        uint32_t vertex, hash;
    };
    constexpr uint32_t empty = UINT32_MAX;
    Buffer<Slot> table(slots);
    Buffer<uint32_t> first(count);
    std::fill(table.begin(), table.end(), Slot{empty, empty});
    // Compute the keys of a few vertices ahead, so that their slots are prefetched.
    constexpr size_t ahead = 8;
    std::array<Key, ahead> keys;
    std::array<uint64_t, ahead> hashes;
    const auto prepare = [&](size_t i) {
        if (i >= count) return;
        keys[i % ahead] = key_of(mesh.vertices[i]);
        hashes[i % ahead] = hash_of(keys[i % ahead]);
        __builtin_prefetch(&table[hashes[i % ahead] & (slots - 1)]);
    };
    for (size_t i = 0; i < ahead; ++i) prepare(i);
    for (size_t i = 0; i < count; ++i) {
        const Key key = keys[i % ahead];
        size_t slot = hashes[i % ahead] & (slots - 1);
        const uint32_t upper = uint32_t(hashes[i % ahead] >> 32);
        prepare(i + ahead);
        const auto is_another = [&](const Slot& there) {
            return there.vertex != empty && (there.hash != upper || key_of(mesh.vertices[there.vertex]) != key);
        };
        while (is_another(table[slot])) slot = (slot + 1) & (slots - 1);
        if (table[slot].vertex == empty) table[slot] = {uint32_t(i), upper};
        first[i] = table[slot].vertex;
    }
    return first;
}

CornerLists::CornerLists(const Mesh& mesh, const Buffer<uint32_t>& vertex_of, unsigned threads)
    : begins_(mesh.vertices.size() + 2), corners_(mesh.indices.size()) {
    std::fill(begins_.begin(), begins_.end(), 0u);
    // Each thread reads all corners and keeps the ones at its own vertices.
    const auto vertices_in_pieces = [&](const auto& work) {
        parallel_pieces(mesh.vertices.size(), 1 << 16, threads, work);
    };
    vertices_in_pieces([&](size_t begin, size_t end) {
        for (const uint32_t index : mesh.indices)
            if (const uint32_t vertex = vertex_of[index]; vertex - begin < end - begin) ++begins_[vertex + 2];
    });
    for (size_t i = 2; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
    // Filling a list moves its begin to its end, where the next list begins.
    vertices_in_pieces([&](size_t begin, size_t end) {
        for (size_t i = 0; i < mesh.indices.size(); ++i)
            if (const uint32_t vertex = vertex_of[mesh.indices[i]]; vertex - begin < end - begin)
                corners_[begins_[vertex + 1]++] = uint32_t(i);
    });
}

}  // namespace relief
