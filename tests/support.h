// Helpers that several tests share.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "framework/core/base/error.h"

namespace relief {

/// The folder of the course under test, and the one of its build. Defined in a file of its own, so that a compiler
/// cache recognises all other files in a course elsewhere.
extern const char* const source_folder;
extern const char* const build_folder;

/// A temporary folder, removed by the destructor.
class TemporaryFolder {
public:
    TemporaryFolder() {
        static std::atomic<int> count = 0;
        path_ = std::filesystem::temp_directory_path() /
                ("relief-test-" + std::to_string(getpid()) + "-" + std::to_string(count++));
        std::filesystem::create_directories(path_);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

    /// Writes a file below the folder, and makes its parent folders. Returns its path.
    std::filesystem::path write(const std::string& name, std::string_view text) const {
        const std::filesystem::path file = path_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary).write(text.data(), std::streamsize(text.size()));
        return file;
    }

private:
    std::filesystem::path path_;
};

/// Returns the message of an exception that a call must throw. Fails the test and returns "" when it throws no
/// `Expected`.
template <class Expected = Error, class Call>
std::string message_of(Call call) {
    try {
        call();
    } catch (const Expected& error) {
        return error.what();
    } catch (const std::exception& error) {
        ADD_FAILURE() << "threw another kind of exception: " << error.what();
        return {};
    }
    ADD_FAILURE() << "threw nothing";
    return {};
}

/// Returns whether each claim is tested on everything that it is about, and not on a sample: see `--all` in
/// tests/README.md.
inline bool tests_all() { return std::getenv("RELIEF_TEST_ALL") != nullptr; }

/// Returns a fixed sample of `count` evenly spaced elements, or all elements if tests_all().
template <class Thing>
std::vector<Thing> sample_of(const std::vector<Thing>& all, size_t count) {
    if (tests_all() || all.size() <= count) return all;
    std::vector<Thing> sample;
    for (size_t i = 0; i < count; ++i) sample.push_back(all[(2 * i + 1) * all.size() / (2 * count)]);
    return sample;
}

/// Returns whether a proof that goes lab by lab looks at this lab, named by its two digits: at all labs, unless
/// `./relief test --ci` names some of them.
inline bool is_in_sample(std::string_view lab) {
    const char* const labs = std::getenv("RELIEF_TEST_LABS");
    return !labs || std::string_view(labs).find(lab) != std::string_view::npos;
}

/// Returns the text with each occurrence of `from` replaced. Fails the test if there is none.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    EXPECT_NE(text.find(from), std::string::npos) << from;
    for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

/// Sets environment variables and restores them at the end. An empty value removes the variable.
class Environment {
public:
    explicit Environment(const std::map<std::string, std::string>& variables) {
        for (const auto& [name, value] : variables) {
            const char* const now = std::getenv(name.c_str());
            before_[name] = now ? now : "";
            set(name, value);
        }
    }
    ~Environment() {
        for (const auto& [name, value] : before_) set(name, value);
    }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

private:
    static void set(const std::string& name, const std::string& value) {
        value.empty() ? unsetenv(name.c_str()) : setenv(name.c_str(), value.c_str(), 1);
    }
    std::map<std::string, std::string> before_;
};

inline bool contains(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

/// Returns how often `part` occurs in `text`.
inline size_t occurrences(std::string_view text, std::string_view part) {
    size_t count = 0;
    for (size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

}  // namespace relief
