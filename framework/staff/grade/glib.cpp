// The module relief-unicode.so: the only place that knows GLib, which has Unicode's tables.
#include <glib.h>

#include <memory>

#include "framework/staff/grade/strangers_text.h"

/// Converts the text to Unicode's normal form C. Leaves it unchanged if it is not UTF-8.
extern "C" void relief_compose(std::string& text) {
    const std::unique_ptr<char, decltype(&g_free)> composed(
        g_utf8_normalize(text.data(), gssize(text.size()), G_NORMALIZE_DEFAULT_COMPOSE), &g_free);
    if (composed) text = composed.get();
}

/// Keeps the letters and digits of the text, without case and accents. Leaves it unchanged if it is not UTF-8.
extern "C" void relief_fold(std::string& text) {
    using Text = std::unique_ptr<char, decltype(&g_free)>;
    const Text apart(g_utf8_normalize(text.data(), gssize(text.size()), G_NORMALIZE_ALL), &g_free);
    if (!apart) return;
    const Text small(g_utf8_casefold(apart.get(), -1), &g_free);
    // A folded letter can have an accent of its own, such as the Turkish I with a dot.
    const Text again(g_utf8_normalize(small.get(), -1, G_NORMALIZE_ALL), &g_free);
    std::string plain;
    for (const char* at = again.get(); *at; at = g_utf8_next_char(at))
        if (g_unichar_isalnum(g_utf8_get_char(at))) plain.append(at, size_t(g_utf8_next_char(at) - at));
    text = plain;
}
