// Arbitrary texts of lab.toml and staff/grading.toml.
#include "framework/course/manifest/manifest.h"
#include "tests/fuzz/fuzz.h"

constexpr const char* with_task = R"(title = "A"
[[probe]]
name = "tangent"
[[task]]
id = "1.1"
title = "T"
file = "shaders/x/task.glsl"
)";

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t count) {
    relief::fuzz(bytes, count, [](const std::string& text) { relief::parse_manifest(text, "lab.toml"); });
    return relief::fuzz(bytes, count, [](const std::string& text) {
        relief::Manifest manifest = relief::parse_manifest(with_task, "lab.toml");
        relief::add_grading(manifest, text, "grading.toml");
    });
}
