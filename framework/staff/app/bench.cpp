// relief bench: measures run time against error, topic by topic.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "framework/core/base/file.h"
#include "framework/core/base/log.h"
#include "framework/core/base/parallel.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/core/image/file.h"
#include "framework/core/lab/registry.h"
#include "framework/course/app/command.h"
#include "framework/course/app/versions.h"
#include "framework/course/pages/page.h"
#include "framework/staff/measure/baseline.h"
#include "framework/staff/measure/run.h"
#include "framework/staff/pages/bench_page.h"

namespace relief::app {
namespace {

namespace fs = std::filesystem;

struct BenchArguments {
    std::vector<std::string> topics, set;
    std::string output, repeats, size, context = "auto";
    bool quick = false, work = false, update = false;
};

/// Returns the topics that are named, or whose lab is named, in the order of bench_topics(); all if nothing is named.
std::vector<const measure::BenchTopic*> chosen(const std::vector<std::string>& names) {
    std::vector<std::string> known, labs;
    for (const measure::BenchTopic& topic : measure::bench_topics()) known.push_back(topic.name);
    for (const LabEntry& lab : registry()) labs.push_back(lab.two_digits());
    const auto has = [](const std::vector<std::string>& all, const std::string& one) {
        return std::find(all.begin(), all.end(), one) != all.end();
    };
    for (const std::string& name : names)
        if (!has(known, name) && !has(labs, name)) throw UsageError(unknown("topic", name, known));
    std::vector<const measure::BenchTopic*> topics;
    for (const measure::BenchTopic& topic : measure::bench_topics())
        if (names.empty() || has(names, topic.name) ||
            std::any_of(topic.labs.begin(), topic.labs.end(), [&](const std::string& lab) { return has(names, lab); }))
            topics.push_back(&topic);
    if (topics.empty()) throw UsageError(fmt::format("no topic is about lab {} alone", names.front()));
    return topics;
}

using Wanted = std::vector<std::pair<std::string, std::vector<std::string>>>;
Wanted wanted_of(const std::vector<std::string>& texts) {
    Wanted wanted;
    for (const std::string& text : texts) {
        const size_t sign = text.find('=');
        if (sign == std::string::npos || sign == 0)
            throw UsageError(fmt::format("--set takes knob=value or knob=value,value, not '{}'", text));
        wanted.emplace_back(text.substr(0, sign), split(text.substr(sign + 1), ','));
    }
    return wanted;
}

measure::BenchSettings settings_of(const BenchArguments& arguments) {
    measure::BenchSettings settings{.repeats = arguments.quick ? 3 : 15,
                                    .quick = arguments.quick,
                                    .is_chosen = !arguments.set.empty(),
                                    .pictures = true};
    if (!arguments.size.empty()) {
        const std::optional<int> side = parse_int(arguments.size);
        if (!side || *side < 64 || *side > 4096)
            throw UsageError(fmt::format(
                "--size takes a whole number from 64 to 4096, not '{}': pictures of N x N pixels", arguments.size));
        settings.size = glm::ivec2(*side);
    }
    if (arguments.repeats.empty()) return settings;
    const int fewest = arguments.quick ? 1 : 10;
    const std::optional<int> repeats = parse_int(arguments.repeats);
    if (!repeats || *repeats < fewest || *repeats > 1000)
        throw UsageError(
            fmt::format("--repeats takes a whole number from {} to 1000, not '{}'{}", fewest, arguments.repeats,
                        arguments.quick ? "" : ": the median of fewer than 10 runs says little (--quick takes 1)"));
    settings.repeats = *repeats;
    return settings;
}

/// Measures a topic's scenes in sequence. The rows are a complete table at any time.
class TopicRun {
public:
    TopicRun(const measure::BenchTopic& topic, std::vector<measure::BenchScene> scenes, measure::BenchRun run)
        : topic_(topic), scenes_(std::move(scenes)), run_(std::move(run)) {
        machine.is_quick = run_.settings.quick;
        for (const measure::BenchScene& scene : scenes_)
            for (measure::BenchRow& row : measure::open_rows(topic, scene)) rows_.push_back(std::move(row));
    }

    measure::BenchMachine machine{.cpu = measure::cpu_name(),
                                  .compiler = versions::compiler,
                                  .commit = versions::commit,
                                  .load = measure::load_average(),
                                  .processors = hardware_threads()};

    /// Calls `changed` after each new result.
    std::vector<measure::BenchRow> measure(const std::function<void(std::span<const measure::BenchRow>)>& changed) {
        int steps = 0;
        for (const measure::BenchScene& scene : scenes_) steps += measure::steps_of(scene, run_.settings);
        Progress progress(steps);
        progress.next(topic_.name);
        size_t begin = 0;
        for (const measure::BenchScene& scene : scenes_) {
            const std::string name = topic_.name + (scene.knobs.empty() ? "" : ", " + measure::knob_text(scene.knobs));
            const auto take_over = [&](const std::vector<measure::BenchRow>& rows) {
                std::copy(rows.begin(), rows.end(), rows_.begin() + long(begin));
                changed(rows_);
            };
            run_.report = [&](const std::vector<measure::BenchRow>& rows, const std::string& next) {
                machine.load = std::max(machine.load, measure::load_average());
                take_over(rows);
                progress.next(name + ": " + next);
            };
            take_over(measure::run_scene(topic_, scene, run_, machine));
            begin += scene.methods.size();
        }
        return std::move(rows_);
    }

private:
    const measure::BenchTopic& topic_;
    std::vector<measure::BenchScene> scenes_;
    measure::BenchRun run_;
    std::vector<measure::BenchRow> rows_;
};

/// A CSV file that is always a complete table, and at most a second out of date.
class GrowingTable {
public:
    GrowingTable(fs::path file, const measure::BenchMachine& machine) : file_(std::move(file)), machine_(machine) {}
    void write(std::span<const measure::BenchRow> rows, bool last) {
        const auto now = std::chrono::steady_clock::now();
        if (!last && written_ && now - *written_ < std::chrono::seconds(1)) return;
        write_file(file_, measure::bench_csv(rows, machine_));
        written_ = now;
    }

private:
    fs::path file_;
    const measure::BenchMachine& machine_;
    std::optional<std::chrono::steady_clock::time_point> written_;
};

int hold_to_baseline(const BenchArguments& arguments) {
    const fs::path file = course_root() / "tests/staff/measure/baseline.csv";
    const Wanted wanted = wanted_of(arguments.set);
    if (arguments.update && (!arguments.topics.empty() || !wanted.empty()))
        throw UsageError("--update renews the whole baseline: it takes neither TOPIC nor --set");
    std::vector<measure::BenchRow> rows, baseline;
    measure::BenchMachine machine;
    for (const measure::BenchTopic* topic : chosen(arguments.topics)) {
        if (topic->only_time) continue;
        const measure::BenchSettings settings{.repeats = 0, .quick = true};
        TopicRun run(*topic, measure::filter_scenes(*topic, topic->scenes(settings), wanted),
                     {.settings = settings, .context = context_kind(arguments.context), .pinned = true});
        for (measure::BenchRow& row : run.measure([](auto) {})) rows.push_back(std::move(row));
        // Keep only the renderer's first word, so that the file does not depend on the machine.
        if (topic->draws) machine.renderer = run.machine.renderer.substr(0, run.machine.renderer.find(' '));
    }
    if (arguments.update) {
        for (const measure::BenchRow& row : rows)
            if (!row.is_measured())
                throw Error(measure::row_name(row) + " " + row.state + ": the baseline was not renewed");
        write_file(file, measure::bench_csv(rows, machine));
        fmt::print("{}: {} methods\n", file.string(), rows.size());
        return 0;
    }
    try {
        baseline = measure::read_bench_csv(read_file(file));
    } catch (const Error& error) {
        throw Error({file, error.place().line}, error.what());
    }
    // Compare a partial run only with its part of the baseline.
    if (!arguments.topics.empty() || !wanted.empty())
        std::erase_if(baseline, [&](const measure::BenchRow& old) {
            return std::none_of(rows.begin(), rows.end(), [&](const measure::BenchRow& row) {
                return measure::row_name(row) == measure::row_name(old);
            });
        });
    // Compilers and their libraries round differently.
    constexpr double tolerance = 0.02;
    const measure::BaselineReport report = measure::compare_with_baseline(rows, baseline, tolerance);
    for (const std::string& line : report.worse) print_error(line);
    for (const std::string& line : report.better) print_note("better: " + line);
    fmt::print("{} methods: {}\n", rows.size(),
               report.worse.empty() ? "no more work and no larger error than in the baseline"
                                    : fmt::format("{} figures are worse than in the baseline", report.worse.size()));
    if (!report.worse.empty() || !report.better.empty())
        print_note("if the change is intended and you know why: ./relief bench --work --update");
    return report.worse.empty() ? 0 : 1;
}

/// Returns a line for each topic, for --help.
std::string bench_topics_text() {
    std::string text = "Topics (if none is named: all):\n";
    for (const measure::BenchTopic& topic : measure::bench_topics())
        text += fmt::format("  {:<14} {}\n", topic.name, topic.help);
    return text;
}

/// Returns 1 if a method failed or, with `work`, if work or error has grown.
int run_bench(const BenchArguments& arguments) {
    if (arguments.work) return hold_to_baseline(arguments);
    if (arguments.update) throw UsageError("--update needs --work: --work --update");
    const measure::BenchSettings settings = settings_of(arguments);
    const Wanted wanted = wanted_of(arguments.set);
    const std::vector<const measure::BenchTopic*> topics = chosen(arguments.topics);
    // Wrong arguments must be reported before anything is measured.
    std::vector<std::vector<measure::BenchScene>> scenes;
    for (const measure::BenchTopic* topic : topics)
        scenes.push_back(measure::filter_scenes(*topic, topic->scenes(settings), wanted));
    if (settings.size)
        for (size_t i = 0; i < topics.size(); ++i)
            for (measure::BenchScene& scene : scenes[i])
                if (topics[i]->draws) scene.knobs.emplace_back("pixels", fmt::format("{0}x{0}", settings.size->x));
    const fs::path folder = arguments.output.empty() ? course_root() / "build" / "bench" : fs::path(arguments.output);
    make_folder(folder);

    std::vector<pages::TopicResult> results;
    size_t failed = 0;
    bool is_plotted = true;
    for (size_t i = 0; i < topics.size(); ++i) {
        const measure::BenchTopic& topic = *topics[i];
        measure::BenchSettings own = settings;
        if (topic.sweeps) own.repeats = 0;
        TopicRun run(topic, std::move(scenes[i]), {.settings = own, .context = context_kind(arguments.context)});
        const fs::path file = folder / (topic.name + ".csv");
        GrowingTable table(file, run.machine);
        pages::TopicResult& result = results.emplace_back();
        result.topic = &topic;
        result.rows = run.measure([&](std::span<const measure::BenchRow> rows) { table.write(rows, false); });
        result.machine = run.machine;
        table.write(result.rows, true);
        failed += size_t(std::count_if(result.rows.begin(), result.rows.end(),
                                       [](const measure::BenchRow& row) { return !row.is_measured(); }));
        is_plotted = pages::draw_plots(result) && is_plotted;
        if (!result.plot.empty()) write_file(folder / (topic.name + ".svg"), result.plot);
        fmt::print("{}{}\n\n", measure::bench_table(topic, result.rows, result.machine), file.string());
        std::fflush(stdout);
    }
    if (!is_plotted) print_note("no plots: gnuplot is missing (Debian package gnuplot-nox)");
    const fs::path page = folder / "index.html";
    const auto put = [&](const std::string& name, const Image& picture) {
        pages::write_beside_page(folder / name, encode_image(picture, ImageFormat::png));
    };
    write_file(page, pages::bench_page(results, put, fs::exists(page) ? read_file(page) : ""));
    fmt::print("{}\n", page.string());
    if (failed == 0) return 0;
    print_error(fmt::format("{} methods have no result: their rows give the reason", failed));
    return 1;
}

class BenchCommand final : public Command {
public:
    void options(CommandOptions& options) override {
        options.words("TOPIC", bench_.topics, "a topic, or the number of a lab for its topics [all]");
        options.value("-o", "FOLDER", bench_.output, "folder for the results [the course's build/bench]");
        options.values("--set", "KNOB=VALUE,...", bench_.set,
                       "sweep only these values: map=bricks,posts or method=linear; may be repeated");
        options.value("--repeats", "N", bench_.repeats,
                      "runs of each method, interleaved, 10 or more [15; with --quick 3]");
        options.value("--size", "N", bench_.size, "draw pictures of N x N pixels [512; with --quick 256]");
        options.value("--context", "NAME", bench_.context, context_help);
        options.flag("--quick", bench_.quick, "few scenes and small sizes, for a first look");
        options.flag("--work", bench_.work,
                     "compare work and error of the quick sweep with tests/staff/measure/baseline.csv; no timing");
        options.flag("--update", bench_.update, "with --work: write the new values to that baseline");
        options.footer(bench_topics_text);
    }
    int run() override { return run_bench(bench_); }

private:
    BenchArguments bench_;
};
RELIEF_COMMAND(BenchCommand, 10, "bench",
               "measures run time against error: tables, a CSV and a plot per topic, one page of them all");

}  // namespace

}  // namespace relief::app
