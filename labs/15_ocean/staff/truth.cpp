// The staff's part of lab 15: see ../truth.h.
#include "truth.h"

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "framework/library/kit/drawn_numbers.h"
#include "waves.h"

namespace relief::ocean {
namespace {

constexpr double two_pi = 2 * glm::pi<double>();

/// A cosine on the water: amplitude * cos(dot(number, place) + phase), with the place in metres.
struct Term {
    glm::dvec2 number;
    double amplitude, phase;
};

std::vector<Term> terms_of(const Sea& sea, double time) {
    std::vector<Term> terms;
    for (const Layer& layer : sea.layers)
        for (const PlaneWave& wave : waves_of(layer.map)) {
            // Drops whole tiles, which are whole periods of every wave.
            glm::dvec2 moved = layer.velocity * time;
            moved -= glm::floor(moved);
            terms.push_back({two_pi * layer.tiles / tile_metres * glm::dvec2(wave.k), layer.amplitude * wave.amplitude,
                             wave.phase + two_pi * glm::dot(glm::dvec2(wave.k), moved + layer.offset)});
        }
    return terms;
}

double height(const std::vector<Term>& terms, const glm::dvec2& place) {
    double sum = 0;
    for (const Term& term : terms) sum += term.amplitude * std::cos(glm::dot(term.number, place) + term.phase);
    return sum;
}

glm::dvec2 slope(const std::vector<Term>& terms, const glm::dvec2& place) {
    glm::dvec2 sum(0);
    for (const Term& term : terms)
        sum -= term.number * (term.amplitude * std::sin(glm::dot(term.number, place) + term.phase));
    return sum;
}

/// Returns upper bounds of the height and of the slope of a map that is tiled once. A sum of waves with wave numbers up
/// to n along each axis is bounded by its maximum over N x N places, divided by cos(pi n / N) squared (Ehlich and
/// Zeller 1964).
glm::dvec2 bounds_of(int map) {
    static const auto measured = [](int of) {
        const Image waves = make_maps(of).waves;
        double height_ = 0, slope_ = 0;
        for (size_t i = 0; i < waves.values.size(); i += 3) {
            height_ = std::max(height_, double(std::abs(waves.values[i + 2])));
            slope_ = std::max(slope_, std::hypot(double(waves.values[i]), double(waves.values[i + 1])));
        }
        int most = 0;
        for (const PlaneWave& wave : waves_of(of)) most = std::max({most, std::abs(wave.k.x), std::abs(wave.k.y)});
        const double between = std::cos(glm::pi<double>() * most / map_texels);
        return glm::dvec2(height_, slope_) / (between * between);
    };
    static const std::array bounds = {measured(0), measured(1)};
    return bounds[size_t(map)];
}

class ExactSea {
public:
    ExactSea(const Sea& sea, const Frame& frame)
        : sea_(sea), terms_(terms_of(sea, frame.time)), eye_(frame.camera.eye()) {
        for (const Layer& layer : sea.layers) {
            const glm::dvec2 bounds = bounds_of(layer.map);
            highest_ += layer.amplitude * bounds.x, steepest_ += layer.amplitude * layer.tiles * bounds.y;
        }
        // The width and the height of a pixel, one metre ahead.
        const glm::dmat4 view = frame.camera.view_from_world();
        const glm::dvec3 right(view[0][0], view[1][0], view[2][0]), up(view[0][1], view[1][1], view[2][1]);
        forward_ = -glm::dvec3(view[0][2], view[1][2], view[2][2]);
        const double pixel = 2 * std::tan(glm::radians(frame.camera.orbit().field_of_view) / 2) / frame.size.y;
        right_ = right * pixel, up_ = up * pixel;
    }

    /// Returns the first hit of the ray with the sea, from the eye's side of it: above or below. With waves it takes
    /// steps that cannot pass the surface, since slopes are bounded by steepest_. An eye in the surface hits nothing.
    std::optional<glm::dvec3> hit(const Ray& ray) const {
        if (!sea_.displaced) {
            const double level = -ray.origin.y / ray.direction.y;
            return level > 0 && std::isfinite(level) ? std::optional(at(ray, level)) : std::nullopt;
        }
        const double rate =
            std::abs(ray.direction.y) + steepest_ * glm::length(glm::dvec2(ray.direction.x, ray.direction.z));
        const double toward_eye = ray.origin.y < height(terms_, {ray.origin.x, ray.origin.z}) ? -1 : 1;
        const double falls = -toward_eye * ray.direction.y, outside = toward_eye * ray.origin.y - highest_;
        double t = outside > 0 ? outside / std::max(falls, 1e-12) : 0;
        for (int step = 0; step < 4000; ++step) {
            const glm::dvec3 place = at(ray, t);
            if (falls <= 0 && toward_eye * place.y > highest_) return {};
            const double away = toward_eye * (place.y - height(terms_, {place.x, place.z}));
            if (away < 1e-7) return t > 0 ? std::optional(place) : std::nullopt;
            t += away / rate;
        }
        return at(ray, t);
    }

    std::optional<glm::dvec4> value(const Ray& ray, const std::string& probe) const {
        const auto place = hit(ray);
        if (!place) return {};
        const glm::dvec2 on_sea(place->x, place->z);
        if (probe == "height") return glm::dvec4(height(terms_, on_sea), 0, 0, 0);
        if (probe == "sigma") return glm::dvec4(covariance(*place), 0);
        if (probe == "glitter") return glm::dvec4(glitter(*place), 0, 0, 0);
        const glm::dvec2 s = slope(terms_, on_sea);
        if (probe == "slope") return glm::dvec4(s, 0, 0);
        const glm::dvec3 normal = glm::normalize(glm::dvec3(-s.x, 1, -s.y)), to_eye = -ray.direction;
        if (probe == "normal") return glm::dvec4(normal, 0);
        const double cosine = glm::clamp(glm::dot(normal, to_eye), 0.0, 1.0);
        if (probe == "fresnel") return glm::dvec4(fresnel(cosine), 0, 0, 0);
        glm::dvec3 mirrored = 2 * glm::dot(normal, to_eye) * normal - to_eye;
        mirrored.y = std::abs(mirrored.y);
        return glm::dvec4(mirrored, 0);
    }

private:
    static constexpr int side = 32;

    static glm::dvec3 at(const Ray& ray, double t) { return ray.origin + t * ray.direction; }

    double fresnel(double cosine) const {
        constexpr double eta = 4.0 / 3, r0 = (eta - 1) * (eta - 1) / ((eta + 1) * (eta + 1));
        if (!sea_.exact_fresnel) return r0 + (1 - r0) * std::pow(1 - cosine, 5);
        const double within = std::sqrt(1 - (1 - cosine * cosine) / (eta * eta));
        const double s = (cosine - eta * within) / (cosine + eta * within),
                     p = (within - eta * cosine) / (within + eta * cosine);
        return (s * s + p * p) / 2;
    }

    /// Calls `take` with the slope at each of 32 x 32 places of the pixel's footprint: a parallelogram of the plane at
    /// the height of its middle. From one row or column to the next the angle of a wave grows by a constant. So a
    /// product of complex numbers turns it, and no place needs a sine of its own.
    template <class Take>
    void each_sample(const glm::dvec3& middle, Take take) const {
        const double depth = glm::dot(middle - eye_, forward_);
        const glm::dvec3 way = (middle - eye_) / depth;
        const auto moved = [&](const glm::dvec3& by) {
            return depth * (glm::dvec2(by.x, by.z) - glm::dvec2(way.x, way.z) * (by.y / way.y));
        };
        const glm::dvec2 across = moved(right_) / double(side), along = moved(up_) / double(side);
        const glm::dvec2 begin = glm::dvec2(middle.x, middle.z) - (side - 1) / 2.0 * (across + along);
        using Rows = std::array<double, side>;
        struct Turning {
            Rows cosine, sine;  // multiplied by the amplitude
            double turn_cosine, turn_sine;
        };
        std::vector<Turning> terms(terms_.size());
        for (size_t i = 0; i < terms_.size(); ++i) {
            const double angle = glm::dot(terms_[i].number, across), row_angle = glm::dot(terms_[i].number, along),
                         first = glm::dot(terms_[i].number, begin) + terms_[i].phase;
            terms[i].turn_cosine = std::cos(angle), terms[i].turn_sine = std::sin(angle);
            const double row_cosine = std::cos(row_angle), row_sine = std::sin(row_angle);
            double cosine = terms_[i].amplitude * std::cos(first), sine = terms_[i].amplitude * std::sin(first);
            for (size_t row = 0; row < side; ++row) {
                terms[i].cosine[row] = cosine, terms[i].sine[row] = sine;
                const double next = cosine * row_cosine - sine * row_sine;
                sine = cosine * row_sine + sine * row_cosine, cosine = next;
            }
        }
        for (int column = 0; column < side; ++column) {
            Rows x{}, z{};
            for (size_t i = 0; i < terms.size(); ++i) {
                Turning& term = terms[i];
                const glm::dvec2 number = terms_[i].number;
                for (size_t row = 0; row < side; ++row) {
                    const double cosine = term.cosine[row], sine = term.sine[row];
                    x[row] -= number.x * sine, z[row] -= number.y * sine;
                    term.cosine[row] = cosine * term.turn_cosine - sine * term.turn_sine;
                    term.sine[row] = cosine * term.turn_sine + sine * term.turn_cosine;
                }
            }
            for (size_t row = 0; row < side; ++row) take(glm::dvec2(x[row], z[row]));
        }
    }

    glm::dvec3 covariance(const glm::dvec3& middle) const {
        if (sea_.whole_spread) {
            glm::dvec3 sum(0);
            for (const Layer& layer : sea_.layers) {
                const double scale = layer.amplitude * layer.tiles;
                sum += scale * scale * slope_moments(layer.map);
            }
            return sum;
        }
        glm::dvec2 mean(0);
        glm::dvec3 squares(0);
        each_sample(middle, [&](const glm::dvec2& s) { mean += s, squares += glm::dvec3(s * s, s.x * s.y); });
        mean /= side * side, squares /= side * side;
        return squares - glm::dvec3(mean * mean, mean.x * mean.y);
    }

    /// Returns the share of the sun's light: the mean over samples, by their distance from the slope that mirrors the
    /// sun.
    double glitter(const glm::dvec3& middle) const {
        const glm::dvec3 sum = glm::normalize(eye_ - middle) + sea_.to_light;
        if (sum.y < 1e-3 || sea_.to_light.y < 0) return 0;
        const glm::dvec2 wanted = -glm::dvec2(sum.x, sum.z) / sum.y;
        if (sea_.whole_spread) {
            const glm::dvec3 sigma = covariance(middle) + glm::dvec3(1, 1, 0) / sea_.shininess;
            const glm::dmat2 matrix(sigma.x, sigma.z, sigma.z, sigma.y);
            return std::exp(-glm::dot(wanted, glm::inverse(matrix) * wanted) / 2) /
                   (sea_.shininess * std::sqrt(glm::determinant(matrix)));
        }
        if (sea_.shininess * std::pow(std::max(0.0, glm::length(wanted) - steepest_), 2) / 2 > 60) return 0;
        double light = 0;
        each_sample(middle, [&](const glm::dvec2& s) {
            const glm::dvec2 off = s - wanted;
            light += std::exp(-sea_.shininess * glm::dot(off, off) / 2);
        });
        return light / (side * side);
    }

    const Sea& sea_;
    std::vector<Term> terms_;
    glm::dvec3 eye_, forward_, right_, up_;
    double highest_ = 0, steepest_ = 0;
};

std::optional<Image> exact_values(const Frame& frame, const Sea& sea) {
    const ExactSea exact(sea, frame);
    return truth_of_rays(frame, [&](const Ray& ray) { return exact.value(ray, frame.probe.name); });
}

const decltype(truth)::Provided provided(truth, exact_values);

}  // namespace
}  // namespace relief::ocean
