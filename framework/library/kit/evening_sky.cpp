#include "framework/library/kit/evening_sky.h"

#include <cmath>

namespace relief {
namespace {

glm::dvec3 toward(double yaw, double pitch) {
    const double y = glm::radians(yaw), p = glm::radians(pitch);
    return {std::sin(y) * std::cos(p), std::sin(p), std::cos(y) * std::cos(p)};
}

std::vector<Lobe> make_sky() {
    std::vector<Lobe> lobes = {
        {{0.012, 0.028, 0.085}, 0, {0, 1, 0}},     // everywhere
        {{0.006, 0.045, 0.150}, 1.6, {0, 1, 0}},   // the zenith
        {{0.140, 0.050, 0.040}, 4, toward(0, 0)},  // the evening's half
        {{0.420, 0.130, 0.030}, 18, toward(-12, 0)},  {{0.420, 0.130, 0.030}, 18, toward(14, 0)},
        {{0.700, 0.320, 0.080}, 55, toward(0, 7)},                                                 // around the sun
        {{6.000, 3.800, 1.700}, 1300, toward(0, 10)}, {{0.075, 0.032, 0.070}, 5, toward(180, 6)},  // the belt of Venus
        {{0.110, 0.040, 0.070}, 6, toward(75, 2)},    {{0.120, 0.042, 0.070}, 6, toward(-75, 2)},
    };
    // Banks of clouds: rows of small lobes.
    struct Bank {
        double yaw, pitch, length;
        int count;
        double sharpness;
        glm::dvec3 color;
    };
    for (const Bank& bank :
         {Bank{24, 5, 50, 26, 3000, {0.30, 0.09, 0.04}}, Bank{-30, 6, 40, 20, 2800, {0.30, 0.10, 0.05}},
          Bank{-14, 15, 44, 22, 2200, {0.62, 0.20, 0.08}}, Bank{30, 18, 50, 22, 1800, {0.56, 0.19, 0.10}},
          Bank{54, 11, 40, 20, 2600, {0.40, 0.12, 0.08}}, Bank{-52, 12, 40, 18, 2400, {0.40, 0.12, 0.08}},
          Bank{10, 26, 44, 18, 1300, {0.30, 0.11, 0.10}}, Bank{62, 25, 50, 18, 1100, {0.22, 0.085, 0.10}},
          Bank{-38, 30, 50, 18, 900, {0.20, 0.08, 0.10}}, Bank{30, 38, 60, 16, 500, {0.12, 0.055, 0.085}}})
        for (int i = 0; i < bank.count; ++i) {
            const double at = (i + 0.5) / bank.count - 0.5, wave = std::sin(2.4 * i + bank.yaw);
            lobes.push_back({bank.color * (1.0 - 2.4 * at * at) * (0.8 + 0.35 * wave),
                             bank.sharpness * (1 + 0.4 * wave),
                             toward(bank.yaw + at * bank.length, bank.pitch + 0.8 * wave - 5 * at * at)});
        }
    return lobes;
}

}  // namespace

const std::vector<Lobe>& evening_lobes() {
    static const std::vector<Lobe> lobes = make_sky();
    return lobes;
}

glm::dvec3 evening_sky(const glm::dvec3& direction) {
    glm::dvec3 sum(0);
    for (const Lobe& lobe : evening_lobes()) {
        const double power = lobe.sharpness * (glm::dot(direction, lobe.middle) - 1);
        if (power > -40) sum += lobe.color * std::exp(power);
    }
    return sum;
}

}  // namespace relief
