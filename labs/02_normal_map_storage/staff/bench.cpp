// Normal-map formats: the time and the error of encoding and decoding vectors, and of compressing maps in blocks.
#include <memory>
#include <random>

#include "framework/core/image/asset.h"
#include "framework/library/maps/bc1.h"
#include "framework/staff/measure/bench.h"
#include "framework/staff/measure/usual.h"
#include "framework/staff/reference/degrees.h"
#include "framework/staff/reference/normal_codec.h"
#include "framework/staff/reference/rgtc.h"

namespace relief::measure {
namespace {

struct Vectors {
    std::vector<glm::dvec3> normals, decoded;
    std::vector<NormalCode> codes;
};

/// Returns uniform random directions on the upper hemisphere, the range of tangent-space maps.
std::vector<glm::dvec3> hemisphere(size_t count) {
    std::mt19937 random(1);
    std::uniform_real_distribution<> z_of(0, 1), turn_of(0, 2 * 3.14159265358979);
    std::vector<glm::dvec3> normals(count);
    for (glm::dvec3& n : normals) {
        const double z = z_of(random), turn = turn_of(random), r = std::sqrt(1 - z * z);
        n = {r * std::cos(turn), r * std::sin(turn), z};
    }
    return normals;
}

/// Returns a format's vectors, encoded and decoded once; its scenes share them.
std::shared_ptr<Vectors> vectors_of(NormalFormat format, size_t count) {
    const auto data = std::make_shared<Vectors>();
    data->normals = hemisphere(count);
    for (const glm::dvec3& normal : data->normals) {
        data->codes.push_back(encode_normal(format, normal));
        data->decoded.push_back(decode_normal(format, data->codes.back()));
    }
    return data;
}

BenchSubject subject_of(const std::shared_ptr<Vectors>& data, double bits, std::function<void()> run) {
    std::vector<double> errors;
    for (size_t i = 0; i < data->normals.size(); ++i)
        errors.push_back(degrees_between(data->decoded[i], data->normals[i]));
    return {.items = data->normals.size(),
            .work = {{"bits", bits}},
            .error = error_figures(std::move(errors), "degree"),
            .run = std::move(run)};
}

/// A map of unit normals, and the map that comes back.
struct Map {
    Image normals, decoded;  ///< three floats a texel; a format of two channels does not write z
};

/// Returns a square of an asset. Its corner is on mortar, so there are creases.
Image square_of(const std::string& asset, int side) {
    const Image picture = read_asset(asset);
    Image normals(side, side, 3);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const float* color = picture.pixel(96 + x, 90 + y);
            const glm::dvec3 n = glm::normalize(2.0 * glm::dvec3(color[0], color[1], color[2]) - 1.0);
            for (int c = 0; c < 3; ++c) normals.pixel(x, y)[c] = float(n[c]);
        }
    return normals;
}

/// Stores each texel in bytes. `channels` is 2 or 3.
void through_bytes(Map& map, size_t channels) {
    for (size_t i = 0; i < map.normals.values.size(); ++i)
        if (i % 3 < channels)
            map.decoded.values[i] = float(std::round(127.5 * (map.normals.values[i] + 1)) / 127.5 - 1);
}

void through_colors(Map& map) {
    Image colors = map.normals;
    for (float& value : colors.values) value = 0.5f * value + 0.5f;
    map.decoded = through_bc1(colors);
    for (float& value : map.decoded.values) value = 2 * value - 1;
}

/// Stores x and y in blocks of RGTC. Precondition: the size is a multiple of 4.
void through_rgtc(Map& map, RgtcKind kind, RgtcBlock (*encode)(const std::array<double, 16>&, RgtcKind)) {
    const bool is_signed = kind == RgtcKind::snorm;
    for (int top = 0; top < map.normals.height; top += 4)
        for (int left = 0; left < map.normals.width; left += 4)
            for (int c = 0; c < 2; ++c) {
                std::array<double, 16> values;
                for (int i = 0; i < 16; ++i) {
                    const double n = map.normals.pixel(left + i % 4, top + i / 4)[c];
                    values[size_t(i)] = is_signed ? n : 0.5 * n + 0.5;
                }
                values = rgtc_decode(encode(values, kind), kind);
                for (int i = 0; i < 16; ++i)
                    map.decoded.pixel(left + i % 4, top + i / 4)[c] =
                        float(is_signed ? values[size_t(i)] : 2 * values[size_t(i)] - 1);
            }
}

BenchScene compression(const char* name, int side) {
    BenchScene scene{{{"do", "compress"}, {"map", name}}, "texel"};
    const auto add = [&](const char* method, int bits, bool has_z, std::function<void(Map&)> store) {
        const auto prepare = [=, asset = std::string(name) + "_normal.png"] {
            const auto map = std::make_shared<Map>();
            map->normals = map->decoded = square_of(asset, side);
            store(*map);
            std::vector<double> errors;
            for (size_t i = 0; i < map->normals.pixel_count(); ++i) {
                const float *n = &map->normals.values[3 * i], *d = &map->decoded.values[3 * i];
                const double z = has_z ? d[2] : std::sqrt(std::max(0.0, 1 - double(d[0]) * d[0] - double(d[1]) * d[1]));
                errors.push_back(degrees_between({d[0], d[1], z}, {n[0], n[1], n[2]}));
            }
            return BenchSubject{.items = map->normals.pixel_count(),
                                .work = {{"bits", double(bits)}},
                                .error = error_figures(std::move(errors), "degree"),
                                .run = [=] { store(*map); }};
        };
        scene.methods.push_back({method, {{"bits", std::to_string(bits)}}, prepare});
    };
    add("unorm8", 24, true, [](Map& map) { through_bytes(map, 3); });
    add("rg8", 16, false, [](Map& map) { through_bytes(map, 2); });
    add("bc1", 4, true, through_colors);
    add("bc5", 8, false, [](Map& map) { through_rgtc(map, RgtcKind::unorm, rgtc_range_fit); });
    add("bc5-snorm", 8, false, [](Map& map) { through_rgtc(map, RgtcKind::snorm, rgtc_range_fit); });
    add("bc5-best", 8, false, [](Map& map) { through_rgtc(map, RgtcKind::unorm, rgtc_best); });
    return scene;
}

std::vector<BenchScene> storage_scenes(const BenchSettings& settings) {
    const size_t count = settings.quick ? 20'000 : 200'000;
    BenchScene encoding{{{"do", "encode"}}, "vector"}, decoding{{{"do", "decode"}}, "vector"};
    for (const NormalFormatInfo& info : normal_formats()) {
        const NormalFormat format = info.format;
        const int bits = info.channels * info.bits;
        const auto add = [&](BenchScene& scene, auto run) {
            scene.methods.push_back({std::string(info.name), {{"bits", std::to_string(bits)}}, [=] {
                                         const auto data = vectors_of(format, count);
                                         return subject_of(data, bits, [=] { run(*data); });
                                     }});
        };
        add(encoding, [format](Vectors& data) {
            for (size_t i = 0; i < data.normals.size(); ++i) data.codes[i] = encode_normal(format, data.normals[i]);
        });
        add(decoding, [format](Vectors& data) {
            for (size_t i = 0; i < data.codes.size(); ++i) data.decoded[i] = decode_normal(format, data.codes[i]);
        });
    }
    const auto add_usual = [&](BenchScene& scene, auto run) {
        const auto prepare = [=] {
            const auto data = std::make_shared<Vectors>();
            data->normals = hemisphere(count);
            for (const glm::dvec3& normal : data->normals)
                data->codes.push_back(usual_code(normal)), data->decoded.push_back(usual_normal(data->codes.back()));
            return subject_of(data, 24, [=] { run(*data); });
        };
        scene.methods.push_back({"usual", {{"bits", "24"}}, prepare, true});
    };
    add_usual(encoding, [](Vectors& data) {
        for (size_t i = 0; i < data.normals.size(); ++i) data.codes[i] = usual_code(data.normals[i]);
    });
    add_usual(decoding, [](Vectors& data) {
        for (size_t i = 0; i < data.codes.size(); ++i) data.decoded[i] = usual_normal(data.codes[i]);
    });
    std::vector<BenchScene> all = {encoding, decoding};
    // The search for the best blocks takes 0.1 ms a texel, so the maps are small.
    for (const char* map : {"bricks", "paving"}) {
        all.push_back(compression(map, 64));
        if (settings.quick) break;
    }
    return all;
}

}  // namespace

const TopicRegistration storage_topic(
    {.name = "storage",
     .help = "normal-map formats on the CPU, in double precision: vectors of the upper hemisphere, and maps in blocks",
     .question = "What does a normal-map format cost in degrees, and what in time?",
     .scenes = storage_scenes,
     .labs = {"02"}});

}  // namespace relief::measure
