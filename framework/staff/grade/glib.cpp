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
