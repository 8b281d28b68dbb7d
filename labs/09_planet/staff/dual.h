// A number with its gradient: arithmetic on it differentiates exactly (forward mode).
#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace relief::planet {

struct Dual {
    double value = 0;
    glm::dvec3 gradient{0};
};

inline double value_of(const Dual& x) { return x.value; }
inline Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.gradient + b.gradient}; }
inline Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.gradient - b.gradient}; }
inline Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.gradient * b.value + a.value * b.gradient};
}
inline Dual operator/(double a, const Dual& b) { return {a / b.value, -a / (b.value * b.value) * b.gradient}; }
inline Dual operator+(const Dual& a, double b) { return {a.value + b, a.gradient}; }
inline Dual operator-(const Dual& a, double b) { return {a.value - b, a.gradient}; }
inline Dual operator-(double a, const Dual& b) { return {a - b.value, -b.gradient}; }
inline Dual operator*(const Dual& a, double b) { return {a.value * b, a.gradient * b}; }
inline Dual sqrt(const Dual& x) {
    const double root = std::sqrt(x.value);
    return {root, x.gradient * (0.5 / root)};
}
inline Dual exp(const Dual& x) {
    const double value = std::exp(x.value);
    return {value, x.gradient * value};
}

}  // namespace relief::planet
