#include "framework/pages/markdown_page.h"

#include <fmt/format.h>

#include <cctype>
#include <map>
#include <vector>

#include "framework/pages/template.h"

namespace relief {
namespace {

class Writer {
public:
    explicit Writer(const PagePlaces& places) : places_(places) {}

    void add(const Block& block) {
        if (block.kind == BlockKind::item) return item(block);
        close_lists(block.kind == BlockKind::heading ? 0 : size_t(block.level));
        switch (block.kind) {
            case BlockKind::heading:
                text_ += fmt::format("<h{0} id=\"{1}\">{2}</h{0}>\n", block.level, id_of(block), line(block.spans));
                break;
            case BlockKind::quote:
                text_ += "<blockquote><p>" + line(block.spans) + "</p></blockquote>\n";
                break;
            case BlockKind::code:
                text_ += "<pre tabindex=\"0\" role=\"region\" aria-label=\"code\">" + html(block.text) + "</pre>\n";
                break;
            case BlockKind::table:
                table(block);
                break;
            case BlockKind::rule:
                text_ += "<hr>\n";
                break;
            default:
                text_ += "<p>" + line(block.spans) + "</p>\n";
        }
    }

    std::string finish() {
        close_lists(0);
        return std::move(text_);
    }

private:
    void close_lists(size_t depth) {
        for (; lists_.size() > depth; lists_.pop_back()) text_ += "</li></" + lists_.back() + ">\n";
    }

    void item(const Block& block) {
        const size_t depth = size_t(block.level) + 1;
        const std::string list = block.marker == "*" ? "ul" : "ol";
        close_lists(depth);
        if (lists_.size() == depth && lists_.back() != list) close_lists(depth - 1);
        if (lists_.size() == depth) text_ += "</li>\n<li>";
        while (lists_.size() < depth) {
            const bool numbered = list == "ol" && block.marker != "1.";
            text_ += "<" + list +
                     (numbered ? " start=\"" + html(block.marker.substr(0, block.marker.size() - 1)) + "\"" : "") +
                     "><li>";
            lists_.push_back(list);
        }
        text_ += line(block.spans);
    }

    void table(const Block& block) {
        text_ += "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"table\"><table>";
        for (size_t row = 0; row < block.rows.size(); ++row) {
            text_ += row == 0 ? "<thead><tr>" : row == 1 ? "<tbody><tr>" : "<tr>";
            for (const Spans& cell : block.rows[row])
                text_ += row == 0 ? "<th scope=\"col\">" + line(cell) + "</th>" : "<td>" + line(cell) + "</td>";
            text_ += row == 0 ? "</tr></thead>\n" : "</tr>\n";
        }
        text_ += std::string(block.rows.size() > 1 ? "</tbody>" : "") + "</table></div>\n";
    }

    std::string line(const Spans& spans) const {
        std::string all;
        for (const Span& span : spans) all += styled(span);
        return all;
    }

    std::string styled(const Span& span) const {
        std::string text;
        for (const char c : html(span.text)) text += c == '\n' ? "<br>" : std::string(1, c);
        if (span.image) {
            const auto picture = places_.picture(span.target);
            if (picture)
                text = fmt::format("<img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}\" loading=\"lazy\">",
                                   html(picture->file), picture->width, picture->height, html(span.text));
        } else {
            if (span.code) text = "<code>" + text + "</code>";
            if (const auto place = span.target.empty() ? std::nullopt : places_.link(span.target))
                text = fmt::format("<a href=\"{}\">{}</a>", html(*place), text);
        }
        if (span.italic) text = "<em>" + text + "</em>";
        return span.bold ? "<strong>" + text + "</strong>" : text;
    }

    /// "What you see, and what to look at" is what-you-see-and-what-to-look-at; a second one has a number.
    std::string id_of(const Block& heading) {
        std::string id;
        for (const Span& span : heading.spans)
            for (const char c : span.text) {
                if (std::isalnum(static_cast<unsigned char>(c)))
                    id += char(std::tolower(static_cast<unsigned char>(c)));
                else if (!id.empty() && id.back() != '-')
                    id += '-';
            }
        while (!id.empty() && id.back() == '-') id.pop_back();
        if (id.empty()) id = "part";
        const int count = ++ids_[id];
        return count == 1 ? id : fmt::format("{}-{}", id, count);
    }

    const PagePlaces& places_;
    std::string text_;
    std::vector<std::string> lists_;  ///< those that are open, each with an open item
    std::map<std::string, int> ids_;
};

}  // namespace

std::string markdown_html(std::span<const Block> blocks, const PagePlaces& places) {
    Writer writer(places);
    for (const Block& block : blocks) writer.add(block);
    return writer.finish();
}

}  // namespace relief
