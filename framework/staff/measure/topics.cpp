#include <algorithm>
#include <tuple>

#include "framework/staff/measure/bench.h"

namespace relief::measure {
namespace {

std::vector<BenchTopic>& registered_topics() {
    static std::vector<BenchTopic> topics;
    return topics;
}

}  // namespace

const std::vector<BenchTopic>& bench_topics() {
    static const std::vector<BenchTopic> sorted = [] {
        std::vector<BenchTopic> topics = registered_topics();
        std::sort(topics.begin(), topics.end(), [](const BenchTopic& a, const BenchTopic& b) {
            return std::tuple(a.labs.empty(), a.labs, a.name) < std::tuple(b.labs.empty(), b.labs, b.name);
        });
        return topics;
    }();
    return sorted;
}

TopicRegistration::TopicRegistration(BenchTopic topic) { registered_topics().push_back(std::move(topic)); }

}  // namespace relief::measure
