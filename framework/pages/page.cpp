#include "framework/pages/page.h"

#include <fmt/format.h>

#include <cstdlib>

#include "framework/base/file.h"
#include "framework/base/sha256.h"
#include "framework/base/text.h"
#include "framework/image/file.h"

extern char** environ;

namespace relief {
namespace {

namespace fs = std::filesystem;

std::string base64(std::string_view bytes) {
    constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (size_t i = 0; i < bytes.size(); i += 3) {
        const size_t have = std::min<size_t>(3, bytes.size() - i);
        uint32_t three = 0;
        for (size_t k = 0; k < 3; ++k) three = three << 8 | (k < have ? uint8_t(bytes[i + k]) : 0);
        for (size_t k = 0; k < 4; ++k) text += k <= have ? letters[three >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

constexpr const char* common_style = R"(
:root { color-scheme: light dark; --ground: #f6f4ef; --card: #ffffff; --text: #23211d; --quiet: #625e56; --line: #d9d4c9;
  --code: #efece5; --accent: #a34a16; --good: #1d6b3a; --bad: #b02a20; --open: #7a5a00; }
@media (prefers-color-scheme: dark) { :root { --ground: #14161a; --card: #1d2026; --text: #e4e2dd; --quiet: #b5b2ab;
  --line: #353942; --code: #0f1114; --accent: #e58a5b; --good: #6fcf8f; --bad: #ff8a7d; --open: #e6c35c; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--ground); color: var(--text); font: 17px/1.5 system-ui, sans-serif; }
header, main, footer { max-width: 1240px; margin: 0 auto; padding: 0 24px; }
header { padding-top: 56px; padding-bottom: 20px; }
header p { margin: 0; color: var(--quiet); max-width: 42em; }
h1 { font-size: 44px; line-height: 1.1; margin: 0 0 8px; letter-spacing: -0.02em; }
h2 { font-size: 22px; margin: 0 0 6px; }
h1 .number, h2 .number { color: var(--accent); font-variant-numeric: tabular-nums; margin-right: 6px; }
a { color: var(--accent); text-underline-offset: 3px; }
code { background: var(--code); padding: 3px 8px; border-radius: 6px; font-size: 14px; overflow-wrap: anywhere; }
select, input[type=search] { display: block; width: 100%; font: inherit; font-size: 16px; color: var(--text); background: var(--card);
  border: 1px solid var(--line); border-radius: 8px; padding: 7px 9px; }
:focus-visible { outline: 3px solid var(--accent); outline-offset: 3px; }
footer { padding-top: 28px; padding-bottom: 48px; color: var(--quiet); font-size: 14px; }
@media print { :root { color-scheme: light; --ground: #fff; --card: #fff; --text: #000; --quiet: #444; --line: #bbb; --code: #f2f2f2;
  --accent: #a34a16; --good: #1d6b3a; --bad: #b02a20; --open: #7a5a00; }
  body { font-size: 11pt; print-color-adjust: exact; -webkit-print-color-adjust: exact; } header { padding-top: 0; } }
)";

/// As a content security policy names a script.
std::string fingerprint(const std::string& script) {
    const std::string digits = sha256(script);
    std::string bytes;
    for (size_t i = 0; i < digits.size(); i += 2) bytes += char(std::stoi(digits.substr(i, 2), nullptr, 16));
    return "'sha256-" + base64(bytes) + "'";
}

}  // namespace

std::string html(const std::string& text) {
    std::string result;
    for (const char c : escaped_markup(text)) result += c == '\'' ? "&#39;" : std::string(1, c);
    return result;
}

std::string html_with_code(const std::string& text) {
    std::string result;
    const std::vector<std::string> parts = split(text, '`');
    for (size_t i = 0; i < parts.size(); ++i)
        result += i % 2 == 1 && i + 1 < parts.size() ? "<code>" + html(parts[i]) + "</code>" : html(parts[i]);
    return result;
}

void write_beside_page(const std::filesystem::path& file, const std::string& bytes) {
    try {
        make_folder(file.parent_path());
        write_file(file, bytes);
    } catch (const Error& error) {
        throw CannotWrite(error.what());
    }
}

std::string picture_uri(const Image& picture) {
    return "data:image/png;base64," + base64(encode_image(picture, ImageFormat::png));
}

std::string closed_page(const std::string& title, const std::string& style, const std::string& body,
                        const std::string& script, PagePictures pictures) {
    // Not every browser takes what lies beside a file for its 'self'.
    const char* const from = pictures == PagePictures::inside ? "data:" : "'self' file:";
    const std::string policy = fmt::format(
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; base-uri 'none'; form-action "
        "'none'; "
        "img-src {}; style-src 'unsafe-inline'{}\">\n",
        from, script.empty() ? "" : "; script-src " + fingerprint(script));
    return R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
)" + policy +
           "<title>" + html(title) + "</title>\n<style>" + common_style + style + "</style></head><body>\n" + body +
           (script.empty() ? "" : "<script>" + script + "</script>\n") + "</body></html>\n";
}

}  // namespace relief
