// A copy of the course and of what is built, in a folder with a space in its name, for tests that damage things.
#pragma once

#include "tests/process.h"
#include "tests/support.h"

namespace relief {

class CourseCopy {
public:
    CourseCopy();

    std::filesystem::path path() const { return folder_.path() / "a course"; }
    /// Runs the copy's executable from its own folder.
    Result relief(std::vector<std::string> arguments, Circumstances where = {}) const;
    /// Replaces a part of a file that must be there.
    void edit(const std::string& file, const std::string& find, const std::string& replace) const;
    void overwrite(const std::string& file, const std::string& content) const;

private:
    TemporaryFolder folder_;
};

std::string read_all(const std::filesystem::path& file);

/// Names of the files in a folder.
std::vector<std::string> files_in(const std::filesystem::path& folder);

}  // namespace relief
