// relief map: makes normal maps, heights, occlusion, and maps of several channels, as files.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/core/base/error.h"
#include "framework/core/base/text.h"
#include "framework/core/image/file.h"
#include "framework/course/app/command.h"
#include "framework/staff/reference/normals.h"
#include "framework/staff/reference/occlusion.h"

namespace relief::app {
namespace {

constexpr double usual_depth = 0.08;  ///< of the course's reliefs, in widths of the map

/// Returns the value of `word` in a table of names. Throws UsageError that suggests the nearest name.
template <class Value, size_t count>
Value value_of(const char* what, const std::string& word, const std::pair<const char*, Value> (&table)[count]) {
    std::vector<std::string> names;
    for (const auto& [name, value] : table) {
        if (word == name) return value;
        names.emplace_back(name);
    }
    throw UsageError(unknown(what, word, names));
}

/// Returns the heights in a file as one channel. Alpha is ignored. Throws Error for a picture with colours, or for a
/// height that is not finite.
Image read_heights(const std::string& file) {
    const Image picture = read_image(file);
    Image heights(picture.width, picture.height, 1, picture.bits);
    for (size_t i = 0; i < heights.values.size(); ++i) {
        const float* texel = picture.values.data() + i * size_t(picture.channels);
        if (picture.channels >= 3 && (texel[0] != texel[1] || texel[0] != texel[2]))
            throw Error({file}, "has colours, and heights have none; `relief map heights` makes heights of a picture");
        if (!std::isfinite(texel[0])) throw Error({file}, "has a height that is not a finite number");
        heights.values[i] = texel[0];
    }
    return heights;
}

/// A channel of a file, "FILE" or "FILE:g", or a number for every texel.
struct Channel {
    Image image = {};
    int index = 0;
    double constant = 0;  ///< if the image is empty
};
Channel read_channel(const std::string& word) {
    if (const auto number = parse_number(word)) {
        if (!(*number >= 0 && *number <= 1)) throw UsageError(fmt::format("a channel of '{}': 0 to 1", word));
        return {.constant = *number};
    }
    constexpr std::string_view letters = "rgba";
    const size_t colon = word.rfind(':');
    const bool names_channel =
        colon != std::string::npos && colon + 2 == word.size() && letters.find(word.back()) != std::string::npos;
    Channel channel;
    channel.image = read_image(names_channel ? word.substr(0, colon) : word);
    channel.index = names_channel ? int(letters.find(word.back())) : 0;
    if (channel.index >= channel.image.channels)
        throw UsageError(fmt::format("{}: this picture has {} channel{}", word, channel.image.channels,
                                     channel.image.channels == 1 ? "" : "s"));
    return channel;
}

Image combined(const std::vector<std::string>& words) {
    std::vector<Channel> channels;
    const Image* first = nullptr;
    for (const std::string& word : words) channels.push_back(read_channel(word));
    for (const Channel& channel : channels) {
        if (channel.image.values.empty()) continue;
        if (!first) first = &channel.image;
        if (channel.image.width != first->width || channel.image.height != first->height)
            throw Error(fmt::format("channels of {} x {} and {} x {} texels do not fit together", first->width,
                                    first->height, channel.image.width, channel.image.height));
    }
    if (!first) throw UsageError("map combine needs a file for one channel at least");
    int bits = 8;
    for (const Channel& channel : channels)
        if (!channel.image.values.empty()) bits = std::max(bits, channel.image.bits);
    Image image(first->width, first->height, int(channels.size()), bits);
    for (size_t i = 0; i < image.pixel_count(); ++i)
        for (size_t c = 0; c < channels.size(); ++c) {
            const Channel& from = channels[c];
            image.values[i * channels.size() + c] =
                from.image.values.empty() ? float(from.constant)
                                          : from.image.values[i * size_t(from.image.channels) + size_t(from.index)];
        }
    return image;
}

/// Returns the mean and the steepest slope of a normal map, as rise over run.
std::pair<double, double> slopes_of(const Image& normals) {
    double sum = 0, most = 0;
    for (size_t i = 0; i < normals.pixel_count(); ++i) {
        const float* texel = normals.values.data() + i * 3;
        const double x = 2 * texel[0] - 1, y = 2 * texel[1] - 1, z = 2 * texel[2] - 1;
        const double slope = std::hypot(x, y) / std::max(z, 1e-9);
        sum += slope, most = std::max(most, slope);
    }
    return {sum / double(normals.pixel_count()), most};
}

struct MadeMap {
    Image image;
    std::string about;  ///< for the line that is printed
};

class MapCommand final : public Command {
public:
    void options(CommandOptions& options) override {
        options.word("KIND", kind_, "normal, heights, occlusion or combine");
        options.words("FILE", files_, "a height map, or a picture (heights); for combine 1 to 4 channels");
        options.value("-o", "FILE", output_, "the map: .png, .exr, .ppm or .pfm");
        options.value("--depth", "DEPTH", depth_, "normal, occlusion: a height of 1, in widths of the map (0.08)");
        options.value("--filter", "NAME", filter_,
                      "normal: central, forward, sobel, scharr, fourth-order or spline (central)");
        options.value("--green", "up|down", green_, "normal: where the green channel points (up)");
        options.value("--bits", "8|16", bits_, "bits of a PNG (8; 16 for heights)");
        options.value("--slices", "COUNT", slices_, "occlusion: directions that are searched (16)");
        options.flag("--no-wrap", no_wrap_, "normal: the map does not tile");
        options.footer([] {
            return std::string(
                "relief map normal stones.png -o stones_normal.png --depth 0.1\n"
                "relief map heights photo.jpg -o heights.png      brightness as a first guess of heights\n"
                "relief map occlusion stones.png -o occlusion.png openness to the sky; the map tiles\n"
                "relief map combine gloss.png stones.png occlusion.png:r 1 -o packed.png\n"
                "A channel of combine is a FILE (its first channel), FILE:r, :g, :b or :a, or a number from 0 to 1.\n"
                "Numbers are stored as they are, without a colour space. `relief inspect` says what a map is.");
        });
    }

    int run() override {
        constexpr std::pair<const char*, MadeMap (MapCommand::*)() const> kinds[] = {
            {"normal", &MapCommand::normal},
            {"heights", &MapCommand::heights},
            {"occlusion", &MapCommand::occlusion},
            {"combine", &MapCommand::combine}};
        const auto make = value_of("map", kind_, kinds);
        if (output_.empty()) throw UsageError("map needs -o FILE, the map to write");
        format_of(output_);
        const bool combines = kind_ == "combine";
        if (files_.empty() || files_.size() > (combines ? 4u : 1u))
            throw UsageError(fmt::format("map {} takes {}", kind_, combines ? "1 to 4 channels" : "one FILE"));
        auto [image, about] = (this->*make)();
        if (!bits_.empty() || kind_ == "heights") image.bits = bits();
        write_image(output_, image, {}, ColorSpace::linear);
        fmt::print("{}: {} x {}, {}{}\n", output_, image.width, image.height, about, stored(image));
        return 0;
    }

private:
    double number(const char* option, const std::string& text, double otherwise, double low, double high) const {
        if (text.empty()) return otherwise;
        const auto value = parse_number(text);
        if (!value || !(*value >= low && *value <= high))
            throw UsageError(fmt::format("{} {}: a number from {} to {}", option, text, low, high));
        return *value;
    }
    int bits() const {
        constexpr std::pair<const char*, int> choices[] = {{"8", 8}, {"16", 16}};
        return bits_.empty() ? 16 : value_of("number of bits", bits_, choices);
    }
    std::string stored(const Image& image) const {
        const ImageFormat format = format_of(output_);
        if (format == ImageFormat::exr || format == ImageFormat::pfm) return "32-bit floats";
        return format == ImageFormat::png && image.bits == 16 ? "16 bits" : "8 bits";
    }

    MadeMap normal() const {
        constexpr std::pair<const char*, bool> greens[] = {{"up", true}, {"down", false}};
        const bool is_up = green_.empty() || value_of("direction of green", green_, greens);
        const double depth = number("--depth", depth_, usual_depth, 0, 1000);
        NormalOptions options;
        options.filter = filter_.empty() ? SlopeFilter::central : value_of("filter", filter_, slope_filters);
        options.wrap = !no_wrap_;
        const Image heights = read_heights(files_[0]);
        options.texels_u = options.texels_v = depth * heights.width;
        Image normals = normals_from_heights(heights, options);
        if (!is_up)
            for (size_t i = 1; i < normals.values.size(); i += 3) normals.values[i] = 1 - normals.values[i];
        const auto [mean, most] = slopes_of(normals);
        std::string about = fmt::format("green {}, slopes {} on average and {} at most, ", is_up ? "up" : "down",
                                        rounded(mean), rounded(most));
        return {std::move(normals), std::move(about)};
    }

    MadeMap heights() const {
        const Image picture = read_image(files_[0]);
        Image made = heights_from_color(picture, ColorSpace::srgb);
        const auto [low, high] = std::minmax_element(made.values.begin(), made.values.end());
        std::string about = fmt::format("heights from {} to {}, ", rounded(double(*low)), rounded(double(*high)));
        return {std::move(made), std::move(about)};
    }

    MadeMap occlusion() const {
        const double depth = number("--depth", depth_, usual_depth, 0, 1000);
        const int slices = int(number("--slices", slices_, 16, 1, 256));
        const Image heights = read_heights(files_[0]);
        // A tile can shade itself from as far as the light of 10 degrees reaches.
        const int reach = int(std::clamp(depth * heights.width * 5.7, 1.0, double(heights.width)));
        Image open = occlusion_from_heights(heights, depth * heights.width, slices, reach);
        open.bits = 8;
        double sum = 0;
        for (const float value : open.values) sum += double(value);
        std::string about =
            fmt::format("{} % of the sky seen on average, ", rounded(100 * sum / double(open.values.size())));
        return {std::move(open), std::move(about)};
    }

    MadeMap combine() const {
        Image image = combined(files_);
        std::string about = fmt::format("{} channel{}, ", image.channels, image.channels == 1 ? "" : "s");
        return {std::move(image), std::move(about)};
    }

    std::string kind_, output_, depth_, filter_, green_, bits_, slices_;
    std::vector<std::string> files_;
    bool no_wrap_ = false;
};
RELIEF_COMMAND(MapCommand, 17, "map", "makes normal maps, heights, occlusion, and maps of several channels, as files");

}  // namespace
}  // namespace relief::app
