// The limits of methods: their error as a function of the input's difficulty, compared with peers.
#include "framework/staff/measure/stability.h"
#include "framework/staff/measure/bench.h"

#include <algorithm>
#include <cmath>

#include "framework/staff/measure/sweep.h"

namespace relief::measure {

std::vector<double> decades(double from, double to, double step) {
    std::vector<double> result;
    for (double exponent = from; exponent <= to + 1e-9; exponent += step) result.push_back(std::pow(10, exponent));
    return result;
}

BenchScene sweep_scene(const std::string& input, const std::string& axis, const std::string& unit,
                       const std::vector<double>& hardness, std::vector<SweptMethod> methods) {
    BenchScene scene{{{"input", input}}, axis};
    for (SweptMethod& method : methods) {
        const auto prepare = [method, hardness, unit] {
            BenchSweep sweep{method.stated, method.why};
            bool all_hold = true;
            for (const double hard : hardness) {
                sweep.places.push_back(method.at(hard));
                all_hold = all_hold && holds(sweep, sweep.places.back());
            }
            if (method.peer && all_hold) sweep.why.clear();  // it explains why peers fail
            return swept(std::move(sweep), unit);
        };
        scene.methods.push_back({method.name, method.knobs, prepare, method.peer});
    }
    return scene;
}

void Tally::add(double error) {
    if (!std::isfinite(error)) return lost();
    errors_.push_back(error);
}

BenchSweep::Place Tally::place(double hardness, double error) const {
    const double all = double(std::max<size_t>(1, errors_.size() + lost_ + endless_));
    return {hardness, error, double(lost_) / all, double(endless_) / all};
}
BenchSweep::Place Tally::largest(double hardness) const { return place(hardness, error_figures(errors_, "").largest); }
BenchSweep::Place Tally::mean(double hardness) const { return place(hardness, error_figures(errors_, "").mean); }
BenchSweep::Place Tally::most(double hardness) const { return place(hardness, error_figures(errors_, "").p99); }

namespace {

std::vector<BenchScene> stability_scenes(const BenchSettings& settings) {
    std::vector<BenchScene> all;
    for (const auto part : {tangent_sweeps, codec_sweeps, height_sweeps, hit_sweeps, lab_sweeps, layer_sweeps}) {
        std::vector<BenchScene> scenes = part(settings);
        for (size_t i = 0; i < scenes.size(); i += settings.is_first_look() ? 2 : 1)
            all.push_back(std::move(scenes[i]));
    }
    return all;
}

}  // namespace

const TopicRegistration stability_topic(
    {.name = "stability",
     .help = "error against how hard the input is: where methods are wrong, not finite, or do not end (seeds: "
             "tangents 1, formats 3, rays 5, rays against a mesh 7, layers 19)",
     .question = "From where on is each method wrong?",
     .scenes = stability_scenes,
     .draws = true,
     .sweeps = true});

}  // namespace relief::measure
