#include "framework/course/window/menu_keys.h"

#include <algorithm>
#include <iterator>
#include <map>

namespace relief::window {
namespace {

struct Steps {
    int columns, rows;
};

/// Returns the part that Escape closes: the one that was opened over all others.
std::optional<MenuAction> closing(const OpenParts& open) {
    const std::pair<bool, MenuAction> parts[] = {
        {open.search, WindowAction::close_search}, {open.list, WindowAction::close_list},
        {open.help, WindowAction::toggle_help},    {open.labs, WindowAction::close_labs},
        {open.part, LabAction::leave_parts},       {open.explanation, LabAction::close_explanation},
        {open.check, LabAction::close_check},      {open.brush, LabAction::toggle_brush},
        {open.wipe, LabAction::toggle_wipe},       {open.motion, LabAction::stop_motion},
        {open.handout, LabAction::toggle_handout}, {open.presents, LabAction::toggle_panel}};
    for (const auto& [is_open, action] : parts)
        if (is_open) return action;
    return {};
}

/// Returns whether a key moves through the part of the window that has the keys.
bool is_of_a_part(int key) {
    static constexpr int keys[] = {GLFW_KEY_UP,    GLFW_KEY_DOWN, GLFW_KEY_LEFT,      GLFW_KEY_RIGHT, GLFW_KEY_PAGE_UP,
                                   GLFW_KEY_SPACE, GLFW_KEY_HOME, GLFW_KEY_PAGE_DOWN, GLFW_KEY_END};
    return std::find(std::begin(keys), std::end(keys), key) != std::end(keys);
}

void add_with_control(const Key& key, const OpenParts& open, MenuWish& wish) {
    if (key.name == "+" || key.name == "=" || key.code == GLFW_KEY_KP_ADD) wish.ask(WindowAction::larger);
    if (key.name == "-" || key.code == GLFW_KEY_KP_SUBTRACT) wish.ask(WindowAction::smaller);
    if (key.name == "0" || key.code == GLFW_KEY_KP_0) wish.ask(WindowAction::usual_size);
    if (key.name == "f") wish.ask(WindowAction::open_search);
    if (key.name == "q") wish.ask(WindowAction::quit);
    if (open.labs) return;
    if (key.name == "e") wish.ask(LabAction::edit_error);
    if (open.typing) return;  // a text field has its own undo
    if (key.name == "z") wish.ask(LabAction::undo);
    if (key.name == "y") wish.ask(LabAction::redo);
}

bool is_enter(int key) { return key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER; }

void add_in_start_page(const Key& key, MenuWish& wish) {
    static const std::map<int, Steps> steps = {{GLFW_KEY_LEFT, {-1, 0}},    {GLFW_KEY_RIGHT, {1, 0}},
                                               {GLFW_KEY_UP, {0, -1}},      {GLFW_KEY_DOWN, {0, 1}},
                                               {GLFW_KEY_PAGE_UP, {0, -3}}, {GLFW_KEY_PAGE_DOWN, {0, 3}}};
    if (const auto found = steps.find(key.code); found != steps.end())
        wish.columns += found->second.columns, wish.rows += found->second.rows;
    if (key.repeated) return;
    if (is_enter(key.code)) wish.ask(WindowAction::choose_lab);
    if (key.code == GLFW_KEY_HOME) wish.ask(WindowAction::close_labs);
}

/// The text field of the search takes all other keys.
void add_in_search(const Key& key, MenuWish& wish) {
    if (key.code == GLFW_KEY_UP) --wish.rows;
    if (key.code == GLFW_KEY_DOWN) ++wish.rows;
    if (is_enter(key.code) && !key.repeated) wish.ask(WindowAction::take_found);
}

void add_in_lab(int key, const OpenParts& open, MenuWish& wish) {
    static const std::map<int, float> lines = {{GLFW_KEY_UP, -2.0f},       {GLFW_KEY_DOWN, 2.0f},
                                               {GLFW_KEY_PAGE_UP, -25.0f}, {GLFW_KEY_PAGE_DOWN, 25.0f},
                                               {GLFW_KEY_HOME, -1e6f},     {GLFW_KEY_END, 1e6f}};
    static const std::map<int, MenuAction> actions = {{GLFW_KEY_PAGE_DOWN, WindowAction::next_lab},
                                                      {GLFW_KEY_RIGHT, WindowAction::next_lab},
                                                      {GLFW_KEY_PAGE_UP, WindowAction::previous_lab},
                                                      {GLFW_KEY_LEFT, WindowAction::previous_lab},
                                                      {GLFW_KEY_R, WindowAction::reset_lab},
                                                      {GLFW_KEY_S, LabAction::save_picture},
                                                      {GLFW_KEY_F12, LabAction::save_picture},
                                                      {GLFW_KEY_M, LabAction::save_map},
                                                      {GLFW_KEY_N, LabAction::save_heights},
                                                      {GLFW_KEY_B, LabAction::toggle_brush},
                                                      {GLFW_KEY_F1, LabAction::toggle_handout},
                                                      {GLFW_KEY_E, LabAction::toggle_error_map},
                                                      {GLFW_KEY_A, LabAction::toggle_wipe},
                                                      {GLFW_KEY_X, LabAction::swap_wipe},
                                                      {GLFW_KEY_P, LabAction::explain_pixel},
                                                      {GLFW_KEY_C, LabAction::reset_camera},
                                                      {GLFW_KEY_T, LabAction::turn_camera},
                                                      {GLFW_KEY_H, LabAction::toggle_panel},
                                                      {GLFW_KEY_SPACE, LabAction::pause},
                                                      {GLFW_KEY_HOME, WindowAction::open_labs},
                                                      {GLFW_KEY_F6, LabAction::next_part}};
    if (const auto line = lines.find(key); open.handout && line != lines.end())
        wish.scroll += line->second;
    else if (const auto action = actions.find(key); action != actions.end())
        wish.ask(action->second);
}

}  // namespace

void add_key(const Key& key, const OpenParts& open, MenuWish& wish) {
    // Only marks move on while a key is held.
    if (key.repeated && (key.control || key.code == GLFW_KEY_ESCAPE || !(open.search || open.labs))) return;
    if (key.code == GLFW_KEY_ESCAPE && open.part && (open.list || open.active)) return;  // the widget's own
    if (key.code == GLFW_KEY_ESCAPE && (open.search || !open.typing)) {
        if (const auto action = closing(open)) wish.ask(*action);
    } else if (key.control) {
        add_with_control(key, open, wish);
    } else if (open.search) {
        add_in_search(key, wish);
    } else if (!open.typing && !(open.part && is_of_a_part(key.code))) {
        open.labs ? add_in_start_page(key, wish) : add_in_lab(key.code, open, wish);
    }
}

void add_character(unsigned character, const OpenParts& open, MenuWish& wish) {
    if (open.typing || open.search) return;
    if (character == '?') wish.ask(WindowAction::toggle_help);
    if (character == '/') wish.ask(WindowAction::open_search);
}

}  // namespace relief::window
