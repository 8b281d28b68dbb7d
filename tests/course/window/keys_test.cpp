// The meaning of keys, which depends on the open parts of the window.
#include "framework/course/window/menu_keys.h"

#include <gtest/gtest.h>

namespace relief::window {
namespace {

std::vector<MenuAction> actions_of(const Key& key, const OpenParts& open) {
    MenuWish wish;
    add_key(key, open, wish);
    return wish.actions;
}
std::vector<MenuAction> escape(const OpenParts& open) { return actions_of({GLFW_KEY_ESCAPE, "", false}, open); }

using Actions = std::vector<MenuAction>;

TEST(Keys, EscapeClosesTheUppermostPart) {
    OpenParts open;
    EXPECT_EQ(escape(open), Actions()) << "it does not end the window";
    // From the lowest part to the uppermost.
    const std::pair<bool OpenParts::*, MenuAction> parts[] = {
        {&OpenParts::handout, MenuAction::toggle_handout}, {&OpenParts::motion, MenuAction::stop_motion},
        {&OpenParts::wipe, MenuAction::toggle_wipe},       {&OpenParts::brush, MenuAction::toggle_brush},
        {&OpenParts::check, MenuAction::close_check},      {&OpenParts::explanation, MenuAction::close_explanation},
        {&OpenParts::labs, MenuAction::close_labs},        {&OpenParts::help, MenuAction::toggle_help},
        {&OpenParts::list, MenuAction::close_list},        {&OpenParts::search, MenuAction::close_search}};
    for (const auto& [part, action] : parts) {
        open.*part = true;
        EXPECT_EQ(escape(open), Actions{action});
    }
    open.typing = true;
    EXPECT_EQ(escape(open), Actions{MenuAction::close_search}) << "the search has a text field";
    open.search = false;
    EXPECT_EQ(escape(open), Actions()) << "it belongs to the text field";
}

TEST(Keys, InATextFieldAreTextOrTheFieldsOwn) {
    for (const Key& key : {Key{GLFW_KEY_S, "s", false}, Key{GLFW_KEY_Z, "z", true}, Key{GLFW_KEY_RIGHT, "", false}})
        EXPECT_EQ(actions_of(key, {.typing = true}), Actions()) << key.code;
    EXPECT_EQ(actions_of({GLFW_KEY_Q, "q", true}, {.typing = true}), Actions{MenuAction::quit});
    MenuWish wish;
    add_character('/', {.typing = true}, wish);
    EXPECT_TRUE(wish.is_empty());
    add_character('/', {}, wish);
    EXPECT_EQ(wish.actions, Actions{MenuAction::open_search});
}

TEST(Keys, ArrowsMoveTheMarkScrollTheHandoutOrSwitchLabs) {
    MenuWish wish;
    add_key({GLFW_KEY_DOWN, "", false}, {.labs = true}, wish);
    add_key({GLFW_KEY_RIGHT, "", false}, {.labs = true}, wish);
    add_key({GLFW_KEY_RIGHT, "", false}, {.labs = true}, wish);
    EXPECT_EQ(std::pair(wish.columns, wish.rows), std::pair(2, 1));
    EXPECT_TRUE(wish.actions.empty());
    wish = {};
    add_key({GLFW_KEY_PAGE_DOWN, "", false}, {.handout = true}, wish);
    EXPECT_GT(wish.scroll, 0);
    EXPECT_TRUE(wish.actions.empty());
    wish = {};
    add_key({GLFW_KEY_RIGHT, "", false}, {.handout = true}, wish);
    add_key({GLFW_KEY_PAGE_DOWN, "", false}, {}, wish);
    EXPECT_EQ(wish.actions, (Actions{MenuAction::next_lab, MenuAction::next_lab}));
    EXPECT_EQ(wish.scroll, 0);
}

TEST(Keys, OfALabDoNothingOnTheStartPage) {
    for (const int key : {GLFW_KEY_S, GLFW_KEY_E, GLFW_KEY_B, GLFW_KEY_F1})
        EXPECT_EQ(actions_of({key, "", false}, {.labs = true}), Actions()) << key;
    EXPECT_EQ(actions_of({GLFW_KEY_E, "e", true}, {.labs = true}), Actions());
    EXPECT_EQ(actions_of({GLFW_KEY_ENTER, "", false}, {.labs = true}), Actions{MenuAction::choose_lab});
}

}  // namespace
}  // namespace relief::window
