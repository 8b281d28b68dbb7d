#include "framework/course/check/check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/log.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/core/gl/gl.h"
#include "framework/core/gl/missing_tasks.h"
#include "framework/core/image/file.h"
#include "framework/course/check/fingerprints.h"
#include "framework/course/check/kept_labs.h"
#include "framework/course/check/reach.h"
#include "framework/course/check/relation.h"
#include "framework/course/check/starter.h"

namespace relief::check {
namespace {

namespace fs = std::filesystem;

/// Limits for pictures. In a trial they caught all of 26 visible one-line mistakes, and accepted one driver's noise.
constexpr double small_difference = 2.0 / 255 + 1e-6, large_difference = 32.0 / 255 + 1e-6;
constexpr double share_over_small = 0.0005;
constexpr size_t pixels_over_large = 4;

/// Allowed deviation of a vector's length from 1. Rounding to 8 bits costs 0.007; the mean of neighbours costs more.
constexpr double unit_tolerance = 0.05;

constexpr const char* outcome_names[] = {"passed",  "waiting",     "wrong",         "unfinished", "broken",
                                         "crashed", "out_of_time", "out_of_memory", "machine"};

/// The measured values with their limits, and whether all limits were kept.
class Findings {
public:
    void add(const char* what, double value, std::optional<double> limit, const std::string& unit) {
        if (limit)
            add(value, *limit, [&](int digits) { return fmt::format("{} {}", what, amount_of(value, unit, digits)); });
    }
    /// Adds the share of pixels for which `what` is true, such as "are too dark".
    void add_share(const std::string& what, double share, std::optional<double> limit) {
        const double percent = 100 * share;
        if (limit)
            add(percent, 100 * *limit,
                [&](int digits) { return fmt::format("{} % of the pixels {}", rounded(percent, digits), what); });
    }
    /// Applies a lower bound to the value that was added last.
    void must_reach(double value, std::optional<double> min) {
        if (!min) return;
        use(*min, value);
        if (value >= *min) return;
        good_ = false;
        text_ += fmt::format(" (at least {})", rounded(*min, digits_for(value, *min)));
    }
    Judgement judgement() const {
        return {.outcome = good_ ? Outcome::passed : Outcome::wrong, .found = text_, .used = used_};
    }

private:
    /// Returns three, or as many digits as distinguish a value from its limit, at most nine.
    static int digits_for(double value, double limit) {
        int digits = 3;
        while (digits < 9 && value != limit && rounded(value, digits) == rounded(limit, digits)) ++digits;
        return digits;
    }
    void add(double value, double limit, const std::function<std::string(int digits)>& text) {
        const bool kept = value <= limit;
        good_ &= kept;
        use(value, limit);
        const int digits = digits_for(value, limit);
        text_ += fmt::format("{}{}{}", text_.empty() ? "" : ", ", text(digits),
                             kept ? "" : fmt::format(" (at most {})", rounded(limit, digits)));
    }
    void use(double part, double whole) {
        if (part > 0) used_ = std::max(used_, part / whole);
    }
    bool good_ = true;
    double used_ = 0;
    std::string text_;
};

bool is_surface(const Image& image, size_t pixel) { return image.values[pixel * image.channels] != no_surface; }

/// Returns the share of pixels in which `expected` has unit length and `drawn` does not. The angle between two
/// directions does not show this mistake.
double share_not_unit(const Image& drawn, const Image& expected) {
    const auto length = [](const Image& image, size_t pixel) {
        const float* const v = &image.values[pixel * size_t(image.channels)];
        return std::sqrt(double(v[0]) * double(v[0]) + double(v[1]) * double(v[1]) + double(v[2]) * double(v[2]));
    };
    size_t count = 0;
    for (size_t i = 0; i < drawn.pixel_count(); ++i)
        if (is_surface(drawn, i) && is_surface(expected, i) && std::abs(length(expected, i) - 1) < unit_tolerance)
            count += !(std::abs(length(drawn, i) - 1) < unit_tolerance);
    return double(count) / double(drawn.pixel_count());
}

Judgement compare_probes(const CheckInfo& check, const ProbeInfo& probe, const Image& drawn, const Image& expected) {
    size_t off = 0;
    const size_t only_one = one_sided(drawn, expected).count();
    const Image error = error_image(drawn, expected, probe.error);
    const ErrorSummary summary = summarize(error);
    if (summary.count == 0) return {Outcome::broken, nothing_to_compare(drawn, expected, summary)};
    for (const float value : error.values) off += value > 1 && value != no_surface;
    Findings findings;
    std::string look_at;
    const Limits& limits = check.limits;
    findings.add("mean", summary.mean, limits.mean, probe.unit);
    findings.must_reach(summary.mean, limits.at_least);
    findings.add("99 % within", summary.p99, limits.p99, probe.unit);
    findings.add("largest", summary.largest, limits.largest, probe.unit);
    findings.add_share("are off by more than " + amount_of(1, probe.unit), double(off) / double(summary.count),
                       limits.wrong);
    if (double(only_one) > limits.outline * double(drawn.pixel_count()))
        findings.add_share("show a surface in only one picture", double(only_one) / double(drawn.pixel_count()),
                           limits.outline);
    if (probe.error == ErrorMetric::angle && !probe.any_length && check.against == "truth")
        if (const double share = share_not_unit(drawn, expected); share > limits.outline) {
            if (findings.judgement().outcome == Outcome::passed)
                look_at = "the directions are right, but their length is not 1: normalise the vector that you return";
            findings.add_share("have a vector whose length is not 1", share, limits.outline);
        }
    if (summary.not_finite > 0)
        return {Outcome::wrong, fmt::format("{} pixels are not a number or have no direction", summary.not_finite)};
    Judgement said = findings.judgement();
    said.look_at = look_at;
    return said;
}

Judgement compare_pictures(const Image& drawn, const Image& expected) {
    const double pixels = double(drawn.pixel_count());
    Findings findings;
    findings.add_share("are off by more than 2/255",
                       double(difference(drawn, expected, small_difference).pixels_over) / pixels, share_over_small);
    findings.add("pixels off by more than 32/255", double(difference(drawn, expected, large_difference).pixels_over),
                 double(pixels_over_large), "");
    return findings.judgement();
}

Image draw(KeptLabs& labs, const Shot& shot) {
    const TellMissingTasks untold(false);  // the check does not need the missing task
    return render_shot(labs.drawer_of(shot), shot);
}

bool has_failed(Outcome outcome) {
    return outcome != Outcome::passed && outcome != Outcome::waiting && outcome != Outcome::unfinished &&
           outcome != Outcome::machine;
}

/// Returns whether a message comes from a compiler. It names the place itself, and all tasks of the file get it.
bool names_its_place(const Judgement& said) {
    const auto has = [&](const char* words) { return said.found.find(words) != std::string::npos; };
    return said.outcome == Outcome::broken && (has("shaders/") || has("labs/") || has("does not compile"));
}

/// Returns for each check the tasks that may have made it fail; empty if it did not fail.
std::vector<std::set<std::string>> suspects_of(const Manifest& manifest, const std::vector<Judgement>& said) {
    std::vector<std::set<std::string>> suspects(said.size());
    for (size_t i = 0; i < said.size(); ++i) {
        if (!has_failed(said[i].outcome)) continue;
        const CheckInfo& check = manifest.checks[i];
        if (!said[i].culprit.empty()) {
            suspects[i] = {said[i].culprit};
        } else {
            suspects[i] = {check.task};
            if (names_its_place(said[i])) continue;
            suspects[i].insert(check.needs.begin(), check.needs.end());
            suspects[i].insert(check.leans_on.begin(), check.leans_on.end());
        }
    }
    return suspects;
}

bool have_common(const std::set<std::string>& some, const TaskIds& others) {
    return std::any_of(others.begin(), others.end(), [&](const std::string& one) { return some.contains(one); });
}

/// Calls `take` with each subset of `size` tasks, in lexicographic order.
void for_each_set(const TaskIds& tasks, size_t size, const std::function<void(const TaskIds&)>& take) {
    std::vector<bool> is_in(tasks.size());
    std::fill(is_in.begin(), is_in.begin() + std::ptrdiff_t(size), true);
    do {
        TaskIds set;
        for (size_t i = 0; i < tasks.size(); ++i)
            if (is_in[i]) set.push_back(tasks[i]);
        take(set);
    } while (std::prev_permutation(is_in.begin(), is_in.end()));
}

/// See put_right_first().
TaskIds wrong_tasks(const Manifest& manifest, const std::vector<Judgement>& said,
                    const std::vector<std::set<std::string>>& suspects, const std::set<std::string>& recognised) {
    struct Share {
        size_t failed = 0, all = 0;
    };
    std::map<std::string, Share> shares;
    for (size_t i = 0; i < said.size(); ++i) {
        Share& share = shares[manifest.checks[i].task];
        share.failed += !suspects[i].empty(), ++share.all;
    }
    const auto is_culprit = [&](const std::string& task) {
        return std::any_of(said.begin(), said.end(), [&](const Judgement& one) { return one.culprit == task; });
    };
    TaskIds failing;
    for (const TaskInfo& task : manifest.tasks)
        if (shares[task.id].failed > 0 || is_culprit(task.id)) failing.push_back(task.id);
    TaskIds best;
    for (size_t size = 1; size <= failing.size() && best.empty(); ++size) {
        std::pair<size_t, double> most;
        for_each_set(failing, size, [&](const TaskIds& set) {
            if (!std::all_of(suspects.begin(), suspects.end(),
                             [&](const auto& one) { return one.empty() || have_common(one, set); }))
                return;
            std::pair<size_t, double> worth;
            for (const std::string& task : set) {
                worth.first += recognised.contains(task);
                worth.second += double(shares[task].failed) / double(shares[task].all);
            }
            if (best.empty() || worth > most) best = set, most = worth;
        });
    }
    return best;
}

std::string as_sentence(const std::string& text) {
    return text + (text.ends_with('?') || text.ends_with('.') ? " " : ". ");
}

/// Returns the text with a capital letter at its start.
std::string as_begin(std::string text) {
    if (!text.empty()) text.front() = char(std::toupper(static_cast<unsigned char>(text.front())));
    return text;
}

/// "1.2", "1.2, 1.3 and 1.4"
std::string names_of(const TaskIds& tasks) {
    if (tasks.size() < 2) return fmt::format("{}", fmt::join(tasks, ""));
    return fmt::format("{} and {}", fmt::join(tasks.begin(), tasks.end() - 1, ", "), tasks.back());
}

/// Returns points as sentences name them, with at most two decimals.
std::string hundredths(double points) { return points_text(std::round(points * 100) / 100); }

}  // namespace

const char* name_of(Outcome outcome) { return outcome_names[int(outcome)]; }

Outcome outcome_of(const std::string& name) {
    for (int i = 0; i < int(std::size(outcome_names)); ++i)
        if (name == outcome_names[i]) return Outcome(i);
    throw Error("unknown outcome '" + name + "'");
}

double TaskResult::points() const {
    double passed = 0;
    for (const CheckResult& result : checks) passed += result.outcome == Outcome::passed;
    return checks.empty() ? 0 : task->points * passed / double(checks.size());
}

double TaskResult::waiting_points() const {
    double waiting = 0;
    for (const CheckResult& result : checks) waiting += result.outcome == Outcome::waiting;
    return checks.empty() ? 0 : task->points * waiting / double(checks.size());
}

std::string points_text(const TaskResult& result) {
    std::set<std::string> others;
    for (const CheckResult& check : result.checks) others.insert(check.waits_for.begin(), check.waits_for.end());
    const std::string points = fmt::format("{} of {} points", hundredths(result.points()), result.task->points);
    if (others.empty()) return points;
    return fmt::format("{}, {} waiting for {}", points, hundredths(result.waiting_points()),
                       names_of({others.begin(), others.end()}));
}

std::string points_text(const std::vector<TaskResult>& tasks) {
    double points = 0, waiting = 0;
    int of = 0;
    for (const TaskResult& task : tasks)
        points += task.points(), waiting += task.waiting_points(), of += task.task->points;
    return fmt::format("{} of {} points{}", hundredths(points), of,
                       waiting > 0 ? fmt::format(", {} waiting", hundredths(waiting)) : "");
}

TaskIds missing_tasks(const CheckInfo& check, const std::function<bool(const std::string& task)>& is_written) {
    TaskIds missing;
    for (const std::string& task : check.needs)
        if (!is_written(task)) missing.push_back(task);
    return missing;
}

std::string waits_text(const TaskIds& tasks, const char* state) {
    return fmt::format("waits for {} {}, which {} not {} yet", tasks.size() > 1 ? "tasks" : "task", names_of(tasks),
                       tasks.size() > 1 ? "are" : "is", state);
}

std::vector<TaskIds> put_right_first(const Manifest& manifest, const std::vector<Judgement>& said,
                                     const std::set<std::string>& recognised) {
    const std::vector<std::set<std::string>> suspects = suspects_of(manifest, said);
    const TaskIds wrong = wrong_tasks(manifest, said, suspects, recognised);
    const auto is_wrong = [&](const std::string& task) {
        return std::find(wrong.begin(), wrong.end(), task) != wrong.end();
    };
    // Wrong tasks with a failure that no other wrong task explains. The check of a wrong task waits only for certain
    // tasks, and a certain task keeps a failed check that waits for none. So waiting has no cycle.
    std::set<std::string> certain;
    for (size_t i = 0; i < said.size(); ++i) {
        const std::string& own = manifest.checks[i].task;
        if (is_wrong(own) && suspects[i].contains(own) &&
            std::count_if(suspects[i].begin(), suspects[i].end(), is_wrong) == 1)
            certain.insert(own);
    }
    std::vector<TaskIds> first(said.size());
    for (size_t i = 0; i < said.size(); ++i)
        for (const std::string& task : wrong)
            if (const std::string& own = manifest.checks[i].task;
                task != own && suspects[i].contains(task) && (!is_wrong(own) || certain.contains(task)))
                first[i].push_back(task);
    return first;
}

std::string hint_of(const CheckInfo& check, const Judgement& said) {
    const std::string& look_at = said.look_at.empty() ? check.look_at : said.look_at;
    return said.relation.empty() ? look_at : as_sentence(look_at) + as_begin(said.relation);
}

std::vector<std::string> hints(const Manifest& manifest, const std::vector<Judgement>& said,
                               const std::vector<TaskIds>& first) {
    std::vector<std::string> hints(said.size());
    std::set<std::string> hinted;
    for (size_t i = 0; i < said.size(); ++i) {
        const CheckInfo& check = manifest.checks[i];
        if (!first[i].empty())
            hints[i] = fmt::format("put task {} right first", fmt::join(first[i], " and task "));
        else if (said[i].outcome == Outcome::wrong)
            hints[i] = hinted.insert(check.task).second || !said[i].look_at.empty() ? hint_of(check, said[i])
                                                                                    : as_begin(said[i].relation);
    }
    return hints;
}

std::string points_text(double points) { return rounded(points, 4); }

fs::path expectation_file(const LabEntry& lab, const CheckInfo& check) {
    std::string name;
    for (const char c : check.name) name += std::isalnum(static_cast<unsigned char>(c)) ? char(std::tolower(c)) : '-';
    return course_root() / "labs" / lab.folder / "expected" / (name + (check.shot.probe ? ".exr" : ".png"));
}

std::optional<Image> expectation(const LabEntry& lab, const CheckInfo& check) {
    KeptLabs labs(lab);
    return expectation(labs, check);
}

std::optional<Image> expectation(KeptLabs& labs, const CheckInfo& check) {
    const ComparableDrawing comparable;  // as run() draws what it compares with this
    if (check.against != "truth" && check.against != "solution") return {};
    const fs::path file = expectation_file(labs.entry(), check);
    if (fs::exists(file)) return read_image(file);
    if (check.against == "solution") return draw(labs, check.shot);
    return truth_of(labs.drawer_of(check.shot), check.shot);
}

fs::path base_file(const LabEntry& lab, const CheckInfo& check) {
    fs::path file = expectation_file(lab, check);
    return file.replace_filename(file.stem().string() + "-base" + file.extension().string());
}

std::optional<Image> base_of(const LabEntry& lab, const Manifest& manifest, const CheckInfo& check) {
    if (!check.shot.probe) return {};
    const ProbeInfo& probe = manifest.probe(check.shot.probe.name);
    if (probe.without.empty()) return {};
    Shot shot = check.shot;
    shot.set.insert(shot.set.end(), probe.without.begin(), probe.without.end());
    try {
        if (const fs::path file = base_file(lab, check); fs::exists(file)) return read_image(file);
        return truth_of(*make_lab(lab, shot), shot);
    } catch (const Error&) {
        return {};  // no exact values, or a damaged file: without a base there are only fewer relations
    }
}

std::optional<Relation> relation_of(const Manifest& manifest, const CheckInfo& check, const Image& drawn,
                                    const Image& expected, const std::function<std::optional<Image>()>& base) {
    if (!drawn.same_shape(expected) || check.shot.calls) return {};
    if (!check.shot.probe) return relation_between(drawn, expected, {});
    const ProbeInfo& probe = manifest.probe(check.shot.probe.name);
    if (const auto& least = check.limits.at_least)
        if (summarize(error_image(drawn, expected, probe.error)).mean < *least) return {};
    Quantity quantity{.name = probe.name, .error = probe.error};
    auto relation = relation_between(drawn, expected, quantity);
    if ((relation && !relation->predicted.values.empty()) || probe.without.empty()) return relation;
    const std::optional<Image> without_relief = base();
    if (!without_relief) return relation;
    quantity.base = &*without_relief;
    for (const auto& [knob, value] : probe.without)
        quantity.base_knob += fmt::format("{}{} = {}", quantity.base_knob.empty() ? "" : ", ", knob, value);
    return relation_between(drawn, expected, quantity);
}

namespace {

/// Judges the values of a task's calls. `look_at` quotes the words of the task that do not hold.
Judgement compare_calls(const Manifest& manifest, const CheckInfo& check, const Image& drawn, const Image& expected) {
    Judgement said{.outcome = Outcome::passed};
    size_t call = 0, wrong = 0;
    for (const ExampleInfo& example : manifest.examples) {
        if (example.task != check.task) continue;
        bool holds = true;
        for (size_t i = 0; i < example.calls.size(); ++i, ++call) {
            double used = 0;
            for (int channel = 0; channel < 4; ++channel) {
                const double value = drawn.values[4 * call + size_t(channel)],
                             right = expected.values[4 * call + size_t(channel)];
                const double error = std::abs(value - right) / (example.within * std::max(1.0, std::abs(right)));
                used = std::max(used, std::isfinite(error) ? error : 1e30);
            }
            said.used = std::max(said.used, used);
            wrong += used > 1;
            holds &= used <= 1;
        }
        if (!holds)
            said.look_at += fmt::format("{}\"{}\"", said.look_at.empty() ? "the task says: " : "; ", example.asks);
    }
    said.found = fmt::format("{} of {} calls return something else", wrong, call);
    if (wrong > 0) said.outcome = Outcome::wrong;
    return said;
}

}  // namespace

Judgement judge(const Manifest& manifest, const CheckInfo& check, const Image& drawn, const Image& expected) {
    if (check.shot.calls && drawn.same_shape(expected)) return compare_calls(manifest, check, drawn, expected);
    try {
        refuse_unusable(drawn, check.shot);
    } catch (const Error& error) {
        return {Outcome::broken, error.what()};
    }
    if (!drawn.same_shape(expected)) return {Outcome::broken, "the expected picture has another size"};
    if (!check.shot.probe) return compare_pictures(drawn, expected);
    return compare_probes(check, manifest.probe(check.shot.probe.name), drawn, expected);
}

namespace {

/// The result of run_check(), and the picture that was drawn, usable or not.
struct CheckRun {
    CheckResult result;
    Image drawn = {};  ///< empty if drawing failed or was not tried
    bool was_tried = false;
};

/// Returns the task whose part of a task file has this line; empty if there is none.
std::string task_at(const Manifest& manifest, const Place& place) {
    for (const TaskInfo& task : manifest.tasks)
        if (place.line > 0 && shown(place.file) == task.file)
            return task_at_line(read_file(place.file), size_t(place.line));
    return {};
}

/// Draws a shot again with each of vertex_moves.
std::vector<Image> moved_drawings(const LabEntry& lab, const Shot& shot, const NamedRenderer& renderer) {
    struct Moving {
        const NamedRenderer& renderer;
        ~Moving() { renderer.move_vertices({}); }
    } const moving{renderer};
    std::vector<Image> drawings;
    for (const glm::vec2 move : vertex_moves) {
        KeptLabs labs(lab);  // a kept lab would keep its textures, which were drawn without the move
        renderer.move_vertices(move);
        drawings.push_back(draw_shot(labs.drawer_of(shot), shot));
    }
    return drawings;
}

CheckRun try_check(KeptLabs& labs, const Manifest& manifest, const CheckInfo& check,
                   const std::optional<Image>& expected, const NamedRenderer& renderer = {.name = "llvmpipe"}) {
    CheckRun run{{&check}};
    CheckResult& result = run.result;
    if (expected) result.expected = *expected;
    Judgement said;
    try {
        const auto is_written = [&](const std::string& task) {
            return !is_unfinished(read_file(course_root() / manifest.task(task).file), task);
        };
        if (!is_written(check.task)) {
            said = {Outcome::unfinished, "not written yet"};
        } else if (result.waits_for = missing_tasks(check, is_written); !result.waits_for.empty()) {
            said = {Outcome::waiting, waits_text(result.waits_for, "written")};
        } else {
            run.was_tried = true;
            const TellMissingTasks untold(false);
            run.drawn = draw_shot(labs.drawer_of(check.shot), check.shot);
            refuse_unusable(run.drawn, check.shot);
            result.drawn = run.drawn;
            if (!expected) result.expected = draw(labs, manifest.check(check.against).shot);
            const std::string& probe = check.shot.probe.name;
            const ErrorMetric metric = probe.empty() ? ErrorMetric::distance : manifest.probe(probe).error;
            const Rasteriser rasteriser = rasteriser_of(renderer.name);
            Image judged = with_allowance(rasteriser, check, metric, result.drawn, result.expected);
            said = judge(manifest, check, judged, result.expected);
            if (rasteriser == Rasteriser::coarse && said.outcome == Outcome::wrong && renderer.move_vertices) {
                judged = with_allowance(rasteriser, check, metric, result.drawn, result.expected,
                                        moved_drawings(labs.entry(), check.shot, renderer));
                said = judge(manifest, check, judged, result.expected);
            }
            if (said.outcome == Outcome::wrong)
                if (auto relation = relation_of(manifest, check, judged, result.expected,
                                                [&] { return base_of(labs.entry(), manifest, check); })) {
                    said.relation = relation->sentence;
                    result.related = std::move(relation->predicted);
                }
        }
    } catch (const Error& error) {
        labs.forget();
        said = {Outcome::broken, error.what(), task_at(manifest, error.place())};
        result.details = error.more_details();
    }
    result.outcome = said.outcome;
    result.found = said.found;
    result.culprit = said.culprit;
    result.look_at = said.look_at;
    result.relation = said.relation;
    return run;
}

/// Returns how a task file reaches beyond its task, in the grader's words; or empty.
std::string what_reaches_beyond(const std::string& file, const OtherShaders& others) {
    if (!is_shader(file) || !fs::exists(course_root() / file)) return {};
    const std::string beyond = reaches_beyond(read_file(course_root() / file), others);
    return beyond.empty() ? "" : fmt::format("{} {}", file, beyond);
}

/// Returns no mistakes if their file is damaged or belongs to another manifest: the checks work without them.
Fingerprints known_mistakes(const LabEntry& lab, const Manifest& manifest) {
    try {
        return load_fingerprints(lab, manifest);
    } catch (const Error& error) {
        print_note(fmt::format("no mistake is named: {}", error.what()));
        return {};
    }
}

}  // namespace

CheckResult run_check(const LabEntry& lab, const Manifest& manifest, const CheckInfo& check,
                      const std::optional<Image>& expected) {
    KeptLabs labs(lab);
    return try_check(labs, manifest, check, expected).result;
}

struct LabChecker::Memory {
    const LabEntry& lab;
    const Manifest& manifest;
    OtherShaders others;
    Fingerprints fingerprints;
    NamedRenderer renderer;
    std::vector<Judgement> said = {};
    Samples drawn = {};
};

NamedRenderer renderer_of_context() {
    if (!glGetString) return {};
    const auto* const name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return {.name = name ? name : ""};
}

LabChecker::LabChecker(const LabEntry& lab, const Manifest& manifest, const NamedRenderer& renderer)
    : memory_(new Memory{lab, manifest, OtherShaders(lab, manifest), known_mistakes(lab, manifest), renderer}) {
    memory_->said.resize(manifest.checks.size(), {.outcome = Outcome::passed});
}
LabChecker::~LabChecker() = default;

CheckResult LabChecker::run(size_t check, const std::optional<Image>& expected) {
    KeptLabs labs(memory_->lab);
    return run(check, expected, labs);
}

CheckResult LabChecker::run(size_t check, const std::optional<Image>& expected, KeptLabs& labs) {
    const ComparableDrawing comparable;  // the window draws its own pictures with all that the GPU has
    auto& [lab, manifest, others, fingerprints, renderer, said, drawn] = *memory_;
    const std::string& file = manifest.task(manifest.checks[check].task).file;
    const std::string beyond = what_reaches_beyond(file, others);
    CheckRun run = beyond.empty() ? try_check(labs, manifest, manifest.checks[check], expected, renderer)
                                  : CheckRun{{&manifest.checks[check], Outcome::broken, beyond}};
    said[check] = {run.result.outcome, run.result.found, run.result.culprit, run.result.look_at, run.result.relation};
    drawn.erase(check);
    if (const auto places = fingerprints.checks.find(check); run.was_tried && places != fingerprints.checks.end())
        drawn[check] = sample_at(run.drawn, run.result.found, places->second.values);
    return std::move(run.result);
}

Advice LabChecker::advice() const {
    const auto& [lab, manifest, others, fingerprints, renderer, said, drawn] = *memory_;
    const Exactness exactness = rasteriser_of(renderer.name) == Rasteriser::exact ? Exactness() : other_renderer;
    std::set<std::string> recognised;
    for (const auto& [task, mistake] : name_mistakes(fingerprints, manifest, said, drawn, exactness))
        recognised.insert(task);
    const std::vector<TaskIds> first = put_right_first(manifest, said, recognised);
    Advice advice{first, hints(manifest, said, first), {}};
    Samples own = drawn;  // without the checks that wait: their pictures say nothing about their own task
    for (size_t i = 0; i < said.size(); ++i)
        if (!first[i].empty()) own.erase(i);
    for (const auto& [task, mistake] : name_mistakes(fingerprints, manifest, said, own, exactness)) {
        std::vector<size_t> failed;
        for (size_t i = 0; i < said.size(); ++i)
            if (manifest.checks[i].task == task && has_failed(said[i].outcome) && first[i].empty()) failed.push_back(i);
        const std::string& hint = advice.mistakes[task] = told(mistake->hint, failed.size());
        for (const size_t i : failed)
            advice.look_at[i] =
                failed.size() > 1 || advice.look_at[i].empty() ? hint : as_sentence(advice.look_at[i]) + hint;
    }
    return advice;
}

void Advice::apply(size_t check, CheckResult& result) const {
    result.look_at = look_at[check];
    // The hint of a known mistake may replace the relation.
    if (result.relation.empty() || result.look_at.find(result.relation.substr(1)) == std::string::npos)
        result.related = {};
    if (first[check].empty()) return;
    result.outcome = Outcome::waiting;
    result.found = waits_text(first[check], "right");
    result.details.clear();
    result.waits_for = first[check];
}

Manifest manifest_to_check(const LabEntry& lab) {
    Manifest manifest = load_manifest(lab);
    std::erase_if(manifest.checks, [&](const CheckInfo& check) {
        return check.hidden && check.against == "solution" && !fs::exists(expectation_file(lab, check));
    });
    return manifest;
}

std::vector<TaskResult> check_lab(const LabEntry& lab, const Manifest& manifest, const Expected& expected,
                                  const std::function<void(const CheckInfo& check)>& begins) {
    LabChecker checker(lab, manifest);
    KeptLabs labs(lab);
    std::vector<TaskResult> results;
    Progress progress(int(manifest.checks.size()));
    for (const TaskInfo& task : manifest.tasks) {
        TaskResult& result = results.emplace_back(TaskResult{&task, {}});
        for (size_t i = 0; i < manifest.checks.size(); ++i) {
            const CheckInfo& check = manifest.checks[i];
            if (check.task != task.id) continue;
            progress.next(check.name);
            if (begins) begins(check);
            std::optional<Image> other;
            try {
                other = expected ? expected(check) : expectation(labs, check);
            } catch (const Error&) {
                labs.forget();
                // The staff's task files are the solution. If they cannot be drawn, the check says why.
                if (check.against != "solution") throw;
            }
            result.checks.push_back(checker.run(i, other, labs));
        }
        if (result.checks.empty())
            throw Error(fmt::format("labs/{}/lab.toml: task {} has no check", lab.folder, task.id));
    }
    Advice advice = checker.advice();
    for (TaskResult& task : results) {
        task.mistake = advice.mistakes[task.task->id];
        for (CheckResult& result : task.checks) advice.apply(size_t(result.check - manifest.checks.data()), result);
    }
    return results;
}

}  // namespace relief::check
