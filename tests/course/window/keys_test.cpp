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
    const std::pair<bool OpenParts::*, MenuAction> parts[] = {{&OpenParts::presents, LabAction::toggle_panel},
                                                              {&OpenParts::handout, LabAction::toggle_handout},
                                                              {&OpenParts::motion, LabAction::stop_motion},
                                                              {&OpenParts::wipe, LabAction::toggle_wipe},
                                                              {&OpenParts::brush, LabAction::toggle_brush},
                                                              {&OpenParts::check, LabAction::close_check},
                                                              {&OpenParts::explanation, LabAction::close_explanation},
                                                              {&OpenParts::labs, WindowAction::close_labs},
                                                              {&OpenParts::help, WindowAction::toggle_help},
                                                              {&OpenParts::list, WindowAction::close_list},
                                                              {&OpenParts::search, WindowAction::close_search}};
    for (const auto& [part, action] : parts) {
        open.*part = true;
        EXPECT_EQ(escape(open), Actions{action});
    }
    open.typing = true;
    EXPECT_EQ(escape(open), Actions{WindowAction::close_search}) << "the search has a text field";
    open.search = false;
    EXPECT_EQ(escape(open), Actions()) << "it belongs to the text field";
}

TEST(Keys, InATextFieldAreTextOrTheFieldsOwn) {
    for (const Key& key : {Key{GLFW_KEY_S, "s", false}, Key{GLFW_KEY_Z, "z", true}, Key{GLFW_KEY_RIGHT, "", false}})
        EXPECT_EQ(actions_of(key, {.typing = true}), Actions()) << key.code;
    EXPECT_EQ(actions_of({GLFW_KEY_Q, "q", true}, {.typing = true}), Actions{WindowAction::quit});
    MenuWish wish;
    add_character('/', {.typing = true}, wish);
    EXPECT_TRUE(wish.is_empty());
    add_character('/', {}, wish);
    EXPECT_EQ(wish.actions, Actions{WindowAction::open_search});
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
    EXPECT_EQ(wish.actions, (Actions{WindowAction::next_lab, WindowAction::next_lab}));
    EXPECT_EQ(wish.scroll, 0);
}

TEST(Keys, InTheSearchMoveItsMarkAndTakeWhatItFound) {
    const OpenParts open{.typing = true, .search = true, .labs = true};
    MenuWish wish;
    add_key({GLFW_KEY_DOWN, "", false}, open, wish);
    add_key({GLFW_KEY_DOWN, "", false, true}, open, wish);
    add_key({GLFW_KEY_UP, "", false}, open, wish);
    EXPECT_EQ(wish.rows, 1);
    EXPECT_TRUE(wish.actions.empty());
    EXPECT_EQ(actions_of({GLFW_KEY_ENTER, "", false}, open), Actions{WindowAction::take_found});
    EXPECT_EQ(actions_of({GLFW_KEY_KP_ENTER, "", false}, open), Actions{WindowAction::take_found});
    EXPECT_EQ(actions_of({GLFW_KEY_ENTER, "", false, true}, open), Actions()) << "it was held";
}

TEST(Keys, AHeldKeyMovesMarksAndNothingElse) {
    const auto held = [](int key, const OpenParts& open) {
        MenuWish wish;
        add_key({key, "", false, true}, open, wish);
        return wish;
    };
    EXPECT_EQ(held(GLFW_KEY_DOWN, {.labs = true}).rows, 1);
    for (const int key : {GLFW_KEY_RIGHT, GLFW_KEY_S, GLFW_KEY_ESCAPE, GLFW_KEY_F6})
        EXPECT_TRUE(held(key, {}).is_empty()) << key;
    for (const int key : {GLFW_KEY_ENTER, GLFW_KEY_HOME, GLFW_KEY_ESCAPE})
        for (const bool search : {false, true})
            EXPECT_TRUE(held(key, {.search = search, .labs = true}).is_empty()) << key;
    EXPECT_EQ(actions_of({GLFW_KEY_KP_ADD, "+", true, true}, {.labs = true}), Actions());
}

TEST(Keys, MoveThroughAPartThatHasThemAndLettersStayTheLabs) {
    EXPECT_EQ(actions_of({GLFW_KEY_F6, "", false}, {}), Actions{LabAction::next_part});
    const OpenParts open{.part = true, .handout = true};
    for (const int key : {GLFW_KEY_LEFT, GLFW_KEY_RIGHT, GLFW_KEY_UP, GLFW_KEY_DOWN, GLFW_KEY_SPACE, GLFW_KEY_HOME,
                          GLFW_KEY_END, GLFW_KEY_PAGE_UP, GLFW_KEY_PAGE_DOWN}) {
        MenuWish wish;
        add_key({key, "", false}, open, wish);
        EXPECT_TRUE(wish.is_empty()) << key;
    }
    EXPECT_EQ(actions_of({GLFW_KEY_F6, "", false}, open), Actions{LabAction::next_part});
    EXPECT_EQ(actions_of({GLFW_KEY_E, "e", false}, open), Actions{LabAction::toggle_error_map});
    EXPECT_EQ(escape(open), Actions{LabAction::leave_parts});
    EXPECT_EQ(escape({.list = true, .part = true}), Actions()) << "it closes the list";
    EXPECT_EQ(escape({.part = true, .active = true}), Actions()) << "it ends the change of a slider";
}

TEST(Keys, OfALabDoNothingOnTheStartPage) {
    for (const int key : {GLFW_KEY_S, GLFW_KEY_E, GLFW_KEY_B, GLFW_KEY_F1})
        EXPECT_EQ(actions_of({key, "", false}, {.labs = true}), Actions()) << key;
    EXPECT_EQ(actions_of({GLFW_KEY_E, "e", true}, {.labs = true}), Actions());
    EXPECT_EQ(actions_of({GLFW_KEY_ENTER, "", false}, {.labs = true}), Actions{WindowAction::choose_lab});
}

}  // namespace
}  // namespace relief::window
