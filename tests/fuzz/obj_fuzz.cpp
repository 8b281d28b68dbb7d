// OBJ models and MTL materials: the model is the text before the first NUL, and its material file the text after it.
// Tangents must be computable for every mesh that is read.
#include <algorithm>

#include "framework/library/mesh/obj.h"
#include "framework/library/mesh/tangents.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t count) {
    return relief::fuzz(bytes, count, [](const std::string& text) {
        const size_t end = std::min(text.find('\0'), text.size());
        const std::string_view all(text);
        const relief::ObjModel model =
            relief::parse_obj(all.substr(0, end), end < all.size() ? all.substr(end + 1) : std::string_view());
        for (const auto method : {relief::TangentMethod::per_face, relief::TangentMethod::mikktspace})
            for (const relief::Vertex& vertex : relief::with_tangents(model.mesh, method, nullptr, 1).vertices) {
                const float length = glm::length(glm::vec3(vertex.tangent));
                if (!(length > 0.99f && length < 1.01f)) __builtin_trap();
            }
    });
}
