// relief map: makes normal maps, heights, occlusion, gloss, maps of several channels, blocks of BC5, and baked maps, as
// files.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/log.h"
#include "framework/core/base/text.h"
#include "framework/core/image/color.h"
#include "framework/core/image/color_profile.h"
#include "framework/core/image/file.h"
#include "framework/core/image/png.h"
#include "framework/course/app/command.h"
#include "framework/course/app/shot_options.h"
#include "framework/library/maps/heights.h"
#include "framework/library/mesh/model.h"
#include "framework/library/mesh/tangents.h"
#include "framework/staff/reference/ambient_occlusion.h"
#include "framework/staff/reference/bake.h"
#include "framework/staff/reference/bc5.h"
#include "framework/staff/reference/normals.h"

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

/// Returns the picture in a file, and prints a note if its colour profile is not applied.
Image read_picture(const std::string& file, bool is_map) {
    Image picture = read_image(file);
    if (const std::string note = profile_note(picture, is_map); !note.empty()) print_note(note_about({file}, note));
    return picture;
}

/// Returns the heights in a file, and prints what was done to them on standard error.
Image read_heights(const std::string& file) {
    Image picture = read_image(file);
    try {
        Heights found = heights_in(std::move(picture));
        for (const std::string& note : found.notes) print_note(note_about({file}, note));
        return std::move(found.image);
    } catch (const Error& error) {
        throw Error({file}, error.what());
    }
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
    channel.image = read_picture(names_channel ? word.substr(0, colon) : word, true);
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

/// The mean and the steepest slope of a normal map, as rise over run.
class SlopeSums {
public:
    /// Adds `count` texels of three channels.
    void add(const float* texels, size_t count) {
        for (size_t i = 0; i < count; ++i) {
            const float* const texel = texels + i * 3;
            const double x = 2 * texel[0] - 1, y = 2 * texel[1] - 1, z = 2 * texel[2] - 1;
            const double slope = std::sqrt(x * x + y * y) / std::max(z, 1e-9);
            sum_ += slope, most_ = std::max(most_, slope);
        }
        count_ += count;
    }
    double mean() const { return sum_ / double(count_); }
    double most() const { return most_; }

private:
    double sum_ = 0, most_ = 0;
    size_t count_ = 0;
};

/// Normals of heights, row by row from the top. Of all filters but the spline's it keeps only some rows.
class NormalRows {
public:
    NormalRows(const Image& heights, const NormalOptions& options, bool is_up)
        : heights_(heights), options_(options), is_up_(is_up) {
        if (options.filter == SlopeFilter::spline) rows_ = normals_from_heights(heights, options);
    }
    /// Precondition: y is 0, or 1 more than in the last call.
    float* row(int y) {
        if (options_.filter != SlopeFilter::spline && y >= end_) {
            begin_ = end_, end_ = std::min(begin_ + 128, heights_.height);
            rows_ = Image(heights_.width, end_ - begin_, 3, 8);
            normals_of_rows(heights_, options_, begin_, rows_);
        }
        float* const row = rows_.pixel(0, y - begin_);
        for (int x = 0; x < (is_up_ ? 0 : heights_.width); ++x) row[3 * x + 1] = 1 - row[3 * x + 1];
        sums_.add(row, size_t(heights_.width));
        return row;
    }
    const SlopeSums& slopes() const { return sums_; }

private:
    const Image& heights_;
    const NormalOptions& options_;
    const bool is_up_;
    Image rows_;  ///< from begin_ to end_, or all
    int begin_ = 0, end_ = 0;
    SlopeSums sums_;
};

/// Returns a guess of the gloss of a picture: its relative luminance (Rec. 709) in linear light, from 0 to 1. So bright
/// places count as smooth; `inverted`, as rough. A picture does not show its gloss: a bright place may as well be
/// chalk. Pictures of 8 and 16 bits are read as sRGB, and floats as light. Alpha is ignored. Throws Error without a
/// place for a value that is not finite.
Image gloss_from_color(const Image& picture, bool inverted) {
    Image gloss(picture.width, picture.height, 1, picture.bits);
    const auto light_of = [&](float stored) {
        return picture.bits == 32 ? double(stored) : linear_from_srgb(double(stored));
    };
    for (size_t i = 0; i < gloss.values.size(); ++i) {
        const float* texel = picture.values.data() + i * size_t(picture.channels);
        const double light = picture.channels >= 3 ? 0.2126 * light_of(texel[0]) + 0.7152 * light_of(texel[1]) +
                                                         0.0722 * light_of(texel[2])
                                                   : light_of(texel[0]);
        if (!std::isfinite(light)) throw Error("has a value that is not a finite number");
        const double bright = std::clamp(light, 0.0, 1.0);
        gloss.values[i] = float(inverted ? 1 - bright : bright);
    }
    return gloss;
}

/// Returns the coarse model of a bake, with the tangents in its file, or else those of MikkTSpace.
Model read_coarse(const std::string& file) {
    Model model = read_model(file);
    constexpr const char* why = "they are the places of its surface on the map";
    if (!model.has_uvs) throw Error({file}, fmt::format("has no uv: {}", why));
    if (model.line_without_uv > 0)
        throw Error({file, model.line_without_uv}, fmt::format("this face has corners without uv (vt): {}", why));
    if (!model.tangents_follow_uv) model.mesh = with_tangents(model.mesh, TangentMethod::mikktspace);
    return model;
}

/// Shows the progress of work in parts.
class PartProgress {
public:
    explicit PartProgress(const char* what) : what_(what) {}
    std::function<void(int, int)> before_part() {
        return [this](int, int parts) {
            if (!progress_) progress_.emplace(parts);
            progress_->next(what_);
        };
    }

private:
    const char* what_;
    std::optional<Progress> progress_;
};

struct MadeMap {
    Image image;
    std::string about;       ///< for the line that is printed
    std::string bytes = {};  ///< the file, if it is none of write_image(); the image has its size then
};

class MapCommand final : public Command {
public:
    void options(CommandOptions& options) override {
        options.word("KIND", kind_, "normal, heights, occlusion, gloss, combine, bc5 or bake");
        options.words("FILE", files_,
                      "a height map; a picture (heights, gloss); 1 to 4 channels (combine); a normal map (bc5); "
                      "FINE.obj COARSE.obj, or .gltf or .glb (bake)");
        options.value("-o", "FILE", output_, "the map: .png, .exr, .ppm or .pfm; .dds (bc5)");
        for (const Option& option : options_) {
            const std::string& help = helps_.emplace_back(fmt::format("{}: {}", option.kinds, option.help));
            if (option.flag)
                options.flag(option.name, *option.flag, help.c_str());
            else
                options.value(option.name, option.type, *option.value, help.c_str());
        }
        options.footer([] {
            return std::string(
                "relief map normal stones.png -o stones_normal.png --depth 0.1\n"
                "relief map heights photo.jpg -o heights.png      brightness as a first guess of heights\n"
                "relief map occlusion stones.png -o occlusion.png openness to the sky; the map tiles\n"
                "relief map gloss photo.jpg -o gloss.png          brightness as a first guess of gloss\n"
                "relief map combine gloss.png stones.png occlusion.png:r 1 -o packed.png\n"
                "relief map bc5 normal.png -o normal.dds --mips   x and y in blocks, 1 byte a texel\n"
                "relief map bake fine.obj coarse.obj -o normal.png --size 2048\n"
                "A channel of combine is a FILE (its first channel), FILE:r, :g, :b or :a, or a number from 0 to 1.\n"
                "gloss is the luminance (Rec. 709) in linear light: bright is smooth. It is a guess, since a picture\n"
                "does not show how rough a surface is. --invert takes bright places for rough.\n"
                "bake casts a ray through each texel of COARSE along its normal, and takes the nearest front of FINE.\n"
                "A ray that misses gives the coarse normal, or height 0. All texels between the islands are filled.\n"
                "The tangents are those of a glTF file that has them, or else MikkTSpace's. Heights are stored from 0\n"
                "(lowest) to 1 (highest).\n"
                "Numbers are stored as they are, without a colour space. `relief inspect` says what a map is.");
        });
    }

    int run() override {
        constexpr std::pair<const char*, Kind> kinds[] = {
            {"normal", {1, 1, "one FILE", &MapCommand::normal}},
            {"heights", {1, 1, "one FILE", &MapCommand::heights}},
            {"occlusion", {1, 1, "one FILE", &MapCommand::occlusion}},
            {"gloss", {1, 1, "one FILE", &MapCommand::gloss}},
            {"combine", {1, 4, "1 to 4 channels", &MapCommand::combine}},
            {"bc5", {1, 1, "one FILE, a normal map", &MapCommand::bc5}},
            {"bake", {2, 2, "FINE.obj and COARSE.obj", &MapCommand::bake_map}}};
        const Kind kind = value_of("map", kind_, kinds);
        refuse_unused_options();
        if (output_.empty()) throw UsageError("map needs -o FILE, the map to write");
        check_output();
        if (files_.size() < kind.least_files || files_.size() > kind.most_files)
            throw UsageError(fmt::format("map {} takes {}", kind_, kind.takes));
        auto [image, about, bytes] = (this->*kind.make)();
        if (!bytes.empty()) {
            write_file(output_, bytes);
            fmt::print("{}: {} x {}, {}\n", output_, image.width, image.height, about);
            return 0;
        }
        if (!bits_.empty() || kind_ == "heights") image.bits = bits();
        write_image(output_, image, {}, ColorSpace::linear);
        fmt::print("{}: {} x {}, {}{}\n", output_, image.width, image.height, about, stored(image));
        return 0;
    }

private:
    struct Kind {
        size_t least_files, most_files;
        const char* takes;
        MadeMap (MapCommand::*make)() const;
    };
    /// An option that not all kinds use.
    struct Option {
        const char* kinds;  ///< the kinds that use it: "normal, bake"
        const char *name, *type;
        std::string* value;
        bool* flag;
        const char* help;
    };

    void refuse_unused_options() const {
        for (const Option& option : options_) {
            const bool given = option.flag ? *option.flag : !option.value->empty();
            const std::vector<std::string> kinds = split(option.kinds, ',');
            const auto is_it = [&](const std::string& kind) { return kind == kind_ || kind == " " + kind_; };
            if (given && std::none_of(kinds.begin(), kinds.end(), is_it))
                throw UsageError(
                    fmt::format("map {} does not use {}, which is for {}", kind_, option.name, option.kinds));
        }
    }
    void check_output() const {
        if (kind_ == "bc5") {
            if (!output_.ends_with(".dds")) throw UsageError(fmt::format("'{}' must end in .dds", output_));
        } else if (format_of(output_) != ImageFormat::png && !bits_.empty()) {
            throw UsageError(fmt::format("--bits is for PNG files, not for {}", output_));
        }
    }
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
    bool is_green_up() const {
        constexpr std::pair<const char*, bool> greens[] = {{"up", true}, {"down", false}};
        return green_.empty() || value_of("direction of green", green_, greens);
    }
    static void turn_green(Image& normals) {
        for (size_t i = 1; i < normals.values.size(); i += 3) normals.values[i] = 1 - normals.values[i];
    }
    std::string stored(const Image& image) const {
        const ImageFormat format = format_of(output_);
        if (format == ImageFormat::exr || format == ImageFormat::pfm) return "32-bit floats";
        return format == ImageFormat::png && image.bits == 16 ? "16 bits" : "8 bits";
    }

    MadeMap normal() const {
        const bool is_up = is_green_up();
        const double depth = number("--depth", depth_, usual_depth, 0, 1000);
        NormalOptions options;
        options.filter = filter_.empty() ? SlopeFilter::central : value_of("filter", filter_, slope_filters);
        options.wrap = !no_wrap_;
        const Image heights = read_heights(files_[0]);
        options.texels_u = options.texels_v = depth * heights.width;
        NormalRows rows(heights, options, is_up);
        const auto about = [&] {
            return fmt::format("green {}, slopes {} on average and {} at most, ", is_up ? "up" : "down",
                               rounded(rows.slopes().mean()), rounded(rows.slopes().most()));
        };
        if (format_of(output_) == ImageFormat::png) {
            Image shape(heights.width, heights.height, 0, bits_.empty() ? 8 : bits());
            shape.channels = 3;
            std::string file = encode_png(shape, {}, ColorSpace::linear, [&](int y) { return rows.row(y); });
            return {shape, fmt::format("{}{} bits", about(), shape.bits), std::move(file)};
        }
        Image normals(heights.width, heights.height, 3, 8);
        for (int y = 0; y < heights.height; ++y)
            std::copy_n(rows.row(y), size_t(heights.width) * 3, normals.pixel(0, y));
        return {std::move(normals), about()};
    }

    MadeMap heights() const {
        const Image picture = read_picture(files_[0], false);
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
        PartProgress progress("horizons");
        Image open = occlusion_from_heights(heights, depth * heights.width, slices, reach, progress.before_part());
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

    MadeMap gloss() const {
        const Image picture = read_picture(files_[0], false);
        try {
            Image made = gloss_from_color(picture, invert_);
            const auto [low, high] = std::minmax_element(made.values.begin(), made.values.end());
            std::string about = fmt::format("gloss from {} to {}, a guess from {} places, ", rounded(double(*low)),
                                            rounded(double(*high)), invert_ ? "dark" : "bright");
            return {std::move(made), std::move(about)};
        } catch (const Error& error) {
            throw Error({files_[0]}, error.what());
        }
    }

    MadeMap bc5() const {
        const Image normals = read_picture(files_[0], true);
        PartProgress progress("blocks");
        try {
            Bc5Texture made = encode_bc5(normals, {.kind = signed_ ? RgtcKind::snorm : RgtcKind::unorm,
                                                   .mips = mips_,
                                                   .best = best_,
                                                   .before_part = progress.before_part()});
            const std::string bytes = rounded(double(made.block_bytes) / double(normals.pixel_count()));
            std::string about =
                fmt::format("{}, {} level{}, {} degrees off on average and {} at most, {} byte{} per texel",
                            signed_ ? "BC5_SNORM" : "BC5_UNORM", made.levels, made.levels == 1 ? "" : "s",
                            rounded(made.mean_degrees), rounded(made.largest_degrees), bytes, bytes == "1" ? "" : "s");
            return {Image(normals.width, normals.height, 0), std::move(about), std::move(made.file)};
        } catch (const Error& error) {
            throw Error({files_[0]}, error.what());
        }
    }

    MadeMap bake_map() const {
        constexpr std::pair<const char*, BakeStore> stores[] = {
            {"tangent", BakeStore::tangent}, {"object", BakeStore::object}, {"heights", BakeStore::heights}};
        BakeOptions options;
        options.store = store_.empty() ? BakeStore::tangent : value_of("content", store_, stores);
        if (!green_.empty() && options.store != BakeStore::tangent)
            throw UsageError(fmt::format("map bake --store {} does not use --green, which is for tangent", store_));
        const bool is_up = is_green_up();
        if (!size_.empty()) options.size = parse_size(parse_int(size_) ? size_ + "x" + size_ : size_);
        const double given_reach = number("--reach", reach_, 0, 1e-9, 1e9);
        Model upper = read_model(files_[0]);
        const Model onto = read_coarse(files_[1]);
        for (const Model* const model : {&std::as_const(upper), &onto})
            for (const std::string& note : model->notes) print_note(note);
        // Both models are moved by one origin before they are rounded to float.
        for (Vertex& vertex : upper.mesh.vertices)
            vertex.position = glm::dvec3(vertex.position) + (upper.centre - onto.centre);
        const Mesh &fine = upper.mesh, &coarse = onto.mesh;
        options.reach = given_reach > 0 ? given_reach : diagonal_of(coarse) / 20;
        PartProgress progress("rays");
        options.before_part = progress.before_part();
        BakedMap baked = [&] {
            try {
                return bake(fine, coarse, options);
            } catch (const Error& error) {
                throw Error({files_[1]}, error.what());
            }
        }();
        if (baked.hit == 0)
            throw Error({files_[0]}, fmt::format("no ray from {} meets it within {}: are both models in one place, "
                                                 "and do its faces turn outwards? "
                                                 "--reach sets the distance",
                                                 files_[1], rounded(options.reach)));
        std::string about;
        Image image = std::move(baked.values);
        if (options.store == BakeStore::heights) {
            const auto [low, high] = std::minmax_element(image.values.begin(), image.values.end());
            about = fmt::format("heights from {} to {}, ", rounded(double(*low)), rounded(double(*high)));
            const double from = double(*low), range = double(*high) - from;
            for (float& value : image.values) value = range > 0 ? float((double(value) - from) / range) : 0;
        } else {
            for (float& value : image.values) value = 0.5f * value + 0.5f;
            about = options.store == BakeStore::object ? "object space, "
                                                       : fmt::format("green {}, ", is_up ? "up" : "down");
            if (!is_up) turn_green(image);
        }
        image.bits = options.store == BakeStore::heights ? 16 : 8;
        const double largest = baked.largest_distance < 1e-9 * options.reach ? 0 : baked.largest_distance;  // rounding
        about += fmt::format("texels: {} hit, {} missed, {} filled{}, largest distance {} of {}, ", baked.hit,
                             baked.missed, baked.filled,
                             baked.covered_twice > 0 ? fmt::format(", {} covered twice", baked.covered_twice) : "",
                             rounded(largest), rounded(options.reach));
        return {std::move(image), std::move(about)};
    }
    static double diagonal_of(const Mesh& mesh) {
        glm::dvec3 low(INFINITY), high(-INFINITY);
        for (const Vertex& vertex : mesh.vertices)
            low = glm::min(low, glm::dvec3(vertex.position)), high = glm::max(high, glm::dvec3(vertex.position));
        return glm::distance(low, high);
    }

    std::string kind_, output_, depth_, filter_, green_, bits_, slices_, store_, size_, reach_;
    std::vector<std::string> files_;
    bool no_wrap_ = false, invert_ = false, signed_ = false, mips_ = false, best_ = false;
    std::deque<std::string> helps_;
    const std::vector<Option> options_ = {
        {"normal, occlusion", "--depth", "DEPTH", &depth_, nullptr, "a height of 1, in widths of the map (0.08)"},
        {"normal", "--filter", "NAME", &filter_, nullptr,
         "central, forward, sobel, scharr, fourth-order or spline (central)"},
        {"normal, bake", "--green", "up|down", &green_, nullptr, "where the green channel points (up)"},
        {"normal", "--no-wrap", "", nullptr, &no_wrap_, "the map does not tile"},
        {"occlusion", "--slices", "COUNT", &slices_, nullptr, "directions that are searched (16)"},
        {"gloss", "--invert", "", nullptr, &invert_, "bright places are rough"},
        {"bc5", "--signed", "", nullptr, &signed_, "BC5_SNORM, where 0 is exact, in place of BC5_UNORM"},
        {"bc5", "--mips", "", nullptr, &mips_, "all mip levels: means of the unit normals, made unit"},
        {"bc5", "--best", "", nullptr, &best_,
         "smallest squared error of x and y: tries all ends, a minute or two for a million texels"},
        {"bake", "--store", "WHAT", &store_, nullptr, "tangent, object (normals in these spaces) or heights (tangent)"},
        {"bake", "--size", "N|WxH", &size_, nullptr, "size of the map, texels (1024)"},
        {"bake", "--reach", "DISTANCE", &reach_, nullptr,
         "distance of the search above and below COARSE, in the models' units (a twentieth of COARSE's diagonal)"},
        {"normal, heights, occlusion, gloss, combine, bake", "--bits", "8|16", &bits_, nullptr,
         "bits of a PNG (8; 16 for heights; those of the input for gloss and combine)"}};
};
RELIEF_COMMAND(MapCommand, 17, "map",
               "makes normal maps, heights, occlusion, gloss, packed channels, BC5 and baked maps, as files");

}  // namespace
}  // namespace relief::app
