#include "framework/staff/grade/fingerprint_maker.h"

#include <algorithm>
#include <cmath>

#include <fcntl.h>
#include <sys/file.h>

#include "framework/core/base/descriptor.h"
#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/context/context.h"
#include "framework/core/lab/shot.h"
#include "framework/staff/grade/mistake_pictures.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;

/// The numbers of compared values of a check: evenly spread ones, which detect unlisted mistakes, and values in which
/// known mistakes differ.
constexpr size_t spread_values = 8, telling_values = 24;
/// The number of candidate values that distinguish each pair.
constexpr size_t candidates_of_pair = 100;

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

/// Returns when the last of the files changed that take part in a lab's pictures.
fs::file_time_type newest_input(const LabEntry& lab) {
    fs::file_time_type newest = fs::file_time_type::min();
    for (const fs::path& folder :
         {fs::path("framework/core"), fs::path("shaders/common"), "shaders" / fs::path(lab.folder),
          "labs" / fs::path(lab.folder), fs::path("assets")}) {
        if (!fs::is_directory(course_root() / folder)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(course_root() / folder))
            if (entry.is_regular_file()) newest = std::max(newest, entry.last_write_time());
    }
    return newest;
}

}  // namespace

std::string hint_with_same(const Manifest& manifest, const MistakeInfo& mistake) {
    std::string hint = mistake.hint;
    for (const MistakeInfo& other : manifest.mistakes)
        if (other.same_as == mistake.id) hint += " Or: " + other.hint;
    return hint;
}

std::vector<const MistakeInfo*> distinct_mistakes(const Manifest& manifest, const std::string& task) {
    std::vector<const MistakeInfo*> mistakes;
    for (const MistakeInfo& mistake : manifest.mistakes)
        if (mistake.task == task && mistake.same_as.empty()) mistakes.push_back(&mistake);
    return mistakes;
}

std::vector<size_t> checks_with_fingerprints(const Manifest& manifest, const std::string& task) {
    std::vector<size_t> checks;
    for (size_t i = 0; i < manifest.checks.size(); ++i)
        if (manifest.checks[i].task == task && !manifest.checks[i].shot.calls) checks.push_back(i);
    return checks;
}

check::Sample whole_sample(const DrawnAttempt& drawn) {
    if (!drawn.image) return {.error = drawn.error};
    return {.values = drawn.image->values, .is_drawn = true};
}

void add_fingerprints(check::Fingerprints& result, const Manifest& manifest, const std::string& task,
                      const std::vector<size_t>& checks, const DrawnProgram& solution,
                      std::vector<DrawnProgram> mistakes) {
    const std::vector<const MistakeInfo*> infos = distinct_mistakes(manifest, task);
    std::vector<DrawnProgram> programs = {solution};
    const size_t first = result.mistakes.size();
    for (size_t m = 0; m < infos.size(); ++m) {
        const auto alike = std::find_if(programs.begin(), programs.end(),
                                        [&](const DrawnProgram& other) { return are_alike(mistakes[m], other); });
        const std::string hint = hint_with_same(manifest, *infos[m]);
        if (alike == programs.end()) {
            programs.push_back(std::move(mistakes[m]));
            result.mistakes.push_back({task, infos[m]->id, hint, {}});
        } else if (alike != programs.begin()) {
            result.mistakes[first + size_t(alike - programs.begin()) - 1].hint += " Or: " + hint;
        }
    }
    for (size_t i = 0; i < checks.size(); ++i) {
        std::vector<const check::Sample*> drawn;
        for (const DrawnProgram& program : programs) drawn.push_back(&program[i]);
        check::Fingerprints::Places& places = result.checks[checks[i]];
        places.values = Chooser(drawn, bool(manifest.checks[checks[i]].shot.probe)).take();
        places.solution = sample_of(programs[0][i], places.values);
        for (size_t j = 1; j < programs.size(); ++j)
            result.mistakes[first + j - 1].draws[checks[i]] = sample_of(programs[j][i], places.values);
    }
}

std::string public_fingerprints(const LabEntry& lab, const std::function<void(const std::string& mistake)>& begins) {
    const fs::path kept = check::fingerprints_file(lab);
    const fs::path folder = kept.parent_path();
    std::error_code none;  // an installed course cannot be written: then they are drawn each time
    fs::create_directories(folder, none);
    // Several processes that need them at once draw them once.
    const Descriptor lock(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    flock(lock, LOCK_EX);
    MistakePictures pictures(lab, {.threads = 0, .pinned = true});
    Manifest manifest = pictures.manifest();
    std::erase_if(manifest.checks, [](const CheckInfo& check) { return check.hidden; });
    if (const auto made = fs::last_write_time(kept, none); !none && made > newest_input(lab)) return read_file(kept);
    if (!is_software_renderer())
        throw Error("fingerprints are made on Mesa's software renderer, as checks are drawn; this is " +
                    describe_context().renderer);
    check::Fingerprints result;
    for (const TaskInfo& task : manifest.tasks) {
        const std::vector<size_t> checks = checks_with_fingerprints(manifest, task.id);
        std::vector<Shot> shots;
        DrawnProgram solution;
        for (const size_t check : checks) {
            const Shot& shot = shots.emplace_back(manifest.checks[check].shot);
            solution.push_back({.values = draw_shot(*make_lab(lab, shot), shot).values, .is_drawn = true});
        }
        std::vector<DrawnProgram> mistakes;
        for (const MistakeInfo* mistake : distinct_mistakes(manifest, task.id)) {
            begins(mistake->id);
            DrawnProgram& program = mistakes.emplace_back();
            for (const DrawnAttempt& one : pictures.draw(*mistake, shots)) program.push_back(whole_sample(one));
        }
        add_fingerprints(result, manifest, task.id, checks, solution, std::move(mistakes));
    }
    const std::string text = check::text_of(result, manifest);
    try {
        write_file(kept, text);
    } catch (const Error&) {  // see above
    }
    return text;
}

}  // namespace relief::grade
