// Runs programs as a user does.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/support.h"

namespace relief {

struct Result {
    int code = -1;  ///< exit code, or 128 + the signal
    std::string out, err;
};

struct Circumstances {
    std::filesystem::path folder;                    ///< working directory; empty: that of the test
    std::map<std::string, std::string> environment;  ///< added to the test's; an empty value removes a variable
};

/// A program that runs beside the test. The destructor kills it if it still runs.
class Process {
public:
    Process(const std::vector<std::string>& command, const Circumstances& where = {});
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    void signal(int number) const;
    /// Returns its standard error so far.
    std::string err() const;
    bool running();
    /// Waits for the end. Kills the program after 20 minutes, which no test needs on the slowest machine, and says so
    /// in `err`.
    Result wait();

private:
    std::filesystem::path out_, err_;
    int pid_ = -1;
    int status_ = 0;
};

inline Result run(const std::vector<std::string>& command, const Circumstances& where = {}) {
    return Process(command, where).wait();
}

/// A run that must be refused: the words of its command, a part of its message, and its exit code.
struct Refusal {
    std::vector<std::string> words;
    std::string said;
    int code = 2;
};

/// Expects that each run ends with its code, and writes one line with `said` to standard error and nothing to standard
/// output.
template <class Run>
void expect_refused(Run run_of, const std::vector<Refusal>& cases) {
    for (const auto& [words, said, code] : cases) {
        const Result result = run_of(words);
        EXPECT_EQ(result.code, code) << said << "\n" << result.err;
        EXPECT_TRUE(contains(result.err, said)) << said << "\n" << result.err;
        EXPECT_EQ(occurrences(result.err, "\n"), 1u) << result.err;
        EXPECT_EQ(result.out, "") << said;
    }
}

/// Returns the path of this build's executable.
std::string relief_program();

}  // namespace relief
