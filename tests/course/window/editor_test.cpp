// The commands that open a file in an editor.
#include "framework/course/window/editor.h"

#include "tests/support.h"

namespace relief {
namespace {

using Words = std::vector<std::string>;

TEST(Editor, ReceivesTheLineInItsDocumentedSyntax) {
    EXPECT_EQ(editor_command("code", "a/task.glsl", 12), (Words{"code", "--goto", "a/task.glsl:12"}));
    EXPECT_EQ(editor_command("/usr/bin/kate", "a/task.glsl", 12), (Words{"/usr/bin/kate", "-l", "12", "a/task.glsl"}));
    EXPECT_EQ(editor_command("subl", "a/task.glsl", 12), (Words{"subl", "a/task.glsl:12"}));
    EXPECT_EQ(editor_command("gedit", "a/task.glsl", 12), (Words{"gedit", "+12", "a/task.glsl"}));
}

TEST(Editor, OpensTerminalEditorsInATerminal) {
    EXPECT_EQ(editor_command("vim", "a/task.glsl", 12),
              (Words{"x-terminal-emulator", "-e", "vim", "+12", "a/task.glsl"}));
}

TEST(Editor, KeepsItsArgumentsAndGetsALineOnlyIfItsSyntaxIsKnown) {
    EXPECT_EQ(editor_command("code  --wait", "a/task.glsl", 3), (Words{"code", "--wait", "--goto", "a/task.glsl:3"}));
    EXPECT_EQ(editor_command("strange", "a/task.glsl", 12), (Words{"strange", "a/task.glsl"}));
    EXPECT_EQ(editor_command("code", "a/task.glsl", 0), (Words{"code", "a/task.glsl"}));
    EXPECT_EQ(editor_command("", "a/task.glsl", 12), (Words{"xdg-open", "a/task.glsl"}));
    EXPECT_EQ(editor_command("  ", "a/task.glsl", 12), (Words{"xdg-open", "a/task.glsl"}));
}

}  // namespace
}  // namespace relief
