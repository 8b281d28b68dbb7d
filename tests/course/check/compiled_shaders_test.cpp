// Compiled shaders that one drawing process hands to another, of which either may be hostile.
#include "framework/course/check/compiled_shaders.h"

#include <gtest/gtest.h>

#include "framework/core/base/file.h"
#include "tests/support.h"

namespace relief::check {
namespace {

const CompiledShaders two = {{std::string(40, 'a'), std::string("\0x", 2)}, {std::string(40, '7'), ""}};

TEST(CompiledShaders, ArriveAsTheyWereSent) {
    const TemporaryFolder folder;
    write_compiled(folder.path(), unpacked(packed(two)));
    EXPECT_EQ(read_compiled(folder.path()), two);
}

TEST(CompiledShaders, ATextThatIsCutHasNoEntries) {
    const std::string text = packed(two);
    EXPECT_EQ(unpacked(text).size(), 2u);
    for (size_t size = 1; size < text.size(); ++size)
        EXPECT_EQ(unpacked(text.substr(0, size)).size(), size == 44 ? 1u : 0u) << size;  // the first entry ends there
}

TEST(CompiledShaders, ANameLeadsNowhereElse) {
    const std::string dots = "../../../../../../../../../../../tmp/evil";
    EXPECT_TRUE(unpacked(packed({{dots.substr(0, 40), "x"}})).empty());
}

TEST(CompiledShaders, FilesThatAreNoEntriesAreNotSent) {
    const TemporaryFolder folder;
    write_compiled(folder.path(), two);
    folder.write("mesa_shader_cache/index", "x");
    folder.write("mesa_shader_cache/aa/" + std::string(38, 'b') + ".tmp", "x");
    folder.write("mesa_shader_cache_db/mesa_cache.db", "x");
    EXPECT_EQ(read_compiled(folder.path()), two);
}

TEST(CompiledShaders, AreBoundedInSize) {
    const TemporaryFolder folder;
    write_compiled(folder.path(), {{std::string(40, 'a'), std::string(longest_compiled, 'x')}});
    EXPECT_TRUE(read_compiled(folder.path()).empty());
}

}  // namespace
}  // namespace relief::check
