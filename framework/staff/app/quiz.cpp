#include "framework/staff/app/quiz.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/log.h"
#include "framework/core/base/text.h"
#include "framework/core/image/file.h"
#include "framework/course/app/shot.h"
#include "framework/course/pages/figures.h"
#include "framework/course/pages/page.h"
#include "framework/staff/app/share.h"
#include "framework/staff/questions/mistake_riddles.h"

namespace relief::app {
namespace {

using nlohmann::json;

constexpr int quiz_side = 320;  ///< longer side of a picture, in pixels

std::string letter_of(size_t choice) { return std::string(1, char('A' + int(choice))); }

/// The tasks of a lab about which there may be a question. One process draws them.
struct QuizPart {
    const LabEntry* lab;
    TaskInfo task;
};

std::vector<QuizPart> quiz_parts(const std::vector<const LabEntry*>& labs) {
    std::vector<QuizPart> parts;
    for (const LabEntry* lab : labs)
        for (const TaskInfo& task : load_manifest(*lab).tasks)
            if (is_shader(task.file)) parts.push_back({lab, task});
    return parts;
}

/// Draws riddles in a child process. Says each one's texts.
void draw_riddles(const std::vector<QuizPart>& parts, const std::filesystem::path& folder, ContextChoice choice,
                  const NextPart& next, const Say& say) {
    const auto context = open_context(choice);
    std::optional<grade::MistakePictures> pictures;
    const LabEntry* lab = nullptr;
    while (const auto place = next()) {
        const auto& [of_lab, task] = parts[*place];
        if (of_lab != lab)
            pictures.emplace(*of_lab, check::Renderer{.context = choice, .threads = 0, .pinned = is_pinned()},
                             quiz_side);
        lab = of_lab;
        json message{{"task", task.id}, {"driver", describe_context().driver()}};
        if (const auto riddle = grade::riddle_of(*pictures, *lab, task, quiz_side)) {
            const auto write = [&](const std::string& name, const Image& image) {
                pages::write_beside_page(folder / (task.id + "-" + name + ".png"),
                                         encode_image(image, ImageFormat::png));
            };
            write("right", riddle->right);
            for (size_t i = 0; i < riddle->choices.size(); ++i) {
                write(letter_of(i), riddle->choices[i].picture);
                message["hints"].push_back(riddle->choices[i].hint);
            }
            message["width"] = riddle->right.width, message["height"] = riddle->right.height;
            message["check"] = riddle->check->name, message["answer"] = riddle->answer;
            message["probe"] = riddle->is_probe ? riddle->check->shot.probe.name : "";
        }
        say(message.dump(-1, ' ', false, json::error_handler_t::replace));
    }
}

pages::Fields quiz_fields(const TaskInfo& task, const json& drawn) {
    const std::vector<std::string> hints = drawn.at("hints");
    const size_t answer = drawn.at("answer");
    pages::List choices;
    for (size_t i = 0; i < hints.size(); ++i)
        choices.push_back(pages::Fields{
            {"letter", letter_of(i)}, {"hint", pages::with_code(hints[i])}, {"is_answer", i == answer}});
    return {{"id", task.id},
            {"title", task.title},
            {"check", drawn.at("check").get<std::string>()},
            {"probe", drawn.at("probe").get<std::string>()},
            {"width", drawn.at("width").get<int>()},
            {"height", drawn.at("height").get<int>()},
            {"choices", std::move(choices)},
            {"answer", letter_of(answer)}};
}

}  // namespace

void write_quiz(const std::vector<const LabEntry*>& labs, const std::filesystem::path& folder, ContextChoice choice) {
    const std::vector<QuizPart> parts = quiz_parts(labs);
    std::map<std::string, json> drawn;  // by task
    std::string driver;
    int count = 0;
    Progress progress{int(parts.size())};
    share_among_processes(
        parts.size(), [&](const NextPart& next, const Say& say) { draw_riddles(parts, folder, choice, next, say); },
        [&](const std::string& text) {
            json message = json::parse(text);
            driver = message.at("driver");
            const std::string task = message.at("task");
            progress.next("task " + task);
            if (message.contains("hints")) drawn[task] = std::move(message), ++count;
        });
    pages::List all;
    for (const LabEntry* lab : labs) {
        const Manifest manifest = load_manifest(*lab);
        pages::List riddles;
        for (const TaskInfo& task : manifest.tasks)
            if (const auto found = drawn.find(task.id); found != drawn.end())
                riddles.push_back(quiz_fields(task, found->second));
        if (riddles.empty()) continue;
        const pages::Fields named = {{"number", lab->two_digits()}, {"title", manifest.title}};
        if (!all.empty()) all.back().fields["next"] = named;
        all.push_back(pages::Fields{named});
        all.back().fields.insert({{"riddles", std::move(riddles)}, {"next", {}}});
    }
    if (all.empty()) throw Error("no task has four mistakes that a picture tells apart");
    write_file(folder / "index.html", pages::render({.title = "Relief: which mistake made this picture?",
                                                     .body = "framework/staff/pages/quiz",
                                                     .styles = {"framework/staff/pages/quiz"},
                                                     .scripts = {},
                                                     .pictures = pages::PagePictures::beside},
                                                    {{"count", count}, {"labs", std::move(all)}, {"driver", driver}}));
}

}  // namespace relief::app
