// relief list: lists the labs.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "framework/core/base/error.h"
#include "framework/core/base/log.h"
#include "framework/course/app/command.h"
#include "framework/course/manifest/manifest.h"

namespace relief::app {
namespace {

int list_labs(bool json) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    bool every_manifest_read = true;
    for (const LabEntry& lab : registry()) try {
            const Manifest manifest = load_manifest(lab);
            all.push_back({{"number", lab.number},
                           {"name", lab.name},
                           {"title", manifest.title},
                           {"points", manifest.points()},
                           {"learns", manifest.learns}});
        } catch (const Error& error) {
            print_error(error.what());
            every_manifest_read = false;
        }
    if (json)
        fmt::print("{}\n", all.dump(2));
    else
        for (const auto& lab : all) {
            const int points = lab["points"];
            fmt::print("{:02}  {:<24} {}{}\n", lab["number"].get<int>(), lab["name"].get<std::string>(),
                       lab["title"].get<std::string>(), points > 0 ? fmt::format(" ({} points)", points) : "");
        }
    return every_manifest_read ? 0 : 1;
}

class ListCommand final : public Command {
public:
    void options(CommandOptions& options) override { options.flag("--json", json_, "print JSON, for scripts"); }
    int run() override { return list_labs(json_); }

private:
    bool json_ = false;
};
RELIEF_COMMAND(ListCommand, 1, "list", "lists the labs with titles and points");

}  // namespace

}  // namespace relief::app
