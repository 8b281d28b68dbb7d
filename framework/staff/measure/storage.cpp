// Normal-map formats: the time and the error of encoding and decoding.
#include <memory>
#include <random>

#include "framework/staff/measure/topics.h"
#include "framework/staff/measure/usual.h"
#include "framework/staff/reference/normal_codec.h"

namespace relief::measure {
namespace {

double degrees_between(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

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

std::vector<BenchScene> scenes(const BenchSettings& settings) {
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
    return {encoding, decoding};
}

}  // namespace

BenchTopic storage_topic() {
    return {"storage", "normal-map formats on the CPU, in double precision, over the upper hemisphere",
            "What does a normal-map format cost in degrees, and what in time?", scenes};
}

}  // namespace relief::measure
