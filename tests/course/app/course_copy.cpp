#include "tests/course/app/course_copy.h"

#include <fstream>
#include <iterator>

namespace relief {

namespace fs = std::filesystem;

CourseCopy::CourseCopy() {
    fs::create_directories(path() / "bin");
    for (const char* name : {"relief", "lab-01", "librelief.so", "librelief-truth.so", "librelief-staff.so",
                             "relief-openimageio.so", "relief-librsvg.so", "relief-window.so"})
        fs::copy(fs::path(build_folder) / "bin" / name, path() / "bin");
    fs::copy(fs::path(build_folder) / "bin/textures", path() / "bin/textures");
    const fs::path source = source_folder;
    for (const char* name :
         {"labs", "shaders", "assets", "framework/course/app/new_lab", "framework/course/pages",
          "framework/staff/pages", "framework/staff/slides", "framework/staff/grade/twin.glsl", "slides"})
        if (fs::exists(source / name)) {
            fs::create_directories((path() / name).parent_path());
            fs::copy(source / name, path() / name, fs::copy_options::recursive);
        }
}

Result CourseCopy::relief(std::vector<std::string> arguments, Circumstances where) const {
    arguments.insert(arguments.begin(), path() / "bin" / "relief");
    if (where.folder.empty()) where.folder = path();
    return run(arguments, where);
}

void CourseCopy::edit(const std::string& file, const std::string& find, const std::string& replace) const {
    std::string text = read_all(path() / file);
    const size_t at = text.find(find);
    ASSERT_NE(at, std::string::npos) << file << " does not contain " << find;
    overwrite(file, text.replace(at, find.size(), replace));
}

void CourseCopy::overwrite(const std::string& file, const std::string& content) const {
    std::ofstream(path() / file, std::ios::binary) << content;
}

std::string read_all(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> files_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
    return names;
}

std::string from_base64(const std::string& text) {
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        if (c == '=') break;
        bits = bits << 6 | uint32_t(letters.find(c));
        if ((count += 6) >= 8) bytes += char(bits >> (count -= 8) & 255);
    }
    return bytes;
}

}  // namespace relief
