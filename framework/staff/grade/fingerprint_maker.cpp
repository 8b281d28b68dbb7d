#include "framework/staff/grade/fingerprint_maker.h"

#include <algorithm>
#include <cmath>

#include "framework/core/base/error.h"
#include "framework/core/base/sha256.h"
#include "framework/course/check/drawing.h"
#include "framework/staff/grade/mistake_names.h"

namespace relief::grade {
namespace {

/// The numbers of compared values of a check: evenly spread ones, which detect unlisted mistakes, and values in which
/// known mistakes differ.
constexpr size_t spread_values = 8, telling_values = 24;
/// The number of candidate values that distinguish each pair.
constexpr size_t candidates_of_pair = 100;

check::Sample all_of(const DrawnAttempt& drawn) {
    if (!drawn.image) return {.error = drawn.error};
    return {.values = drawn.image->values, .is_drawn = true};
}

/// Returns the indices in [0, count) in a fixed order that spreads them evenly: sorted by the fractional part of i
/// times the golden ratio.
std::vector<size_t> shuffled(size_t count) {
    std::vector<std::pair<double, size_t>> keys;
    for (size_t i = 0; i < count; ++i) keys.emplace_back(std::fmod(double(i) * 0.6180339887498949, 1), i);
    std::sort(keys.begin(), keys.end());
    std::vector<size_t> places;
    for (const auto& [key, place] : keys) places.push_back(place);
    return places;
}

/// Chooses the places of a check's values. Balances them, so that every pair among the solution and the mistakes
/// differs in about as many places.
class Chooser {
public:
    /// `programs` begins with the solution.
    Chooser(const std::vector<const check::Sample*>& programs, bool is_probe) {
        const check::Sample& right = *programs.front();
        for (const check::Sample* program : programs)
            if (program->is_drawn)
                programs_.push_back({&program->values, check::tolerance_of(*program, right, is_probe)});
        const std::vector<size_t> order = shuffled(right.values.size());
        for (size_t i = 0; i < order.size() && chosen_.size() < spread_values; ++i)
            if (std::isfinite(right.values[order[i]])) chosen_.push_back(order[i]);
        counts_.resize(programs_.size() * programs_.size());
        std::vector<size_t> found(counts_.size());
        for (const size_t place : order) {
            std::vector<size_t> pairs = told_apart(place);
            bool is_wanted = false;
            for (const size_t pair : pairs) is_wanted |= found[pair]++ < candidates_of_pair;
            if (is_wanted) candidates_.push_back({place, std::move(pairs)});
        }
        while (chosen_.size() < spread_values + telling_values && !candidates_.empty()) take_best();
        std::sort(chosen_.begin(), chosen_.end());
        chosen_.erase(std::unique(chosen_.begin(), chosen_.end()), chosen_.end());
    }

    std::vector<size_t> take() { return std::move(chosen_); }

private:
    struct Drawn {
        const std::vector<float>* values;
        double tolerance;
    };
    struct Candidate {
        size_t place;
        std::vector<size_t> pairs;
    };

    std::vector<size_t> told_apart(size_t place) const {
        std::vector<size_t> pairs;
        for (size_t i = 0; i < programs_.size(); ++i)
            for (size_t j = i + 1; j < programs_.size(); ++j)
                if (!check::is_near((*programs_[i].values)[place], (*programs_[j].values)[place],
                                    std::max(programs_[i].tolerance, programs_[j].tolerance)))
                    pairs.push_back(i * programs_.size() + j);
        return pairs;
    }

    void take_best() {
        const auto worth = [&](const Candidate& candidate) {
            double sum = 0;
            for (const size_t pair : candidate.pairs) sum += 1 / double((1 + counts_[pair]) * (1 + counts_[pair]));
            return sum;
        };
        size_t best = 0;
        double best_worth = -1;
        for (size_t i = 0; i < candidates_.size(); ++i) {
            const double own = worth(candidates_[i]);
            if (own <= best_worth) continue;
            best_worth = own;
            best = i;
        }
        for (const size_t pair : candidates_[best].pairs) ++counts_[pair];
        chosen_.push_back(candidates_[best].place);
        candidates_.erase(candidates_.begin() + std::ptrdiff_t(best));
    }

    std::vector<Drawn> programs_;
    std::vector<size_t> chosen_;
    std::vector<Candidate> candidates_;
    std::vector<size_t> counts_;  ///< by pair
};

/// Returns the public checks of a task, by their indices in the manifest.
std::vector<size_t> public_checks(const Manifest& manifest, const std::string& task) {
    std::vector<size_t> checks;
    for (size_t i = 0; i < manifest.checks.size(); ++i)
        if (manifest.checks[i].task == task && !manifest.checks[i].hidden) checks.push_back(i);
    return checks;
}

/// Returns whether two mistakes, or a mistake and the solution, draw the same in all checks up to rounding. Then no
/// check distinguishes them.
bool are_alike(const std::vector<check::Sample>& one, const std::vector<check::Sample>& other) {
    return std::equal(one.begin(), one.end(), other.begin(), [](const check::Sample& a, const check::Sample& b) {
        return a.error == b.error &&
               std::equal(
                   a.values.begin(), a.values.end(), b.values.begin(), b.values.end(), [](float left, float right) {
                       return check::is_near(left, right, std::isfinite(left) ? 1e-7 + 1e-5 * std::abs(left) : 0);
                   });
    });
}

check::Sample sample_of(const check::Sample& all, const std::vector<size_t>& places) {
    check::Sample sample{.error = all.error, .is_drawn = all.is_drawn};
    if (all.is_drawn)
        for (const size_t place : places) sample.values.push_back(all.values[place]);
    return sample;
}

}  // namespace

std::string fingerprints_made_of(const LabEntry& lab, const Manifest& manifest) {
    std::string all;
    std::vector<Shot> shots;
    for (const CheckInfo& check : manifest.checks) {
        if (check.hidden) continue;
        all += check.task + '\n' + check.name + '\n';
        shots.push_back(check.shot);
    }
    all += check::drawing_request(lab, shots, {});
    for (const MistakeInfo& mistake : manifest.mistakes) {
        all += '\n' + mistake.task + '\n' + mistake.hint + '\n' + (mistake.same_as.empty() ? "" : "same");
        for (const Edit& edit : mistake.edits) all += '\n' + edit.file + '\n' + edit.find + '\n' + edit.replace;
    }
    return sha256(all).substr(0, 16);
}

check::Fingerprints make_fingerprints(const LabEntry& lab, MistakePictures& pictures,
                                      const std::function<void(const std::string& mistake)>& begins) {
    const Manifest& manifest = pictures.manifest();
    check::Fingerprints result;
    result.made_of = fingerprints_made_of(lab, manifest);
    for (const TaskInfo& task : manifest.tasks) {
        const std::vector<size_t> checks = public_checks(manifest, task.id);
        std::vector<Shot> shots;
        std::vector<std::vector<check::Sample>> drawn(1);  // by program (the solution, then mistakes), then by check
        for (const size_t check : checks) {
            const Shot& shot = shots.emplace_back(manifest.checks[check].shot);
            drawn[0].push_back({.values = draw_shot(*make_lab(lab, shot), shot).values, .is_drawn = true});
        }
        const size_t first = result.mistakes.size();
        for (const MistakeInfo& mistake : manifest.mistakes) {
            if (mistake.task != task.id || !mistake.same_as.empty()) continue;
            begins(mistake.id);
            std::vector<check::Sample> own;
            for (const DrawnAttempt& one : pictures.draw(mistake, shots)) own.push_back(all_of(one));
            const auto alike = std::find_if(drawn.begin(), drawn.end(), [&](const std::vector<check::Sample>& other) {
                return are_alike(own, other);
            });
            const std::string hint = hint_with_same(manifest, mistake);
            if (alike == drawn.end()) {
                drawn.push_back(std::move(own));
                result.mistakes.push_back({task.id, hint, {}});
            } else if (alike != drawn.begin()) {
                result.mistakes[first + size_t(alike - drawn.begin()) - 1].hint += " Or: " + hint;
            }
        }
        for (size_t i = 0; i < checks.size(); ++i) {
            std::vector<const check::Sample*> programs;
            for (const std::vector<check::Sample>& program : drawn) programs.push_back(&program[i]);
            check::Fingerprints::Places& places = result.checks[checks[i]];
            places.values = Chooser(programs, bool(shots[i].probe)).take();
            places.solution = sample_of(drawn[0][i], places.values);
            for (size_t j = 1; j < drawn.size(); ++j)
                result.mistakes[first + j - 1].draws[checks[i]] = sample_of(drawn[j][i], places.values);
        }
    }
    return result;
}

}  // namespace relief::grade
