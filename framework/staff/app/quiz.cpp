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
#include "framework/staff/questions/dice.h"
#include "framework/staff/questions/mistake_riddles.h"

namespace relief::app {
namespace {

using nlohmann::json;

constexpr int quiz_side = 480;  ///< longer side of a picture, in pixels

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

/// Returns the fields of a choice, for one with a picture of its own or without.
pages::Fields choice_fields(size_t place, const std::string& text, bool is_answer, const std::string& said) {
    return {{"letter", letter_of(place)},
            {"hint", pages::with_code(text)},
            {"is_answer", is_answer},
            {"said", pages::with_code(said)}};
}

pages::Fields riddle_fields(const TaskInfo& task, const json& drawn) {
    const std::vector<std::string> hints = drawn.at("hints");
    const size_t answer = drawn.at("answer");
    pages::List choices;
    for (size_t i = 0; i < hints.size(); ++i)
        choices.push_back(choice_fields(i, hints[i], i == answer,
                                        i == answer ? "this mistake draws the picture." : "this mistake draws this:"));
    return {{"place", task.id},
            {"id", task.id},
            {"title", task.title},
            {"drawn", pages::Fields{{"id", task.id},
                                    {"check", drawn.at("check").get<std::string>()},
                                    {"probe", drawn.at("probe").get<std::string>()},
                                    {"width", drawn.at("width").get<int>()},
                                    {"height", drawn.at("height").get<int>()},
                                    {"answer", letter_of(answer)}}},
            {"choices", std::move(choices)}};
}

/// `place`: a word that no other question of the page has.
pages::Fields question_fields(const QuestionInfo& question, const std::string& place) {
    std::vector<std::string> answers = {question.right};
    answers.insert(answers.end(), question.wrong.begin(), question.wrong.end());
    std::mt19937 dice = grade::dice_of(question.asks);
    grade::shuffle(answers, dice);
    pages::List choices;
    for (size_t i = 0; i < answers.size(); ++i) {
        const bool is_answer = answers[i] == question.right;
        choices.push_back(
            choice_fields(i, answers[i], is_answer, is_answer ? question.why : "read the handout again."));
    }
    return {{"place", place}, {"id", ""}, {"title", question.asks}, {"drawn", ""}, {"choices", std::move(choices)}};
}

}  // namespace

void write_quiz(const std::vector<const LabEntry*>& labs, const std::filesystem::path& folder, ContextChoice choice) {
    const std::vector<QuizPart> parts = quiz_parts(labs);
    std::map<std::string, json> drawn;  // by task
    std::string driver;
    Progress progress{int(parts.size())};
    share_among_processes(
        parts.size(), [&](const NextPart& next, const Say& say) { draw_riddles(parts, folder, choice, next, say); },
        [&](const std::string& text) {
            json message = json::parse(text);
            driver = message.at("driver");
            const std::string task = message.at("task");
            progress.next("task " + task);
            if (message.contains("hints")) drawn[task] = std::move(message);
        });
    pages::List all;
    int count = 0;
    for (const LabEntry* lab : labs) {
        const Manifest manifest = load_manifest(*lab);
        pages::List questions;
        for (const TaskInfo& task : manifest.tasks)
            if (const auto found = drawn.find(task.id); found != drawn.end())
                questions.push_back(riddle_fields(task, found->second));
        for (const QuestionInfo& question : manifest.questions)
            questions.push_back(question_fields(question, fmt::format("{}-{}", lab->two_digits(), questions.size())));
        if (questions.empty()) continue;
        count += int(questions.size());
        const pages::Fields named = {{"number", lab->two_digits()}, {"title", manifest.title}};
        if (!all.empty()) all.back().fields["next"] = named;
        all.push_back(pages::Fields{named});
        all.back().fields.insert({{"questions", std::move(questions)}, {"next", {}}});
    }
    if (all.empty()) throw Error("no task has four mistakes that a picture tells apart, and the lab has no questions");
    write_file(folder / "index.html", pages::render({.title = "Relief: which mistake made this picture?",
                                                     .body = "framework/staff/pages/quiz",
                                                     .styles = {"framework/staff/pages/quiz"},
                                                     .scripts = {},
                                                     .pictures = pages::PagePictures::beside},
                                                    {{"count", count}, {"labs", std::move(all)}, {"driver", driver}}));
}

}  // namespace relief::app
