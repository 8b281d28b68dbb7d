// A lab's knobs, as text.
#include "framework/core/lab/knobs.h"

#include <array>
#include <bit>
#include <random>

#include "framework/core/image/file.h"
#include "framework/core/lab/lab.h"
#include "framework/library/maps/own_picture.h"
#include "tests/support.h"

namespace relief {
namespace {

class Wall final : public Lab {
public:
    float scale = 0.25f, strength = 0.5f;
    int steps = 32, method = 1;
    bool shadows = true;

    void draw(const Frame&) override {}
    void knobs(Knobs& knobs) override {
        static constexpr std::array methods = {"linear", "secant", "cone"};
        knobs.slider("scale", scale, -0.5f, 2, "depth in metres");
        knobs.slider("strength", strength, 0.1f, 0.7f, "share of the relief");
        knobs.steps("steps", steps, 1, 256, "samples along the ray");
        knobs.toggle("shadows", shadows, "march to the light too");
        knobs.choice("method", method, methods, "how the crossing is found");
    }
};

class Bare final : public Lab {
    void draw(const Frame&) override {}
};

std::string knob_refusal(const std::string& name, const std::string& value) {
    Wall wall;
    const std::string message = message_of<UsageError>([&] { set_knob(wall, name, value); });
    EXPECT_TRUE(wall.scale == 0.25f && wall.strength == 0.5f && wall.steps == 32 && wall.shadows && wall.method == 1)
        << name << "=" << value << " was refused, yet it changed something";
    return message;
}

TEST(Knobs, AreDescribedInOrderWithValueRangeAndHelp) {
    Wall wall;
    const std::vector<KnobText> knobs = describe_knobs(wall);
    const std::array<std::array<const char*, 4>, 5> expected = {{
        {"scale", "0.25", "-0.5 to 2", "depth in metres"},
        {"strength", "0.5", "0.1 to 0.7", "share of the relief"},
        {"steps", "32", "1 to 256, whole", "samples along the ray"},
        {"shadows", "on", "on, off", "march to the light too"},
        {"method", "secant", "linear, secant, cone", "how the crossing is found"},
    }};
    ASSERT_EQ(knobs.size(), expected.size());
    for (size_t i = 0; i < knobs.size(); ++i) {
        EXPECT_EQ(knobs[i].name, expected[i][0]);
        EXPECT_EQ(knobs[i].value, expected[i][1]);
        EXPECT_EQ(knobs[i].range(), expected[i][2]);
        EXPECT_EQ(knobs[i].help.line(), expected[i][3]);
    }
}

TEST(Knobs, HaveTheRangeOfLargeIntegersInFull) {
    class Many final : public Lab {
        int many_ = 1;
        void draw(const Frame&) override {}
        void knobs(Knobs& knobs) override { knobs.steps("many", many_, -1'234'567, 7'654'321, "how many"); }
    } lab;
    EXPECT_EQ(describe_knobs(lab).front().range(), "-1234567 to 7654321, whole");
}

TEST(Knobs, AreSetFromTextForEveryType) {
    Wall wall;
    set_knob(wall, "scale", "-0.125");
    set_knob(wall, "steps", "64");
    set_knob(wall, "shadows", "off");
    set_knob(wall, "method", "cone");
    EXPECT_EQ(wall.scale, -0.125f);
    EXPECT_EQ(wall.steps, 64);
    EXPECT_FALSE(wall.shadows);
    EXPECT_EQ(wall.method, 2);
    for (const auto& [text, on] :
         {std::pair("on", true), {"0", false}, {"true", true}, {"false", false}, {"1", true}}) {
        set_knob(wall, "shadows", text);
        EXPECT_EQ(wall.shadows, on) << text;
    }
}

TEST(Knobs, HaveTextsThatSetTheirExactValues) {
    Wall wall;
    std::mt19937 random(1);
    for (int i = 0; i < 100'000; ++i) {
        const auto value = std::bit_cast<float>(uint32_t(random()));
        if (!(value >= -0.5f && value <= 2)) continue;
        wall.scale = value;
        const std::string text = describe_knobs(wall).front().value;
        wall.scale = 0;
        set_knob(wall, "scale", text);
        ASSERT_EQ(std::bit_cast<uint32_t>(wall.scale), std::bit_cast<uint32_t>(value)) << text;
    }
}

TEST(Knobs, AcceptTheEndsOfTheirRange) {
    Wall wall;
    for (const char* end : {"-0.5", "2"}) EXPECT_NO_THROW(set_knob(wall, "scale", end)) << end;
    for (const char* end : {"1", "256"}) EXPECT_NO_THROW(set_knob(wall, "steps", end)) << end;
}

TEST(Knobs, AcceptTheEndsAsShownDespiteFloatRounding) {
    Wall wall;  // 0.1f is a little more than 0.1, 0.7f a little less than 0.7
    for (const auto& [text, end] : {std::pair("0.1", 0.1f), {"0.7", 0.7f}}) {
        EXPECT_NO_THROW(set_knob(wall, "strength", text)) << text;
        EXPECT_EQ(wall.strength, end);
    }
}

TEST(Knobs, RefuseValuesOutOfRangeAndInvalidNumbers) {
    for (const char* value : {"-0.51", "2.01", "1e9", "nan", "inf", "-inf", "", "x", "1x", " 1", "0,5"})
        EXPECT_EQ(knob_refusal("scale", value), std::string("knob scale takes -0.5 to 2, not '") + value + "'");
    for (const char* value : {"0", "257", "-1", "3.5", "1e2", "nan", "", "many", "99999999999"})
        EXPECT_EQ(knob_refusal("steps", value),
                  std::string("knob steps takes whole numbers from 1 to 256, not '") + value + "'");
    for (const char* value : {"", "2", "yes", "On", "onn"})
        EXPECT_EQ(knob_refusal("shadows", value), std::string("knob shadows takes on or off, not '") + value + "'");
}

TEST(Knobs, SuggestTheNearestNameAndChoice) {
    EXPECT_EQ(knob_refusal("stpes", "3"),
              "unknown knob 'stpes': did you mean 'steps'? There are: scale, strength, steps, shadows, method");
    EXPECT_EQ(knob_refusal("method", "secnat"),
              "unknown value of knob method, 'secnat': did you mean 'secant'? There are: linear, secant, cone");
    EXPECT_TRUE(contains(knob_refusal("method", "2"), "linear, secant, cone")) << "a choice goes by name";
    EXPECT_TRUE(contains(knob_refusal("", "1"), "unknown knob ''"));
}

TEST(Knobs, MayBeMissing) {
    Bare bare;
    EXPECT_TRUE(describe_knobs(bare).empty());
    EXPECT_EQ(message_of<UsageError>([&] { set_knob(bare, "steps", "1"); }),
              "unknown knob 'steps'; there is no knob here");
}

/// Accepts pictures that are one pixel wide.
class Canvas final : public Lab {
public:
    int map = 1;
    OwnPicture own{[](Image picture, std::vector<std::string>&) {
        if (picture.width != 1) throw Error("is wider than a pixel");
        return picture;
    }};

    void draw(const Frame&) override {}
    void knobs(Knobs& knobs) override {
        static constexpr std::array maps = {"bricks", "stones"};
        knobs.choice_or_file("map", map, own, maps, "the height map");
    }
};

TEST(Knobs, TakeAPictureBesideTheNamesOfAChoice) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "mine.pfm", wide = folder.path() / "wide.pfm";
    write_image(file, Image(1, 1, 1));
    write_image(wide, Image(2, 1, 1));
    Canvas canvas;
    EXPECT_EQ(describe_knobs(canvas)[0].range(), "bricks, stones");
    EXPECT_EQ(describe_knobs(canvas)[0].help.line(), "the height map, or a picture's file");

    set_knob(canvas, "map", file.string());
    EXPECT_EQ(canvas.map, 2);
    EXPECT_EQ(describe_knobs(canvas)[0].value, file.string()) << "as --set takes it";

    // A rejected value changes nothing, and the message says which values are accepted.
    EXPECT_EQ(message_of<Error>([&] { set_knob(canvas, "map", wide.string()); }),
              wide.string() + ": is wider than a pixel");
    EXPECT_THROW(set_knob(canvas, "map", (folder.path() / "missing.png").string()), Error);
    EXPECT_EQ(
        message_of<UsageError>([&] { set_knob(canvas, "map", "brick"); }),
        "unknown value of knob map, 'brick': did you mean 'bricks'? There are: bricks, stones, or a picture's file");
    EXPECT_EQ(canvas.own.file(), file);
    EXPECT_EQ(canvas.own.version(), 1);

    set_knob(canvas, "map", "bricks");
    EXPECT_EQ(canvas.map, 0);
    EXPECT_EQ(set_file(canvas, file), "map");
    EXPECT_EQ(canvas.map, 2);
    Wall wall;
    EXPECT_EQ(set_file(wall, file), "") << "has no knob for it";
}

/// Accepts pictures of any kind, and models that a test allows.
class Sculpture final : public Lab {
public:
    class Model final : public OwnFile {
    public:
        const char* kind() const override { return "an OBJ file"; }
        bool accepts(const std::filesystem::path& file) const override { return is_named_as_model(file); }

    private:
        std::vector<std::string> load(const std::filesystem::path&) override { return {}; }
    } model;
    int map = 0, shape = 0;
    OwnPicture picture{[](Image image, std::vector<std::string>&) { return image; }};

    void draw(const Frame&) override {}
    void knobs(Knobs& knobs) override {
        static constexpr std::array maps = {"bricks"};
        static constexpr std::array shapes = {"sphere", "box"};
        knobs.choice_or_file("map", map, picture, maps, "the height map");
        knobs.choice_or_file("shape", shape, model, shapes, "the shape");
    }
};

TEST(Knobs, GiveADroppedFileToTheKnobOfItsKind) {
    const TemporaryFolder folder;
    write_image(folder.path() / "mine.pfm", Image(1, 1, 1));
    Sculpture sculpture;
    EXPECT_EQ(set_file(sculpture, folder.path() / "mine.obj"), "shape");
    EXPECT_EQ(sculpture.shape, 2);
    EXPECT_EQ(sculpture.map, 0);
    EXPECT_EQ(set_file(sculpture, folder.path() / "mine.pfm"), "map");
    EXPECT_EQ(sculpture.map, 1);
    EXPECT_EQ(describe_knobs(sculpture)[1].help.line(), "the shape, or an OBJ file");
    EXPECT_EQ(message_of<UsageError>([&] { set_knob(sculpture, "shape", "bo"); }),
              "unknown value of knob shape, 'bo': did you mean 'box'? There are: sphere, box, or an OBJ file");
    Canvas canvas;
    EXPECT_EQ(set_file(canvas, folder.path() / "mine.obj"), "") << "it has a knob for pictures only";
}

}  // namespace
}  // namespace relief
