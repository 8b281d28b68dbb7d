#include "framework/staff/pages/question_pages.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "framework/core/base/text.h"
#include "framework/course/pages/page.h"
#include "framework/staff/pages/student_page.h"

namespace relief::pages {
namespace {

using grade::Question;
using grade::QuestionKind;

std::string letter_of(size_t place) { return std::string(1, char('A' + place)); }

/// Returns a picture with its letter, which may be empty.
Fields picture_of(const Image& picture, const std::string& letter, const std::string& caption) {
    return {{"src", picture_uri(picture)},
            {"width", picture.width},
            {"height", picture.height},
            {"letter", letter},
            {"caption", caption}};
}

Fields change_of(const grade::LineChange& change, const std::string& letter) {
    return {{"letter", letter},
            {"line", change.line},
            {"was", change.was},
            {"now", change.now.empty() ? "(nothing)" : change.now}};
}

List changes_of(const Question& question) {
    List changes;
    for (size_t i = 0; i < question.changes.size(); ++i)
        changes.push_back(change_of(question.changes[i], question.changes.size() > 1 ? letter_of(i) : ""));
    return changes;
}

List hints_of(const Question& question) {
    List hints;
    for (size_t i = 0; i < question.hints.size(); ++i)
        hints.push_back(Fields{{"letter", letter_of(i)}, {"hint", with_code(question.hints[i])}});
    return hints;
}

std::string call_text(const check::LoneCall& call) {
    return call.count > 1 ? fmt::format("call {} of {} at this pixel", call.number + 1, call.count) : "";
}

/// Returns the fields that a sheet and the key share. None of them tells the answer.
Fields question_fields(const Question& question, size_t number) {
    const bool is_value = question.kind == QuestionKind::value;
    Fields value = {{"function", question.call.name},
                    {"line", question.call.line},
                    {"call", call_text(question.call)},
                    {"column", question.pixel.x},
                    {"row", question.pixel.y},
                    {"arguments", rows(question.call.arguments)},
                    {"mark_is_lost", question.mark_is_lost}};
    return {{"number", number},
            {"task", question.task},
            {"file", question.file},
            {"view", question.view},
            {"probe", question.probe},
            {"value", is_value ? Value(std::move(value)) : Value()},
            {"which_picture", question.kind == QuestionKind::picture},
            {"which_line", question.kind == QuestionKind::line},
            {"which_mistake", question.kind == QuestionKind::mistake},
            {"hints", hints_of(question)},
            {"changes", changes_of(question)}};
}

Fields sheet_fields(const Question& question, size_t number) {
    Fields fields = question_fields(question, number);
    List pictures;
    Value mark;
    for (size_t i = 0; i < question.pictures.size(); ++i) {
        const bool is_choice = question.kind == QuestionKind::picture;
        const bool is_mistake = question.kind == QuestionKind::mistake;
        const char* const caption = is_choice              ? ""
                                    : is_mistake && i == 0 ? "right"
                                    : is_mistake           ? "with a mistake"
                                    : i == 0               ? "your picture"
                                                           : "with one line changed";
        pictures.push_back(picture_of(question.pictures[i], is_choice ? letter_of(i) : "", caption));
    }
    if (question.kind == QuestionKind::value && !question.pictures.empty()) {
        const Image& picture = question.pictures.front();
        mark = Fields{{"left", fmt::format("{:.2f}", 100 * (question.pixel.x + 0.5) / picture.width)},
                      {"top", fmt::format("{:.2f}", 100 * (question.pixel.y + 0.5) / picture.height)}};
    }
    fields["pictures"] = std::move(pictures);
    fields["mark"] = std::move(mark);
    return fields;
}

std::string answer_text(const Question& question) {
    if (question.kind != QuestionKind::value) return question.answer;
    return fmt::format("{} (± {})", question.answer, rounded(question.margin, 2));
}

Fields key_fields(const Question& question, size_t number) {
    Fields fields = question_fields(question, number);
    Value why;
    if (question.mark_is_lost)
        why = Fields{{"drawn", question.drawn_here},
                     {"expected", question.expected_here},
                     {"unit", question.unit},
                     {"found", question.found},
                     {"look_at", with_code(question.look_at)}};
    fields["answer"] = answer_text(question);
    fields["why"] = std::move(why);
    return fields;
}

std::string too_few(const StudentQuestions& student) {
    if (student.questions.size() >= student.wanted) return {};
    return fmt::format("{} of {} questions: this code has no more with an answer that can be checked",
                       student.questions.size(), student.wanted);
}

}  // namespace

std::string question_sheet(const StudentQuestions& student) {
    List questions;
    for (const Question& question : student.questions)
        questions.push_back(sheet_fields(question, questions.size() + 1));
    return render(
        {.title = "Questions about your code",
         .body = "framework/staff/pages/question_sheet",
         .styles = {"framework/staff/pages/questions"},
         .scripts = {}},
        {{"name", grade::printable(student.name)}, {"questions", std::move(questions)}, {"too_few", too_few(student)}});
}

std::string question_key(const std::vector<StudentQuestions>& students) {
    List all;
    for (const StudentQuestions& student : students) {
        List questions;
        for (const Question& question : student.questions)
            questions.push_back(key_fields(question, questions.size() + 1));
        all.push_back(Fields{{"name", grade::printable(student.name)},
                             {"questions", std::move(questions)},
                             {"too_few", student.questions.empty() ? "no sheet" : too_few(student)},
                             {"problems", rows(student.problems)}});
    }
    return render({.title = "Questions: the key",
                   .body = "framework/staff/pages/question_key",
                   .styles = {"framework/staff/pages/questions"},
                   .scripts = {}},
                  {{"students", std::move(all)}});
}

std::string questions_json(const std::vector<StudentQuestions>& students, const std::string& seed) {
    using Json = nlohmann::ordered_json;
    constexpr const char* kinds[] = {"value", "picture", "line", "mistake"};
    Json all = Json::object();
    if (!seed.empty()) all["seed"] = seed;
    all["students"] = Json::array();
    for (const StudentQuestions& student : students) {
        Json questions = Json::array();
        for (const Question& question : student.questions) {
            Json one = {{"kind", kinds[size_t(question.kind)]},
                        {"lab", question.lab},
                        {"task", question.task},
                        {"file", question.file},
                        {"view", question.view}};
            if (!question.probe.empty()) one["probe"] = question.probe;
            if (question.kind == QuestionKind::value) {
                one["pixel"] = {question.pixel.x, question.pixel.y};
                one["function"] = question.call.name;
                one["line"] = question.call.line;
                one["call"] = question.call.number + 1;
                one["arguments"] = question.call.arguments;
                one["returned"] = question.call.results;
                one["margin"] = question.margin;
                if (question.mark_is_lost) {
                    one["drawn"] = question.drawn_here;
                    one["expected"] = question.expected_here;
                }
            }
            for (const grade::LineChange& change : question.changes)
                one["changes"].push_back({{"line", change.line}, {"was", change.was}, {"now", change.now}});
            if (!question.hints.empty()) one["hints"] = question.hints;
            one["answer"] = question.answer;
            questions.push_back(std::move(one));
        }
        all["students"].push_back({{"name", grade::utf8_of_bytes(student.name)},
                                   {"wanted", student.wanted},
                                   {"problems", student.problems},
                                   {"questions", std::move(questions)}});
    }
    return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace relief::pages
