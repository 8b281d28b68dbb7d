#include "framework/course/pages/page.h"

#include "framework/core/base/file.h"
#include "framework/core/base/sha256.h"
#include "framework/core/image/file.h"

namespace relief::pages {
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

/// Returns the SHA-256 of a script in base64, for the content security policy.
std::string fingerprint(const std::string& script) {
    const std::string digits = sha256(script);
    std::string bytes;
    for (size_t i = 0; i < digits.size(); i += 2) bytes += char(std::stoi(digits.substr(i, 2), nullptr, 16));
    return base64(bytes);
}

std::string together(const std::vector<std::string>& names, const char* kind) {
    std::string all;
    for (const std::string& name : names) all += page_file(name, kind) + '\n';
    return all;
}

}  // namespace

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

std::string render(const Page& page, Fields values) {
    const std::string script = together(page.scripts, ".js");
    values["page"] = Fields{{"title", page.title},
                            {"body", page.body},
                            {"style", together({"colors", "page"}, ".css") + together(page.styles, ".css")},
                            {"script", script},
                            {"fingerprint", fingerprint(script)},
                            {"pictures_inside", page.pictures == PagePictures::inside}};
    return render("page", values) + "\n";
}

}  // namespace relief::pages
