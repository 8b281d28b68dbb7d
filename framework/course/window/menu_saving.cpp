#include "framework/course/window/menu_saving.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "framework/core/base/log.h"
#include "framework/core/image/file.h"
#include "framework/library/kit/made_map.h"
#include "framework/library/kit/paint_layer.h"

namespace relief::window {
namespace {

template <class Make>
std::string save_as(const Stage& stage, const char* what, ColorSpace space, Make make) {
    try {
        int number = 1;
        const auto name = [&] { return fmt::format("{}{}-{}.png", stage.entry().folder, what, number); };
        while (std::filesystem::exists(name())) ++number;
        write_image(name(), make(), {}, space);
        fmt::print("{}\n", name());
        std::fflush(stdout);
        return "saved " + name();
    } catch (const Error& error) {
        print_error(error.what());
        return error.what();
    }
}

}  // namespace

std::string save_picture(const Stage& stage) {
    return save_as(stage, "", ColorSpace::srgb, [&] { return stage.picture(); });
}

std::string save_map(const Stage& stage) {
    return save_as(stage, "-map", ColorSpace::linear, [&] {
        if (!stage.lab() || !stage.framebuffer()) throw Error("there is no map to save");
        return map_of(*stage.lab());
    });
}

std::string save_heights(const Stage& stage) {
    return save_as(stage, "-heights", ColorSpace::linear, [&] {
        auto* const lab = dynamic_cast<Paintable*>(stage.lab());
        if (!lab || !stage.framebuffer()) throw Error("this lab has no heights to save");
        Image heights = lab->painted_heights();
        for (float& height : heights.values) height = std::clamp(height, 0.0f, 1.0f);
        heights.bits = 16;
        return heights;
    });
}

}  // namespace relief::window
