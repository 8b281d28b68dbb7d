#include "framework/staff/questions/questions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <span>

#include "framework/core/base/error.h"
#include "framework/core/base/parallel.h"
#include "framework/core/base/text.h"
#include "framework/course/explain/lone_function.h"
#include "framework/course/task/task_text.h"
#include "framework/library/maps/visualize.h"
#include "framework/staff/grade/variation.h"
#include "framework/staff/questions/dice.h"
#include "framework/staff/questions/mistake_riddles.h"

namespace relief::grade {
namespace {

/// A difference that a person sees, in a channel.
constexpr double seen_change = 8.0 / 255 + 1e-6;
constexpr size_t pixels_of_a_check = 8, checks_noted = 8, mutants_drawn = 12, views_of_a_task = 3;
constexpr int digits_of_answers = 4;
/// How far an answer may be off, and how far rounded arguments may move a result, as shares of its largest number.
constexpr double share_of_margin = 0.005, share_of_rounding = 0.0025;
constexpr glm::ivec2 sheet_size{240, 180};

double size_of(const std::vector<float>& numbers) {
    double largest = 0;
    for (const float number : numbers) largest = std::max(largest, double(std::abs(number)));
    return largest;
}

check::ValueShape shape_of_result(size_t count) {
    if (count == 1) return {};
    return {.name = {}, .kind = check::ValueShape::group, .parts = std::vector<check::ValueShape>(count)};
}

check::ShownValue answer_of(const check::LoneCall& call) {
    const float* at = call.results.data();
    return check::shown_value(shape_of_result(call.results.size()), at, digits_of_answers);
}

std::string numbers_at(const Image& image, glm::ivec2 pixel) {
    std::string text;
    for (int i = 0; i < image.channels; ++i)
        text += (i == 0 ? "" : ", ") + rounded(double(image.pixel(pixel.x, pixel.y)[i]));
    return text;
}

/// Returns the error of each pixel; NaN where one of the two has no value.
Image errors_of(const Image& drawn, const Image& expected, const ProbeInfo* probe) {
    if (probe) return error_image(drawn, expected, probe->error);
    Image errors(drawn.width, drawn.height, 1);
    for (size_t i = 0; i < drawn.values.size(); ++i) {
        float& error = errors.values[i / size_t(drawn.channels)];
        error = std::max(error, std::abs(drawn.values[i] - expected.values[i]));
    }
    return errors;
}

Image as_seen(const Image& image, const ProbeInfo* probe) {
    return probe ? visualize_probe(image, probe->colors()) : visualize_picture(image);
}

std::string trimmed_line(const std::string& text, int line) {
    const std::string all = split(text, '\n').at(size_t(line) - 1);
    const size_t begin = all.find_first_not_of(" \t\r"), end = all.find_last_not_of(" \t\r");
    return begin == std::string::npos ? "" : printable(all.substr(begin, end + 1 - begin));
}

}  // namespace

std::vector<glm::ivec2> telling_pixels(const Image& drawn, const Image* expected, const ProbeInfo* probe, size_t count,
                                       const std::string& seed) {
    const Image errors = expected ? errors_of(drawn, *expected, probe) : Image();
    double largest = 0;
    for (const float error : errors.values)
        if (std::isfinite(error)) largest = std::max(largest, double(error));
    if (expected && largest == 0) return {};
    std::vector<glm::ivec2> pixels;
    for (int y = 2; y + 2 < drawn.height; ++y)
        for (int x = 2; x + 2 < drawn.width; ++x) {
            const float* const value = drawn.pixel(x, y);
            const bool is_finite = std::all_of(value, value + drawn.channels, [](float v) { return std::isfinite(v); });
            bool tells = is_finite && (probe || !std::equal(value, value + drawn.channels, drawn.pixel(0, 0)));
            if (expected) {
                const float error = *errors.pixel(x, y);
                tells = is_finite && std::isfinite(error) && double(error) >= largest / 2 &&
                        (probe || double(error) > seen_change);
            }
            if (tells) pixels.emplace_back(x, y);
        }
    std::mt19937 dice = dice_of(seed);
    shuffle(pixels, dice);
    pixels.resize(std::min(pixels.size(), count));
    return pixels;
}

bool is_telling(const check::LoneCall& call) {
    const double size = size_of(call.results);
    if (!std::isfinite(size) || size == 0 || answer_of(call).text.empty()) return false;
    const auto is_near = [&](float a, float b, double share) {
        return std::abs(double(a) - double(b)) <= share * size;
    };
    for (size_t i = 0; i < call.results.size(); ++i)
        if (!is_near(call.results[i], call.again[i], share_of_rounding)) return false;
    const std::vector<float> shown = answer_of(call).numbers;
    if (std::all_of(shown.begin(), shown.end(), [](float v) { return v == 0 || std::abs(v) == 1; })) return false;
    const auto copied = std::search(call.inputs.begin(), call.inputs.end(), call.results.begin(), call.results.end(),
                                    [&](float a, float b) { return is_near(a, b, 2 * share_of_margin); });
    return copied == call.inputs.end();
}

bool are_distinct(const Image& a, const Image& b) {
    return double(difference(a, b, distinct_change).pixels_over) >= distinct_share * double(a.pixel_count());
}

std::vector<size_t> distinct_pictures(const std::vector<Image>& pictures, size_t count) {
    std::vector<size_t> taken;
    for (size_t i = 0; i < pictures.size() && taken.size() < count; ++i) {
        if (pictures[i].values.empty()) continue;
        const bool is_new = std::all_of(taken.begin(), taken.end(),
                                        [&](size_t other) { return are_distinct(pictures[i], pictures[other]); });
        if (is_new) taken.push_back(i);
    }
    return taken;
}

std::vector<Question> chosen_questions(const std::vector<LabQuestions>& labs, size_t count) {
    std::vector<Question> chosen;
    std::map<std::pair<size_t, QuestionKind>, size_t> next;  // by lab and kind
    for (bool found = true; found && chosen.size() < count;) {
        found = false;
        for (const QuestionKind kind :
             {QuestionKind::value, QuestionKind::picture, QuestionKind::line, QuestionKind::mistake})
            for (size_t i = 0; i < labs.size() && chosen.size() < count; ++i) {
                const std::vector<Question>& all = labs[i].questions;
                size_t& at = next[{i, kind}];
                while (at < all.size() && all[at].kind != kind) ++at;
                if (at == all.size()) continue;
                chosen.push_back(all[at++]);
                found = true;
            }
    }
    return chosen;
}

QuestionMaker::QuestionMaker(const LabEntry& lab, const Stage& stage, GradeSetup setup)
    : lab_(lab),
      stage_(stage),
      setup_([&] {
          setup.seed.clear();
          return setup;
      }()),
      views_(lab, stage, setup_),
      others_(lab, views_.manifest()) {}

/// The questions about one submission.
class QuestionMaker::Sheet {
public:
    Sheet(const QuestionMaker& maker, const Submission& submission, size_t count, const std::string& seed, int jobs)
        : maker_(maker),
          manifest_(maker.views_.manifest()),
          count_(count),
          seed_(seed + "|" + submission.hash + "|" + maker.lab_.folder),
          jobs_(jobs),
          files_(solution_files(manifest_)),
          limits_{.cpu = std::max(60.0, 20 * maker.views_.solution_cpu())} {
        for (const TaskInfo& task : manifest_.tasks) take(task, submission);
    }

    LabQuestions make(const std::function<void(const std::string&)>& begins) {
        begins("checks");
        if (result_.problem.empty() && asked_.empty()) result_.problem = "has no shader task that is written";
        if (result_.problem.empty()) draw_checks();
        begins("values");
        if (result_.problem.empty()) ask_for_values();
        begins("changed lines");
        if (result_.problem.empty()) ask_for_changes();
        begins("known mistakes");
        if (result_.problem.empty()) ask_about_mistakes();
        return std::move(result_);
    }

private:
    void take(const TaskInfo& task, const Submission& submission) {
        if (!is_shader(task.file)) return;
        if (const auto refused = submission.refused.find(task.file); refused != submission.refused.end()) {
            result_.problem = fmt::format("{} is {}", task.file, refused->second);
            return;
        }
        const auto own = submission.files.find(task.file);
        if (own == submission.files.end()) return;
        if (const std::string beyond = check::broken_rule(own->second, maker_.others_); !beyond.empty()) {
            result_.problem = fmt::format("{} {}", task.file, printable(beyond));
            return;
        }
        files_[task.file] = own->second;
        if (const std::string missing = check::missing_text(own->second, task); !missing.empty())
            result_.problem = missing;
        else if (!check::is_unfinished(own->second, task))
            asked_.push_back(&task);
    }

    bool is_asked(const std::string& task) const {
        return std::any_of(asked_.begin(), asked_.end(), [&](const TaskInfo* one) { return one->id == task; });
    }

    void draw_checks() {
        const std::vector<CheckInfo>& checks = manifest_.checks;
        std::vector<bool> wanted;
        for (const CheckInfo& check : checks)
            wanted.push_back(!check.hidden && !check.shot.calls && is_asked(check.task));
        drawn_ = maker_.views_.draw(files_, wanted, WhichViews::own);
        for (size_t i = 0; i < checks.size(); ++i)
            if (wanted[i] && drawn_.checks[i].own.image) usable_.push_back(i);
        if (!usable_.empty()) return;
        result_.problem = "draws nothing";
        for (size_t i = 0; i < checks.size(); ++i)
            if (wanted[i]) result_.problem = printable(drawn_.checks[i].own.error);
    }

    const ProbeInfo* probe_of(const Shot& shot) const {
        return shot.probe ? &manifest_.probe(shot.probe.name) : nullptr;
    }

    /// A check of which values are asked.
    struct Noted {
        size_t check;
        check::Verdict said;
        bool lost = false;  ///< it fails through its own task, and its pixels are wrong
        check::NotedShot shot = {};
    };

    /// Returns the checks to ask about: those that fail come first, the others are in a seeded order.
    std::vector<Noted> noted_checks() const {
        std::vector<Noted> noted;
        std::vector<check::Verdict> said(manifest_.checks.size(), {check::Outcome::passed});
        for (const size_t i : usable_) said[i] = maker_.views_.judge(maker_.views_.own(i, drawn_));
        // A check that waits for another task costs no mark of its own.
        const std::vector<check::Cause> causes = check::causes_of(manifest_, said);
        for (const size_t i : usable_)
            noted.push_back({i, said[i], said[i].outcome == check::Outcome::wrong && causes[i].first.empty()});
        std::mt19937 dice = dice_of(seed_ + "|checks");
        shuffle(noted, dice);
        std::stable_partition(noted.begin(), noted.end(), [](const Noted& one) { return one.lost; });
        noted.resize(std::min(noted.size(), std::max(checks_noted, count_)));
        for (Noted& one : noted) {
            const CheckInfo& check = manifest_.checks[one.check];
            const Comparison shown = maker_.views_.own(one.check, drawn_);
            const Image& drawn = *shown.drawn.image;
            const std::string seed = seed_ + "|" + check.name;
            one.shot.shot = check.shot;
            if (one.lost && shown.expected() && drawn.same_shape(*shown.expected()))
                one.shot.pixels =
                    telling_pixels(drawn, &*shown.expected(), probe_of(check.shot), pixels_of_a_check, seed);
            one.lost = !one.shot.pixels.empty();
            if (!one.lost)
                one.shot.pixels = telling_pixels(drawn, nullptr, probe_of(check.shot), pixels_of_a_check, seed);
        }
        return noted;
    }

    void ask_for_values() {
        const std::vector<Noted> noted = noted_checks();
        std::vector<check::NotedShot> shots;
        for (const Noted& one : noted) shots.push_back(one.shot);
        const check::NotedCalls calls =
            note_calls(maker_.stage_, maker_.lab_, files_, shots, maker_.setup_.renderer, limits_);
        std::set<std::string> known;  // functions that a question is about
        size_t asked = 0;
        // The first round takes one function of each check.
        for (const bool is_first : {true, false})
            for (size_t i = 0; i < noted.size(); ++i)
                for (size_t pixel = 0; pixel < calls[i].size(); ++pixel)
                    for (const check::LoneCall& call : calls[i][pixel]) {
                        if (asked == count_ || known.contains(call.name) || !is_telling(call)) continue;
                        if (is_first && known.contains(manifest_.checks[noted[i].check].name)) continue;
                        if (!is_of_task(call, manifest_.checks[noted[i].check].task)) continue;
                        add_value(noted[i], noted[i].shot.pixels[pixel], call);
                        known.insert(call.name);
                        known.insert(manifest_.checks[noted[i].check].name);
                        ++asked;
                    }
    }

    bool is_of_task(const check::LoneCall& call, const std::string& task) const {
        return call.file == manifest_.task(task).file && call.line > 0 &&
               check::task_at_line(files_.at(call.file), manifest_.tasks, call.file, size_t(call.line)) == task;
    }

    void add_value(const Noted& noted, glm::ivec2 pixel, const check::LoneCall& call) {
        const CheckInfo& check = manifest_.checks[noted.check];
        const Comparison shown = maker_.views_.own(noted.check, drawn_);
        Question question = begun(QuestionKind::value, manifest_.task(check.task), check);
        question.pictures = {as_seen(*shown.drawn.image, probe_of(check.shot))};
        question.pixel = pixel;
        question.probe = check.shot.probe.name;
        question.call = call;
        question.call.name = printable(call.name);
        for (std::string& argument : question.call.arguments) argument = printable(argument);
        question.answer = answer_of(call).text;
        question.margin = share_of_margin * size_of(call.results);
        question.mark_is_lost = noted.lost;
        if (noted.lost) {
            question.drawn_here = numbers_at(*shown.drawn.image, pixel);
            question.expected_here = numbers_at(*shown.expected(), pixel);
            if (const ProbeInfo* const probe = probe_of(check.shot); probe && probe->error != ErrorMetric::angle)
                question.unit = plural(probe->unit);
            question.found = noted.said.found;
            question.look_at = check::hint_of(check, noted.said);
        }
        result_.questions.push_back(std::move(question));
    }

    Question begun(QuestionKind kind, const TaskInfo& task, const CheckInfo& check) const {
        Question question;
        question.kind = kind;
        question.lab = maker_.lab_.folder;
        question.task = task.id;
        question.file = task.file;
        question.view = check.name;
        return question;
    }

    /// A view of a check, with its probe or without.
    struct ChangeView {
        const CheckInfo* check = nullptr;
        Shot shot = {};
    };
    /// Changed lines of one task, and their pictures in the view that shows most of them.
    struct Changed {
        const TaskInfo* task;
        std::vector<Mutant> mutants;
        ChangeView view = {};
        /// The student's own picture, then the mutants'. Empty where nothing is drawn.
        std::vector<Image> pictures = {};
        std::vector<size_t> distinct = {};  ///< the pictures that differ from each other
        bool is_enough() const { return distinct.size() >= 5; }
    };

    void ask_for_changes() {
        std::vector<Changed> tasks;
        for (const TaskInfo* task : asked_) tasks.push_back({task, sampled_mutants(*task)});
        std::mt19937 dice = dice_of(seed_ + "|tasks");
        shuffle(tasks, dice);
        tasks.resize(std::min(tasks.size(), count_));
        draw_changes(tasks, false);
        draw_changes(tasks, true);  // probes are harder to read than pictures
        // Each task has at most one question of each kind, and their changes differ if there are enough.
        for (const Changed& one : tasks) {
            const std::vector<size_t>& distinct = one.distinct;
            if (distinct.size() >= 4) add_picture(one, {distinct.begin(), distinct.begin() + 4});
            if (one.is_enough()) add_line(one, {distinct.end() - 4, distinct.end()});
        }
    }

    std::vector<Mutant> sampled_mutants(const TaskInfo& task) const {
        const std::string& text = files_.at(task.file);
        std::vector<Mutant> all = line_mutants_of(text);
        std::erase_if(all, [&](const Mutant& one) {
            return check::task_at_line(text, manifest_.tasks, task.file, size_t(one.line)) != task.id;
        });
        std::mt19937 dice = dice_of(seed_ + "|" + task.id);
        shuffle(all, dice);
        std::set<int> lines;
        std::vector<Mutant> sample, others;
        for (Mutant& one : all)  // first one of each line
            (lines.insert(one.line).second ? sample : others).push_back(std::move(one));
        std::move(others.begin(), others.end(), std::back_inserter(sample));
        sample.resize(std::min(sample.size(), mutants_drawn));
        return sample;
    }

    /// Returns different views of a task's checks that draw something.
    std::vector<ChangeView> change_views(const TaskInfo& task, bool with_probes) const {
        std::vector<ChangeView> views;
        std::set<std::string> known;
        for (const size_t i : usable_) {
            const CheckInfo& check = manifest_.checks[i];
            Shot shot = check.shot;
            if (!with_probes) shot.probe = {};
            shot.size = glm::min(shot.size, sheet_size);
            if (check.task == task.id && bool(shot.probe) == with_probes && views.size() < views_of_a_task &&
                known.insert(shot.probe.name + view_text(shot)).second)
                views.push_back({&check, shot});
        }
        return views;
    }

    /// Draws the changes of tasks that have not enough pictures yet, and takes the view that shows more of them.
    void draw_changes(std::vector<Changed>& tasks, bool with_probes) const {
        struct Place {
            size_t task, mutant;  ///< mutant 0 is the student's own file
        };
        std::vector<std::vector<ChangeView>> views(tasks.size());
        std::vector<std::vector<std::vector<Image>>> drawn(tasks.size());  // by task, view and mutant
        std::vector<Place> places;
        for (size_t i = 0; i < tasks.size(); ++i) {
            if (!tasks[i].is_enough()) views[i] = change_views(*tasks[i].task, with_probes);
            drawn[i].assign(views[i].size(), std::vector<Image>(tasks[i].mutants.size() + 1));
            for (size_t mutant = 0; !views[i].empty() && mutant <= tasks[i].mutants.size(); ++mutant)
                places.push_back({i, mutant});
        }
        parallel_each(places.size(), unsigned(jobs_), [&](size_t i) {
            const auto [task, mutant] = places[i];
            draw_change(tasks[task], views[task], mutant, drawn[task]);
        });
        for (size_t i = 0; i < tasks.size(); ++i)
            for (size_t view = 0; view < views[i].size(); ++view) {
                if (drawn[i][view].front().values.empty()) continue;
                std::vector<size_t> distinct = distinct_pictures(drawn[i][view], 8);
                if (distinct.size() <= tasks[i].distinct.size()) continue;
                tasks[i].distinct = std::move(distinct);
                tasks[i].view = views[i][view];
                tasks[i].pictures = std::move(drawn[i][view]);
            }
    }

    /// Draws all views of one changed file into `pictures`, by view and mutant.
    void draw_change(const Changed& of, const std::vector<ChangeView>& views, size_t mutant,
                     std::vector<std::vector<Image>>& pictures) const {
        CourseFiles files = files_;
        if (mutant > 0) files[of.task->file] = of.mutants[mutant - 1].text;
        draw_views(files, views, mutant, pictures);
    }

    /// Draws all views of the files into `pictures`, by view and `place`.
    void draw_views(const CourseFiles& files, const std::vector<ChangeView>& views, size_t place,
                    std::vector<std::vector<Image>>& pictures) const {
        const AttemptLimits limits{.cpu = std::max(10.0, 10 * maker_.views_.solution_cpu())};
        std::vector<Shot> shots;
        for (const ChangeView& view : views) shots.push_back(view.shot);
        const Attempt drawn = attempt(maker_.stage_, maker_.lab_, files, shots, maker_.setup_.renderer, limits);
        for (size_t view = 0; view < views.size(); ++view)
            if (const auto& image = drawn.shots[view].image; image && !is_one_color(*image))
                pictures[view][place] = as_seen(*image, probe_of(shots[view]));
    }

    LineChange change_of(const Changed& of, size_t picture) const {
        const Mutant& mutant = of.mutants.at(picture - 1);
        return {mutant.line, trimmed_line(files_.at(of.task->file), mutant.line),
                trimmed_line(mutant.text, mutant.line)};
    }

    std::mt19937 dice_for(const Changed& of, const char* what) const {
        return dice_of(seed_ + "|" + what + "|" + of.task->id);
    }

    static std::string letter(size_t place) { return std::string(1, char('A' + place)); }

    /// `choices`: the student's own picture, then the pictures of three changes. The question is about the first
    /// change.
    void add_picture(const Changed& of, std::vector<size_t> choices) {
        Question question = begun(QuestionKind::picture, *of.task, *of.view.check);
        question.probe = of.view.shot.probe.name;
        const size_t right = choices[1];
        question.changes = {change_of(of, right)};
        std::mt19937 dice = dice_for(of, "picture");
        shuffle(choices, dice);
        for (size_t i = 0; i < choices.size(); ++i) {
            question.pictures.push_back(of.pictures[choices[i]]);
            if (choices[i] == right) question.answer = letter(i);
        }
        result_.questions.push_back(std::move(question));
    }

    /// `choices`: the pictures of four changes; the question shows the last.
    void add_line(const Changed& of, std::vector<size_t> choices) {
        Question question = begun(QuestionKind::line, *of.task, *of.view.check);
        question.probe = of.view.shot.probe.name;
        const size_t right = choices.back();
        question.pictures = {of.pictures.front(), of.pictures[right]};
        std::mt19937 dice = dice_for(of, "line");
        shuffle(choices, dice);
        for (size_t i = 0; i < choices.size(); ++i) {
            question.changes.push_back(change_of(of, choices[i]));
            if (choices[i] == right) question.answer = letter(i);
        }
        result_.questions.push_back(std::move(question));
    }

    void ask_about_mistakes() {
        std::vector<const TaskInfo*> tasks = asked_;
        std::mt19937 dice = dice_of(seed_ + "|mistakes");
        shuffle(tasks, dice);
        tasks.resize(std::min(tasks.size(), count_));
        for (const TaskInfo* task : tasks)
            for (const bool with_probes : {false, true})
                if (ask_about_mistake(*task, with_probes)) break;
    }

    /// Returns known mistakes of shaders, those of the task first, each group in a seeded order.
    std::vector<const MistakeInfo*> sampled_mistakes(const TaskInfo& task) const {
        std::vector<const MistakeInfo*> sample;
        for (const MistakeInfo& one : manifest_.mistakes)
            if (one.same_as.empty() && is_asked(one.task) &&
                std::all_of(one.edits.begin(), one.edits.end(), [](const Edit& edit) { return is_shader(edit.file); }))
                sample.push_back(&one);
        std::mt19937 dice = dice_of(seed_ + "|mistakes|" + task.id);
        shuffle(sample, dice);
        std::stable_partition(sample.begin(), sample.end(),
                              [&](const MistakeInfo* one) { return one->task == task.id; });
        sample.resize(std::min(sample.size(), mutants_drawn));
        return sample;
    }

    /// Adds a question about a known mistake of the task whose picture differs visibly from the right one and from
    /// those of three other mistakes. Returns whether there is one.
    bool ask_about_mistake(const TaskInfo& task, bool with_probes) {
        const std::vector<const MistakeInfo*> mistakes = sampled_mistakes(task);
        const std::vector<ChangeView> views = change_views(task, with_probes);
        if (views.empty()) return false;
        std::vector<CourseFiles> files(1, solution_files(manifest_));
        for (const MistakeInfo* one : mistakes) {
            files.push_back(files.front());
            for (auto& [file, text] : edited(one->edits)) files.back()[file] = text;
        }
        std::vector<std::vector<Image>> pictures(views.size(), std::vector<Image>(files.size()));
        parallel_each(files.size(), unsigned(jobs_), [&](size_t i) { draw_views(files[i], views, i, pictures); });
        for (size_t view = 0; view < views.size(); ++view)
            for (size_t i = 1; i < files.size() && mistakes[i - 1]->task == task.id; ++i)
                if (add_mistake(task, views[view], mistakes, pictures[view], i)) return true;
        return false;
    }

    /// `pictures`: the solution's, then one of each mistake. The question is about the picture `right`.
    bool add_mistake(const TaskInfo& task, const ChangeView& view, const std::vector<const MistakeInfo*>& mistakes,
                     const std::vector<Image>& pictures, size_t right) {
        std::vector<std::string> hints;
        for (const MistakeInfo* one : mistakes) hints.push_back(one->hint);
        std::vector<size_t> choices = choices_beside(right - 1, pictures[0], std::span(pictures).subspan(1), hints);
        if (choices.empty()) return false;
        Question question = begun(QuestionKind::mistake, task, *view.check);
        question.probe = view.shot.probe.name;
        question.pictures = {pictures[0], pictures[right]};
        std::mt19937 dice = dice_of(seed_ + "|mistake|" + task.id);
        shuffle(choices, dice);
        for (size_t i = 0; i < choices.size(); ++i) {
            question.hints.push_back(hints[choices[i]]);
            if (choices[i] == right - 1) question.answer = letter(i);
        }
        result_.questions.push_back(std::move(question));
        return true;
    }

    const QuestionMaker& maker_;
    const Manifest& manifest_;
    size_t count_;
    std::string seed_;
    int jobs_;
    CourseFiles files_;  ///< the student's shaders, and the solution's files where there is none
    AttemptLimits limits_;
    std::vector<const TaskInfo*> asked_;  ///< the written tasks
    DrawnChecks drawn_;
    std::vector<size_t> usable_;  ///< the public checks of these tasks that draw an image
    LabQuestions result_;
};

LabQuestions QuestionMaker::ask(const Submission& submission, size_t count, const std::string& seed, int jobs,
                                const std::function<void(const std::string&)>& begins) const {
    return Sheet(*this, submission, count, seed + "|" + submission.name, jobs).make(begins);
}

}  // namespace relief::grade
