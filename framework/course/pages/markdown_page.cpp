#include "framework/course/pages/markdown_page.h"

#include <fmt/format.h>

#include <cctype>
#include <map>
#include <vector>

#include "framework/core/base/text.h"
#include "framework/course/pages/mathml.h"

namespace relief::pages {
namespace {

class Reader {
public:
    explicit Reader(const PagePlaces& places) : places_(places) {}

    Fields block(const Block& block) {
        Fields fields = nothing();
        fields["spans"] = line(block.spans);
        if (block.kind == BlockKind::item) {
            item(block, fields);
            return fields;
        }
        fields["closed"] = close_lists(block.kind == BlockKind::heading ? 0 : size_t(block.level));
        switch (block.kind) {
            case BlockKind::heading:
                fields["heading"] = block.level, fields["id"] = id_of(block), fields["title"] = plain_text(block.spans);
                break;
            case BlockKind::quote:
                fields["quote"] = true;
                break;
            case BlockKind::code:
                fields["number"] = ++boxes_;
                if (block.language == "formula")
                    fields["formulas"] = rows(formulas(block.text));
                else if (block.language == "measured")
                    fields["measured"] = block.text;
                else
                    fields["code"] = block.text;
                break;
            case BlockKind::table:
                fields["table"] = table(block), fields["number"] = ++boxes_;
                break;
            case BlockKind::rule:
                fields["rule"] = true;
                break;
            default:
                fields["figure"] = figure(block);
                if (fields["figure"].kind == Value::Kind::nothing) fields["paragraph"] = true;
        }
        return fields;
    }

    /// Returns the fields after the last block, which close all open lists.
    Fields end() {
        Fields fields = nothing();
        fields["closed"] = close_lists(0);
        return fields;
    }

private:
    /// Returns an empty value for each optional name of block.mustache.
    static Fields nothing() {
        return {{"closed", ""}, {"heading", ""},  {"paragraph", ""}, {"figure", ""}, {"item", ""}, {"quote", ""},
                {"code", ""},   {"formulas", ""}, {"measured", ""},  {"table", ""},  {"rule", ""}, {"number", ""}};
    }

    List close_lists(size_t depth) {
        List closed;
        for (; lists_.size() > depth; lists_.pop_back()) closed.push_back(lists_.back());
        return closed;
    }

    void item(const Block& block, Fields& fields) {
        const size_t depth = size_t(block.level) + 1;
        const std::string list = block.marker == "*" ? "ul" : "ol";
        const bool is_other = lists_.size() >= depth && lists_[depth - 1] != list;
        fields["item"] = true, fields["closed"] = close_lists(is_other ? depth - 1 : depth);
        fields["is_next"] = lists_.size() == depth;
        List opened;
        while (lists_.size() < depth) {
            const bool counts_on = list == "ol" && block.marker != "1.";
            opened.push_back(
                Fields{{"list", list}, {"start", counts_on ? block.marker.substr(0, block.marker.size() - 1) : ""}});
            lists_.push_back(list);
        }
        fields["opened"] = std::move(opened);
    }

    /// Returns the figure of a paragraph that consists of one picture; else an empty value.
    Value figure(const Block& block) const {
        if (block.spans.size() != 1 || !block.spans.front().image) return {};
        const Span& span = block.spans.front();
        const auto picture = places_.picture(span.target);
        if (!picture) return {};
        return Fields{{"file", picture->file},     {"width", picture->width},
                      {"height", picture->height}, {"kind", picture->is_drawing ? "drawing" : "picture"},
                      {"text", span.text},         {"command", picture->command},
                      {"words", picture->words},   {"moving", picture->moving}};
    }

    /// Returns lines, each with a label, formulas and notes. Words before a line's first formula are its label.
    static List formulas(const std::string& text) {
        List lines;
        for (const std::vector<FormulaCell>& line : formula_lines(text)) {
            Fields fields{{"label", ""}};
            List cells;
            for (const FormulaCell& cell : line) {
                if (cell.is_words && &cell == &line.front())
                    fields["label"] = cell.words;
                else
                    cells.push_back(
                        Fields{{"words", cell.words}, {"math", cell.is_words ? "" : formula_mathml(cell.formula)}});
            }
            fields["cells"] = std::move(cells);
            lines.push_back(std::move(fields));
        }
        return lines;
    }

    Fields table(const Block& block) const {
        std::vector<List> all;
        for (const std::vector<Spans>& row : block.rows)
            for (List& cells = all.emplace_back(); const Spans& cell : row)
                cells.push_back(Fields{{"spans", line(cell)}});
        List body;
        for (size_t row = 1; row < all.size(); ++row) body.push_back(Fields{{"cells", all[row]}});
        return {{"head", all.at(0)}, {"body", rows(std::move(body))}};
    }

    List line(const Spans& spans) const {
        List all;
        for (const Span& span : spans) all.push_back(styled(span));
        return all;
    }

    Fields styled(const Span& span) const {
        List lines;
        for (const std::string& line : split(span.text, '\n'))
            lines.push_back(Fields{{"line", line}, {"is_first", lines.empty()}});
        const auto picture = span.image ? places_.picture(span.target) : std::nullopt;
        const auto place = span.image || span.target.empty() ? std::nullopt : places_.link(span.target);
        return {{"bold", span.bold},
                {"italic", span.italic},
                {"code", span.code && !span.image},
                {"text", span.text},
                {"lines", std::move(lines)},
                {"link", place.value_or("")},
                {"picture",
                 picture ? Fields{{"file", picture->file}, {"width", picture->width}, {"height", picture->height}}
                         : Value()}};
    }

    /// Returns a heading's id: "Why, and how" becomes why-and-how. A repeated id gets a number.
    std::string id_of(const Block& heading) {
        std::string id;
        for (const char c : plain_text(heading.spans)) {
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
    std::vector<std::string> lists_;  ///< open lists, each with an open item
    std::map<std::string, int> ids_;
    int boxes_ = 0;  ///< count of scrolling boxes; numbers them, because landmarks of a page need unique names
};

}  // namespace

List markdown_blocks(std::span<const Block> blocks, const PagePlaces& places) {
    Reader reader(places);
    List list;
    for (const Block& block : blocks) list.push_back(reader.block(block));
    list.push_back(reader.end());
    return list;
}

}  // namespace relief::pages
