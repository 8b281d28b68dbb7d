// Runs a program of GL tests in one context: `--context osmesa`, `--context egl`, or `--context auto`, which is OSMesa
// where it is installed. The software renderer is pinned, so that every machine produces the same bits. `--context gpu`
// runs them on a hardware driver: by hand, since no test machine has one. With `--sample`, leaves out the labs that are
// not among those of `./relief test --ci`.
#include <gtest/gtest.h>

#include <cctype>
#include <cstdio>
#include <cstring>

#include "framework/core/base/error.h"
#include "framework/core/context/context.h"
#include "framework/core/gl/gl.h"
#include "framework/core/lab/registry.h"
#include "tests/support.h"

namespace {

/// Fails each test that leaves an OpenGL error behind.
class NoErrorLeft final : public testing::EmptyTestEventListener {
    void OnTestEnd(const testing::TestInfo&) override {
        const std::string errors = relief::take_gl_errors();
        if (!errors.empty()) ADD_FAILURE() << "OpenGL: " << errors;
    }
};

/// Returns the name of a lab's own tests: BaseColor for `base_color`.
std::string tests_of(const std::string& lab) {
    std::string name;
    bool is_first = true;
    for (const char letter : lab) {
        if (letter != '_') name += is_first ? char(std::toupper(letter)) : letter;
        is_first = letter == '_';
    }
    return name;
}

/// Excludes the tests of the labs that are not in the sample: a lab's own, and those that have it as their parameter.
void leave_out_other_labs() {
    std::string filter = GTEST_FLAG_GET(filter);
    for (const relief::LabEntry& lab : relief::registry()) {
        if (relief::is_in_sample(lab.two_digits())) continue;
        filter += (filter.find('-') == std::string::npos ? "-" : ":") + tests_of(lab.name) + ".*:*" + lab.folder;
    }
    GTEST_FLAG_SET(filter, filter);
}

}  // namespace

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    if (argc == 4 && std::strcmp(argv[3], "--sample") == 0) --argc, leave_out_other_labs();
    if (argc != 3 || std::strcmp(argv[1], "--context") != 0) {
        std::fprintf(stderr, "usage: %s --context osmesa|egl|auto|gpu\n", argv[0]);
        return 2;
    }
    try {
        const std::optional<relief::ContextKind> kind = relief::context_kind(argv[2]);
        kind == relief::ContextKind::gpu ? relief::draw_comparably() : relief::pin_software_renderer();
        const auto context = relief::open_context(kind);
        std::printf("%s: %s\n", argv[2], relief::describe_context().driver().c_str());
        testing::UnitTest::GetInstance()->listeners().Append(new NoErrorLeft);
        return RUN_ALL_TESTS();
    } catch (const relief::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
