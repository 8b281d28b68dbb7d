#include "views.h"

#include <fmt/format.h>

#include "framework/core/base/error.h"

namespace relief::baking {
namespace {

View model_view(const Settings& s, Shape shape, Shown shown, int frame, std::string title = "",
                bool wears_file = false) {
    return {.sight = {s.recipe(shape), shown, s.diagonal == Settings::other},
            .frame = frame,
            .title = std::move(title),
            .wears_file = wears_file};
}

/// Returns the chosen model alone: with its map, bare, the fine model, or with the map in its file.
std::vector<View> one(const Settings& s) {
    static constexpr std::array shown = {Shown::mapped, Shown::low, Shown::high, Shown::mapped};
    const bool wears_file = s.wears == Settings::map_of_file && s.is_own();
    if (wears_file && !s.has_file_map())
        throw Error("wears=file needs a glTF file with a normal map: choose wears=map to bake one");
    return {model_view(s, Shape(s.shape), shown[size_t(s.wears)], s.frame, "", wears_file)};
}

/// Returns the cube, or a file with its own map, by each of the renderer's frames.
std::vector<View> cubes(const Settings& s) {
    std::vector<View> views;
    for (size_t i = 0; i < frames.size(); ++i)
        views.push_back(model_view(s, s.is_own() ? Shape::own : Shape::cube, Shown::mapped, int(i), frames.names[i],
                                   s.has_file_map()));
    return views;
}

/// Returns the fine and the coarse model, the coarse one with its map, a model in two frames, and the map.
std::vector<View> compare(const Settings& s) {
    const Shape shape = Shape(s.shape) == Shape::cube ? Shape::ammonite : Shape(s.shape);
    const int other_frame = s.bake_frame == gram_schmidt ? interpolated : gram_schmidt;
    std::vector<View> views = {
        model_view(s, shape, Shown::high, interpolated, fmt::format("{} triangles", s.high_triangles())),
        model_view(s, shape, Shown::low, interpolated, std::to_string(s.low_triangles())),
        model_view(s, shape, Shown::mapped, s.frame, fmt::format("{} and a map", s.low_triangles()))};
    if (s.has_file_map()) {
        views.push_back(model_view(s, shape, Shown::mapped, interpolated, "its file's map: interpolated", true));
        views.push_back(model_view(s, shape, Shown::mapped, gram_schmidt, "its file's map: gram-schmidt", true));
    } else {
        views.push_back(model_view(s, Shape::cube, Shown::mapped, s.bake_frame, "flat: one frame"));
        views.push_back(model_view(s, Shape::cube, Shown::mapped, other_frame, "another frame"));
    }
    views.push_back({.draws = Draws::map, .sight = {s.recipe(shape), Shown::nothing}, .title = "the map"});
    return views;
}

std::vector<View> views_by_knobs(const Settings& s, const Probe& probe) {
    if (probe && probe.name != "normal")
        return {{.draws = probe.name == "cover" ? Draws::cover : Draws::map, .sight = {s.recipe()}}};
    if (s.view == Settings::one) return one(s);
    if (s.view == Settings::map) return {{.draws = Draws::map, .sight = {s.recipe()}}};
    if (s.view == Settings::rays) return {{.draws = Draws::cut, .sight = {s.recipe()}}};
    return s.view == Settings::cube ? cubes(s) : compare(s);
}

}  // namespace

std::vector<View> views_of(const Settings& settings, const Frame& frame) {
    std::vector<View> views = views_by_knobs(settings, frame.probe);
    const std::vector<Tile> tiles = tiles_of(frame.size, int(views.size()));
    for (size_t i = 0; i < views.size(); ++i) views[i].tile = tiles[i];
    return views;
}

}  // namespace relief::baking
