// The calls of Dear ImGui that differ between its versions, from 1.86 (Debian 12) to 1.92. In the window module only.
#pragma once

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <cstdint>

namespace relief::window {

/// A picture to draw, from the name of an OpenGL texture.
inline ImTextureID texture_id(unsigned texture) {
#if IMGUI_VERSION_NUM >= 19140
    return texture;
#else
    return reinterpret_cast<ImTextureID>(std::uintptr_t(texture));
#endif
}

/// Returns whether all keys and letters have reached the widgets. From 1.87 on, they do so over several frames.
inline bool is_input_read() {
#if IMGUI_VERSION_NUM >= 18700
    return ImGui::GetCurrentContext()->InputEventsQueue.empty();
#else
    return true;
#endif
}

/// Begins a child window whose items keys reach from its parent. ImGui::EndChild() ends it.
inline void begin_reachable_child(const char* name) {
#if IMGUI_VERSION_NUM >= 19090
    ImGui::BeginChild(name, {0, 0}, ImGuiChildFlags_NavFlattened);
#else
    ImGui::BeginChild(name, {0, 0}, false, ImGuiWindowFlags_NavFlattened);
#endif
}

// From 1.92 on, a font has glyphs of every size. The window uses the size with which it loads each font.
#if IMGUI_VERSION_NUM >= 19200

/// Returns a font's size in pixels.
inline float size_of(const ImFont& face) { return face.LegacySize; }
/// Returns the distance from a line's upper edge to its baseline, in pixels.
inline float ascent_of(ImFont& face) { return face.GetFontBaked(size_of(face))->Ascent; }
/// Returns a character's glyph, or that of the replacement character.
inline const ImFontGlyph& glyph_of(ImFont& face, ImWchar character) {
    return *face.GetFontBaked(size_of(face))->FindGlyph(character);
}
inline bool has_glyph(ImFont& face, ImWchar character) {
    return face.GetFontBaked(size_of(face))->FindGlyphNoFallback(character) != nullptr;
}
inline void push_font(ImFont* face) { ImGui::PushFont(face, size_of(*face)); }
/// Uploads the fonts after a change. From 1.92 on, the backend does so by itself.
inline void upload_fonts() {}

#else

inline float size_of(const ImFont& face) { return face.FontSize; }
inline float ascent_of(const ImFont& face) { return face.Ascent; }
inline const ImFontGlyph& glyph_of(const ImFont& face, ImWchar character) { return *face.FindGlyph(character); }
inline bool has_glyph(const ImFont& face, ImWchar character) { return face.FindGlyphNoFallback(character) != nullptr; }
inline void push_font(ImFont* face) { ImGui::PushFont(face); }
inline void upload_fonts() {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

#endif

}  // namespace relief::window
