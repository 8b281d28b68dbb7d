#include "framework/staff/proof/mutation_test.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <mutex>
#include <random>

#include "framework/core/base/file.h"
#include "framework/core/base/log.h"
#include "framework/core/base/parallel.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/sha256.h"
#include "framework/core/base/text.h"
#include "framework/library/maps/visualize.h"
#include "framework/staff/grade/variation.h"

namespace relief::grade {
namespace {

/// A difference that a person sees: `visible` in a channel, in at least `changed_share` of the pixels.
constexpr double visible_change = 8.0 / 255 + 1e-6, changed_share = 0.002;
constexpr int random_views = 24;
constexpr glm::ivec2 view_size{96, 96};
constexpr AttemptLimits looking{.cpu = 600};

/// Sets a third of a lab's knobs at random. Half of the numbers are at an end of their range.
class RandomKnobs final : public Knobs {
public:
    RandomKnobs(std::mt19937& dice, Shot& shot) : dice_(dice), shot_(shot) {}
    void slider(const char* name, float&, float low, float high, const KnobHelp&) override {
        set(name, [&] { return plain(double(low) + share() * double(high - low)); });
    }
    void steps(const char* name, int&, int low, int high, const KnobHelp&) override {
        set(name, [&] { return fmt::format("{:.0f}", low + share() * (high - low)); });
    }
    void toggle(const char* name, bool& value, const KnobHelp&) override {
        set(name, [&] { return value ? "false" : "true"; });
    }
    void choice(const char* name, int&, std::span<const char* const> names, const KnobHelp&) override {
        set(name, [&] { return names[dice_() % names.size()]; });
    }

private:
    void set(const char* name, const std::function<std::string()>& value) {
        if (dice_() % 3 == 0) shot_.set.emplace_back(name, value());
    }
    double share() {
        const auto end = dice_() % 4;
        return end < 2 ? double(end) : double(dice_()) / 4294967295.0;
    }
    std::mt19937& dice_;
    Shot& shot_;
};

/// Returns every check's view with and without its probe, every reference screenshot, and random views.
std::vector<Shot> views_of(const LabEntry& entry, const Manifest& manifest, const std::string& seed) {
    std::vector<Shot> shots;
    const auto add = [&](Shot shot) {
        shot.size = glm::min(shot.size, view_size);
        shots.push_back(std::move(shot));
    };
    for (const CheckInfo& check : manifest.checks) {
        if (check.shot.calls) continue;
        shots.push_back(check.shot);
        if (!check.shot.probe) continue;
        Shot lit = check.shot;
        lit.probe = {};
        add(lit);
    }
    for (const GoldenInfo& golden : manifest.goldens) add(golden.shot);
    const std::string words = sha256(seed + "|" + entry.folder);
    std::seed_seq sequence(words.begin(), words.end());
    std::mt19937 dice(sequence);
    const std::unique_ptr<Lab> lab = make_lab(entry, {});
    const size_t known = shots.size();
    for (int i = 0; i < random_views; ++i) {
        Shot shot = shots[dice() % known];
        shot.camera.yaw += double(dice() % 360);
        shot.camera.pitch = std::clamp(shot.camera.pitch + double(dice() % 120) - 60, -89.0, 89.0);
        shot.camera.distance *= 0.5 + double(dice() % 100) / 60;
        RandomKnobs knobs(dice, shot);
        lab->knobs(knobs);
        if (dice() % 2 == 0) shot.probe = {};
        add(shot);
    }
    return shots;
}

/// Returns the header of a C++ task, `task.h` beside it; empty for other tasks.
std::string header_of(const std::string& file) {
    const std::filesystem::path header = (course_root() / file).replace_extension(".h");
    return std::filesystem::exists(header) ? read_file(header) : "";
}

class Tester {
public:
    Tester(const LabEntry& lab, const Stage& stage, const GradeSetup& setup, MutationOptions options)
        : lab_(lab),
          stage_(stage),
          setup_(setup),
          options_(options),
          grader_(lab, stage, setup),
          solution_(solution_files(grader_.manifest())),
          views_(views_of(lab, grader_.manifest(), setup.seed)),
          right_(attempt(stage, lab, solution_, views_, setup.renderer, looking).shots) {}

    MutationTest run() {
        const auto begin = std::chrono::steady_clock::now();
        MutationTest test;
        for (const auto& [file, text] : solution_)
            for (Mutant& mutant : mutants_of(text, file, header_of(file))) {
                files_.push_back(file);
                test.results.push_back({std::move(mutant)});
            }
        thin(test.results);
        Progress progress(int(test.results.size()));
        std::mutex mutex;
        parallel_each(test.results.size(), unsigned(options_.jobs), [&](size_t i) {
            {
                const std::lock_guard lock(mutex);
                progress.next(fmt::format("lab {}, line {}", lab_.two_digits(), test.results[i].mutant.line));
            }
            try_out(test.results[i], files_[i]);
        });
        test.views = views_.size();
        test.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        return test;
    }

private:
    void thin(std::vector<MutantResult>& results) {
        const size_t count = results.size(), wanted = size_t(options_.sample);
        if (wanted == 0 || wanted >= count) return;
        for (size_t i = 0; i < wanted; ++i) {
            const size_t from = (2 * i + 1) * count / (2 * wanted);
            if (from == i) continue;
            results[i] = std::move(results[from]);
            files_[i] = files_[from];
        }
        results.resize(wanted);
        files_.resize(wanted);
    }

    void try_out(MutantResult& result, const std::string& file) const {
        Submission submission;
        submission.files = solution_;
        submission.files[file] = result.mutant.text;
        const LabMark mark = grader_.mark(submission, nullptr, false);
        bool own = false, all_broken = true;
        for (const check::TaskVerdict& task : mark.tasks) {
            const bool is_own = task.id == result.mutant.task, lost = task.points() < task.of;
            own |= is_own && lost;
            result.accused |= !is_own && lost;
            for (const check::Verdict& check : task.checks)
                all_broken &= !is_own || check.outcome == check::Outcome::broken;
        }
        if (own)
            result.fate = all_broken ? MutantFate::invalid : MutantFate::killed;
        else if (result.accused)
            result.fate = MutantFate::elsewhere;
        else
            look(result, submission.files);
    }

    /// Compares every view, and records the largest difference.
    void look(MutantResult& result, const CourseFiles& files) const {
        const std::vector<DrawnAttempt> drawn = attempt(stage_, lab_, files, views_, setup_.renderer, looking).shots;
        for (size_t i = 0; i < views_.size(); ++i) {
            if (!right_[i].image && !drawn[i].image) continue;
            double largest = 1, share = 1;  // if only one of them draws an image
            if (right_[i].image && drawn[i].image) {
                if (right_[i].image->values == drawn[i].image->values) continue;
                const auto [one, other] = shown(views_[i].probe, *right_[i].image, *drawn[i].image);
                const Difference differs = difference(one, other, visible_change);
                largest = differs.largest, share = double(differs.pixels_over) / double(one.pixel_count());
            }
            result.fate = MutantFate::unseen;
            if (result.where.empty() || std::pair(share, largest) > std::pair(result.share, result.largest)) {
                result.share = share;
                result.where = (views_[i].probe ? "probe " + views_[i].probe.name + ", " : "") + view_text(views_[i]);
            }
            result.largest = std::max(result.largest, largest);
        }
        if (result.share >= changed_share) result.fate = MutantFate::survived;
    }

    /// Returns two pictures to compare with `visible`. A vector's tone curve would hide small differences. So its pair
    /// is black and the error, in which 1 is a sixteenth of the usual size.
    std::pair<Image, Image> shown(const Probe& probe, const Image& one, const Image& other) const {
        if (!probe) return {one, other};
        const ProbeColors colors = grader_.manifest().probe(probe.name).colors();
        if (colors.error != ErrorMetric::distance) return visualize_probes(one, other, colors);
        Image error = error_image(one, other, colors.error);
        const double scale = 16 / usual_size(one);
        for (size_t i = 0; i < error.pixel_count(); ++i) {
            float& value = error.values[i];
            const size_t first = i * size_t(one.channels);
            if (value == no_surface)
                value = one.values[first] == other.values[first] ? 0 : 1;
            else if (!std::isnan(value))
                value = float(std::min(std::abs(value) * scale, 1.0));
        }
        return {Image(error.width, error.height, 1), std::move(error)};
    }

    const LabEntry& lab_;
    const Stage& stage_;
    GradeSetup setup_;
    MutationOptions options_;
    LabGrader grader_;
    CourseFiles solution_;
    std::vector<Shot> views_;
    std::vector<DrawnAttempt> right_;
    std::vector<std::string> files_;  ///< by mutant: name of its file
};

}  // namespace

size_t MutationTest::count(MutantFate fate, const std::string& task) const {
    return size_t(std::count_if(results.begin(), results.end(), [&](const MutantResult& one) {
        return one.fate == fate && (task.empty() || one.mutant.task == task);
    }));
}

double MutationTest::kill_rate() const {
    const size_t seen = count(MutantFate::killed) + count(MutantFate::elsewhere) + count(MutantFate::survived);
    return seen == 0 ? 1 : double(count(MutantFate::killed)) / double(seen);
}

double MutationTest::own_rate() const {
    size_t lost = 0, own = 0;
    for (const MutantResult& one : results) {
        if (one.fate != MutantFate::killed && one.fate != MutantFate::elsewhere) continue;
        ++lost;
        own += !one.accused;
    }
    return lost == 0 ? 1 : double(own) / double(lost);
}

MutationTest test_mutants(const LabEntry& lab, const GradeSetup& setup, MutationOptions options) {
    Stage stage(setup.isolation);
    stage.add(lab);
    return Tester(lab, stage, setup, options).run();
}

}  // namespace relief::grade
