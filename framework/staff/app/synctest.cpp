// relief synctest: tests whether a renderer reads normal maps in the frame in which they were baked.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "framework/core/base/error.h"
#include "framework/core/base/text.h"
#include "framework/core/image/file.h"
#include "framework/course/app/command.h"
#include "framework/staff/synctest/files.h"
#include "framework/staff/synctest/flatness.h"

namespace relief::app {
namespace {

void print_likenesses(const synctest::SyncJudgement& judgement) {
    if (judgement.likenesses.empty()) {
        fmt::print("frame: cannot tell: the outline is that of the camera of README.md by {} % only\n",
                   rounded(100 * judgement.overlap));
        return;
    }
    const auto renderer = judgement.renderer();
    fmt::print("frame: {}{}\n",
               renderer ? renderer->text() : "none that is known here, or another camera than README.md's",
               renderer && renderer->is_in_sync() ? ", in sync with the map" : "");
    for (size_t i = 0; i < 3 && i < judgement.likenesses.size(); ++i)
        fmt::print("  {:>5} degrees from {}\n", rounded(judgement.likenesses[i].degrees, 2),
                   judgement.likenesses[i].renderer.text());
}

void print_text(const std::string& file, const Image& picture, const synctest::SyncJudgement& judgement) {
    fmt::print("{}: {}, {} degrees on average (99 %: {}, largest: {}) over {} pixels\n", file,
               judgement.is_flat() ? "flat" : "not flat", rounded(judgement.mean), rounded(judgement.p99),
               rounded(judgement.worst), judgement.pixels);
    if (picture.bits == 8) fmt::print("8 bits of the picture alone make 0.32 degrees\n");
    if (judgement.was_srgb) fmt::print("the picture was stored as sRGB, and has been decoded\n");
    print_likenesses(judgement);
}

void print_json(const std::string& file, const synctest::SyncJudgement& judgement) {
    nlohmann::ordered_json all = {
        {"file", file},
        {"flat", judgement.is_flat()},
        {"degrees", {{"mean", judgement.mean}, {"p99", judgement.p99}, {"max", judgement.worst}}},
        {"pixels", judgement.pixels},
        {"was_srgb", judgement.was_srgb},
        {"overlap", judgement.overlap},
        {"frame", nullptr},
        {"in_sync", nullptr},
        {"likenesses", nlohmann::ordered_json::array()}};
    if (const auto renderer = judgement.renderer())
        all["frame"] = renderer->text(), all["in_sync"] = renderer->is_in_sync();
    for (const auto& [renderer, degrees] : judgement.likenesses)
        all["likenesses"].push_back({{"frame", renderer.text()}, {"degrees", degrees}});
    // A file name can contain bytes that are not valid UTF-8.
    fmt::print("{}\n", all.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

int judge(const std::string& file, bool as_json) {
    const Image picture = read_image(file);
    const synctest::SyncJudgement judgement = synctest::judge_synctest(picture);
    if (!judgement.shows_normals)
        throw Error({file},
                    fmt::format("shows no normals{}: colours are to be 0.5 n + 0.5, in the space of the world or "
                                "the object",
                                judgement.problem.empty() ? "" : fmt::format(" ({})", judgement.problem)));
    if (as_json)
        print_json(file, judgement);
    else
        print_text(file, picture, judgement);
    return judgement.is_flat() ? 0 : 1;
}

class SynctestCommand final : public Command {
public:
    void options(CommandOptions& options) override {
        options.value("-o", "FOLDER", output_,
                      "write the cube, its map, and a README.md that says what to do with them");
        options.value("--judge", "PICTURE", picture_, "a picture of the cube's normals by another renderer");
        options.flag("--json", json_, "with --judge: print JSON, for scripts");
        options.footer(
            [] { return std::string("Exit code of --judge: 0 flat to half a degree, 1 not, 2 wrong use."); });
    }
    int run() override {
        if (output_.empty() == picture_.empty()) throw UsageError("synctest takes -o FOLDER or --judge PICTURE");
        if (json_ && picture_.empty()) throw UsageError("--json goes with --judge PICTURE");
        if (!picture_.empty()) return judge(picture_, json_);
        synctest::write_synctest(output_);
        fmt::print("{}\n", (std::filesystem::path(output_) / "README.md").string());
        return 0;
    }

private:
    std::string output_, picture_;
    bool json_ = false;
};
RELIEF_COMMAND(SynctestCommand, 16, "synctest",
               "writes a cube that other renderers must show flat, and judges their pictures of it");

}  // namespace
}  // namespace relief::app
