#include "framework/course/window/menu_style.h"

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "framework/core/base/file.h"
#include "framework/core/base/module.h"

namespace relief::window {
namespace {

namespace fs = std::filesystem;

/// Returns a font's file, in a package's folder beside the program or where Debian, Fedora, openSUSE, Arch or Homebrew
/// install it. Returns an empty path if there is none.
fs::path font_file(const char* name) {
    const fs::path system = "/usr/share/fonts";
    const char* const home = std::getenv("HOME");
    for (const fs::path& folder :
         {framework_folder() / "fonts", fs::path(home ? home : "") / "Library/Fonts", system / "truetype/dejavu",
          system / "dejavu-sans-fonts", system / "dejavu-sans-mono-fonts", system / "dejavu-serif-fonts",
          system / "truetype", system / "TTF"})
        if (std::error_code ignored; fs::exists(folder / name, ignored)) return folder / name;
    return {};
}

// Characters of handouts besides Latin: Greek, dashes and quotes, small digits, arrows, mathematics, tree lines,
// shapes, ticks. Pairs of first and last.
constexpr ImWchar characters[] = {0x20,   0x17f,  0x370,  0x3ff,  0x1d40, 0x1d40, 0x1d50, 0x1d50, 0x2010,
                                  0x205f, 0x2070, 0x209f, 0x2100, 0x214f, 0x2190, 0x21ff, 0x2200, 0x22ff,
                                  0x2500, 0x257f, 0x25a0, 0x25ff, 0x2713, 0x2717, 0};

// Characters of formulas (framework/course/pages/formula.h) and of the words in them.
constexpr ImWchar formula_characters[] = {0x20,   0x17f,  0x391,  0x3c9,  0x2032, 0x2032, 0x2192, 0x2192, 0x21d4,
                                          0x21d4, 0x2200, 0x2211, 0x2212, 0x221a, 0x2260, 0x2265, 0};
constexpr ImWchar sum_characters[] = {0x2211, 0x2211, 0};

void load_fonts(float scale) {
    struct File {
        const char* name;
        float size;
        const ImWchar* ranges = characters;
    };
    // Indexed by FontRole. Without these files all roles use Dear ImGui's own font.
    static constexpr File files[] = {{"DejaVuSans.ttf", 15},
                                     {"DejaVuSans-Bold.ttf", 15},
                                     {"DejaVuSans-Bold.ttf", 21},
                                     {"DejaVuSansMono.ttf", 14},
                                     {"DejaVuSerif.ttf", 17, formula_characters},
                                     {"DejaVuSerif.ttf", 12.5f, formula_characters},
                                     {"DejaVuSerif.ttf", 25, sum_characters}};
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    for (const File& file : files)
        if (const fs::path path = font_file(file.name); !path.empty()) {
            const std::string bytes = read_file(path);         // Dear ImGui itself cannot open every path on Windows
            void* const copy = ImGui::MemAlloc(bytes.size());  // freed by the atlas
            std::memcpy(copy, bytes.data(), bytes.size());
            atlas.AddFontFromMemoryTTF(copy, int(bytes.size()), file.size * scale, nullptr, file.ranges);
        } else {
            atlas.AddFontDefault();
        }
}

}  // namespace

std::string broken_at_blanks(std::string lines, float width) {
    size_t start = 0, blank = 0;
    for (size_t at = 0; at <= lines.size(); ++at) {
        if (at < lines.size() && lines[at] != ' ' && lines[at] != '\n') continue;
        if (blank > start && ImGui::CalcTextSize(lines.data() + start, lines.data() + at).x > width) {
            lines[blank] = '\n';
            start = blank + 1;
        }
        blank = at;
        if (at < lines.size() && lines[at] == '\n') start = at + 1;
    }
    return lines;
}

void style_menu(float scale) {
    load_fonts(scale);
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    ImGui::StyleColorsDark();
    style.WindowPadding = {14, 10};
    style.FramePadding = {8, 5};
    style.ItemSpacing = {8, 6};
    style.FrameRounding = style.GrabRounding = style.PopupRounding = 4;
    style.WindowBorderSize = 0;
    style.Colors[ImGuiCol_WindowBg] = {0.09f, 0.095f, 0.11f, 1};
    style.Colors[ImGuiCol_FrameBg] = {0.16f, 0.17f, 0.20f, 1};
    style.Colors[ImGuiCol_Button] = {0.20f, 0.21f, 0.25f, 1};
    for (const int color : {ImGuiCol_FrameBgHovered, ImGuiCol_ButtonHovered, ImGuiCol_HeaderHovered})
        style.Colors[color] = {0.30f, 0.24f, 0.21f, 1};
    for (const int color : {ImGuiCol_FrameBgActive, ImGuiCol_ButtonActive, ImGuiCol_HeaderActive})
        style.Colors[color] = {0.42f, 0.28f, 0.21f, 1};
    style.Colors[ImGuiCol_PopupBg] = {0.11f, 0.115f, 0.13f, 1};
    style.Colors[ImGuiCol_Header] = {0.22f, 0.19f, 0.18f, 1};
    style.Colors[ImGuiCol_CheckMark] = accent;
#if IMGUI_VERSION_NUM >= 19140
    style.Colors[ImGuiCol_NavCursor] = accent;
#else
    style.Colors[ImGuiCol_NavHighlight] = accent;
#endif
    // Dark enough for the digits on it: white has a contrast of 8 to 1.
    style.Colors[ImGuiCol_SliderGrab] = {0.48f, 0.28f, 0.18f, 1};
    for (const int color : {ImGuiCol_Tab, ImGuiCol_TabUnfocused}) style.Colors[color] = {0.14f, 0.15f, 0.18f, 1};
    for (const int color : {ImGuiCol_TabActive, ImGuiCol_TabUnfocusedActive})
        style.Colors[color] = {0.36f, 0.26f, 0.21f, 1};
    style.Colors[ImGuiCol_TabHovered] = {0.42f, 0.28f, 0.21f, 1};
    style.ScaleAllSizes(scale);
}

ImFont* font(FontRole role) { return ImGui::GetIO().Fonts->Fonts[int(role)]; }

void text(const std::string& line) { ImGui::TextUnformatted(line.data(), line.data() + line.size()); }

void wrapped(const std::string& line, float right) {
    ImGui::PushTextWrapPos(right);
    text(broken_at_blanks(line, right > 0 ? right - ImGui::GetCursorPosX() : ImGui::GetContentRegionAvail().x));
    ImGui::PopTextWrapPos();
}

void colored_text(const ImVec4& color, const std::string& line) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    wrapped(line);
    ImGui::PopStyleColor();
}

void quiet_text(const std::string& line) { colored_text(quiet, line); }

void tooltip(const std::string& line) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1);  // opaque over a disabled widget, too
    ImGui::BeginTooltip();
    wrapped(line, ImGui::GetFontSize() * 28);
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
}

}  // namespace relief::window
