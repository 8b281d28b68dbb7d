#include "framework/course/check/fingerprints.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/course/manifest/toml_table.h"

namespace relief::check {
namespace {

namespace fs = std::filesystem;

/// Stands for a value that equals the solution's; and the prefix of an error that replaces the values.
constexpr const char* same = "=";
constexpr const char* error_mark = "! ";

/// Returns the factor of written numbers: a picture's values are written as integers from 0 to 255.
double steps_of(const CheckInfo& check) { return check.shot.probe ? 1 : 255; }

size_t value_count(const CheckInfo& check) {
    return size_t(check.shot.size.x) * size_t(check.shot.size.y) * (check.shot.probe ? 4 : 3);
}

/// Returns the number with the fewest digits that differs from `value` by at most `allowed`.
std::string number_text(float value, double allowed, double steps) {
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    if (steps != 1) return fmt::format("{}", std::lround(double(value) * steps));
    return shortest_near(value, allowed);
}

std::optional<float> number_of(const std::string& text, double steps) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    if (text == "nan") return std::numeric_limits<float>::quiet_NaN();
    if (text == "inf" || text == "-inf") return text == "inf" ? infinity : -infinity;
    const auto number = parse_number(text);
    return number ? std::optional(float(*number / steps)) : std::nullopt;
}

std::string text_of(const Sample& mistake, const Sample& solution, const CheckInfo& check) {
    if (!mistake.is_drawn) return error_mark + mistake.error;
    const double allowed = tolerance_of(mistake, solution, bool(check.shot.probe)) / 10;
    std::string text;
    bool differs = false;
    for (size_t i = 0; i < mistake.values.size(); ++i) {
        const bool is_same = is_near(mistake.values[i], solution.values[i], 0);
        differs |= !is_same;
        text += (i > 0 ? " " : "") + (is_same ? same : number_text(mistake.values[i], allowed, steps_of(check)));
    }
    return differs ? text : same;
}

/// Converts each word with `read`. Returns nothing if `read` rejects a word.
template <class Value, class Read>
std::optional<std::vector<Value>> words_as(const std::string& text, Read read) {
    std::vector<Value> values;
    for (const std::string& word : split(text, ' ')) {
        const std::optional<Value> value = read(word);
        if (!value) return {};
        values.push_back(*value);
    }
    return values;
}

/// Parses a mistake's sample of one check. Returns nothing if the text does not fit the check's places.
std::optional<Sample> sample_of(const std::string& text, const Fingerprints::Places& places, double steps) {
    if (text.starts_with(error_mark)) return Sample{.error = text.substr(std::string_view(error_mark).size())};
    if (text == same) return places.solution;
    size_t next = 0;
    auto values = words_as<float>(text, [&](const std::string& word) -> std::optional<float> {
        if (next == places.values.size()) return {};
        const float solution = places.solution.values[next++];
        return word == same ? solution : number_of(word, steps);
    });
    if (!values || next != places.values.size()) return {};
    return Sample{.values = *std::move(values), .is_drawn = true};
}

/// Reads a table [[check]], and adds its places to `result`.
void read_check(Table& table, const Manifest& manifest, Fingerprints& result) {
    const std::string name = table.text("name"), at = table.text("at"), solution = table.text("solution");
    table.finish();
    size_t check = 0;
    while (check < manifest.checks.size() && manifest.checks[check].name != name) ++check;
    if (check == manifest.checks.size()) table.fail("name", fmt::format("lab.toml has no check '{}'", name));
    const CheckInfo& info = manifest.checks[check];
    const size_t count = value_count(info);
    auto places = words_as<size_t>(at, [&](const std::string& word) -> std::optional<size_t> {
        const auto place = parse_int(word);
        return place && *place >= 0 && size_t(*place) < count ? std::optional(size_t(*place)) : std::nullopt;
    });
    if (!places) table.fail("at", fmt::format("'at' must be whole numbers below {}", count));
    const auto number = [&](const std::string& word) { return number_of(word, steps_of(info)); };
    auto values = words_as<float>(solution, number);
    if (!values || values->size() != places->size())
        table.fail("solution", fmt::format("'solution' must be {} numbers", places->size()));
    result.checks[check] = {*std::move(places), {.values = *std::move(values), .is_drawn = true}};
}

/// Reads a table [[mistake]]. Its `draws` has a text for each check of the task.
void read_mistake(Table& table, const Manifest& manifest, Fingerprints& result) {
    Fingerprints::Mistake& mistake = result.mistakes.emplace_back();
    mistake.task = table.text("task");
    mistake.hint = table.text("hint");
    std::vector<std::string> draws;
    table.read("draws", draws);
    table.finish();
    size_t next = 0;
    for (const auto& [check, places] : result.checks) {
        const CheckInfo& info = manifest.checks[check];
        if (info.task != mistake.task) continue;
        const auto sample = next < draws.size() ? sample_of(draws[next++], places, steps_of(info)) : std::nullopt;
        if (!sample)
            table.fail("draws", fmt::format("'draws' must have {} numbers for '{}'", places.values.size(), info.name));
        mistake.draws[check] = *sample;
    }
}

/// Returns the sum of the agreements of all drawn checks, or nothing if one of them does not match the mistake.
std::optional<Agreement> agreement_of(const Fingerprints& fingerprints, const Fingerprints::Mistake& mistake,
                                      const Manifest& manifest, const std::vector<Verdict>& said, const Samples& drawn,
                                      const Exactness& exactness) {
    Agreement sum;
    for (const auto& [check, sample] : mistake.draws) {
        if (!drawn.contains(check)) continue;
        const Sample& solution = fingerprints.checks.at(check).solution;
        // A verdict with a view is about a hidden view: the picture of the check's own view is right.
        const bool passed = said[check].outcome == Outcome::passed || !said[check].view.empty();
        if (passed && !exactness.compares_passed && sample.is_drawn && sample.values == solution.values) continue;
        const Agreement one =
            agreement(drawn.at(check), sample, solution, bool(manifest.checks[check].shot.probe), exactness);
        if (!is_like(one, passed, exactness)) return {};
        sum.add(one);
    }
    return sum;
}

}  // namespace

fs::path fingerprints_file(const LabEntry& lab) {
    const fs::path handed_out = course_root() / handed_fingerprints(lab);
    return fs::exists(handed_out) ? handed_out : course_root() / "build/fingerprints" / (lab.folder + ".toml");
}

fs::path handed_fingerprints(const LabEntry& lab) {
    return fs::path("labs") / lab.folder / "expected" / "fingerprints.toml";
}

Fingerprints load_fingerprints(const LabEntry& lab, const Manifest& manifest) {
    const fs::path file = fingerprints_file(lab);
    return fs::exists(file) ? parse_fingerprints(read_file(file), file, manifest) : Fingerprints();
}

Fingerprints parse_fingerprints(const std::string& text, const fs::path& file, const Manifest& manifest) {
    const toml::table parsed = parse_toml(text, file);
    Table table(file, parsed, "the file");
    Fingerprints result;
    for (Table& check : table.tables("check")) read_check(check, manifest, result);
    for (Table& mistake : table.tables("mistake")) read_mistake(mistake, manifest, result);
    table.finish();
    return result;
}

std::string text_of(const Fingerprints& fingerprints, const Manifest& manifest) {
    std::string text =
        "# The values that each known mistake draws at a few places of the checks of its task. `relief check` names\n"
        "# mistakes by them.\n";
    const auto quoted = [](std::string_view words) {
        std::string inside;
        for (const char c : words) inside += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
        return '"' + inside + '"';
    };
    for (const auto& [check, places] : fingerprints.checks) {
        const CheckInfo& info = manifest.checks[check];
        std::string solution;
        for (const float value : places.solution.values)
            solution += (solution.empty() ? "" : " ") + number_text(value, 0, steps_of(info));
        text += fmt::format("\n[[check]]\nname = {}\nat = \"{}\"\nsolution = \"{}\"\n", quoted(info.name),
                            fmt::join(places.values, " "), solution);
    }
    for (const Fingerprints::Mistake& mistake : fingerprints.mistakes) {
        text +=
            fmt::format("\n[[mistake]]\ntask = {}\nhint = {}\ndraws = [\n", quoted(mistake.task), quoted(mistake.hint));
        for (const auto& [check, sample] : mistake.draws)
            text +=
                "  " + quoted(text_of(sample, fingerprints.checks.at(check).solution, manifest.checks[check])) + ",\n";
        text += "]\n";
    }
    return text;
}

Sample sample_at(const Image& drawn, const std::string& error, const std::vector<size_t>& values) {
    if (drawn.pixel_count() == 0) return {.error = error};
    Sample sample{.is_drawn = true};
    for (const size_t place : values) sample.values.push_back(drawn.values[place]);
    return sample;
}

std::map<std::string, Recognised> name_mistakes(const Fingerprints& fingerprints, const Manifest& manifest,
                                                const std::vector<Verdict>& said, const Samples& drawn,
                                                const Exactness& exactness) {
    std::map<std::string, Recognised> named;
    std::map<std::string, double> best;
    for (const auto& [check, sample] : drawn)
        if (said[check].outcome != Outcome::passed) best[manifest.checks[check].task] = 0;
    // A mistake within the limits of all drawn checks may still fail the calls for the words of its task.
    for (size_t i = 0; i < said.size(); ++i)
        if (manifest.checks[i].shot.calls && has_failed(said[i].outcome)) best[manifest.checks[i].task] = 0;
    for (const Fingerprints::Mistake& mistake : fingerprints.mistakes) {
        const auto share = best.find(mistake.task);
        if (share == best.end()) continue;
        const auto like = agreement_of(fingerprints, mistake, manifest, said, drawn, exactness);
        if (!like || like->share() <= share->second) continue;
        share->second = like->share();
        named[mistake.task] = {&mistake, like->is_certain()};
    }
    return named;
}

}  // namespace relief::check
