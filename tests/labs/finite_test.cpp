// Every pixel of a picture, and of a probe where it shows a surface, is finite: at degenerate tangents, scales, depths,
// maps and lights, and from eyes inside of things. Labs 10 and 12 test this in their own files, with further bounds.
#include "framework/core/base/text.h"
#include "labs/09_planet/heights.h"
#include "tests/labs/shots.h"

namespace relief {
namespace {

struct Scenes {
    std::vector<const char*> settings;
    std::vector<Orbit> eyes = {};  ///< none: the lab's own
};

struct FiniteRow {
    const char* lab;
    std::vector<const char*> bases;  ///< one lab each, so that its programs are compiled once for all scenes
    std::vector<Scenes> scenes;
    std::vector<const char*> probes;  ///< "": the picture, before it is encoded
    glm::ivec2 size;
    bool is_filled = false;  ///< whether every pixel of a probe shows a surface
};

void PrintTo(const FiniteRow& row, std::ostream* out) { *out << row.lab; }

std::vector<FiniteRow> finite_rows() {
    const Orbit near{.yaw = 40, .pitch = 20, .distance = 1}, above{.yaw = 0, .pitch = 89, .distance = 2.5},
        below{.yaw = 0, .pitch = -89, .distance = 2.5}, ahead{.yaw = 0, .pitch = 0, .distance = 1};
    const auto at = [&](const glm::dvec3& target, double distance, double yaw = 0, double pitch = 0) {
        return Orbit{.yaw = yaw, .pitch = pitch, .distance = distance, .target = target};
    };
    const glm::dvec3 up(0, 0, 1), vertex = (1 + height(planet::Ground{.seed = 3}, up)) * up;
    // In front of a wall, on it, inside its relief and behind it; in its plane and edge-on.
    std::vector<Orbit> around;
    for (const double yaw : {0.0, 89.9, 90.0, 90.1, 180.0})
        for (const double z : {0.05, 0.0, -0.02, -0.05, -0.3}) around.push_back(at({0, 0, z}, 0.5, yaw));
    return {
        {"06",
         {"view=one shape=sphere|column|wall light_in=world|tangent"},
         {{{"trouble=leaning|along-normal|missing", "map=one-texel", "scale_x=-2 scale_y=-1", "scale_z=0",
            "scale_x=0 scale_y=0", "scale_x=0 scale_y=0 scale_z=0", "light_distance=0 light_height=0",
            "light_distance=1 light_height=0 scale_x=1 scale_y=1 scale_z=1"}},
          {{"size=6"}, {at({}, 3e6, 30, 20)}},
          {{"size=-6"}, {at({}, 3e-6, 30, 20)}}},
         {""},
         {64, 64}},
        {"09",
         {"view=planet texels=16 radius=0|7"},
         {{{""},
           {at({}, 1e-12), at(vertex, 1e-12, 10, 20), at(vertex, 1e-9, 90), at(glm::dvec3(0.58), 0.001, 30, -20),
            at({0, 1.01, 0}, 0.02, 30, 40), at({}, 1e6, 30, 40)}}},
         {"", "normal", "place", "level"},
         {48, 48}},
        {"11",
         {"view=one refine=none", "view=one refine=illinois skip=false mip=footprint", "view=compare show=error"},
         {{{"count=texel"}, around},
          {{"map=low|high|plateau|damaged size=1|256", "depth=0|0.001|1 count=fixed|angle|texel", "steps=1",
            "steps=1 least_steps=512 count=angle", "shift=10000", "map=stones size=4096"},
           {near}},
          {{"surface=urn depth=1"}, {above}}},
         {"", "uv", "depth"},
         {48, 48}},
        {"13",
         {"view=one level=7.5 spacing=fractional-odd corners=3|4"},
         {{{"surface=wall"}, around},
          {{"surface=wall"}, {at({0, 0, -1}, 1)}},
          {{"surface=sphere"}, {ahead, at({}, 0.01)}},
          {{"surface=globe"}, {at({}, 1.2, 0, 89)}},
          {{"map=low|plateau|damaged size=1|256 normals=map|heights|surface"}}},
         {"", "depth", "normal", "winding"},
         {40, 40}},
        {"14",
         {"patches=3 map=smooth size=256 view=both method=error budget=8",
          "patches=3 map=smooth size=256 view=eye method=size corners=3 segment=64 spacing=fractional-even",
          "patches=3 map=smooth size=256 view=eye method=distance levels_of=patch finest=2"},
         {{{"map=low|high|plateau|damaged|fbm size=1|256", "fade=true fade_begin=0 fade_end=0"}, {at({}, 2.5, 40, 20)}},
          {{"surface=globe|urn|column|wall depth=0.5"}, {above, below}},
          {{"depth=0.5"}, {at({0, -1, 0}, 0.5), at({}, 12, 0, -30)}},      // inside the relief and below it
          {{"surface=globe"}, {at({}, 0.01, 0, 10), at({0, 1, -1}, 1)}}},  // inside and on a pole
         {"", "depth"},
         {32, 32}},
        {"15",
         {"view=one"},
         {{{"", "shininess=1|4096", "light_pitch=0|-5|90", "light_yaw=180", "wind=0 amplitude_1=4",
            "amplitude_1=0 amplitude_2=0", "far=toksvig tiles_1=0.02"},
           {at({}, 5, 180), at({0, 0.3, 0}, 5, 180), at({0, 5, 0}, 5, 180)}}},
         {"normal", "reflection", "fresnel", "sigma", "glitter"},
         {16, 16}},
        {"16",
         {""},
         {{{"light_pitch=90|-90", "light_pitch=0 light_yaw=90|180", "exponent=0", "roughness=1",
            "fresnel=exact gloss=even", "fresnel=whole exponent=512 lamps=3", "shadow_texels=256 pcf=2",
            "scene=groove tilt=89|0", "scene=plane tilt=89 light_yaw=0", "slices=1 taps=1"},
           // From outside, from the floor along it, and inside the lantern.
           {at({-0.9, 1.6, -2}, 11, 18, 5.5), at({}, 3, 10), at({-6.6, 2.1, -1}, 0.5, 90)}}},
         {"light", "reflection", "shadow", "occlusion"},
         {16, 16}},
        {"18",
         {"view=skin signs=opposite shape=tube|serpent blend=linear|dual-quaternion "
          "normal_by=gradient|matrix|inverse-transpose|unit-cofactors"},
         {{{"stretch=0", "stretch=0 weights_over=0", "weights_over=0", "scale_y=0", "bend=150|0 twist=180",
            "weights=uneven bend=150", "instance_scale=0", "material_scale=0"}}},
         {"normal", "tangent", "carried", "fold", "place", "uv"},
         {12, 24},
         true}};
}

/// Returns the settings of a text such as "map=low|high size=1": all combinations of the values.
std::vector<std::vector<Knob>> settings_of(const std::string& text) {
    std::vector<std::vector<Knob>> all(1);
    for (const std::string& word : split(text, ' ')) {
        const size_t equals = word.find('=');
        if (equals == std::string::npos) continue;
        std::vector<std::vector<Knob>> longer;
        for (const auto& knobs : all)
            for (const std::string& value : split(word.substr(equals + 1), '|'))
                longer.push_back(with(knobs, {{word.substr(0, equals), value}}));
        all = longer;
    }
    return all;
}

class EveryPixelIsFinite : public testing::TestWithParam<FiniteRow> {
protected:
    void expect_finite(Lab& lab, const std::vector<Knob>& knobs, const Orbit& eye, const std::string& where) {
        for (const auto& [name, value] : knobs) set_knob(lab, name, value);
        const FiniteRow& row = GetParam();
        for (const char* probe : row.probes) {
            const Target target(*probe ? TargetKind::probe : TargetKind::light, row.size);
            draw_lab(lab, {target.framebuffer(), row.size, 0, Camera(eye, double(row.size.x) / row.size.y), {probe}});
            for (const float value : target.read().values)
                ASSERT_TRUE(std::isfinite(value) || (*probe && !row.is_filled && value == no_surface))
                    << probe << ": " << where << " from " << eye.yaw << ", " << eye.pitch << ", " << eye.distance;
        }
    }
};

TEST_P(EveryPixelIsFinite, AtDegenerateInput) {
    const LabEntry& entry = find_lab(GetParam().lab);
    for (const char* text : GetParam().bases)
        for (const std::vector<Knob>& base : settings_of(text)) {
            const auto lab = make_lab(entry, shot_of(GetParam().lab, base));
            const std::vector<KnobText> before = describe_knobs(*lab);
            for (const auto& [settings, eyes] : GetParam().scenes)
                for (const std::string setting : settings)
                    for (const std::vector<Knob>& knobs : settings_of(setting))
                        for (const Orbit& eye : eyes.empty() ? std::vector{load_manifest(entry).camera} : eyes) {
                            expect_finite(*lab, knobs, eye, text + (": " + setting));
                            if (HasFatalFailure()) return;
                            for (const KnobText& knob : before) set_knob(*lab, knob.name, knob.value);
                        }
        }
}

INSTANTIATE_TEST_SUITE_P(Labs, EveryPixelIsFinite, testing::ValuesIn(finite_rows()),
                         [](const auto& row) { return find_lab(row.param.lab).folder; });

}  // namespace
}  // namespace relief
