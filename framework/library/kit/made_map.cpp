#include "framework/library/kit/made_map.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "framework/core/base/error.h"

namespace relief {

Image map_of(Lab& lab) {
    auto* const maker = dynamic_cast<MapMaker*>(&lab);
    if (!maker) {
        std::vector<std::string> others;
        for (const LabEntry& entry : registry())
            if (dynamic_cast<MapMaker*>(entry.make().get())) others.push_back(entry.two_digits());
        throw UsageError(others.empty() ? "this lab makes no map"
                                        : fmt::format("this lab makes no map; these do: {}", fmt::join(others, ", ")));
    }
    std::optional<Image> map = maker->made_map();
    if (!map) throw Error("no map is made for this picture: choose another view");
    map->bits = 16;
    return *std::move(map);
}

}  // namespace relief
