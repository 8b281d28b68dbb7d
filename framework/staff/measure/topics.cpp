#include "framework/staff/measure/topics.h"

namespace relief::measure {

std::span<const BenchTopic> bench_topics() {
    const auto of = [](std::vector<std::string> labs, BenchTopic topic) {
        topic.labs = std::move(labs);
        return topic;
    };
    static const std::vector<BenchTopic> topics = {of({"02"}, storage_topic()),
                                                   of({"03"}, normals_topic()),
                                                   of({"05"}, tangents_topic()),
                                                   intersection_topic(),
                                                   of({"10", "11", "12"}, parallax_topic()),
                                                   of({"13", "14"}, displacement_topic()),
                                                   of({"01", "06"}, lighting_topic()),
                                                   of({"07"}, baking_topic()),
                                                   of({"08"}, materials_topic()),
                                                   of({"09"}, planet_topic()),
                                                   of({"15"}, ocean_topic()),
                                                   of({"16"}, environment_topic()),
                                                   of({"18"}, moving_frames_topic()),
                                                   of({"19"}, layers_topic()),
                                                   of({"12"}, terminator_topic()),
                                                   of({"17"}, budget_topic()),
                                                   frames_topic(),
                                                   stability_topic(),
                                                   grade_topic(),
                                                   start_topic()};
    return topics;
}

}  // namespace relief::measure
