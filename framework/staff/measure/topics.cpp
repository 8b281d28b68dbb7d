#include "framework/staff/measure/topics.h"

namespace relief::measure {

std::span<const BenchTopic> bench_topics() {
    static const std::vector<BenchTopic> topics = {
        storage_topic(),      normals_topic(),     tangents_topic(),      intersection_topic(), parallax_topic(),
        displacement_topic(), lighting_topic(),    baking_topic(),        materials_topic(),    planet_topic(),
        ocean_topic(),        environment_topic(), moving_frames_topic(), layers_topic(),       terminator_topic(),
        budget_topic(),       frames_topic(),      stability_topic(),     grade_topic(),        start_topic()};
    return topics;
}

}  // namespace relief::measure
