#include "framework/course/inspect/inspect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "framework/core/base/error.h"
#include "framework/core/base/text.h"
#include "framework/course/inspect/reading.h"
#include "framework/course/inspect/seam.h"
#include "framework/course/inspect/slopes.h"
#include "framework/course/inspect/zero.h"
#include "framework/library/maps/heights.h"

namespace relief::inspect {
namespace {

std::string percent(double share) {
    // Rounding must not turn 99.99 % into "100 %".
    if (share < 1 && share > 0.999) return "over 99.9 %";
    if (share > 0 && share < 0.001) return "under 0.1 %";
    return rounded(100 * share) + " %";
}

std::string texels(size_t count) { return fmt::format("{} texel{}", count, count == 1 ? "" : "s"); }

/// Returns whether all values are multiples of 1/255 in [0, 1], in 16-bit and float images too.
bool has_8_bit_steps(const Image& map) {
    if (map.bits == 8) return true;
    return std::all_of(map.values.begin(), map.values.end(), [](float v) {
        const double code = 255.0 * v;
        return code >= 0 && code <= 255 && std::abs(code - std::round(code)) < 1e-4;
    });
}

class Inspector {
public:
    Inspector(const Image& map, const Image* heights) : map_(map), heights_(heights), as_(recognize(map)) {
        result_.marks.resize(map.pixel_count());
        eight_bits_ = has_8_bit_steps(map);
        if (as_.kind == MapKind::normals && as_.reading.z == 2) find_order();
    }

    Inspection run() {
        kind();
        values();
        switch (as_.kind) {
            case MapKind::normals:
                normals();
                break;
            case MapKind::heights:
                heights();
                break;
            case MapKind::one_color:
            case MapKind::neither:
                break;
        }
        const bool is_height = result_.find("channel") != nullptr;
        if (!is_height && (map_.channels == 4 || (map_.channels == 2 && as_.kind == MapKind::heights))) last_channel();
        return std::move(result_);
    }

private:
    using Numbers = std::vector<std::pair<std::string, double>>;

    void add(std::string name, Outcome outcome, std::string verdict, std::string reason, Numbers numbers = {}) {
        result_.findings.push_back(
            {std::move(name), outcome, std::move(verdict), std::move(reason), std::move(numbers)});
    }
    void mark(size_t texel, Mark what) { result_.marks[texel] |= what; }
    bool covered(size_t texel) const { return !std::isnan(vectors_[texel].x); }

    /// Detects swapped channels. If all vectors face red or green, either the channels are in another order, or this is
    /// the object-space map of a flat object. The slopes distinguish x from y. A rotation of an object never mirrors
    /// its axes, so a mirrored arrangement has swapped channels. So has a mere permutation without negated axes.
    void find_order() {
        const std::optional<FacedAxis> faced = faced_axis(as_.statistics);
        if (!faced || faced->axis == 2) return;
        as_.object_space = true;
        const int axis = faced->axis, other = 1 - axis;
        Recognition tried = reordered(map_, as_, {other, 2, axis});
        std::vector<glm::vec3> vectors = vectors_of(map_, tried);
        if (tried.blue_down)
            for (glm::vec3& n : vectors) n.z = -n.z;
        const FieldTest test = test_field(slopes_of_normals(vectors, map_.width, map_.height));
        const bool swapped = std::abs(test.turned) > std::abs(test.up);
        const double field = swapped ? test.turned : test.up;
        if (test.count < 36 || test.rms < 0.002 || std::abs(field) < 0.5) return;
        if (swapped) tried = reordered(map_, as_, {2, other, axis});
        const bool cyclic = tried.reading.x == (axis + 1) % 3, turned = field < 0, down = faced->downward;
        const bool mirrored = cyclic == (turned != down), only_reordered = cyclic && !turned && !down;
        constexpr const char* colors[] = {"red", "green", "blue"};
        faced_ = fmt::format("{}{}", down ? "away from " : "", colors[axis]);
        order_ = fmt::format("x in {}, y in {}, z in {}", colors[tried.reading.x], colors[tried.reading.y],
                             colors[tried.reading.z]);
        if (!mirrored && !only_reordered) return;
        as_ = tried;
    }

    void order() {
        if (order_.empty() || as_.object_space) return;
        const bool cyclic = as_.reading.x == (as_.reading.z + 1) % 3;
        add("order", Outcome::fault, order_,
            fmt::format(
                "the channels are swapped: all vectors face {}, and the slopes of the other two are those of one "
                "height field{}. Put them in order; what follows is about that map",
                faced_, cyclic ? ". It could also be the object-space map of a flat thing that faces this axis" : ""));
    }

    void kind() {
        const VectorStatistics& s = as_.statistics;
        switch (as_.kind) {
            case MapKind::one_color:
                return one_color();
            case MapKind::heights:
                return add("kind", Outcome::note, "heights",
                           map_.channels == 1 ? "one channel: they, or another quantity of one number"
                                              : "shades of grey: they, or another quantity of one number");
            case MapKind::neither:
                return add(
                    "kind", Outcome::fault, "neither",
                    fmt::format("no heights, the channels differ; no normals, {} of the vectors have a length within "
                                "0.1 of 1",
                                percent(s.unit)),
                    {{"unit_share", s.unit}});
            case MapKind::normals:
                break;
        }
        const Numbers numbers = {{"unit_share", s.unit}, {"away_share", s.away}, {"mean_z", s.mean.z}};
        if (as_.object_space)
            add("kind", Outcome::note, "object space",
                order_.empty()
                    ? fmt::format("the normals of an object or a world: {} point to negative z. Read them without "
                                  "tangents",
                                  percent(s.away))
                    : fmt::format(
                          "the normals of something flat, such as a floor or a wall: all face {}. A tangent-space "
                          "map would have {}, and one axis turned around",
                          faced_, order_),
                numbers);
        else if (as_.reading.z < 0)
            add("kind", Outcome::note, "tangent space, two channels",
                fmt::format("x in {} and y in green: rebuild z = sqrt(1 - x² - y²)",
                            as_.reading.x == 3 ? "alpha" : "red"),
                numbers);
        else
            add("kind", Outcome::good, "tangent space",
                fmt::format("normals, {} of a length within 0.1 of 1, {} out of the surface", percent(s.unit),
                            percent(1 - s.away)),
                numbers);
    }

    void one_color() {
        const auto color = [&](int c) { return map_.values[size_t(c)]; };
        std::string shown;
        for (int c = 0; c < map_.channels; ++c)
            shown += fmt::format("{}{}", c ? ", " : "", rounded(map_.bits == 8 ? 255.0 * color(c) : color(c)));
        std::string meaning = "no direction, no slope and no seam can be told";
        Outcome outcome = Outcome::note;
        if (map_.channels >= 3) {
            const glm::dvec3 n = Reading{}.vector(map_.values.data());
            const bool flat = n.z > 0 && std::hypot(n.x, n.y) < 0.02 && std::abs(glm::length(n) - 1) < 0.02;
            const bool grey = color(0) == color(1) && color(1) == color(2);
            if (flat)
                meaning =
                    fmt::format("a flat normal map, {} degrees from straight up", rounded(angle_between(n, {0, 0, 1})));
            else if (grey)
                meaning = "flat heights; " + meaning;
            else
                outcome = Outcome::fault, meaning = "neither a flat normal, which is 128, 128, 255, nor a height";
        }
        add("kind", outcome, "one color", fmt::format("one colour ({}): {}", shown, meaning));
    }

    void values() {
        size_t not_finite = 0;
        for (size_t i = 0; i < map_.pixel_count(); ++i) {
            const float* const texel = map_.values.data() + i * size_t(map_.channels);
            if (std::all_of(texel, texel + map_.channels, [](float v) { return std::isfinite(v); })) continue;
            ++not_finite;
            mark(i, mark_not_finite);
        }
        if (not_finite > 0)
            add("finite", Outcome::fault, "no",
                fmt::format("{} hold{} infinity or NaN: every filter that reads one spreads it", texels(not_finite),
                            not_finite == 1 ? "s" : ""),
                {{"texels", double(not_finite)}});
        if (eight_bits_ && map_.bits != 8 && as_.kind != MapKind::one_color && as_.kind != MapKind::neither)
            add("bits", Outcome::note, "8-bit steps",
                fmt::format("{} bits, but all values are steps of 8 bits: the rest was lost before", map_.bits),
                {{"bits", double(map_.bits)}});
    }

    void normals() {
        vectors_ = vectors_of(map_, as_);
        order();
        stored();
        background();
        if (as_.reading.z >= 0) length();
        side();
        zero();
        if (as_.blue_down)
            for (glm::vec3& n : vectors_) n.z = -n.z;
        if (as_.object_space) {
            add("green", Outcome::unknown, "cannot tell",
                "in object space green is an axis of the object, not a direction along the map");
        } else {
            slopes_ = slopes_of_normals(vectors_, map_.width, map_.height);
            green();
            tilt();
        }
        seam();
        if (heights_) agree();
    }

    void stored() {
        if (as_.reading.is_signed)
            return add("stored", Outcome::note, "signed", "floats that hold the vector itself, not 0.5 n + 0.5");
        const Numbers numbers = {{"mean_off", as_.as_it_is.median_off}, {"decoded_off", as_.statistics.median_off}};
        const std::string off = as_.reading.z < 0
                                    ? "red and green are 0 on average only"
                                    : fmt::format("lengths are off by {} as they are, and by {}",
                                                  rounded(as_.as_it_is.median_off), rounded(as_.statistics.median_off));
        switch (as_.reading.curve) {
            case StoredCurve::none:
                return add("stored", Outcome::good, "linear", "numbers without a colour curve", numbers);
            case StoredCurve::srgb_added:
                return add("stored", Outcome::fault, "sRGB",
                           off + " after decoding sRGB: flat is 188, not 128. Export it as linear (non-colour) data",
                           numbers);
            case StoredCurve::srgb_removed:
                return add("stored", Outcome::fault, "darkened",
                           off +
                               " after encoding as sRGB: numbers that were linear have been decoded as a colour, so "
                               "flat is 55, not 128",
                           numbers);
        }
    }

    void background() {
        if (!as_.background) return;
        const auto count =
            size_t(std::count_if(vectors_.begin(), vectors_.end(), [](glm::vec3 n) { return std::isnan(n.x); }));
        const double share = double(count) / double(vectors_.size());
        add("background", Outcome::note, "one color",
            fmt::format("{} have one colour that is no normal; taken for texels that nothing covers", percent(share)),
            {{"share", share}});
    }

    void length() {
        const double allowed = eight_bits_ ? 0.02 : 0.01;
        double least = INFINITY, most = 0, sum = 0;
        size_t off = 0, far_off = 0, hopeless = 0, count = 0;
        for (size_t i = 0; i < vectors_.size(); ++i) {
            if (!covered(i)) continue;
            const double length = glm::length(glm::dvec3(vectors_[i]));
            least = std::min(least, length), most = std::max(most, length), sum += length, ++count;
            const double by = std::abs(length - 1);
            if (by > allowed) ++off;
            if (by > 0.1) ++far_off, mark(i, mark_length);
            if (length < 0.5 || length > 2) ++hopeless;
        }
        if (count == 0) return;
        const double share_off = double(off) / double(count), share_far = double(far_off) / double(count);
        const Numbers numbers = {{"least", least},
                                 {"most", most},
                                 {"mean", sum / double(count)},
                                 {"share_off", share_off},
                                 {"share_far_off", share_far}};
        const std::string range =
            fmt::format("{} to {}, {} on average", rounded(least), rounded(most), rounded(sum / double(count)));
        const char* const cause = most < 0.98 ? ": the vectors were scaled"
                                  : least > 0.97 && most > 1.15
                                      ? ": red and green were made stronger, blue was not made to fit"
                                      : "";
        if (share_far > 0.01 || hopeless > 0)
            add("length", Outcome::fault, "not unit",
                fmt::format("{}; {} of the texels are off by more than 0.1, {} shorter than 0.5 or longer than 2{}",
                            range, percent(share_far), hopeless, cause),
                numbers);
        else if (share_off > 0.01 || far_off > 0)
            add("length", Outcome::note, "nearly unit",
                fmt::format(
                    "{}; {} of the texels are off by more than {}, {} by more than 0.1, as after resizing or JPEG: "
                    "normalise after reading",
                    range, percent(share_off), rounded(allowed), far_off),
                numbers);
        else
            add("length", Outcome::good, "unit", range, numbers);
    }

    void side() {
        if (as_.object_space || as_.reading.z < 0) return;
        size_t away = 0, count = 0;
        double lowest = 1;
        for (size_t i = 0; i < vectors_.size(); ++i) {
            if (!covered(i)) continue;
            ++count;
            const double z = vectors_[i].z / std::max(1e-9f, glm::length(vectors_[i]));
            lowest = std::min(lowest, z);
            // A tangential normal, z = 0, is stored as -0.004 in 8 bits.
            if (z >= -0.01) continue;
            ++away;
            if (!as_.blue_down) mark(i, mark_side);
        }
        if (as_.blue_down)
            add("side", Outcome::fault, "blue turned", "every normal points into the surface: turn blue around, 1 - b",
                {{"texels", double(away)}});
        else if (away > 0)
            add("side", Outcome::fault, "into the surface",
                fmt::format("{} point{} into the surface (blue below 0.5), down to z = {}: no relief has such normals",
                            texels(away), away == 1 ? "s" : "", rounded(lowest)),
                {{"texels", double(away)}, {"share", double(away) / double(std::max<size_t>(count, 1))}});
    }

    void zero() {
        if (!eight_bits_ || as_.reading.curve != StoredCurve::none || as_.reading.is_signed || as_.reading.z < 0)
            return;
        const ZeroTest test = test_zero(map_);
        Numbers numbers = {{"colors", double(test.colors)}};
        for (size_t i = 0; i < zero_names.size(); ++i)
            numbers.emplace_back(std::string("off_by_") + zero_names[i], test.rms[i]);
        if (!test.best) return add("zero", Outcome::unknown, "cannot tell", test.why, numbers);
        const std::string by = fmt::format("lengths of {} different colours are off by {} (rms)", test.colors,
                                           rounded(test.rms[*test.best]));
        switch (StoredZero(*test.best)) {
            case StoredZero::half:
                return add("zero", Outcome::good, "127.5",
                           by + ": read as 2 c / 255 - 1; flat, 128, tilts by 0.32 degrees", numbers);
            case StoredZero::paired:
                return add("zero", Outcome::note, "128",
                           by + ", less than with 127.5: read as (c - 128) / 127, and flat is exact", numbers);
            case StoredZero::cut:
                return add("zero", Outcome::note, "127, cut",
                           by + ", less than with 127.5: values were cut where they should be rounded, twice the error",
                           numbers);
        }
    }

    void green() {
        const FieldTest test = test_field(slopes_);
        const Numbers numbers = {{"up", test.up}, {"turned", test.turned}, {"rms_slope", test.rms}};
        const double chance = 6 / std::sqrt(double(std::max<size_t>(test.count, 1)));
        const auto cannot = [&](const std::string& why) {
            add("green", Outcome::unknown, "cannot tell", why, numbers);
        };
        const std::string measured =
            fmt::format("mixed derivatives of the slopes agree by {} (1: up, -1: down)", rounded(test.up, 2));
        if (test.count < 36) return cannot("the map is too small");
        if (test.rms < 0.002) return cannot("the map is flat");
        if (std::abs(test.turned) > 0.5 && std::abs(test.turned) > std::abs(test.up) + 0.1) {
            axes_swapped_ = true;
            return add("green", Outcome::fault, test.turned > 0 ? "swapped" : "turned by 90 degrees",
                       test.turned > 0 ? "red and green are swapped"
                                       : "the picture was turned by 90 degrees, but not the vectors in it",
                       numbers);
        }
        if (std::abs(test.up) < std::max(0.1, chance))
            return cannot(test.across < 0.05 ? "the relief has slopes along one direction only"
                                             : measured + ": these are not the slopes of one height field");
        const bool up = test.up > 0;
        add("green", up ? Outcome::good : Outcome::fault, up ? "up" : "down",
            measured + (up ? "" : ": turn green around, 1 - g"), numbers);
        squares(up);
    }

    /// Finds squares in which green points the opposite way, for example where another map was pasted in.
    void squares(bool up) {
        const double noise = eight_bits_ ? 1 / 127.5 / std::sqrt(12.0) : 1e-5;
        const SquareTests tests = test_squares(slopes_, noise);
        size_t other = 0, telling = 0;
        for (const double one : tests.up) {
            if (std::abs(one) > 0.5) ++telling;
            if (one * (up ? -1 : 1) > 0.5) ++other;
        }
        if (other == 0) return;
        const double share = double(other) / double(telling);
        for (int y = 0; y < map_.height; ++y)
            for (int x = 0; x < map_.width; ++x)
                if (tests.up[size_t(y / tests.side * tests.columns + x / tests.side)] * (up ? -1 : 1) > 0.5)
                    mark(size_t(y) * size_t(map_.width) + size_t(x), mark_green);
        add("parts", Outcome::fault, "green differs",
            fmt::format("in {} of {} squares of {} x {} texels green points the other way, as where another map was "
                        "pasted in",
                        other, telling, tests.side, tests.side),
            {{"squares", double(other)}, {"share", share}});
    }

    void tilt() {
        double sum = 0, most = 0;
        glm::dvec2 slope{0};
        size_t count = 0;
        for (size_t i = 0; i < vectors_.size(); ++i) {
            if (!covered(i) || std::isnan(slopes_.of[i].x)) continue;
            const double angle = std::atan(glm::length(glm::dvec2(slopes_.of[i]))) * 180 / std::numbers::pi;
            sum += angle, most = std::max(most, angle), slope += glm::dvec2(slopes_.of[i]), ++count;
        }
        if (count == 0) return;
        slope /= double(count);
        const double leans = std::atan(glm::length(slope)) * 180 / std::numbers::pi;
        add("tilt", Outcome::good, rounded(sum / double(count), 2) + " degrees",
            fmt::format("mean angle to straight up; the largest is {} degrees, the mean slope leans by {}",
                        rounded(most), rounded(leans)),
            {{"mean", sum / double(count)}, {"largest", most}, {"lean", leans}});
    }

    void seam() {
        for (glm::vec3& n : vectors_)
            if (!(glm::length(n) > 0)) n = glm::vec3(NAN);
        BorderSteps sides = steps_across_sides(vectors_, map_.width, map_.height),
                    top = steps_across_top(vectors_, map_.width, map_.height);
        if (!as_.object_space) hold_to_slopes(slopes_, sides, top);
        judge_seam(sides, top, " degrees", 1);
    }

    /// A repeating relief may have a step along its border if it has such steps elsewhere. Still, its slope along the
    /// border is the same on both sides.
    void hold_to_slopes(const Slopes& slopes, BorderSteps& sides, BorderSteps& top) const {
        const auto judge = [&](BorderSteps& steps, int component, auto steps_across) {
            std::vector<float> along(slopes.of.size());
            std::transform(slopes.of.begin(), slopes.of.end(), along.begin(),
                           [&](glm::vec2 s) { return float(std::atan(s[component]) * 180 / std::numbers::pi); });
            const BorderSteps aligned = steps_across(along, map_.width, map_.height);
            steps.fits = (steps.fits || steps.across < 0.5 * steps.sharp) && aligned.fits_nearby();
        };
        using Values = std::span<const float>;
        judge(sides, axes_swapped_ ? 0 : 1, [](Values along, int w, int h) { return steps_across_sides(along, w, h); });
        judge(top, axes_swapped_ ? 1 : 0, [](Values along, int w, int h) { return steps_across_top(along, w, h); });
    }

    void judge_seam(const BorderSteps& sides, const BorderSteps& top, const std::string& unit, double scale) {
        const Numbers numbers = {{"sides", sides.across * scale},
                                 {"sides_within", sides.within * scale},
                                 {"top", top.across * scale},
                                 {"top_within", top.within * scale},
                                 {"worst", std::max(sides.worst, top.worst) * scale}};
        if (!sides.tells && !top.tells)
            return add(
                "seam", Outcome::unknown, "cannot tell",
                map_.width < 4 || map_.height < 4 ? "the map is too small" : "no texels at the border are covered",
                numbers);
        const auto steps = [&](const char* border, const BorderSteps& s) {
            return fmt::format("{}{} from {}, {} between neighbours within", rounded(s.across * scale), unit, border,
                               rounded(s.within * scale));
        };
        const std::string measured = steps("right to left", sides) + "; " + steps("bottom to top", top);
        const bool good_sides = sides.fits, good_top = top.fits;
        if (good_sides && good_top) return add("seam", Outcome::good, "none", measured, numbers);
        mark_band(!good_sides, !good_top);
        add("seam", Outcome::fault,
            good_sides ? "top and bottom"
            : good_top ? "left and right"
                       : "all around",
            measured + ": it does not repeat", numbers);
    }

    void mark_band(bool sides, bool top) {
        const int band = std::max(1, std::min(map_.width, map_.height) / 128);
        for (int y = 0; y < map_.height; ++y)
            for (int x = 0; x < map_.width; ++x)
                if ((sides && std::min(x, map_.width - 1 - x) < band) ||
                    (top && std::min(y, map_.height - 1 - y) < band))
                    mark(size_t(y) * size_t(map_.width) + size_t(x), mark_seam);
    }

    void agree() {
        if (as_.object_space)
            return add("heights", Outcome::unknown, "cannot tell",
                       "normals in object space cannot be compared with heights without the model");
        const Recognition theirs = recognize(*heights_);
        if (theirs.kind == MapKind::normals)
            return add("heights", Outcome::fault, "normals", "the second file holds normals, not heights");
        if (theirs.kind == MapKind::one_color)
            return add("heights", Outcome::unknown, "cannot tell", "the heights are all the same");
        Image heights;
        try {
            heights = heights_in(*heights_).image;
        } catch (const Error& error) {
            return add("heights", Outcome::fault, "no heights", fmt::format("the second file {}", error.what()));
        }
        const Agreement as = agreement(slopes_, heights, 0, 1);
        Numbers numbers = {{"correlation", as.correlation}, {"strength", as.strength}};
        const std::string measured = fmt::format("slopes agree by {}", rounded(as.correlation, 2));
        if (!as.comparable)
            return add("heights", Outcome::unknown, "cannot tell",
                       fmt::format("the heights have {} x {} texels: not this size times a power of two, or without "
                                   "slopes",
                                   heights_->width, heights_->height),
                       numbers);
        if (as.correlation < 0.5)
            return add("heights", Outcome::fault, "differ", measured + " (1: exactly): they do not belong together",
                       numbers);
        if (as.layout != Layout{}) {
            std::string how;
            if (as.layout.transposed) how = "transposed (rows and columns exchanged)";
            if (as.layout.mirrored_u) how += std::string(how.empty() ? "" : ", ") + "mirrored left to right";
            if (as.layout.mirrored_v) how += std::string(how.empty() ? "" : ", ") + "mirrored top to bottom";
            return add("heights", Outcome::fault, "mirrored or turned",
                       fmt::format("{} with the heights {}: one of the two pictures was turned", measured, how),
                       numbers);
        }
        if (as.channels != Channels{})
            return add("heights", Outcome::fault, verdict_of(as.channels),
                       fmt::format("{} when {}", measured, words_of(as.channels)), numbers);
        compare(as, heights, numbers, measured);
    }

    static std::string verdict_of(const Channels& channels) {
        if (channels.swapped) return "red and green swapped";
        if (channels.red_turned && channels.green_turned) return "inverted";
        return channels.green_turned ? "green turned" : "red turned";
    }
    static std::string words_of(const Channels& channels) {
        if (!channels.swapped && channels.red_turned && channels.green_turned)
            return "the heights are inverted: depths, or white is below";
        std::vector<std::string> words;
        if (channels.swapped) words.push_back("red and green are swapped");
        if (channels.red_turned) words.push_back("red is turned around");
        if (channels.green_turned) words.push_back("green is turned around");
        return join(words, " and ");
    }

    void compare(const Agreement& as, const Image& heights, Numbers numbers, const std::string& measured) {
        if (heights.width != map_.width)
            return add("heights", Outcome::good, "agree",
                       fmt::format("{}; a height of 1 is {} texels of the map", measured, rounded(as.strength)),
                       numbers);
        const Slopes theirs = slopes_of_heights(heights, 0, 1);
        double sum = 0;
        size_t count = 0;
        std::vector<double> angles(vectors_.size(), NAN);
        for (size_t i = 0; i < angles.size(); ++i) {
            if (std::isnan(theirs.of[i].x) || std::isnan(slopes_.of[i].x)) continue;
            const glm::dvec2 a = slopes_.of[i], b = as.strength * glm::dvec2(theirs.of[i]);
            angles[i] = angle_between({-a.x, -a.y, 1}, {-b.x, -b.y, 1});
            sum += angles[i], ++count;
        }
        const double mean = count ? sum / double(count) : 0;
        for (size_t i = 0; i < angles.size(); ++i)
            if (angles[i] > std::max(5.0, 4 * mean)) mark(i, mark_heights);
        numbers.emplace_back("mean_angle", mean);
        const bool close = as.correlation > 0.9;
        add("heights", close ? Outcome::good : Outcome::note, close ? "agree" : "agree roughly",
            fmt::format("{}; a height of 1 is {} texels, {} degrees are left on average{}", measured,
                        rounded(as.strength), rounded(mean),
                        close ? "" : ": details were added to one of them, or another filter made the normals"),
            numbers);
    }

    void heights() {
        Heights found;
        try {
            found = heights_in(map_);
        } catch (const Error&) {
            return;  // no texel has a height, as values() says
        }
        double low = INFINITY, high = -INFINITY;
        const size_t step = size_t(map_.channels);
        std::vector<float> values;
        values.reserve(map_.pixel_count());
        size_t voids = 0;
        for (size_t i = 0; i < map_.pixel_count(); ++i) {
            const float value = map_.values[i * step + size_t(found.channel)];
            const bool is_void = !found.voids.empty() && found.voids[i];
            values.push_back(is_void ? NAN : value);
            if (is_void) mark(i, mark_not_finite), ++voids;
            if (!is_void) low = std::min<double>(low, value), high = std::max<double>(high, value);
        }
        if (found.channel > 0)
            add("channel", Outcome::note, found.channel == 1 ? "second" : "fourth",
                "the heights are in this channel: the others are all one colour", {{"channel", double(found.channel)}});
        for (const std::string& note : found.notes)
            if (note.find("far from all others") != std::string::npos)
                add("voids", voids > found.not_finite ? Outcome::fault : Outcome::note, "marked", note,
                    {{"texels", double(voids - found.not_finite)}});
        if (!(high > low)) return;
        const bool beyond = low < 0 || high > 1;
        add("range", beyond ? Outcome::note : Outcome::good, fmt::format("{} to {}", rounded(low), rounded(high)),
            beyond ? "heights beyond 0 and 1: this course scales them to 0 to 1; a texture of integers cuts them off"
                   : fmt::format("{} of what can be stored", percent(high - low)),
            {{"low", low}, {"high", high}});
        if (map_.bits == 8)
            add("bits", Outcome::note, "8",
                "8 bits: smooth slopes come out in steps when normals are made of these heights");
        BorderSteps sides = steps_across_sides(values, map_.width, map_.height),
                    top = steps_across_top(values, map_.width, map_.height);
        judge_seam(sides, top, " % of the range", 100 / (high - low));
        if (heights_) swapped_files();
    }

    void swapped_files() {
        const bool swapped = recognize(*heights_).kind == MapKind::normals;
        add("heights", Outcome::fault, swapped ? "swapped files" : "two of heights",
            swapped ? "the first file holds heights and the second normals: give the normals first"
                    : "the first file holds heights, too: there are no normals to compare with");
    }

    void last_channel() {
        const int last = map_.channels - 1;
        if (as_.kind == MapKind::normals && as_.reading.x == last) return;
        double low = INFINITY, high = -INFINITY;
        for (size_t i = size_t(last); i < map_.values.size(); i += size_t(map_.channels))
            if (std::isfinite(map_.values[i]))
                low = std::min<double>(low, map_.values[i]), high = std::max<double>(high, map_.values[i]);
        const Numbers numbers = {{"low", low}, {"high", high}};
        if (!(high > low))
            return add("fourth", Outcome::good, "constant",
                       fmt::format("the last channel is {} everywhere", rounded(low)), numbers);
        std::string meaning = "opacity, gloss, or another quantity";
        if (as_.kind == MapKind::normals && !as_.object_space)
            if (const Agreement as = agreement(slopes_, map_, last, 1); as.correlation > 0.8)
                meaning = fmt::format("heights of this relief: slopes agree by {}{}", rounded(as.correlation, 2),
                                      as.channels == Channels{} ? "" : " when " + words_of(as.channels));
        add("fourth", Outcome::note, "varies",
            fmt::format("the last channel runs from {} to {}: {}", rounded(low), rounded(high), meaning), numbers);
    }

    const Image& map_;
    const Image* heights_;
    Recognition as_;
    bool eight_bits_ = false;
    bool axes_swapped_ = false;  ///< red is along v
    std::string order_;          ///< order of the channels, in words; empty for red, green, blue
    std::string faced_;          ///< the colour that all vectors face, in words
    std::vector<glm::vec3> vectors_;
    Slopes slopes_;
    Inspection result_;
};

}  // namespace

int Inspection::faults() const {
    return int(
        std::count_if(findings.begin(), findings.end(), [](const Finding& f) { return f.outcome == Outcome::fault; }));
}

const Finding* Inspection::find(const std::string& name) const& {
    for (const Finding& finding : findings)
        if (finding.name == name) return &finding;
    return nullptr;
}

Inspection inspect(const Image& map, const Image* heights) { return Inspector(map, heights).run(); }

}  // namespace relief::inspect
