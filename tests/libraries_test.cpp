// The libraries and modules that can meet in one process.
#include <map>
#include <set>
#include <sstream>

#include "framework/core/base/paths.h"
#include "tests/process.h"
#include "tests/support.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

/// Returns the functions and variables with external linkage that a library defines. Leaves out weak ones, such as
/// inline functions, which several libraries may share.
std::set<std::string> definitions(const fs::path& library) {
    const Result listed = run({"nm", "--dynamic", "--defined-only", "--format=posix", library.string()});
    EXPECT_EQ(listed.code, 0) << listed.err;
    std::set<std::string> found;
    std::istringstream lines(listed.out);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string name, kind;
        if (words >> name >> kind && std::string("TDBR").find(kind) != std::string::npos) found.insert(name);
    }
    return found;
}

TEST(Libraries, DefineEachSymbolOnce) {
    std::map<std::string, std::string> owner;
    int libraries = 0;
    for (const auto& entry : fs::directory_iterator(executable_folder())) {
        if (entry.path().extension() != ".so") continue;
        ++libraries;
        const std::string library = entry.path().filename().string();
        const std::set<std::string> all = definitions(entry.path());
        EXPECT_FALSE(all.empty()) << library;
        for (const std::string& symbol : all)
            if (const auto [place, is_new] = owner.emplace(symbol, library); !is_new)
                ADD_FAILURE() << symbol << " is defined in " << place->second << " and in " << library;
    }
    EXPECT_GE(libraries, 5);
}

}  // namespace
}  // namespace relief
