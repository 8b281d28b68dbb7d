// relief bench: run time against error, topic by topic.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "framework/app/commands.h"
#include "framework/app/versions.h"
#include "framework/base/file.h"
#include "framework/base/log.h"
#include "framework/base/paths.h"
#include "framework/base/text.h"
#include "framework/measure/bench.h"

namespace relief {
namespace {

std::vector<const BenchTopic*> chosen(const std::vector<std::string>& names) {
    std::vector<const BenchTopic*> topics;
    std::vector<std::string> known;
    for (const BenchTopic& topic : bench_topics()) {
        known.push_back(topic.name);
        if (names.empty()) topics.push_back(&topic);
    }
    for (const std::string& name : names) {
        const auto found = std::find(known.begin(), known.end(), name);
        if (found == known.end()) throw UsageError(unknown("topic", name, known));
        topics.push_back(&bench_topics()[size_t(found - known.begin())]);
    }
    return topics;
}

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

std::string bench_topics_text() {
    std::string text = "Topics (all of them when none is named):\n";
    for (const BenchTopic& topic : bench_topics()) text += fmt::format("  {:<14} {}\n", topic.name, topic.help);
    return text;
}

int run_bench(const BenchArguments& arguments) {
    const std::optional<int> repeats = parse_int(arguments.repeats);
    if (!repeats || *repeats < 1 || *repeats > 1000)
        throw UsageError(fmt::format("--repeats takes a whole number from 1 to 1000, not '{}'", arguments.repeats));
    const BenchSettings settings{.repeats = *repeats, .quick = arguments.quick};
    const std::vector<const BenchTopic*> topics = chosen(arguments.topics);
    const std::filesystem::path folder =
        arguments.output.empty() ? course_root() / "build" / "bench" : std::filesystem::path(arguments.output);
    make_folder(folder);

    BenchMachine machine{.cpu = cpu_name(), .compiler = versions::compiler, .commit = versions::commit};
    for (const BenchTopic* topic : topics) {
        const std::unique_ptr<Context> context = topic->draws ? open_context(context_kind(arguments.context)) : nullptr;
        machine.renderer = context ? describe_context().renderer : "none";
        std::vector<BenchMethod> methods;
        std::vector<BenchTimes> times;
        {
            Progress progress(settings.repeats + 1);
            progress.next(topic->name + ", errors");
            methods = topic->methods(settings);
            times = time_in_turns(methods, settings.repeats, seconds, [&] { progress.next(topic->name); });
        }
        const std::filesystem::path file = folder / (topic->name + ".csv");
        write_file(file, bench_csv(*topic, methods, times, settings, machine));
        fmt::print("{}{}\n\n", bench_table(*topic, methods, times), file.string());
    }
    return 0;
}

}  // namespace relief
