#include "framework/course/check/hidden_checks.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/lab/registry.h"

namespace relief::check {

HiddenByTask hidden_checks(const Manifest& manifest) {
    HiddenByTask hidden;
    for (const CheckInfo& check : manifest.checks)
        if (check.hidden) ++hidden[check.task].count;
    for (const ExampleInfo& example : manifest.examples) {
        const auto says_the_same = [&](const ExampleInfo& other) {
            return !other.hidden && other.task == example.task && other.asks == example.asks;
        };
        if (example.hidden && std::none_of(manifest.examples.begin(), manifest.examples.end(), says_the_same))
            hidden[example.task].not_tested.push_back(example.asks);
    }
    return hidden;
}

std::filesystem::path hidden_checks_file(const LabEntry& lab) {
    return course_root() / "labs" / lab.folder / "expected" / "hidden_checks.json";
}

std::string text_of(const HiddenByTask& hidden) {
    nlohmann::ordered_json text = nlohmann::ordered_json::object();
    for (const auto& [task, one] : hidden) text[task] = {{"checks", one.count}, {"not_tested", one.not_tested}};
    return text.dump(1) + "\n";
}

HiddenByTask read_hidden_checks(const LabEntry& lab) {
    HiddenByTask hidden;
    const std::filesystem::path file = hidden_checks_file(lab);
    if (!std::filesystem::exists(file)) return hidden;
    try {
        const nlohmann::json all = nlohmann::json::parse(read_file(file));
        for (const auto& [task, one] : all.items())
            hidden[task] = {one.at("checks"), one.at("not_tested").get<std::vector<std::string>>()};
    } catch (const std::exception&) {  // then nothing is said of hidden checks
        hidden.clear();
    }
    return hidden;
}

}  // namespace relief::check
