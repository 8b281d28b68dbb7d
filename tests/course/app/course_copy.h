// A copy of the course and its build, for tests that damage files. Its folder has a space in its name.
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
    /// Replaces the first occurrence of `find`, which must exist.
    void edit(const std::string& file, const std::string& find, const std::string& replace) const;
    void overwrite(const std::string& file, const std::string& content) const;

private:
    TemporaryFolder folder_;
};

std::string read_all(const std::filesystem::path& file);

/// Returns the bytes of a data URI's text.
std::string from_base64(const std::string& text);

/// Returns the names of the files in a folder.
std::vector<std::string> files_in(const std::filesystem::path& folder);

}  // namespace relief
