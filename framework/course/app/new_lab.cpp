// relief new-lab: creates a lab that builds, runs and is tested, from the templates in framework/course/app/new_lab/.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/from_staff.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/core/lab/registry.h"
#include "framework/course/app/command.h"

namespace relief::app {
namespace {

namespace fs = std::filesystem;

// The course's own labs are 01 to 19, and their numbers are fixed.
constexpr int first_free_number = 20, last_number = 99;

/// Returns the numbers and folder names of everything in labs/, built or not.
std::map<int, std::string> taken_numbers() {
    std::map<int, std::string> taken;
    for (const auto& entry : fs::directory_iterator(course_root() / "labs")) {
        const std::string folder = entry.path().filename().string();
        if (const auto number = parse_int(folder.substr(0, folder.find('_')))) taken.emplace(*number, folder);
    }
    return taken;
}

struct NewName {
    int number;
    std::string name;
    std::string folder() const { return fmt::format("{:02}_{}", number, name); }
};

NewName parse_name(const std::string& text) {
    const auto taken = taken_numbers();
    NewName result{first_free_number, text};
    const size_t underscore = text.find('_');
    if (const auto number = parse_int(text.substr(0, underscore)); number && underscore != std::string::npos) {
        if (*number < 1 || *number > last_number)
            throw UsageError(fmt::format("lab numbers go from 01 to {}, not '{}'", last_number, text));
        result = {*number, text.substr(underscore + 1)};
        if (taken.contains(*number))
            throw UsageError(fmt::format("lab number {:02} is taken by {}", *number, taken.at(*number)));
    } else {
        while (taken.contains(result.number)) ++result.number;
        if (result.number > last_number) throw UsageError("all lab numbers are in use");
    }
    const bool good = !result.name.empty() && std::islower(static_cast<unsigned char>(result.name[0])) &&
                      result.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
    if (!good)
        throw UsageError(
            fmt::format("a lab's name is lower case with underscores, with or without a number: wet_stone or "
                        "21_wet_stone, not '{}'",
                        text));
    for (const auto& [number, folder] : taken)
        if (folder.substr(folder.find('_') + 1) == result.name)
            throw UsageError(fmt::format("a lab of that name exists: {}", folder));
    return result;
}

std::string replace_all(std::string text, const std::string& from, const std::string& to) {
    for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

std::string class_name(const std::string& name) {
    std::string result;
    for (const std::string& word : split(name, '_')) result += capitalized(word);
    return result;
}

std::string title(const std::string& name) { return capitalized(replace_all(name, "_", " ")); }

int make_new_lab(const std::string& text) {
    const NewName name = parse_name(text);
    const fs::path& root = course_root();
    const fs::path templates = root / "framework" / "course" / "app" / "new_lab";
    const fs::path lab = root / "labs" / name.folder(), shaders = root / "shaders" / name.folder();
    std::vector<std::pair<const char*, fs::path>> files = {{"surface.vert", shaders / "surface.vert"},
                                                           {"surface.frag", shaders / "surface.frag"},
                                                           {"README.md", lab / "README.md"},
                                                           {"truth.h", lab / "truth.h"},
                                                           {"lab.cpp", lab / "lab.cpp"}};
    // The students' course has no exact values and no slides.
    if (staff_is_here()) files.emplace_back("truth.cpp", lab / "staff" / "truth.cpp");
    if (fs::exists(root / "slides")) files.emplace_back("deck.md", root / "slides" / (name.folder() + ".md"));
    // Write the manifest last: a folder is a lab if it has one, so a half-made folder does not count.
    files.emplace_back("lab.toml", lab / "lab.toml");
    for (const auto& [from, file] : files) {
        std::string content = read_file(templates / (std::string(from) + ".in"));
        content = replace_all(content, "@Class@", class_name(name.name));
        content = replace_all(content, "@name@", name.name);
        content = replace_all(content, "@title@", title(name.name));
        content = replace_all(content, "@number@", fmt::format("{:02}", name.number));
        content = replace_all(content, "@folder@", name.folder());
        make_folder(file.parent_path());
        write_file(file, content);
        fmt::print("{}\n", shown(file));
    }
    fmt::print("Build and look at it: ./relief run {:02}\n", name.number);
    return 0;
}

class NewLabCommand final : public Command {
public:
    void options(CommandOptions& options) override {
        options.word("NAME", name_, "like wet_stone (gets a number from 20 on) or 21_wet_stone");
    }
    int run() override { return make_new_lab(name_); }

private:
    std::string name_;
};
RELIEF_COMMAND(NewLabCommand, 20, "new-lab", "makes a new lab that builds, runs and passes the tests");

}  // namespace

}  // namespace relief::app
