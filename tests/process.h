// Programs run by the tests as a user runs them.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace relief {

struct Result {
    int code = -1;  ///< exit code, or 128 + the signal
    std::string out, err;
};

struct Circumstances {
    std::filesystem::path folder;                    ///< working directory, this one's when empty
    std::map<std::string, std::string> environment;  ///< added to this one's; an empty value takes one away
};

/// A program that runs beside the test; killed when the object goes, unless it has ended.
class Process {
public:
    Process(const std::vector<std::string>& command, const Circumstances& where = {});
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    void signal(int number) const;
    /// What it has written to standard error so far.
    std::string err() const;
    bool running();
    /// Waits for the end. What has not ended after 20 minutes hangs: no test asks for as much on the slowest machine.
    /// It is killed, and `err` says so.
    Result wait();

private:
    std::filesystem::path out_, err_;
    int pid_ = -1;
    int status_ = 0;
};

inline Result run(const std::vector<std::string>& command, const Circumstances& where = {}) {
    return Process(command, where).wait();
}

/// The executable of this build.
std::string relief_program();

}  // namespace relief
