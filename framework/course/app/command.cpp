#include "framework/course/app/command.h"

#include <algorithm>

namespace relief::app {
namespace {

std::vector<CommandEntry>& entries() {
    static std::vector<CommandEntry> all;
    return all;
}

}  // namespace

const std::vector<CommandEntry>& commands() { return entries(); }

bool has_command(const std::string& name) {
    return std::any_of(commands().begin(), commands().end(),
                       [&](const CommandEntry& command) { return command.name == name; });
}

CommandRegistration::CommandRegistration(CommandEntry entry) {
    const auto place = std::upper_bound(entries().begin(), entries().end(), entry,
                                        [](const CommandEntry& a, const CommandEntry& b) { return a.order < b.order; });
    entries().insert(place, entry);
}

}  // namespace relief::app
