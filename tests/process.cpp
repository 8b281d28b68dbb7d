#include "tests/process.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

#include "tests/support.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

std::string whole(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void redirect(int descriptor, const char* file, int flags) {
    const int opened = open(file, flags, 0600);
    if (opened < 0 || dup2(opened, descriptor) < 0) _exit(126);
}

}  // namespace

Process::Process(const std::vector<std::string>& command, const Circumstances& where) {
    static std::atomic<int> count = 0;
    const std::string stem =
        fs::temp_directory_path() / ("relief-process-" + std::to_string(getpid()) + "-" + std::to_string(++count));
    out_ = stem + ".out", err_ = stem + ".err";
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    pid_ = fork();
    if (pid_ < 0) throw std::runtime_error("fork failed");
    if (pid_ > 0) return;
    std::signal(SIGINT, SIG_DFL);  // a shell starts background programs with SIGINT ignored
    redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
    redirect(STDOUT_FILENO, out_.c_str(), O_WRONLY | O_CREAT | O_TRUNC);
    redirect(STDERR_FILENO, err_.c_str(), O_WRONLY | O_CREAT | O_TRUNC);
    if (!where.folder.empty() && chdir(where.folder.c_str()) != 0) _exit(126);
    for (const auto& [name, value] : where.environment)
        value.empty() ? unsetenv(name.c_str()) : setenv(name.c_str(), value.c_str(), 1);
    execvp(arguments[0], arguments.data());
    _exit(127);
}

Process::~Process() {
    if (running()) {
        kill(pid_, SIGKILL);
        waitpid(pid_, &status_, 0);
    }
    fs::remove(out_), fs::remove(err_);
}

void Process::signal(int number) const { kill(pid_, number); }

std::string Process::err() const { return whole(err_); }

bool Process::running() {
    if (pid_ > 0 && waitpid(pid_, &status_, WNOHANG) == pid_) pid_ = -1;
    return pid_ > 0;
}

Result Process::wait() {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(20);
    for (int i = 0; running() && std::chrono::steady_clock::now() < end; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5 + std::min(i / 50, 55)));
    const bool hangs = running();
    if (hangs) {
        signal(SIGKILL);
        waitpid(pid_, &status_, 0);
        pid_ = -1;
    }
    return {WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_), whole(out_),
            whole(err_) + (hangs ? "\nkilled by its test after 20 minutes\n" : "")};
}

std::string relief_program() { return std::string(build_folder) + "/bin/relief"; }

}  // namespace relief
