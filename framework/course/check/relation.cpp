#include "framework/course/check/relation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "framework/core/base/text.h"
#include "framework/course/check/hypotheses.h"

namespace relief::check {
namespace {

constexpr double explained_share = 0.95;
/// Most of the sum of the errors that a relation may leave.
constexpr double most_left = 0.1;

std::optional<Value> predicted(const PicturePair& pair, const Hypothesis& one, const PixelPair& sample) {
    return pair.finished(one.rule(sample.pixel, sample.expected));
}

/// A part of the picture.
struct Part {
    std::string words;  ///< "where the expected x is negative"
    std::function<bool(const PixelPair&)> has;
};

std::vector<Part> parts_of(const PicturePair& pair) {
    std::vector<Part> parts;
    for (int c = 0; c < pair.channels() && !pair.is_picture(); ++c) {
        const std::string name = pair.channels() == 1 ? "value" : pair.name(c);
        const auto i = size_t(c);
        parts.push_back({fmt::format("where the expected {} is negative", name),
                         [=](const PixelPair& s) { return s.expected[i] < 0; }});
        parts.push_back({fmt::format("where the expected {} is positive", name),
                         [=](const PixelPair& s) { return s.expected[i] > 0; }});
        parts.push_back({fmt::format("where the expected {} is 0", name),
                         [=](const PixelPair& s) { return std::abs(s.expected[i]) < 1e-6; }});
        parts.push_back({fmt::format("where the expected {} is above 1", name),
                         [=](const PixelPair& s) { return s.expected[i] > 1; }});
    }
    const auto w = size_t(pair.width()), h = size_t(pair.height());
    parts.push_back({"in the left half of the picture", [=](const PixelPair& s) { return s.pixel % w < w / 2; }});
    parts.push_back({"in the right half of the picture", [=](const PixelPair& s) { return s.pixel % w >= w / 2; }});
    parts.push_back({"in the upper half of the picture", [=](const PixelPair& s) { return s.pixel / w < h / 2; }});
    parts.push_back({"in the lower half of the picture", [=](const PixelPair& s) { return s.pixel / w >= h / 2; }});
    parts.push_back({"within 2 pixels of a surface's edge", [=, &pair](const PixelPair& s) {
                         const int x = int(s.pixel % w), y = int(s.pixel / w);
                         for (int dy = -2; dy <= 2; ++dy)
                             for (int dx = -2; dx <= 2; ++dx) {
                                 if (x + dx < 0 || y + dy < 0 || x + dx >= int(w) || y + dy >= int(h)) continue;
                                 if (!pair.expected_at(size_t(y + dy) * w + size_t(x + dx))) return true;
                             }
                         return false;
                     }});
    return parts;
}

size_t count_in(const Part& part, const PixelPairs& samples) {
    return size_t(std::count_if(samples.begin(), samples.end(), part.has));
}

/// Returns the part that has all of `inside` and hardly any of `outside`.
std::optional<Part> part_with(const PicturePair& pair, const PixelPairs& inside, const PixelPairs& outside) {
    for (Part& part : parts_of(pair)) {
        const size_t in = count_in(part, inside), out = count_in(part, outside);
        if (double(in) >= 0.98 * double(inside.size()) &&
            double(out) <= 0.02 * double(inside.size() + outside.size()) &&
            outside.size() > 0.1 * double(inside.size()))
            return part;
    }
    return {};
}

std::string percent(const PicturePair& pair, double share) {
    return fmt::format("{} % of the {}", rounded(100 * share, 3), pair.is_unrolled() ? "components" : "pixels");
}

/// A hypothesis that explains the difference at the pixels that differ.
struct Explained {
    const Hypothesis* hypothesis;
    double left;              ///< sum of the errors that remain
    double share;             ///< of all pixels: those that it explains, or where it agrees that there is no difference
    PixelPairs contradicted;  ///< pixels that are right, and for which it predicts a difference
};

/// Returns the sum of the errors of the mean, where the pictures differ.
double spread_of_drawn(const PicturePair& pair) {
    Value sum{};
    for (const PixelPair& one : pair.differing())
        for (size_t c = 0; c < 4; ++c) sum[c] += one.drawn[c] / double(pair.differing().size());
    const auto mean = pair.finished(sum);
    double spread = 0;
    for (const PixelPair& one : pair.differing()) spread += mean ? pair.error(*mean, one.drawn) : one.error;
    return spread;
}

std::optional<Explained> explanation(const PicturePair& pair, const Hypothesis& one) {
    const PixelPairs& differing = pair.differing();
    const auto most_failures = size_t((1 - explained_share) * double(differing.size()));
    size_t failures = 0;
    Explained found{&one, 0, 0, {}};
    for (const PixelPair& sample : differing) {
        const auto value = predicted(pair, one, sample);
        if (!pair.explains(value, sample, one.most_left) && ++failures > most_failures) return {};
        found.left += std::min(pair.error(value, sample.drawn), 2 * sample.error);
    }
    if (found.left > most_left * pair.sum()) return {};
    // Nearly constant values are near many functions of large expected ones. Only a constant explains them.
    if (!one.is_constant && found.left > 0.3 * spread_of_drawn(pair)) return {};
    for (const PixelPair& sample : pair.same())
        if (pair.error(predicted(pair, one, sample), sample.drawn) > pair.threshold())
            found.contradicted.push_back(sample);
    found.share = 1 - double(failures + found.contradicted.size()) / double(pair.count());
    return found;
}

bool holds_everywhere(const PicturePair& pair, const Explained& one) {
    const auto contradicted = double(one.contradicted.size());
    return contradicted <= 0.02 * double(pair.count()) && contradicted <= 0.25 * double(pair.differing().size());
}

/// Returns the simplest of the explanations for which `holds` is true and that leave nearly as little as the best.
const Explained* simplest(const PicturePair& pair, const std::vector<Explained>& all,
                          const std::function<bool(const Explained&)>& holds) {
    std::vector<const Explained*> some;
    double least = INFINITY;
    for (const Explained& one : all)
        if (holds(one)) some.push_back(&one), least = std::min(least, one.left);
    for (const Explained* one : some)
        if (one->left <= 20 * least + pair.noise() * double(pair.count())) return one;
    return nullptr;
}

/// Returns the expected picture with the hypothesis applied. Directions get the length of the drawn ones.
Image predicted(const PicturePair& pair, const Hypothesis& one, const Image& expected) {
    Image result = expected;
    for (size_t i = 0; i < expected.pixel_count(); ++i) {
        const auto e = pair.expected_at(i);
        auto value = e ? pair.finished(one.rule(i, *e)) : e;
        if (value && pair.is_direction()) value = scaled(*value, pair.drawn_length(i));
        for (int c = 0; value && c < pair.channels(); ++c)
            result.values[i * size_t(expected.channels) + size_t(c)] = float((*value)[size_t(c)]);
    }
    return result;
}

/// Says when every error has the same sign: a value that is too large, a picture that is too dark.
std::optional<Relation> one_sided_error(const PicturePair& pair) {
    if (pair.is_unrolled() || (!pair.is_picture() && pair.channels() > 1)) return {};
    size_t above = 0, below = 0;
    double sum = 0;
    for (const PixelPairs* const some : {&pair.differing(), &pair.same()})
        for (const PixelPair& one : *some) {
            if (one.error <= pair.noise()) continue;
            double off = 0;
            for (size_t c = 0; c < 4; ++c) off += one.drawn[c] - one.expected[c];
            ++(off > 0 ? above : below), sum += off;
        }
    const auto count = double(above + below);
    if (double(std::min(above, below)) > 0.005 * count) return {};
    const char* const words = pair.is_picture() ? sum > 0 ? "brighter" : "darker" : sum > 0 ? "larger" : "smaller";
    const std::string by =
        pair.is_picture() ? "" : fmt::format(", by {} on average", rounded(std::abs(sum) / count, 3));
    return Relation{fmt::format("yours is {} than expected wherever they differ{}: on {}", words, by,
                                percent(pair, count / double(pair.count())))};
}

std::optional<Relation> relation_of_pixels(const Image& drawn, const Image& expected, const Quantity& quantity,
                                           bool is_unrolled = false) {
    const PicturePair pair(drawn, expected, quantity, is_unrolled);
    if (pair.differing().size() < least_differing) return {};
    const std::vector<Hypothesis> all = hypotheses(pair);
    std::vector<Explained> explanations;
    for (const Hypothesis& one : all)
        if (auto found = explanation(pair, one)) explanations.push_back(std::move(*found));
    const auto told = [&](std::string sentence, const Explained& one) {
        return Relation{std::move(sentence), predicted(pair, *one.hypothesis, expected)};
    };
    const auto part_of = [&](const Explained& one) { return part_with(pair, pair.differing(), one.contradicted); };
    if (const auto* one = simplest(pair, explanations, [&](auto& each) { return holds_everywhere(pair, each); }))
        return told(fmt::format("yours is {}{}", one->hypothesis->words,
                                one->share < 0.9995 ? ", on " + percent(pair, one->share) : ""),
                    *one);
    if (const auto* one = simplest(pair, explanations, [&](auto& each) { return part_of(each).has_value(); }))
        return told(fmt::format("{}, yours is {}; elsewhere it is right or nearly so", part_of(*one)->words,
                                one->hypothesis->words),
                    *one);
    if (const auto* one = simplest(pair, explanations, [](auto& each) { return each.hypothesis->may_hold_in_part; }))
        return told(
            fmt::format("on {}, yours is {}; on the others it is right or nearly so",
                        percent(pair, double(pair.differing().size()) / double(pair.count())), one->hypothesis->words),
            *one);
    if (const auto part = part_with(pair, pair.differing(), pair.same()))
        return Relation{fmt::format("yours is right except {}", part->words)};
    return one_sided_error(pair);
}

/// Returns an image in which each of the first channels is a pixel of its own.
Image unrolled(const Image& image, int channels) {
    Image result(image.width * channels, image.height, 1, image.bits);
    for (size_t i = 0; i < result.values.size(); ++i)
        result.values[i] = image.values[i / size_t(channels) * size_t(image.channels) + i % size_t(channels)];
    return result;
}

std::optional<Relation> relation_of_components(const Image& drawn, const Image& expected, const Quantity& quantity) {
    if (quantity.error != ErrorMetric::distance || quantity.name.empty() || expected.channels < 2) return {};
    const int channels = PicturePair(drawn, expected, quantity).channels();
    auto found = relation_of_pixels(unrolled(drawn, channels), unrolled(expected, channels),
                                    {.name = quantity.name, .error = ErrorMetric::absolute}, true);
    if (!found || found->predicted.values.empty()) return {};
    found->sentence = "component by component, " + found->sentence;
    const Image components = std::move(found->predicted);
    found->predicted = expected;
    for (size_t i = 0; i < components.values.size(); ++i)
        found->predicted.values[i / size_t(channels) * size_t(expected.channels) + i % size_t(channels)] =
            components.values[i];
    return found;
}

/// Returns directions in the frames of the base's normals, or back in the world.
Image in_frames(const Image& image, const Image& base, bool back) {
    Image result = image;
    for (size_t i = 0; i < image.pixel_count(); ++i) {
        float* const v = result.values.data() + i * size_t(image.channels);
        const float* const n = base.values.data() + i * size_t(image.channels);
        const auto normal = unit({n[0], n[1], n[2]});
        if (!normal || !std::isfinite(v[0])) {
            std::fill(v, v + image.channels, no_surface);
            continue;
        }
        const TangentFrame frame(*normal);
        const Value value{v[0], v[1], v[2]}, turned = back ? frame.world(value) : frame.local(value);
        for (size_t c = 0; c < 3; ++c) v[c] = float(turned[c]);
    }
    return result;
}

std::optional<Relation> relation_in_tangent_space(const Image& drawn, const Image& expected, const Quantity& quantity) {
    if (quantity.error != ErrorMetric::angle || !quantity.base || !quantity.base->same_shape(expected)) return {};
    auto found = relation_of_pixels(in_frames(drawn, *quantity.base, false), in_frames(expected, *quantity.base, false),
                                    {.name = quantity.name, .error = ErrorMetric::angle});
    if (!found || found->predicted.values.empty()) return {};
    found->sentence = "in tangent space, " + found->sentence;
    found->predicted = in_frames(found->predicted, *quantity.base, true);
    return found;
}

}  // namespace

std::optional<Relation> relation_between(const Image& drawn, const Image& expected, const Quantity& quantity) {
    if (!drawn.same_shape(expected) || expected.channels < (quantity.error == ErrorMetric::angle ? 3 : 1)) return {};
    auto found = relation_of_pixels(drawn, expected, quantity);
    // A sentence without a prediction only says where the pictures differ, so the search goes on.
    const auto is_whole = [&] { return found && !found->predicted.values.empty(); };
    if (!is_whole())
        if (auto other = relation_in_tangent_space(drawn, expected, quantity)) found = std::move(other);
    if (!is_whole())
        if (auto other = relation_of_components(drawn, expected, quantity)) found = std::move(other);
    if (found && double(one_sided(drawn, expected).count()) > 0.01 * double(expected.pixel_count()))
        found->sentence += ", where both pictures have a surface";
    return found;
}

}  // namespace relief::check
