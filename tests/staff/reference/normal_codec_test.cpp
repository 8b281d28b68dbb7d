// The error of each normal-map format: published means and maxima, and inputs at which codecs fail.
#include "framework/staff/reference/normal_codec.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <vector>

#include "framework/core/base/parallel.h"
#include "framework/core/image/color.h"
#include "framework/staff/reference/degrees.h"
#include "framework/staff/reference/half.h"

namespace relief {

static void PrintTo(NormalFormat format, std::ostream* stream) { *stream << info_of(format).name; }

namespace {

using Coding = NormalFormat;

double round_trip(Coding encoder, Coding decoder, glm::dvec3 normal) {
    return degrees_between(decode_normal(decoder, encode_normal(encoder, normal)), normal);
}
double round_trip(Coding format, glm::dvec3 normal) { return round_trip(format, format, normal); }

struct Cost {
    double mean = 0, largest = 0;
};

/// Measures the error over directions that are uniform on the part of the sphere with z >= lowest. By Archimedes, z is
/// uniform.
Cost cost(Coding encoder, Coding decoder, double lowest, int count) {
    constexpr int pieces = 16;  // each with its own seed, so that the result does not depend on the threads
    std::vector<Cost> costs(pieces);
    parallel_pieces(pieces, 1, 0, [&](size_t begin, size_t end) {
        for (size_t piece = begin; piece < end; ++piece) {
            std::mt19937_64 random(100 + piece);
            std::uniform_real_distribution<> z_of(lowest, 1), turn_of(0, 2 * M_PI);
            for (int i = 0; i < count / pieces; ++i) {
                const double z = z_of(random), turn = turn_of(random), r = std::sqrt(1 - z * z);
                const double error = round_trip(encoder, decoder, {r * std::cos(turn), r * std::sin(turn), z});
                costs[piece].mean += error / (count / pieces * pieces);
                costs[piece].largest = std::max(costs[piece].largest, error);
            }
        }
    });
    Cost all;
    for (const Cost& one : costs) all.mean += one.mean, all.largest = std::max(all.largest, one.largest);
    return all;
}

constexpr double whole_sphere = -1, hemisphere = 0, cone60 = 0.5;
constexpr int samples = 500'000;

TEST(NormalFormat, HasTheErrorPublishedByCigolleEtAl) {
    // "A Survey of Efficient Representations for Independent Unit Vectors", JCGT 3(2), 2014: mean and maximum in
    // degrees.
    struct Row {
        Coding format;
        double mean, largest;
    };
    for (const Row& row : {Row{Coding::oct8, 0.33709, 0.94424}, Row{Coding::snorm8, 0.17015, 0.38588},
                           Row{Coding::oct12, 0.02091, 0.05874}, Row{Coding::oct8_precise, 0.31485, 0.63575},
                           Row{Coding::oct12_precise, 0.01953, 0.03928}, Row{Coding::oct16, 0.00131, 0.00366},
                           Row{Coding::oct16_precise, 0.00122, 0.00246}}) {
        const Cost measured = cost(row.format, row.format, whole_sphere, samples);
        // The mean of 200,000 samples varies by 0.1 %, and the last row is printed with three digits. A sampled maximum
        // is a lower bound: here with fewer samples than theirs, elsewhere up to 0.8 % above.
        EXPECT_NEAR(measured.mean, row.mean, 0.005 * row.mean + 0.000005) << testing::PrintToString(row.format);
        EXPECT_GE(measured.largest, 0.99 * row.largest) << testing::PrintToString(row.format);
        EXPECT_LE(measured.largest, 1.015 * row.largest) << testing::PrintToString(row.format);
    }
}

TEST(NormalFormat, HasTheKnownErrorOnSphereHemisphereAndCone) {
    struct Row {
        Coding encoder, decoder;
        double part, mean, largest;
    };
    // Measured once with 2,000,000 vectors by an independent program.
    for (const Row& row : {Row{Coding::unorm8, Coding::unorm8, whole_sphere, 0.16962, 0.38646},
                           Row{Coding::unorm8, Coding::unorm8, cone60, 0.16943, 0.38571},
                           Row{Coding::paired8, Coding::paired8, whole_sphere, 0.17016, 0.38681},
                           Row{Coding::paired8, Coding::unorm8, whole_sphere, 0.34046, 0.77520},
                           Row{Coding::unorm8_truncated, Coding::unorm8, whole_sphere, 0.33911, 0.76880},
                           Row{Coding::rg8, Coding::rg8, hemisphere, 0.46714, 5.91003},
                           Row{Coding::rg8, Coding::rg8, cone60, 0.20699, 0.62379},
                           Row{Coding::rg16, Coding::rg16, hemisphere, 0.00298, 0.35770},
                           Row{Coding::rg16, Coding::rg16, cone60, 0.00081, 0.00240},
                           Row{Coding::oct8, Coding::oct8, whole_sphere, 0.33691, 0.95169},
                           Row{Coding::oct8, Coding::oct8, cone60, 0.34509, 0.95354},
                           Row{Coding::oct8_precise, Coding::oct8_precise, whole_sphere, 0.31479, 0.63501},
                           Row{Coding::oct8_precise, Coding::oct8_precise, cone60, 0.32442, 0.63491}}) {
        // Maxima of codecs that store x, y and z separately are rare, and rarest at the horizon. These codecs get more
        // samples.
        const bool is_octahedral = info_of(row.decoder).name.starts_with("oct");
        const Cost measured = cost(row.encoder, row.decoder, row.part, is_octahedral ? samples : 4 * samples);
        SCOPED_TRACE(testing::PrintToString(row.encoder) + " to " + testing::PrintToString(row.decoder));
        EXPECT_NEAR(measured.mean, row.mean, 0.005 * row.mean + 0.000005);
        EXPECT_GE(measured.largest, 0.99 * row.largest);
        // At the rim of the cone, half a step in x and in y is 2 sqrt(2) / 65535, or 0.00247 degrees: 3 % above the
        // table's value.
        EXPECT_LE(measured.largest, (row.decoder == Coding::rg16 ? 1.031 : 1.015) * row.largest);
    }
}

/// Returns the values at which the code of a component changes, in ascending order.
std::vector<double> borders_of(Coding format) {
    std::vector<double> borders;
    if (format == Coding::half) {
        // A component below 1/4 rounds by 2^-14 at most, and two others by 2^-12: together 0.0202 degrees. So the
        // largest error is that of components above 1/4. Signs make no difference.
        for (double x = 0.25; x < 1; x += x < 0.5 ? 0x1p-12 : 0x1p-11)
            borders.push_back(x + (x < 0.5 ? 0x1p-13 : 0x1p-12));
        return borders;
    }
    const bool is_symmetric = format == Coding::snorm8 || format == Coding::paired8;
    const double last = is_symmetric ? 254 : (1 << info_of(format).bits) - 1;
    const double first = format == Coding::unorm8_truncated ? 2 : 1;
    for (int i = 0; i < last; ++i) borders.push_back((2 * i + first) / last - 1);
    return borders;
}

/// Searches for the largest error of a format that stores components, in degrees. The directions of one code are a
/// piece of the sphere between planes of constant x, y or z. On the circle where a plane cuts the sphere, the angle to
/// a vector has one maximum, opposite to the vector. So the farthest direction of a piece is a corner: there two
/// components change their codes, or z is 0 and another component changes. All components are encoded alike, so these
/// two are x and y, and x is the larger one.
double largest_by_components(Coding encoder, Coding decoder) {
    constexpr double nearby = 1e-11;
    const bool has_z = info_of(encoder).channels == 3;
    const std::vector<double> borders = borders_of(encoder);
    std::vector<double> errors(borders.size());
    parallel_each(borders.size(), 0, [&](size_t i) {
        const auto look_around = [&](double x, double y) {
            for (const double at_x : {x - nearby, x + nearby})
                for (const double at_y : {y - nearby, y + nearby})
                    if (const double z = std::sqrt(1 - at_x * at_x - at_y * at_y); z >= 0) {
                        errors[i] = std::max(errors[i], round_trip(encoder, decoder, {at_x, at_y, z}));
                        if (has_z) errors[i] = std::max(errors[i], round_trip(encoder, decoder, {at_x, at_y, -z}));
                    }
        };
        const double rim = std::sqrt(1 - borders[i] * borders[i]);
        const auto last = std::upper_bound(borders.begin(), borders.end(), std::min(rim, borders[i]));
        // A column of rg16 has 65,535 borders. Its error grows towards the rim, so the eight nearest are enough.
        const auto count =
            encoder == Coding::rg16 ? std::min<ptrdiff_t>(8, last - borders.begin()) : last - borders.begin();
        for (auto y = last - count; y != last; ++y) look_around(borders[i], *y);
        if (!has_z) look_around(borders[i], rim - 3 * nearby);
    });
    return *std::max_element(errors.begin(), errors.end());
}

/// The same for an octahedral format. The directions within an angle of a vector cut a face of the octahedron in a
/// convex region, so the farthest point of a polygon is a corner. The faces cut the square cells at the cells' corners
/// and at the middles of their edges. With more than 8 bits only the middle of a face is searched, where a step of p is
/// the widest angle.
double largest_octahedral(Coding format) {
    constexpr double nearby = 1e-11;
    const int last = (1 << (info_of(format).bits - 1)) - 1;
    std::vector<double> errors(size_t(2 * last) + 1);
    parallel_each(errors.size(), 0, [&](size_t i) {
        const bool is_searched = last == 127 || std::abs(double(i) - 2.0 * last / 3) < 10;
        for (size_t j = last == 127 ? 0 : i - 10; is_searched && j <= i;
             ++j)  // x and y, and the signs of all three, make no difference
            for (const double dx : {-nearby, nearby})
                for (const double dy : {-nearby, nearby}) {
                    const glm::dvec2 p(double(i) / (2 * last) + dx, double(j) / (2 * last) + dy);
                    const double z = 1 - std::abs(p.x) - std::abs(p.y);
                    if (p.x > 1) continue;
                    const glm::dvec3 n = z >= 0 ? glm::dvec3(p, z) : glm::dvec3(1 - p.y, 1 - p.x, z);
                    errors[i] = std::max(errors[i], round_trip(format, n));
                }
    });
    return *std::max_element(errors.begin(), errors.end());
}

TEST(NormalFormat, HasTheLargestErrorAtACornerOfACodesDirections) {
    struct Row {
        Coding encoder, decoder;
        double largest;
    };
    // A sample of two million directions finds 0.387, 0.769, 0.387, 0.387, 0.775, 5.91, 0.358, 0.0224, 0.952,
    // 0.0590 and 0.00369.
    for (const Row& row :
         {Row{Coding::unorm8, Coding::unorm8, 0.3889}, Row{Coding::unorm8_truncated, Coding::unorm8, 0.7777},
          Row{Coding::snorm8, Coding::snorm8, 0.3904}, Row{Coding::paired8, Coding::paired8, 0.3904},
          Row{Coding::paired8, Coding::unorm8, 0.7811}, Row{Coding::rg8, Coding::rg8, 5.9597},
          Row{Coding::rg16, Coding::rg16, 0.3759}, Row{Coding::half, Coding::half, 0.02379},
          Row{Coding::oct8, Coding::oct8, 0.9570}, Row{Coding::oct12, Coding::oct12, 0.05938},
          Row{Coding::oct16, Coding::oct16, 0.003709}}) {
        const bool is_octahedral = info_of(row.decoder).name.starts_with("oct");
        const double largest =
            is_octahedral ? largest_octahedral(row.encoder) : largest_by_components(row.encoder, row.decoder);
        EXPECT_NEAR(largest, row.largest, 0.0002 * row.largest)
            << testing::PrintToString(row.encoder) << " to " << testing::PrintToString(row.decoder);
    }
}

TEST(NormalFormat, HalfIsWithinHalfAStepOfEachComponent) {
    // The error of a component below 1 is at most 2^-12. Three components tilt the normal by at most sqrt(3) times
    // that, 0.0242 degrees.
    const Cost measured = cost(Coding::half, Coding::half, whole_sphere, samples);
    EXPECT_LT(measured.largest, glm::degrees(std::sqrt(3) * 0x1p-12));
    EXPECT_GT(measured.largest, glm::degrees(0x1p-12)) << "or it keeps more bits than it should";
}

TEST(NormalFormat, KeepsAFlatTexelOrTiltsItByTheErrorOfItsZeroCode) {
    const glm::dvec3 flat(0, 0, 1);
    for (const NormalFormatInfo& info : normal_formats()) {
        const double error = round_trip(info.format, flat);
        // In unorm, 0 is half-way between two codes: an error of 1/255 (or 1/65535) in x and in y.
        if (info.format == Coding::unorm8 || info.format == Coding::unorm8_truncated || info.format == Coding::rg8)
            EXPECT_NEAR(error, glm::degrees(std::atan(std::sqrt(2) / 255)), 1e-5) << info.name;
        else if (info.format == Coding::rg16)
            EXPECT_NEAR(error, glm::degrees(std::atan(std::sqrt(2) / 65535)), 1e-9) << info.name;
        else
            EXPECT_EQ(error, 0) << info.name;
    }
    EXPECT_NEAR(round_trip(Coding::paired8, Coding::unorm8, flat), 0.3178, 5e-5) << "the mismatched pair";
}

TEST(NormalFormat, LoadedAsSrgbOrWithGreenDownHasTheErrorOfTheHandout) {
    const auto read = [](double code) { return 2 * linear_from_srgb(code / 255) - 1; };
    EXPECT_NEAR(read(128), -0.57, 0.005) << "in place of 0";
    EXPECT_NEAR(degrees_between({read(128), read(128), read(255)}, {0, 0, 1}), 38.8, 0.05);
    for (const double lean : {5.0, 20.0, 45.0}) {
        const double a = glm::radians(lean);
        EXPECT_NEAR(degrees_between({0, -std::sin(a), std::cos(a)}, {0, std::sin(a), std::cos(a)}), 2 * lean, 1e-9);
    }
}

TEST(NormalFormat, KeepsTheAxesAndTheFoldsOfTheOctahedronWithEitherSignOfZero) {
    const double r = std::sqrt(0.5);
    for (const NormalFormatInfo& info : normal_formats()) {
        const bool upper_only = info.format == Coding::rg8 || info.format == Coding::rg16;
        const bool octahedral = info.name.starts_with("oct");
        for (const double zero : {0.0, -0.0})
            for (const double one : {1.0, -1.0})
                for (const glm::dvec3 n :
                     {glm::dvec3(zero, zero, one), glm::dvec3(zero, one, zero), glm::dvec3(one, zero, zero),
                      glm::dvec3(one * r, zero, -r), glm::dvec3(zero, one * r, -r), glm::dvec3(one * r, -r, zero)}) {
                    if (upper_only && n.z < 0) continue;
                    const double error = round_trip(info.format, n);
                    // Axes have codes of their own. Half of 127 is not a whole number: half a step in both channels is
                    // 0.643 degrees.
                    const bool axis = std::abs(n.x) + std::abs(n.y) + std::abs(n.z) == 1;
                    const double allowed = octahedral ? axis ? 1e-13 : 0.65 : upper_only ? 6 : 0.8;
                    EXPECT_LE(error, allowed) << info.name << " " << n.x << " " << n.y << " " << n.z;
                }
    }
}

TEST(NormalFormat, RebuildsZAtTheHorizonWithoutNanWithTheExpectedError) {
    double largest = 0;
    for (double degrees = 0; degrees <= 10; degrees += 0.001) {
        const double t = glm::radians(degrees);
        const double error = round_trip(Coding::rg8, {std::cos(t), 0, std::sin(t)});
        ASSERT_TRUE(std::isfinite(error)) << degrees;
        largest = std::max(largest, error);
    }
    EXPECT_GT(largest, 4.5);
    EXPECT_LT(largest, 6);
}

TEST(NormalFormat, MinusOneHasTwoCodesInSnorm) {
    EXPECT_EQ(decode_normal(Coding::snorm8, {{0x80, 0, 0}}), glm::dvec3(-1, 0, 0));
    EXPECT_EQ(decode_normal(Coding::snorm8, {{0x81, 0, 0}}), glm::dvec3(-1, 0, 0));
    EXPECT_EQ(decode_normal(Coding::snorm8, {{0x80, 0x81, 0}}), decode_normal(Coding::snorm8, {{0x81, 0x80, 0}}));
    EXPECT_EQ(encode_normal(Coding::snorm8, {-1, 0, 0}), (NormalCode{{0x81, 0, 0}}));
}

TEST(NormalFormat, EncodesADirectionOfAnyLength) {
    const glm::dvec3 direction(3, -5, 7);  // exact also in denormals
    for (const NormalFormatInfo& info : normal_formats())
        for (const double length : {1e-300, 1e-20, 1e20, 1e300, 0x1p-1060})
            EXPECT_EQ(encode_normal(info.format, length * direction), encode_normal(info.format, direction))
                << info.name << " " << length;
    EXPECT_EQ(encode_normal(Coding::unorm8, {0, 0, 5e-324}), encode_normal(Coding::unorm8, {0, 0, 1})) << "a denormal";
}

TEST(NormalFormat, EncodesAVectorWithoutDirectionAsStraightUp) {
    const double nan = std::nan(""), endless = std::numeric_limits<double>::infinity();
    for (const NormalFormatInfo& info : normal_formats())
        for (const glm::dvec3 none : {glm::dvec3(0), glm::dvec3(-0.0), glm::dvec3(nan, 0, 1), glm::dvec3(0, endless, 0),
                                      glm::dvec3(0, 0, -endless)})
            EXPECT_EQ(encode_normal(info.format, none), encode_normal(info.format, {0, 0, 1})) << info.name;
    EXPECT_EQ(decode_normal(Coding::snorm8, {}), glm::dvec3(0, 0, 1));
    EXPECT_EQ(decode_normal(Coding::half, {{0x7e00, 0, 0}}), glm::dvec3(0, 0, 1)) << "a NaN";
    EXPECT_EQ(decode_normal(Coding::half, {{0, 0, 0}}), glm::dvec3(0, 0, 1));
}

TEST(NormalFormat, DecodesEveryCodeToAUnitVector) {
    const unsigned seed = 12;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    for (const NormalFormatInfo& info : normal_formats())
        for (int i = 0; i < 20000; ++i) {
            NormalCode code;
            for (int c = 0; c < info.channels; ++c)
                code.channel[size_t(c)] = uint16_t(random() & ((1u << info.bits) - 1));
            ASSERT_NEAR(glm::length(decode_normal(info.format, code)), 1, 1e-12) << info.name;
        }
}

TEST(NormalFormat, RoundTripsOctahedralCodesExceptDuplicates) {
    // On the rim of the square, where an edge is folded onto itself, two codes are one direction. Also, -128 means
    // -127.
    for (int x = -126; x <= 126; ++x)
        for (int y = -126; y <= 126; ++y) {
            const NormalCode code{{uint16_t(x & 255), uint16_t(y & 255)}};
            ASSERT_EQ(encode_normal(Coding::oct8, decode_normal(Coding::oct8, code)), code) << x << ", " << y;
            ASSERT_EQ(encode_normal(Coding::oct8_precise, decode_normal(Coding::oct8, code)), code) << x << ", " << y;
        }
}

TEST(NormalFormat, ThePreciseEncoderIsNeverWorse) {
    std::mt19937 random(13);
    std::normal_distribution<> bell;
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 n = glm::normalize(glm::dvec3(bell(random), bell(random), bell(random)));
        EXPECT_LE(round_trip(Coding::oct8_precise, n), round_trip(Coding::oct8, n) + 1e-12);
        EXPECT_LE(round_trip(Coding::oct16_precise, n), round_trip(Coding::oct16, n) + 1e-12);
    }
}

TEST(NormalFormat, HasADistinctNameAtItsIndex) {
    std::map<std::string_view, int> names;
    for (const NormalFormatInfo& info : normal_formats()) {
        EXPECT_EQ(&info_of(info.format), &info);
        EXPECT_EQ(++names[info.name], 1) << info.name;
    }
}

TEST(Half, RoundTripsEveryBitPattern) {
    for (int bits = 0; bits < 65536; ++bits) {
        const double value = double_from_half(uint16_t(bits));
        if (std::isnan(value))
            EXPECT_TRUE(std::isnan(double_from_half(half_from_double(value))));
        else
            ASSERT_EQ(half_from_double(value), bits) << value;
    }
}

TEST(Half, RoundsToTheNearestAndTiesToEven) {
    EXPECT_EQ(half_from_double(1), 0x3c00);
    EXPECT_EQ(half_from_double(-2), 0xc000);
    EXPECT_EQ(half_from_double(1 + 0x1p-11), 0x3c00) << "a tie, down to even";
    EXPECT_EQ(half_from_double(1 + 0x3p-11), 0x3c02) << "a tie, up to even";
    EXPECT_EQ(half_from_double(1 + 0x1p-11 + 0x1p-40), 0x3c01);
    EXPECT_EQ(half_from_double(2 - 0x1p-12), 0x4000) << "carries into the exponent";
    EXPECT_EQ(half_from_double(65519.99), 0x7bff);
    EXPECT_EQ(half_from_double(65520), 0x7c00);
    EXPECT_EQ(half_from_double(-1e300), 0xfc00);
    EXPECT_EQ(half_from_double(0x1p-25), 0) << "a tie, down to zero";
    EXPECT_EQ(half_from_double(0x1.8p-25), 1);
    EXPECT_EQ(half_from_double(0x1p-14 - 0x1p-26), 0x0400) << "from denormal to normal";
    EXPECT_EQ(half_from_double(-0.0), 0x8000);
}

}  // namespace
}  // namespace relief
