#include "framework/course/check/hypotheses.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <set>

#include "framework/core/base/text.h"
#include "framework/core/image/color.h"

namespace relief::check {
namespace {

double median(std::vector<double> values) {
    if (values.empty()) return NAN;
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Returns the number of values of a channel that are at least a hundredth of its range apart, at most `most`.
size_t distinct(const PixelPairs& samples, size_t channel, size_t most = 8) {
    double low = INFINITY, high = -INFINITY;
    for (const PixelPair& one : samples)
        low = std::min(low, one.expected[channel]), high = std::max(high, one.expected[channel]);
    if (!(high - low > 0.02 * std::max(std::abs(low), std::abs(high)))) return 1;
    std::set<long> found;
    for (const PixelPair& one : samples) {
        found.insert(std::lround((one.expected[channel] - low) / (high - low) * 100));
        if (found.size() >= most) break;
    }
    return found.size();
}

/// Returns the mean of all samples, if each is near it.
std::optional<Value> constant(const PicturePair& pair, const PixelPairs& samples, Value PixelPair::*of) {
    Value sum{};
    for (const PixelPair& one : samples)
        for (size_t c = 0; c < 4; ++c) sum[c] += (one.*of)[c] / double(samples.size());
    const auto mean = pair.finished(sum);
    if (!mean) return {};
    size_t near = 0;
    for (const PixelPair& one : samples)
        near += pair.error(*mean, one.*of) <= std::max(0.005 * one.error, pair.noise());
    if (double(near) < 0.98 * double(samples.size())) return {};
    return mean;
}

std::string text_of(const PicturePair& pair, const Value& value) {
    if (pair.channels() == 1) return rounded(value[0], 3);
    double largest = 0;
    for (int c = 0; c < pair.channels(); ++c) largest = std::max(largest, std::abs(value[size_t(c)]));
    std::string text;
    for (int c = 0; c < pair.channels(); ++c) {
        const double one = value[size_t(c)];
        text += (c ? ", " : "(") + rounded(std::abs(one) < 1e-3 * largest ? 0 : one, 3);
    }
    return text + ")";
}

struct NamedFactor {
    double factor;
    const char* words;
};
constexpr double pi = std::numbers::pi;
constexpr NamedFactor named_factors[] = {{2, "twice"},
                                         {0.5, "half"},
                                         {4, "4 times"},
                                         {0.25, "a quarter of"},
                                         {pi, "pi times"},
                                         {1 / pi, "1 / pi times"},
                                         {2 * pi, "2 pi times"},
                                         {1 / (2 * pi), "1 / (2 pi) times"},
                                         {180 / pi, "180 / pi times"},
                                         {pi / 180, "pi / 180 times"},
                                         {255, "255 times"},
                                         {1 / 255.0, "1 / 255 of"},
                                         {std::numbers::sqrt2, "the square root of 2 times"},
                                         {1 / std::numbers::sqrt2, "the square root of 1/2 times"}};

const NamedFactor* name_of(double factor) {
    for (const NamedFactor& one : named_factors)
        if (std::abs(std::abs(factor) / one.factor - 1) < 0.002) return &one;
    return nullptr;
}
bool is_one(double factor) { return std::abs(factor - 1) < 0.005; }
/// Returns whether somebody may have written this factor. A fit to noise gives any.
bool is_plausible(double factor) {
    const double size = std::abs(factor);
    return name_of(factor) || (size > 1.0 / 64 && size < 64);
}
bool is_named(double factor) { return name_of(factor) || std::abs(std::abs(factor) - 1) < 0.002; }

/// Returns a factor in words: "twice", "half", "pi / 180 times", "1.37 times".
std::string times(double factor) {
    if (const NamedFactor* const one = name_of(factor))
        return fmt::format("{}{}", factor < 0 ? "minus " : "", one->words);
    if (is_one(-factor)) return "minus";
    return fmt::format("{} times", rounded(factor, 3));
}

/// A function of one number. The words have {} for the number's name.
struct Function {
    const char* words;
    double (*of)(double);
};
constexpr Function functions[] = {
    {"{} negated", [](double x) { return -x; }},
    {"the absolute value of {}", [](double x) { return std::abs(x); }},
    {"{} with 0 in place of negative values", [](double x) { return std::max(x, 0.0); }},
    {"{} with 0 in place of positive values", [](double x) { return std::min(x, 0.0); }},
    {"1 - {}", [](double x) { return 1 - x; }},
    {"{} clamped to at most 1", [](double x) { return std::min(x, 1.0); }},
    {"{} clamped to 0 to 1", [](double x) { return std::clamp(x, 0.0, 1.0); }},
    {"the square of {}", [](double x) { return x * x; }},
    {"the square root of {}", [](double x) { return std::sqrt(x); }},
    {"1 / {}", [](double x) { return 1 / x; }},
    {"{} / 2 + 1/2", [](double x) { return x / 2 + 0.5; }},
    {"2 {} - 1", [](double x) { return 2 * x - 1; }},
    {"{} encoded as sRGB", srgb_from_linear},
    {"{} decoded from sRGB", linear_from_srgb},
    {"{} read from an sRGB texture", [](double x) { return 2 * linear_from_srgb(x / 2 + 0.5) - 1; }},
    {"the sine for the cosine {}", [](double x) { return std::sqrt(1 - x * x); }},
    {"1 - the square of {}", [](double x) { return 1 - x * x; }},
};

/// For values that go through more than one integer.
constexpr Function roundings[] = {
    {"{} rounded down", [](double x) { return std::floor(x); }},
    {"{} rounded up", [](double x) { return std::ceil(x); }},
    {"{} rounded to an integer", [](double x) { return std::round(x); }},
    {"the fraction of {}", [](double x) { return x - std::floor(x); }},
};

/// The hypotheses about two pictures, from simple to complex.
class Hypotheses {
public:
    explicit Hypotheses(const PicturePair& pair) : pair_(pair) {
        for (int c = 0; c < pair.channels(); ++c) count_ = std::max(count_, distinct(differing(), size_t(c)));
    }

    std::vector<Hypothesis> all() {
        constants();
        if (count_ > 1 && pair_.channels() >= 2) signs_and_orders();
        if (pair_.has_base()) moves();
        if (pair_.channels() >= 2) turns();
        for (const Function& one : functions) whole(one);
        if (!pair_.is_direction() && pair_.largest() > 2)
            for (const Function& one : roundings) whole(one);
        factors();
        in_place();
        components();
        if (pair_.channels() > 1)
            for (const Function& one : functions)
                for (int c = 0; c < pair_.channels(); ++c) part(one, size_t(c));
        lines();
        return std::move(found_);
    }

private:
    std::string whole_name() const { return fmt::format("the expected {}", pair_.noun()); }
    const PixelPairs& differing() const { return pair_.differing(); }
    void add(std::string words, Rule rule) { found_.push_back({std::move(words), std::move(rule)}); }
    void add_constant(std::string words, Rule rule) {
        add(std::move(words), std::move(rule));
        found_.back().is_constant = true;
    }
    void add_function(std::string words, Rule rule) {
        add(std::move(words), std::move(rule));
        found_.back().most_left = 0.03;
    }
    /// With a number that comes from the pictures.
    void add_fitted(std::string words, Rule rule) {
        add_function(std::move(words), std::move(rule));
        found_.back().may_hold_in_part = false;
    }
    void add_component(const std::string& words, size_t channel, const std::function<double(const Value&)>& of) {
        add(fmt::format("the expected {} with {}", pair_.noun(), words), [=](size_t, const Value& e) {
            Value value = e;
            value[channel] = of(e);
            return std::optional(value);
        });
    }

    void constants() {
        PixelPairs all = differing();
        all.insert(all.end(), pair_.same().begin(), pair_.same().end());
        const auto everywhere = constant(pair_, all, &PixelPair::drawn);
        const auto drawn = constant(pair_, differing(), &PixelPair::drawn),
                   expected = constant(pair_, differing(), &PixelPair::expected);
        const char* const kind = pair_.is_direction() ? "the direction " : "";  // its length may vary
        if (everywhere && !expected)
            add_constant(fmt::format("{}{} everywhere", kind, text_of(pair_, *everywhere)),
                         [v = *everywhere](size_t, const Value&) { return v; });
        if (drawn && expected)
            add_constant(
                fmt::format("{}{} where {} is expected", kind, text_of(pair_, *drawn), text_of(pair_, *expected)),
                [v = *drawn, was = *expected, &pair = pair_](size_t, const Value& e) {
                    return pair.error(e, was) <= pair.threshold() ? v : e;
                });
    }

    /// All orders of the components with all signs, the simplest first.
    void signs_and_orders() {
        const size_t n = std::min(3, pair_.channels());
        struct Order {
            std::array<size_t, 3> from;
            unsigned negated;
            int cost;
        };
        std::vector<Order> orders;
        std::array<size_t, 3> from{0, 1, 2};
        do {
            int moved = 0;
            for (size_t i = 0; i < n; ++i) moved += from[i] != i;
            for (unsigned signs = 0; signs < 1u << n; ++signs)
                if (moved > 0 || signs > 0) {
                    const int bits = std::popcount(signs);
                    orders.push_back({from, signs, 2 * moved + (bits == int(n) ? 1 : bits)});
                }
        } while (std::next_permutation(from.begin(), from.begin() + std::ptrdiff_t(n)));
        std::stable_sort(orders.begin(), orders.end(), [](const Order& a, const Order& b) { return a.cost < b.cost; });
        for (const Order& order : orders)
            add(words_of(order.from, order.negated, n), [=](size_t, const Value& e) {
                Value value = e;
                for (size_t i = 0; i < n; ++i) value[i] = (order.negated >> i & 1 ? -1 : 1) * e[order.from[i]];
                return std::optional(value);
            });
    }
    std::string words_of(const std::array<size_t, 3>& from, unsigned negated, size_t n) const {
        std::string row;
        bool is_plain = true;
        for (size_t i = 0; i < n; ++i) {
            is_plain &= from[i] == i;
            row += fmt::format("{}{}{}", i ? ", " : "", negated >> i & 1 ? "-" : "", pair_.name(int(from[i])));
        }
        if (is_plain && negated == (1u << n) - 1) return whole_name() + " negated";
        if (is_plain) {
            std::string names;
            for (size_t i = 0; i < n; ++i)
                if (negated >> i & 1) names += (names.empty() ? "" : " and ") + std::string(pair_.name(int(i)));
            return fmt::format("the expected {} with {} negated", pair_.noun(), names);
        }
        if (negated == 0)
            for (size_t i = 0; i < n; ++i)
                for (size_t j = i + 1; j < n; ++j)
                    if (from[i] == j && from[j] == i)
                        return fmt::format("the expected {} with {} and {} swapped", pair_.noun(), pair_.name(int(i)),
                                           pair_.name(int(j)));
        return fmt::format("({}) of the expected {}", row, pair_.noun());
    }

    std::string base_name() const { return fmt::format("the {} for {}", pair_.noun(), pair_.base_knob()); }
    void add_from_base(std::string words, std::function<std::optional<Value>(const Value& base, const Value& e)> of) {
        add(std::move(words),
            [of = std::move(of), &pair = pair_](size_t pixel, const Value& e) -> std::optional<Value> {
                const auto base = pair.base_at(pixel);
                return base ? of(*base, e) : std::nullopt;
            });
    }
    /// Returns the samples with a base.
    std::vector<std::pair<PixelPair, Value>> with_base() const {
        std::vector<std::pair<PixelPair, Value>> some;
        for (const PixelPair& one : differing())
            if (const auto base = pair_.base_at(one.pixel)) some.emplace_back(one, *base);
        return some;
    }
    void add_factor_from_base(double k) {
        if (!is_plausible(k) || std::abs(k - 1) < 0.02) return;
        const std::string words = std::abs(k + 1) < 0.005
                                      ? fmt::format("{} moved to the opposite side of {}", whole_name(), base_name())
                                      : fmt::format("{} as far from {} as the expected value", times(k), base_name());
        add_from_base(words, [=](const Value& g, const Value& e) {
            Value value{};
            for (size_t c = 0; c < 4; ++c) value[c] = g[c] + k * (e[c] - g[c]);
            return std::optional(value);
        });
    }

    /// Turned by one angle about an axis: for two channels about the origin.
    void turns() {
        const int n = std::min(3, pair_.channels());
        for (int axis = n == 2 ? 2 : 0; axis < 3; ++axis) {
            const auto a = size_t((axis + 1) % 3), b = size_t((axis + 2) % 3);
            std::vector<double> sines, cosines;
            for (const PixelPair& one : differing()) {
                const Value &e = one.expected, &d = one.drawn;
                const double both = std::hypot(e[a], e[b]) * std::hypot(d[a], d[b]);
                if (both < 0.01 * length(e) * length(d)) continue;
                cosines.push_back((e[a] * d[a] + e[b] * d[b]) / both);
                sines.push_back((e[a] * d[b] - e[b] * d[a]) / both);
            }
            if (sines.size() < least_differing) continue;
            const double angle = std::atan2(median(sines), median(cosines));
            const double s = std::sin(angle), c = std::cos(angle);
            std::string words =
                fmt::format("{} turned by {} degrees", whole_name(), rounded(angle * 180 / std::numbers::pi, 3));
            if (n == 3) words += fmt::format(" about {}", pair_.name(axis));
            add(words, [=](size_t, const Value& e) {
                Value value = e;
                value[a] = c * e[a] - s * e[b], value[b] = s * e[a] + c * e[b];
                return std::optional(value);
            });
            found_.back().may_hold_in_part = false;
        }
    }

    /// Values whose distance from the base is another one.
    void moves() {
        add_from_base(base_name(), [](const Value& g, const Value&) { return std::optional(g); });
        if (pair_.is_direction()) {
            add_from_base(whole_name() + " left in tangent space",
                          [](const Value& g, const Value& e) { return std::optional(TangentFrame(g).local(e)); });
            return;
        }
        std::vector<double> factors;
        for (const auto& [one, g] : with_base()) {
            double de = 0, ee = 0;
            for (size_t c = 0; c < 4; ++c)
                de += (one.drawn[c] - g[c]) * (one.expected[c] - g[c]),
                    ee += (one.expected[c] - g[c]) * (one.expected[c] - g[c]);
            if (ee > 0) factors.push_back(de / ee);
        }
        if (factors.size() < least_differing) return;
        add_factor_from_base(median(factors));
        for (int i = 0; i < pair_.channels() && pair_.channels() > 1; ++i) {
            const auto c = size_t(i);
            add_from_base(
                fmt::format("{} with {} moved to the opposite side of {}", whole_name(), pair_.name(i), base_name()),
                [c](const Value& g, Value e) { return e[c] = 2 * g[c] - e[c], std::optional(e); });
            add_from_base(fmt::format("{} with {} of {}", whole_name(), pair_.name(i), base_name()),
                          [c](const Value& g, Value e) { return e[c] = g[c], std::optional(e); });
        }
        if (pair_.channels() == 2)
            add_from_base(fmt::format("{} with the moves of {} and {} from {} swapped", whole_name(), pair_.name(0),
                                      pair_.name(1), base_name()),
                          [](const Value& g, const Value& e) {
                              return std::optional(Value{g[0] + e[1] - g[1], g[1] + e[0] - g[0]});
                          });
    }

    /// A function of all components.
    void whole(const Function& one) {
        if (count_ < 2) return;
        const int n = pair_.channels();
        add_function(fmt::format(fmt::runtime(one.words), whole_name()), [=](size_t, const Value& e) {
            Value value = e;
            for (int c = 0; c < n; ++c) value[size_t(c)] = one.of(e[size_t(c)]);
            return std::optional(value);
        });
    }
    /// A function of one component.
    void part(const Function& one, size_t channel) {
        if (distinct(differing(), channel) < 2) return;
        add_component(fmt::format("{} in place of {}", fmt::format(fmt::runtime(one.words), pair_.name(int(channel))),
                                  pair_.name(int(channel))),
                      channel, [=](const Value& e) { return one.of(e[channel]); });
        found_.back().most_left = 0.03;
    }

    /// Returns the median of a quotient where the pictures differ and the divisor is not small.
    double quotient(const std::function<std::pair<double, double>(const PixelPair&)>& of) const {
        double largest = 0;
        for (const PixelPair& one : differing()) largest = std::max(largest, std::abs(of(one).second));
        std::vector<double> quotients;
        for (const PixelPair& one : differing())
            if (const auto [a, b] = of(one); std::abs(b) > 0.05 * largest) quotients.push_back(a / b);
        return median(quotients);
    }

    /// A constant factor, an offset, a bound.
    void factors() {
        if (pair_.is_direction() || count_ < 2) return;
        const double k = quotient([](const PixelPair& one) {
            return std::pair(dot(one.drawn, one.expected), dot(one.expected, one.expected));
        });
        if (is_plausible(k) && !is_one(k))
            add_fitted(fmt::format("{} {}", times(k), whole_name()),
                       [=](size_t, const Value& e) { return std::optional(scaled(e, k)); });
        Value apart{};
        for (int c = 0; c < pair_.channels(); ++c) {
            std::vector<double> offsets;
            for (const PixelPair& one : differing()) offsets.push_back(one.drawn[size_t(c)] - one.expected[size_t(c)]);
            apart[size_t(c)] = median(offsets);
        }
        add_fitted(pair_.channels() == 1 ? fmt::format("{} {} {}", whole_name(), apart[0] < 0 ? "minus" : "plus",
                                                       rounded(std::abs(apart[0]), 3))
                                         : fmt::format("{} plus {}", whole_name(), text_of(pair_, apart)),
                   [=](size_t, const Value& e) {
                       return std::optional(Value{e[0] + apart[0], e[1] + apart[1], e[2] + apart[2], e[3] + apart[3]});
                   });
        if (pair_.channels() == 1) bounds();
        if (pair_.channels() >= 2) add(whole_name() + " normalised", [](size_t, const Value& e) { return unit(e); });
    }
    void bounds() {
        double low = INFINITY, high = -INFINITY;
        for (const PixelPairs* some : {&pair_.differing(), &pair_.same()})
            for (const PixelPair& one : *some) low = std::min(low, one.drawn[0]), high = std::max(high, one.drawn[0]);
        add_fitted(fmt::format("{}, but never above {}", whole_name(), rounded(high, 3)),
                   [=](size_t, const Value& e) { return std::optional(Value{std::min(e[0], high)}); });
        add_fitted(fmt::format("{}, but never below {}", whole_name(), rounded(low, 3)),
                   [=](size_t, const Value& e) { return std::optional(Value{std::max(e[0], low)}); });
    }

    /// The expected picture at another place.
    void in_place() {
        const int w = pair_.width(), h = pair_.height();
        const auto add_moved = [&](std::string words, const std::function<std::pair<int, int>(int x, int y)>& from) {
            add(std::move(words), [=, &pair = pair_](size_t pixel, const Value&) -> std::optional<Value> {
                const auto [x, y] = from(int(pixel % size_t(w)), int(pixel / size_t(w)));
                if (x < 0 || y < 0 || x >= w || y >= h) return {};
                return pair.expected_at(size_t(y) * size_t(w) + size_t(x));
            });
            found_.back().may_hold_in_part = false;  // a few pixels agree with those of another place by chance
        };
        const std::string name = whole_name();
        if (count_ < 4 || pair_.is_unrolled()) return;
        add_moved(name + " upside down", [h](int x, int y) { return std::pair(x, h - 1 - y); });
        add_moved(name + " mirrored from left to right", [w](int x, int y) { return std::pair(w - 1 - x, y); });
        add_moved(name + " turned by 180 degrees", [w, h](int x, int y) { return std::pair(w - 1 - x, h - 1 - y); });
        if (w == h) add_moved(name + " with rows and columns swapped", [](int x, int y) { return std::pair(y, x); });
        for (int size = 1; size <= 3; ++size)
            for (const auto& [dx, dy, way] : {std::tuple(1, 0, "left"), std::tuple(-1, 0, "right"),
                                              std::tuple(0, 1, "up"), std::tuple(0, -1, "down")})
                add_moved(fmt::format("{} moved {} by {} pixel{}", name, way, size, size > 1 ? "s" : ""),
                          [=, dx = dx, dy = dy](int x, int y) { return std::pair(x + dx * size, y + dy * size); });
    }

    /// One component that is a constant, or has another weight than the others.
    void components() {
        if (pair_.channels() < 2) return;
        for (int c = 0; c < pair_.channels(); ++c) {
            const auto i = size_t(c);
            const char* const name = pair_.name(c);
            if (distinct(differing(), i) < 2) continue;
            if (pair_.is_direction()) {
                weights(i, name);
                continue;
            }
            const size_t before = found_.size();
            std::vector<double> drawn, apart;
            for (const PixelPair& one : differing())
                drawn.push_back(one.drawn[i]), apart.push_back(one.drawn[i] - one.expected[i]);
            const double middle = median(drawn), offset = median(apart);
            const double k = quotient([=](const PixelPair& one) { return std::pair(one.drawn[i], one.expected[i]); });
            add_component(fmt::format("{} for {}", rounded(middle, 3), name), i, [=](const Value&) { return middle; });
            if (std::isfinite(k) && !is_one(k))
                add_component(fmt::format("{} {}", times(k), name), i, [=](const Value& e) { return k * e[i]; });
            add_component(fmt::format("{} {} {}", name, offset < 0 ? "minus" : "plus", rounded(std::abs(offset), 3)), i,
                          [=](const Value& e) { return e[i] + offset; });
            for (size_t last = before; last < found_.size(); ++last) found_[last].may_hold_in_part = false;
        }
        // A component in place of another.
        for (int c = 0; c < pair_.channels(); ++c)
            for (int from = 0; from < pair_.channels(); ++from)
                if (c != from)
                    add_component(fmt::format("{} in place of {}", pair_.name(from), pair_.name(c)), size_t(c),
                                  [=](const Value& e) { return e[size_t(from)]; });
    }
    /// For directions: component `up` against the two others.
    void weights(size_t up, const char* name) {
        const size_t a = (up + 1) % 3, b = (up + 2) % 3;
        // d_up / |d_ab| = k e_up / |e_ab|
        const auto across = [=](const Value& v) { return std::hypot(v[a], v[b]); };
        const double k = quotient([=](const PixelPair& one) {
            return std::pair(one.drawn[up] * across(one.expected), one.expected[up] * across(one.drawn));
        });
        if (std::isfinite(k) && std::abs(k) < 0.003)
            add_component(fmt::format("0 for {}", name), up, [](const Value&) { return 0.0; });
        else if (std::isfinite(k) && !is_one(k))
            add_component(fmt::format("{} {}", times(k), name), up, [=](const Value& e) { return k * e[up]; });
        // A fixed component, and one with an offset, before the vector was normalised.
        const double fixed = quotient(
            [=](const PixelPair& one) { return std::pair(one.drawn[up] * across(one.expected), across(one.drawn)); });
        if (std::isfinite(fixed))
            add_component(fmt::format("{} for {}", rounded(fixed, 3), name), up, [=](const Value&) { return fixed; });
        std::vector<double> offsets;
        for (const PixelPair& one : differing())
            if (across(one.drawn) > 0.05)
                offsets.push_back(one.drawn[up] / across(one.drawn) * across(one.expected) - one.expected[up]);
        if (const double offset = median(offsets); std::isfinite(offset))
            add_component(fmt::format("{} {} {}", name, offset < 0 ? "minus" : "plus", rounded(std::abs(offset), 3)),
                          up, [=](const Value& e) { return e[up] + offset; });
    }

    /// A factor and an offset, perhaps with bounds.
    void lines() {
        if (pair_.channels() > 1 || distinct(differing(), 0) < 5) return;
        double low = INFINITY, high = -INFINITY;
        for (const PixelPair& one : differing()) low = std::min(low, one.drawn[0]), high = std::max(high, one.drawn[0]);
        PixelPairs inside;
        size_t at_low = 0, at_high = 0;
        for (const PixelPair& one : differing()) {
            at_low += one.drawn[0] == low, at_high += one.drawn[0] == high;
            if (one.drawn[0] > low && one.drawn[0] < high) inside.push_back(one);
        }
        if (inside.size() < least_differing || distinct(inside, 0) < 5) return;
        double se = 0, sd = 0, see = 0, sed = 0;
        const double n = double(inside.size());
        for (const PixelPair& one : inside) {
            const double e = one.expected[0], d = one.drawn[0];
            se += e, sd += d, see += e * e, sed += e * d;
        }
        const double b = (n * sed - se * sd) / (n * see - se * se), a = (sd - b * se) / n;
        if (!std::isfinite(a) || std::abs(b) < 0.01) return;
        const bool is_offset = is_one(b), is_factor = std::abs(a) < 1e-4 * (std::abs(low) + std::abs(high));
        if (is_offset && is_factor) return;
        if (!is_offset && !is_factor && !is_named(b)) return;  // any two numbers would say little
        std::string words = is_offset ? whole_name() : fmt::format("{} {}", times(b), whole_name());
        if (!is_factor) words += fmt::format(" {} {}", a < 0 ? "minus" : "plus", rounded(std::abs(a), 3));
        add_fitted(words, [=](size_t, const Value& e) { return std::optional(Value{a + b * e[0]}); });
        const auto often = size_t(0.01 * double(differing().size()) + 10);
        if (at_low > often) words += fmt::format(", but never below {}", rounded(low, 3));
        if (at_high > often) words += fmt::format(", but never above {}", rounded(high, 3));
        if (at_low > often || at_high > often)
            add_fitted(words, [=](size_t, const Value& e) {
                return std::optional(Value{
                    std::clamp(a + b * e[0], at_low > often ? low : -INFINITY, at_high > often ? high : INFINITY)});
            });
    }

    const PicturePair& pair_;
    size_t count_ = 1;  ///< largest number of distinct values of a channel, where the pictures differ
    std::vector<Hypothesis> found_;
};

}  // namespace

std::vector<Hypothesis> hypotheses(const PicturePair& pair) { return Hypotheses(pair).all(); }

}  // namespace relief::check
