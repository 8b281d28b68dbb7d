#include "framework/course/check/fingerprints.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"

namespace relief::check {
namespace {

namespace fs = std::filesystem;

using nlohmann::json;

/// Returns the factor of written numbers: a picture's values are written as integers from 0 to 255.
double steps_of(const CheckInfo& check) { return check.shot.probe ? 1 : 255; }

size_t value_count(const CheckInfo& check) {
    return size_t(check.shot.size.x) * size_t(check.shot.size.y) * (check.shot.probe ? 4 : 3);
}

/// Returns a value as JSON, with the digits of a float. JSON has no infinity and no NaN, so they are texts.
json as_json(float value, double steps) {
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    if (steps != 1) return std::lround(double(value) * steps);
    return *parse_number(fmt::format("{}", value));
}

float value_of(const json& written, double steps) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    if (written == "nan") return std::numeric_limits<float>::quiet_NaN();
    if (written == "inf" || written == "-inf") return written == "inf" ? infinity : -infinity;
    return float(written.get<double>() / steps);
}

/// A value that equals the solution's is null, and so is a picture of such values. A text is the error that replaces
/// the picture.
json as_json(const Sample& mistake, const Sample& solution, double steps) {
    if (!mistake.is_drawn) return mistake.error;
    json values = json::array();
    bool differs = false;
    for (size_t i = 0; i < mistake.values.size(); ++i) {
        const bool is_same = is_near(mistake.values[i], solution.values[i], 0);
        differs |= !is_same;
        values.push_back(is_same ? json() : as_json(mistake.values[i], steps));
    }
    return differs ? values : json();
}

Sample sample_of(const json& written, const Fingerprints::Places& places, const CheckInfo& check) {
    if (written.is_null()) return places.solution;
    if (written.is_string()) return {.error = written};
    if (written.size() != places.values.size())
        throw Error(fmt::format("'draws' must have {} numbers for '{}'", places.values.size(), check.name));
    Sample sample{.is_drawn = true};
    for (size_t i = 0; i < places.values.size(); ++i)
        sample.values.push_back(written.at(i).is_null() ? places.solution.values[i]
                                                        : value_of(written.at(i), steps_of(check)));
    return sample;
}

/// Reads the places of one check, and adds them to `result`.
void read_check(const json& written, const Manifest& manifest, Fingerprints& result) {
    const std::string name = written.at("name");
    size_t check = 0;
    while (check < manifest.checks.size() && manifest.checks[check].name != name) ++check;
    if (check == manifest.checks.size()) throw Error(fmt::format("lab.toml has no check '{}'", name));
    Fingerprints::Places places{written.at("at"), {.is_drawn = true}};
    for (const size_t place : places.values)
        if (const size_t count = value_count(manifest.checks[check]); place >= count)
            throw Error(fmt::format("'at' must be whole numbers below {} for '{}'", count, name));
    for (const json& value : written.at("solution"))
        places.solution.values.push_back(value_of(value, steps_of(manifest.checks[check])));
    if (places.solution.values.size() != places.values.size())
        throw Error(fmt::format("'solution' must be {} numbers for '{}'", places.values.size(), name));
    result.checks[check] = std::move(places);
}

/// Reads a mistake. Its `draws` has an entry for each check of the task.
void read_mistake(const json& written, const Manifest& manifest, Fingerprints& result) {
    Fingerprints::Mistake mistake{.task = written.at("task"), .id = {}, .hint = written.at("hint"), .draws = {}};
    size_t next = 0;
    for (const auto& [check, places] : result.checks)
        if (manifest.checks[check].task == mistake.task)
            mistake.draws[check] = sample_of(written.at("draws").at(next++), places, manifest.checks[check]);
    result.mistakes.push_back(std::move(mistake));
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
    return fs::exists(handed_out) ? handed_out : course_root() / "build/fingerprints" / (lab.folder + ".json");
}

fs::path handed_fingerprints(const LabEntry& lab) {
    return fs::path("labs") / lab.folder / "expected" / "fingerprints.json";
}

Fingerprints load_fingerprints(const LabEntry& lab, const Manifest& manifest) {
    const fs::path file = fingerprints_file(lab);
    return fs::exists(file) ? parse_fingerprints(read_file(file), file, manifest) : Fingerprints();
}

Fingerprints parse_fingerprints(const std::string& text, const fs::path& file, const Manifest& manifest) {
    try {
        const json written = json::parse(text);
        Fingerprints result;
        for (const json& check : written.at("checks")) read_check(check, manifest, result);
        for (const json& mistake : written.at("mistakes")) read_mistake(mistake, manifest, result);
        return result;
    } catch (const std::exception& error) {
        throw Error({file}, error.what());
    }
}

std::string text_of(const Fingerprints& fingerprints, const Manifest& manifest) {
    json checks = json::array(), mistakes = json::array();
    for (const auto& [check, places] : fingerprints.checks) {
        json solution = json::array();
        for (const float value : places.solution.values)
            solution.push_back(as_json(value, steps_of(manifest.checks[check])));
        checks.push_back({{"name", manifest.checks[check].name}, {"at", places.values}, {"solution", solution}});
    }
    for (const Fingerprints::Mistake& mistake : fingerprints.mistakes) {
        json draws = json::array();
        for (const auto& [check, sample] : mistake.draws)
            draws.push_back(as_json(sample, fingerprints.checks.at(check).solution, steps_of(manifest.checks[check])));
        mistakes.push_back({{"task", mistake.task}, {"hint", mistake.hint}, {"draws", draws}});
    }
    return json{{"checks", checks}, {"mistakes", mistakes}}.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
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
