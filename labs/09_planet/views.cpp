#include "views.h"

#include <fmt/format.h>

#include <set>

namespace relief::planet {
namespace {

double aspect_of(const Tile& tile) { return double(tile.size.x) / std::max(1, tile.size.y); }

/// Returns an eye above a place, `distance` radii from the centre, with `up` upwards in the picture.
Eye above(const glm::dvec3& place, double distance, const glm::dvec3& up, double aspect) {
    const glm::dvec3 from = glm::normalize(place);
    return Eye::looking(distance * from, -from, glm::normalize(up - glm::dot(up, from) * from),
                        2 * std::atan(0.42 * std::max(1.0, 1 / aspect)), aspect);
}

Eye above_pole(double aspect) { return above({0, 1, 0.32}, 1.75, {0, 0, -1}, aspect); }

/// Returns a second eye at the side, which sees ground that is hidden from `eye`.
Eye beside(const Eye& eye, double aspect) {
    const double away = glm::length(eye.place);
    const glm::dvec3 towards = away > 0 ? eye.place / away : glm::dvec3(0, 0, 1);
    const glm::dvec3 pole = std::abs(towards.y) > 0.95 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 side = glm::normalize(glm::cross(pole, towards)), up = glm::cross(towards, side);
    return above(0.75 * towards + 0.75 * side + 0.35 * up, 3.1, up, aspect);
}

/// Returns the eye of the knobs: the camera, or above a place on the ground.
Eye eye_of(const Settings& s, const Frame& frame) {
    const double aspect = double(frame.size.x) / std::max(1, frame.size.y);
    if (s.eye == Settings::at_camera) return Eye::of(frame.camera, aspect);
    const double lon = glm::radians(double(s.longitude)), lat = glm::radians(double(s.latitude));
    const glm::dvec3 up(std::cos(lat) * std::sin(lon), std::sin(lat), std::cos(lat) * std::cos(lon));
    const glm::dvec3 east(std::cos(lon), 0, -std::sin(lon)), north = glm::cross(up, east);
    const double turn = glm::radians(double(s.heading)), rise = glm::radians(double(s.tilt));
    const glm::dvec3 ahead = std::cos(turn) * north + std::sin(turn) * east;
    const double from_centre = 1 + height(s.shape().ground, up) + std::pow(10.0, double(s.altitude));
    const double field_of_view = std::min(2.4, 2 * std::atan(std::tan(glm::radians(30.0)) * std::max(1.0, 1 / aspect)));
    return Eye::looking(from_centre * up, std::cos(rise) * ahead + std::sin(rise) * up,
                        std::cos(rise) * up - std::sin(rise) * ahead, field_of_view, aspect);
}

View view_in(const Settings& s, const Frame& frame, const Tile& tile, const char* title = "") {
    const Eye eye = eye_of(s, frame_in(frame, tile));
    return {.tile = tile,
            .title = title,
            .plan = {.shape = s.shape(),
                     .levels = Levels(s.levels),
                     .level = s.level,
                     .budget = double(s.budget),
                     .cull = Cull(s.cull),
                     .radius = s.radius_metres(),
                     .skirts = s.skirts,
                     .pixels = double(tile.size.y),
                     .eye = eye},
            .seen_from = eye,
            .recipe = {.shape = s.shape(),
                       .normals = Normals(s.normals),
                       .texels = 16 << s.texels,
                       .gutter = s.gutter,
                       .strength = Strength(s.strength),
                       .slopes = frame.probe.name == "slope"},
            .lit_by = s.lit_by};
}

// Changes to a view of the knobs.

View seen_by(View view, const Eye& eye) {
    view.plan.eye = view.seen_from = eye;
    return view;
}
/// Returns a view of the planet as it is commonly made.
View as_usual(View view) {
    view.plan.shape.mapping = view.recipe.shape.mapping = SphereMapping::lat_long;
    view.recipe.normals = Normals::one_scale;
    return view;
}
/// Returns a view from the side of the patches that the picture of `plan` needs.
View as_patches(View view, const Plan& plan) {
    view.shows_patches = true;
    view.seen_from = beside(view.plan.eye, aspect_of(view.tile));
    view.plan = plan;
    return view;
}
View with_frames(View view) {
    view.plan.levels = Levels::uniform, view.plan.level = 2;
    view.shows_frames = true;
    return view;
}
View lit(View view, Settings::LitBy lit_by) {
    view.lit_by = lit_by;
    return view;
}

// The views of each picture.

std::vector<View> faces(const Settings& s, const Frame& frame) {
    View view = view_in(s, frame, {{0, 0}, frame.size});
    view.is_flat = true, view.plan.levels = Levels::uniform, view.plan.cull = Cull::none;
    return {view};
}

std::vector<View> pole(const Settings& s, const Frame& frame) {
    const auto tiles = tiles_of(frame.size, 2);
    return {seen_by(view_in(s, frame, tiles[0], "no poles"), above_pole(aspect_of(tiles[0]))),
            as_usual(seen_by(view_in(s, frame, tiles[1], "latitude and longitude"), above_pole(aspect_of(tiles[1]))))};
}

std::vector<View> frames(const Settings& s, const Frame& frame) {
    const auto tiles = tiles_of(frame.size, 2);
    const View corner = view_in(s, frame, tiles[0], "a corner of the cube"),
               pole = view_in(s, frame, tiles[1], "a pole of latitude and longitude");
    return {with_frames(seen_by(corner, above({-1, 0.85, 1}, 1.75, {0, 1, 0}, aspect_of(tiles[0])))),
            as_usual(with_frames(seen_by(pole, above({0, 1, 0}, 1.7, {0, 0, -1}, aspect_of(tiles[1])))))};
}

std::vector<View> mountains(const Settings& s, const Frame& frame) {
    const auto tiles = tiles_of(frame.size, 2);
    return {lit(view_in(s, frame, tiles[0], "normals of the map"), Settings::lit_by_map),
            lit(view_in(s, frame, tiles[1], "normals of the vertices"), Settings::lit_by_vertices)};
}

/// Both views have the same patches: those that the eye's picture needs.
std::vector<View> patches(const Settings& s, const Frame& frame) {
    const auto tiles = tiles_of(frame.size, frame.probe ? 1 : 2);
    const View eye = view_in(s, frame, tiles[0]), side = as_patches(view_in(s, frame, tiles.back()), eye.plan);
    return frame.probe ? std::vector{side} : std::vector{eye, side};
}

/// The planet is large, and the other two views are beside or below it.
std::vector<View> compare(const Settings& s, const Frame& frame) {
    const glm::ivec2 size = frame.size;
    const bool is_wide = size.x >= size.y;
    const int part = (is_wide ? size.x : size.y) * 2 / 3, half = (is_wide ? size.y : size.x) / 2;
    const std::array<Tile, 3> tiles = is_wide ? std::array<Tile, 3>{{{{0, 0}, {part, size.y}},
                                                                     {{part, half}, {size.x - part, size.y - half}},
                                                                     {{part, 0}, {size.x - part, half}}}}
                                              : std::array<Tile, 3>{{{{0, size.y - part}, {size.x, part}},
                                                                     {{0, 0}, {half, size.y - part}},
                                                                     {{half, 0}, {size.x - half, size.y - part}}}};
    const View planet = view_in(s, frame, tiles[0]), bald = view_in(s, frame, tiles[1], "latitude and longitude");
    return {planet, as_usual(seen_by(bald, above_pole(aspect_of(tiles[1])))),
            as_patches(view_in(s, frame, tiles[2], "patches"), planet.plan)};
}

std::vector<View> views_by_knobs(const Settings& s, const Frame& frame) {
    static const std::set<std::string> of_the_grid = {"direction", "stretch", "corner", "gradient", "texel", "slope"};
    if (s.view == Settings::faces || of_the_grid.contains(frame.probe.name)) return faces(s, frame);
    if (s.view == Settings::pole) return pole(s, frame);
    if (s.view == Settings::frames) return frames(s, frame);
    if (s.view == Settings::patches) return patches(s, frame);
    if (s.view == Settings::mountains && !frame.probe) return mountains(s, frame);
    if (s.view == Settings::compare && !frame.probe) return compare(s, frame);
    return {view_in(s, frame, {{0, 0}, frame.size})};
}

}  // namespace

std::vector<View> views_of(const Settings& settings, const Frame& frame) {
    std::vector<View> views = views_by_knobs(settings, frame);
    for (View& view : views) {
        view.plan.most_patches =
            size_t(most_vertices) / views.size() / size_t(SkirtedPatch{view.plan.shape.quads}.vertices());
        view.most_texels = most_texels / int(views.size());
    }
    return views;
}

void cover_with_patches(View& view) {
    Cover all = cover(view.plan);
    view.leaves = std::move(all.leaves);
    // Culled patches are only drawn in the view from the side.
    if (!view.shows_patches) std::erase_if(view.leaves, [](const Leaf& leaf) { return leaf.state != Leaf::drawn; });
    if (all.is_bounded) view.bounded = fmt::format("at most {} patches", view.plan.most_patches);
    const int wanted = view.recipe.texels;
    view.recipe.texels = texels_that_fit(wanted, view.leaves.size(), view.most_texels);
    if (view.recipe.texels < wanted)
        view.bounded +=
            fmt::format("{}maps of {} texels at most", view.bounded.empty() ? "" : ", ", view.recipe.texels);
}

}  // namespace relief::planet
