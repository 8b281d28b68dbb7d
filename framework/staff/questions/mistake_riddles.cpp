#include "framework/staff/questions/mistake_riddles.h"

#include <algorithm>
#include <functional>
#include <set>
#include <tuple>

#include "framework/core/base/code_text.h"
#include "framework/core/image/compare.h"
#include "framework/library/maps/visualize.h"
#include "framework/staff/questions/dice.h"
#include "framework/staff/questions/questions.h"

namespace relief::grade {
namespace {

constexpr size_t most_riddle_views = 2, most_riddle_mistakes = 8;

bool tells_apart(const Image& a, const Image& b) { return distinct_pictures({a, b}, 2).size() == 2; }

/// Returns the words of a hint that say something: those of four letters or more.
std::set<std::string> long_words(const std::string& hint) {
    std::set<std::string> words;
    std::string word;
    for (const char c : hint + " ") {
        if (is_word_character(c))
            word += char(std::tolower(static_cast<unsigned char>(c)));
        else if (word.size() >= 4)
            words.insert(std::exchange(word, {}));
        else
            word.clear();
    }
    return words;
}

/// Returns whether two hints share more than half of the long words of the shorter one.
bool say_alike(const std::string& a, const std::string& b) {
    const std::set<std::string> words_a = long_words(a), words_b = long_words(b);
    const auto shared =
        std::count_if(words_a.begin(), words_a.end(), [&](const auto& word) { return words_b.contains(word); });
    return a == b || 2 * size_t(shared) > std::min(words_a.size(), words_b.size());
}

/// Returns known mistakes in shaders, those of the task first.
std::vector<const MistakeInfo*> riddle_mistakes(const Manifest& manifest, const TaskInfo& task) {
    std::vector<const MistakeInfo*> all;
    for (const MistakeInfo& one : manifest.mistakes)
        if (one.same_as.empty() &&
            std::all_of(one.edits.begin(), one.edits.end(), [](const Edit& edit) { return is_shader(edit.file); }))
            all.push_back(&one);
    std::stable_partition(all.begin(), all.end(), [&](const MistakeInfo* one) { return one->task == task.id; });
    all.resize(std::min(all.size(), most_riddle_mistakes));
    return all;
}

struct RiddleView {
    const CheckInfo* check;
    Shot shot;
};

std::vector<RiddleView> riddle_views(const Manifest& manifest, const TaskInfo& task, bool with_probes, int side) {
    std::vector<RiddleView> views;
    for (const CheckInfo& check : manifest.checks) {
        if (check.task != task.id || check.hidden || check.added || check.shot.calls) continue;
        if (with_probes && !check.shot.probe) continue;
        RiddleView view{&check, check.shot};
        if (!with_probes) view.shot.probe = {};
        const double scale = double(side) / std::max(view.shot.size.x, view.shot.size.y);
        view.shot.size = glm::max(glm::ivec2(glm::dvec2(view.shot.size) * scale + 0.5), 1);
        views.push_back(std::move(view));
        if (views.size() == most_riddle_views) break;
    }
    return views;
}

/// One view.
struct DrawnRiddle {
    Image right;
    std::vector<Image> pictures;  ///< empty where a mistake draws nothing
};

Image seen_in_riddle(const Manifest& manifest, const Shot& shot, const Image& image) {
    return shot.probe ? visualize_probe(image, manifest.probe(shot.probe.name).colors()) : visualize_picture(image);
}

}  // namespace

std::vector<size_t> choices_beside(size_t asked, const Image& right, std::span<const Image> pictures,
                                   const std::vector<std::string>& hints) {
    const Image& shown = pictures[asked];
    if (shown.values.empty() || right.values.empty() || !tells_apart(shown, right)) return {};
    std::vector<size_t> choices = {asked};
    std::vector<size_t> apart;
    for (size_t i = 0; i < pictures.size(); ++i)
        if (!pictures[i].values.empty() && tells_apart(shown, pictures[i])) apart.push_back(i);
    const auto add_unless = [&](const auto& is_like) {
        for (const size_t i : apart)
            if (choices.size() < 4 && std::none_of(choices.begin(), choices.end(),
                                                   [&](size_t other) { return is_like(hints[other], hints[i]); }))
                choices.push_back(i);
    };
    add_unless(say_alike);
    add_unless(std::equal_to<>());  // better a hint with the same words than no riddle
    if (choices.size() < 4) choices.clear();
    return choices;
}

std::optional<MistakeRiddle> riddle_of(MistakePictures& pictures, const LabEntry& lab, const TaskInfo& task, int side) {
    const Manifest& manifest = pictures.manifest();
    if (!is_shader(task.file)) return {};
    const std::vector<const MistakeInfo*> mistakes = riddle_mistakes(manifest, task);
    std::vector<std::string> hints;
    for (const MistakeInfo* one : mistakes) hints.push_back(one->hint);
    for (const bool with_probes : {false, true}) {
        const std::vector<RiddleView> views = riddle_views(manifest, task, with_probes, side);
        std::vector<DrawnRiddle> drawn(views.size());
        std::vector<Shot> shots;
        for (size_t i = 0; i < views.size(); ++i) {
            shots.push_back(views[i].shot);
            drawn[i].right = seen_in_riddle(manifest, shots[i], draw_shot(*make_lab(lab, shots[i]), shots[i]));
        }
        for (const MistakeInfo* one : mistakes) {
            const std::vector<DrawnAttempt> attempts = pictures.draw(*one, shots);
            for (size_t i = 0; i < views.size(); ++i)
                drawn[i].pictures.push_back(attempts[i].image ? seen_in_riddle(manifest, shots[i], *attempts[i].image)
                                                              : Image());
        }
        std::optional<MistakeRiddle> best;
        double best_weight = 0;
        for (size_t view = 0; view < views.size(); ++view)
            for (size_t asked = 0; asked < mistakes.size() && mistakes[asked]->task == task.id; ++asked) {
                const auto& [right, wrong] = std::tie(drawn[view].right, drawn[view].pictures[asked]);
                if (wrong.values.empty()) continue;
                const double contrast = contrast_of(wrong);
                if (contrast < min_contrast) continue;
                const double changed = double(difference(right, wrong, distinct_change).pixels_over) /
                                       double(std::max<size_t>(1, right.pixel_count()));
                std::vector<size_t> choices = choices_beside(asked, right, drawn[view].pictures, hints);
                const double weight = changed * contrast;  // two even squares of other greys say little
                if (choices.empty() || weight <= best_weight) continue;
                best_weight = weight;
                std::mt19937 dice = dice_of(task.id);
                shuffle(choices, dice);
                best = MistakeRiddle{.check = views[view].check, .is_probe = with_probes, .right = right};
                for (size_t i = 0; i < choices.size(); ++i) {
                    best->choices.push_back({hints[choices[i]], drawn[view].pictures[choices[i]]});
                    if (choices[i] == asked) best->answer = i;
                }
            }
        if (best) return best;
    }
    return {};
}

}  // namespace relief::grade
