#include "framework/course/window/menu_keys.h"

#include <map>

namespace relief::window {
namespace {

struct Steps {
    int columns, rows;
};

/// Returns the part that Escape closes: the one that was opened over all others.
std::optional<MenuAction> closing(const OpenParts& open) {
    const std::pair<bool, MenuAction> parts[] = {{open.search, MenuAction::close_search},
                                                 {open.list, MenuAction::close_list},
                                                 {open.help, MenuAction::toggle_help},
                                                 {open.labs, MenuAction::close_labs},
                                                 {open.explanation, MenuAction::close_explanation},
                                                 {open.check, MenuAction::close_check},
                                                 {open.brush, MenuAction::toggle_brush},
                                                 {open.wipe, MenuAction::toggle_wipe},
                                                 {open.motion, MenuAction::stop_motion},
                                                 {open.handout, MenuAction::toggle_handout}};
    for (const auto& [is_open, action] : parts)
        if (is_open) return action;
    return {};
}

void add_with_control(const Key& key, const OpenParts& open, MenuWish& wish) {
    if (key.name == "+" || key.name == "=" || key.code == GLFW_KEY_KP_ADD) wish.ask(MenuAction::larger);
    if (key.name == "-" || key.code == GLFW_KEY_KP_SUBTRACT) wish.ask(MenuAction::smaller);
    if (key.name == "0" || key.code == GLFW_KEY_KP_0) wish.ask(MenuAction::usual_size);
    if (key.name == "f") wish.ask(MenuAction::open_search);
    if (key.name == "q") wish.ask(MenuAction::quit);
    if (open.labs) return;
    if (key.name == "e") wish.ask(MenuAction::edit_error);
    if (open.typing) return;  // a text field has its own undo
    if (key.name == "z") wish.ask(MenuAction::undo);
    if (key.name == "y") wish.ask(MenuAction::redo);
}

void add_in_start_page(int key, MenuWish& wish) {
    static const std::map<int, Steps> steps = {{GLFW_KEY_LEFT, {-1, 0}},    {GLFW_KEY_RIGHT, {1, 0}},
                                               {GLFW_KEY_UP, {0, -1}},      {GLFW_KEY_DOWN, {0, 1}},
                                               {GLFW_KEY_PAGE_UP, {0, -3}}, {GLFW_KEY_PAGE_DOWN, {0, 3}}};
    if (const auto found = steps.find(key); found != steps.end())
        wish.columns += found->second.columns, wish.rows += found->second.rows;
    if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) wish.ask(MenuAction::choose_lab);
    if (key == GLFW_KEY_HOME) wish.ask(MenuAction::close_labs);
}

void add_in_lab(int key, const OpenParts& open, MenuWish& wish) {
    static const std::map<int, float> lines = {{GLFW_KEY_UP, -2.0f},       {GLFW_KEY_DOWN, 2.0f},
                                               {GLFW_KEY_PAGE_UP, -25.0f}, {GLFW_KEY_PAGE_DOWN, 25.0f},
                                               {GLFW_KEY_HOME, -1e6f},     {GLFW_KEY_END, 1e6f}};
    static const std::map<int, MenuAction> actions = {
        {GLFW_KEY_PAGE_DOWN, MenuAction::next_lab},   {GLFW_KEY_RIGHT, MenuAction::next_lab},
        {GLFW_KEY_PAGE_UP, MenuAction::previous_lab}, {GLFW_KEY_LEFT, MenuAction::previous_lab},
        {GLFW_KEY_R, MenuAction::reset_lab},          {GLFW_KEY_S, MenuAction::save_picture},
        {GLFW_KEY_F12, MenuAction::save_picture},     {GLFW_KEY_M, MenuAction::save_map},
        {GLFW_KEY_N, MenuAction::save_heights},       {GLFW_KEY_B, MenuAction::toggle_brush},
        {GLFW_KEY_F1, MenuAction::toggle_handout},    {GLFW_KEY_E, MenuAction::toggle_error_map},
        {GLFW_KEY_A, MenuAction::toggle_wipe},        {GLFW_KEY_X, MenuAction::swap_wipe},
        {GLFW_KEY_P, MenuAction::explain_pixel},      {GLFW_KEY_C, MenuAction::reset_camera},
        {GLFW_KEY_T, MenuAction::turn_camera},        {GLFW_KEY_H, MenuAction::toggle_panel},
        {GLFW_KEY_SPACE, MenuAction::pause},          {GLFW_KEY_HOME, MenuAction::open_labs}};
    if (const auto line = lines.find(key); open.handout && line != lines.end())
        wish.scroll += line->second;
    else if (const auto action = actions.find(key); action != actions.end())
        wish.ask(action->second);
}

}  // namespace

void add_key(const Key& key, const OpenParts& open, MenuWish& wish) {
    if (key.code == GLFW_KEY_ESCAPE && (open.search || !open.typing)) {
        if (const auto action = closing(open)) wish.ask(*action);
    } else if (key.control) {
        add_with_control(key, open, wish);
    } else if (!open.typing && !open.search) {
        open.labs ? add_in_start_page(key.code, wish) : add_in_lab(key.code, open, wish);
    }
}

void add_character(unsigned character, const OpenParts& open, MenuWish& wish) {
    if (open.typing || open.search) return;
    if (character == '?') wish.ask(MenuAction::toggle_help);
    if (character == '/') wish.ask(MenuAction::open_search);
}

}  // namespace relief::window
