// Normal-map formats: what encoding and decoding cost, and what comes back.
#include <memory>
#include <random>

#include "framework/image/normal_codec.h"
#include "framework/measure/topics.h"

namespace relief {
namespace {

double degrees_between(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

struct Vectors {
    std::vector<glm::dvec3> normals, decoded;
    std::vector<NormalCode> codes;
};

/// Evenly on the upper hemisphere, where tangent-space maps live.
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

std::vector<BenchMethod> methods(const BenchSettings& settings) {
    const size_t count = settings.quick ? 20'000 : 200'000;
    std::vector<BenchMethod> result;
    for (const NormalFormatInfo& info : normal_formats()) {
        const auto data = std::make_shared<Vectors>();
        data->normals = hemisphere(count);
        data->decoded.resize(count), data->codes.resize(count);
        std::vector<double> errors;
        for (size_t i = 0; i < count; ++i) {
            data->codes[i] = encode_normal(info.format, data->normals[i]);
            errors.push_back(degrees_between(decode_normal(info.format, data->codes[i]), data->normals[i]));
        }
        const BenchError error = error_figures(std::move(errors), "degree");
        const auto add = [&](const char* work, auto run) {
            result.push_back({.name = std::string(info.name),
                              .knobs = {{"do", work}, {"bits", std::to_string(info.channels * info.bits)}},
                              .items = count,
                              .item = "vector",
                              .run = run,
                              .error = error});
        };
        const NormalFormat format = info.format;
        add("encode", [data, format] {
            for (size_t i = 0; i < data->normals.size(); ++i) data->codes[i] = encode_normal(format, data->normals[i]);
        });
        add("decode", [data, format] {
            for (size_t i = 0; i < data->codes.size(); ++i) data->decoded[i] = decode_normal(format, data->codes[i]);
        });
    }
    return result;
}

}  // namespace

BenchTopic storage_topic() {
    return {"storage", "normal-map formats on the CPU, in double precision, over the upper hemisphere", methods};
}

}  // namespace relief
