// The libraries and modules that can meet in one process.
#include <map>
#include <sstream>
#include <vector>

#include "framework/core/base/paths.h"
#include "tests/process.h"
#include "tests/support.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> libraries() {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(executable_folder()))
        if (entry.path().extension() == ".so") found.push_back(entry.path());
    EXPECT_GE(found.size(), 5u);
    return found;
}

/// Returns the functions and variables that other libraries can see in this one, by name, with the letter of nm for
/// their kind.
std::map<std::string, char> shown_symbols(const fs::path& library) {
    const Result listed = run({"nm", "--dynamic", "--defined-only", "--format=posix", library.string()});
    EXPECT_EQ(listed.code, 0) << listed.err;
    std::map<std::string, char> found;
    std::istringstream lines(listed.out);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string name;
        if (char kind = 0; words >> name >> kind) found[name] = kind;
    }
    EXPECT_FALSE(found.empty()) << library;
    return found;
}

TEST(Libraries, DefineEachSymbolOnce) {
    std::map<std::string, std::string> owner;
    for (const fs::path& path : libraries()) {
        const std::string library = path.filename().string();
        for (const auto& [symbol, kind] : shown_symbols(path)) {
            // Several libraries may define a weak symbol, such as an inline function.
            if (std::string("TDBR").find(kind) == std::string::npos) continue;
            if (const auto [place, is_new] = owner.emplace(symbol, library); !is_new)
                ADD_FAILURE() << symbol << " is defined in " << place->second << " and in " << library;
        }
    }
}

TEST(Libraries, ShowNothingOfTheLibrariesThatTheyContain) {
    for (const fs::path& path : libraries()) {
        const bool is_module = path.filename().string().starts_with("relief-");
        for (const auto& [symbol, kind] : shown_symbols(path)) {
            // The names of C++ have the namespace in them, also as an argument of a template.
            const bool is_own = contains(symbol, "6relief") || symbol.starts_with("glad") || symbol.starts_with("GLAD");
            EXPECT_TRUE(is_module ? symbol.starts_with("relief_") : is_own) << path.filename() << " shows " << symbol;
        }
    }
}

}  // namespace
}  // namespace relief
