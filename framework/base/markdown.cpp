#include "framework/base/markdown.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "framework/base/text.h"

namespace relief {
namespace {

constexpr auto npos = std::string_view::npos;

bool is_space(char c) { return c == ' ' || c == '\t'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) >= 0x80; }

std::string_view trimmed(std::string_view line) {
    while (!line.empty() && is_space(line.front())) line.remove_prefix(1);
    while (!line.empty() && is_space(line.back())) line.remove_suffix(1);
    return line;
}

size_t indent_of(std::string_view line) { return std::min(line.find_first_not_of(' '), line.size()); }

/// How many times the first character stands at the beginning.
size_t run_of(std::string_view text) { return std::min(text.find_first_not_of(text.substr(0, 1)), text.size()); }

// ---- within a line ----

class Inline {
public:
    static Spans parse(std::string_view text, const Span& style = {}, int depth = 0) {
        Inline reader(text, style, depth);
        reader.read();
        return std::move(reader.spans_);
    }

private:
    Inline(std::string_view text, const Span& style, int depth) : text_(text), style_(style), depth_(depth) {}

    void read() {
        while (at_ < text_.size()) {
            if (escape() || code() || image() || link() || address() || emphasis()) continue;
            literal(text_[at_++]);
        }
    }

    std::string_view rest() const { return text_.substr(at_); }
    void literal(char c) {
        if (spans_.empty() || !literal_) spans_.push_back(style_), literal_ = true;
        spans_.back().text += c;
    }
    void add(Span span) {
        spans_.push_back(std::move(span));
        literal_ = false;
    }

    bool escape() {
        if (text_[at_] != '\\' || at_ + 1 >= text_.size() || !std::ispunct(static_cast<unsigned char>(text_[at_ + 1])))
            return false;
        literal(text_[at_ + 1]);
        at_ += 2;
        return true;
    }

    bool code() {
        if (text_[at_] != '`') return false;
        const size_t run = run_of(rest());
        for (size_t close = text_.find('`', at_ + run); close != npos;) {
            const size_t length = run_of(text_.substr(close));
            if (length == run) {
                std::string_view inner = text_.substr(at_ + run, close - at_ - run);
                const bool padded = inner.size() > 2 && inner.front() == ' ' && inner.back() == ' ';
                if (padded) inner = inner.substr(1, inner.size() - 2);  // so that code can begin with a backtick
                Span span = style_;
                span.text = inner, span.code = true;
                add(std::move(span));
                at_ = close + run;
                return true;
            }
            close = text_.find('`', close + length);
        }
        for (size_t i = 0; i < run; ++i) literal('`');
        at_ += run;
        return true;
    }

    /// "[text](target)" at a place; `text` may have brackets in pairs.
    struct Bracketed {
        std::string_view text, target;
        size_t end = 0;  ///< 0: it is none
    };
    Bracketed bracketed(size_t open) const {
        if (open >= text_.size() || text_[open] != '[') return {};
        int depth = 0;
        for (size_t i = open; i < text_.size(); ++i) {
            if (text_[i] == '\\')
                ++i;
            else if (text_[i] == '[')
                ++depth;
            else if (text_[i] == ']' && --depth == 0) {
                if (i + 1 >= text_.size() || text_[i + 1] != '(') return {};
                const size_t close = text_.find(')', i + 2);
                if (close == npos) return {};
                std::string_view target = trimmed(text_.substr(i + 2, close - i - 2));
                target = target.substr(0, target.find(' '));  // without the title
                return {text_.substr(open + 1, i - open - 1), target, close + 1};
            }
        }
        return {};
    }
    bool image() {
        if (text_[at_] != '!') return false;
        const Bracketed found = bracketed(at_ + 1);
        if (!found.end) return false;
        Span span = style_;
        span.text = found.text, span.target = found.target, span.image = true;
        add(std::move(span));
        at_ = found.end;
        return true;
    }
    bool link() {
        if (text_[at_] != '[' || depth_ >= deepest) return false;
        const Bracketed found = bracketed(at_);
        if (!found.end) return false;
        Span style = style_;
        style.target = found.target;
        add_all(parse(found.text, style, depth_ + 1));
        at_ = found.end;
        return true;
    }
    bool address() {
        if (!rest().starts_with("<http")) return false;
        const size_t close = text_.find_first_of("> \n", at_);
        if (close == npos || text_[close] != '>') return false;
        Span span = style_;
        span.text = span.target = text_.substr(at_ + 1, close - at_ - 1);
        add(std::move(span));
        at_ = close + 1;
        return true;
    }

    bool emphasis() {
        const char mark = text_[at_];
        if (mark != '*' && mark != '_') return false;
        const size_t run = run_of(rest());
        for (const size_t count : {size_t{2}, size_t{1}}) {
            if (run < count || run > 3 || depth_ >= deepest || !opens(at_, count)) continue;
            const size_t close = closing(mark, count, run);
            if (close == npos) continue;
            Span style = style_;
            (count == 2 ? style.bold : style.italic) = true;
            add_all(parse(text_.substr(at_ + count, close - at_ - count), style, depth_ + 1));
            at_ = close + count;
            return true;
        }
        for (size_t i = 0; i < run; ++i) literal(mark);
        at_ += run;
        return true;
    }
    char before(size_t i) const { return i > 0 ? text_[i - 1] : ' '; }
    char after(size_t i) const { return i < text_.size() ? text_[i] : ' '; }
    // A name such as world_from_model has no emphasis in it, and neither has 2 * 3 * 4.
    bool opens(size_t i, size_t count) const {
        return !std::isspace(static_cast<unsigned char>(after(i + count))) && !(text_[i] == '_' && is_word(before(i)));
    }
    bool closes(size_t i, size_t count) const {
        return !std::isspace(static_cast<unsigned char>(before(i))) && !(text_[i] == '_' && is_word(after(i + count)));
    }
    size_t closing(char mark, size_t count, size_t opening) {
        bool& none = none_[size_t(mark == '_')][count - 1];
        if (none) return npos;  // or text that is all asterisks would be searched again from each of them
        for (size_t i = at_ + opening; i < text_.size();) {
            if (text_[i] == '\\') {
                i += 2;
            } else if (text_[i] == '`') {  // marks within code do not close
                const size_t run = run_of(text_.substr(i));
                const size_t close = text_.find(text_.substr(i, run), i + run);
                i = close == npos ? i + run : close + run;
            } else if (text_[i] == mark) {
                const size_t run = run_of(text_.substr(i));
                const bool fits = run == count || run >= 3;
                // Of three, the outer emphasis takes the last: **bold *both***.
                const size_t place = run >= 3 ? i + run - count : i;
                if (fits && place > at_ + count && closes(i, run)) return place;
                i += run;
            } else {
                ++i;
            }
        }
        none = true;
        return npos;
    }
    void add_all(Spans spans) {
        for (Span& span : spans) add(std::move(span));
    }

    static constexpr int deepest = 4;
    std::string_view text_;
    Span style_;
    int depth_;
    size_t at_ = 0;
    bool literal_ = false;  ///< the last span is plain text that may grow
    std::array<std::array<bool, 2>, 2> none_{};
    Spans spans_;
};

// ---- lines ----

/// The level of "## heading", 0 when it is none.
int heading_level(std::string_view line) {
    const std::string_view text = trimmed(line);
    if (text.empty() || text[0] != '#') return 0;
    const size_t run = run_of(text);
    return run <= 6 && (run == text.size() || is_space(text[run])) ? int(run) : 0;
}

std::string_view heading_text(std::string_view line) {
    std::string_view text = trimmed(line);
    text = trimmed(text.substr(run_of(text)));
    const size_t last = text.find_last_not_of('#');
    if (last == npos) return {};
    return last + 1 < text.size() && is_space(text[last]) ? trimmed(text.substr(0, last)) : text;
}

bool is_rule(std::string_view line) {
    std::string marks;
    for (const char c : line)
        if (!is_space(c)) marks += c;
    return marks.size() >= 3 && (marks[0] == '-' || marks[0] == '*' || marks[0] == '_') &&
           run_of(marks) == marks.size();
}

/// The backticks or tildes that open a block of code, and where they stand.
struct Fence {
    std::string_view marks;
    size_t indent = 0;
};
Fence fence_of(std::string_view line) {
    const std::string_view text = trimmed(line);
    if (!text.starts_with("```") && !text.starts_with("~~~")) return {};
    const size_t run = run_of(text);
    if (text[0] == '`' && text.find('`', run) != npos) return {};  // a span of code in a paragraph
    return {text.substr(0, run), indent_of(line)};
}
bool ends_fence(std::string_view line, const Fence& open) {
    const std::string_view text = trimmed(line);
    return text.size() >= open.marks.size() && text[0] == open.marks[0] && run_of(text) == text.size();
}

/// "- ", "* ", "+ ", "2. " or "2) " before an item.
struct ItemStart {
    std::string marker;  ///< empty: it is none
    size_t text = 0;     ///< where the item's text begins
};
ItemStart item_start(std::string_view line) {
    size_t i = indent_of(line);
    std::string marker;
    if (i < line.size() && (line[i] == '-' || line[i] == '*' || line[i] == '+')) {
        marker = "*", ++i;
    } else {
        const size_t begin = i;
        while (i < line.size() && is_digit(line[i]) && i - begin < 9) ++i;
        if (i == begin || i >= line.size() || (line[i] != '.' && line[i] != ')')) return {};
        marker = std::string(line.substr(begin, i - begin)) + ".", ++i;
    }
    if (i < line.size() && !is_space(line[i])) return {};
    return {marker, std::min(i + 1, line.size())};
}

std::vector<std::string> cells_of(std::string_view line) {
    std::string_view row = trimmed(line);
    if (row.starts_with('|')) row.remove_prefix(1);
    if (row.ends_with('|') && !row.ends_with("\\|")) row.remove_suffix(1);
    std::vector<std::string> cells(1);
    for (size_t i = 0; i < row.size(); ++i) {
        const bool pair = row[i] == '\\' && i + 1 < row.size();
        if (row[i] == '|')
            cells.emplace_back();
        else if (pair && row[i + 1] == '|')
            cells.back() += row[++i];  // within code too, where a backslash otherwise stands for itself
        else if (cells.back() += row[i]; pair)
            cells.back() += row[++i];
    }
    for (std::string& cell : cells) cell = trimmed(cell);
    return cells;
}

/// "|---|:--|", below the heading of a table.
bool is_table_line(std::string_view line) {
    if (line.find('|') == npos) return false;
    for (const std::string& cell : cells_of(line)) {
        std::string_view dashes(cell);
        if (dashes.starts_with(':')) dashes.remove_prefix(1);
        if (dashes.ends_with(':')) dashes.remove_suffix(1);
        if (dashes.empty() || dashes[0] != '-' || run_of(dashes) != dashes.size()) return false;
    }
    return true;
}

class Reader {
public:
    explicit Reader(std::string_view text) {
        if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);  // some editors' mark of UTF-8
        for (std::string& line : split(text, '\n')) {
            if (line.ends_with('\r')) line.pop_back();
            std::string spaced;
            for (const char c : line)
                if (c == '\t')
                    spaced.append(4 - spaced.size() % 4, ' ');
                else
                    spaced += c;
            lines_.push_back(std::move(spaced));
        }
    }

    std::vector<Block> read() {
        while (at_ < lines_.size()) {
            if (trimmed(line()).empty()) {
                finish();
                ++at_;
            } else {
                block();
            }
        }
        finish();
        return std::move(blocks_);
    }

private:
    const std::string& line() const { return lines_[at_]; }

    void block() {
        if (code_by_fence() || code_by_indent()) return;
        if (const int level = heading_level(line())) {
            finish();
            lists_.clear();
            add({.kind = BlockKind::heading, .level = level, .spans = Inline::parse(heading_text(line()))});
            ++at_;
        } else if (is_rule(line())) {
            finish();
            lists_.clear();
            add({.kind = BlockKind::rule});
            ++at_;
        } else if (!table() && !item()) {
            text();
        }
    }

    bool code_by_fence() {
        const Fence fence = fence_of(line());
        if (fence.marks.empty()) return false;
        finish();
        Block block{.kind = BlockKind::code, .level = depth_at(fence.indent)};
        for (++at_; at_ < lines_.size() && !ends_fence(line(), fence); ++at_)
            block.text += line().substr(std::min(indent_of(line()), fence.indent)) + "\n";
        ++at_;  // the closing fence; the end of the text closes too
        add(std::move(block));
        return true;
    }

    bool code_by_indent() {
        const auto is_code = [&] { return indent_of(line()) >= 4 && indent_of(line()) < line().size(); };
        if (!open_.empty() || !lists_.empty() || !is_code()) return false;
        Block block{.kind = BlockKind::code};
        for (; at_ < lines_.size() && is_code(); ++at_) block.text += line().substr(4) + "\n";
        add(std::move(block));
        return true;
    }

    bool table() {
        if (line().find('|') == std::string::npos || at_ + 1 >= lines_.size() || !is_table_line(lines_[at_ + 1]))
            return false;
        const size_t columns = cells_of(line()).size();
        if (cells_of(lines_[at_ + 1]).size() != columns) return false;
        finish();
        Block block{.kind = BlockKind::table, .level = depth_at(indent_of(line()))};
        const size_t first = at_;
        for (; at_ < lines_.size() && !trimmed(line()).empty() && line().find('|') != std::string::npos; ++at_) {
            if (at_ == first + 1) continue;
            std::vector<Spans> row;
            for (const std::string& cell : cells_of(line())) row.push_back(Inline::parse(cell));
            row.resize(columns);
            block.rows.push_back(std::move(row));
        }
        add(std::move(block));
        return true;
    }

    bool item() {
        const ItemStart start = item_start(line());
        if (start.marker.empty()) return false;
        // In the middle of a paragraph a number is most likely part of it: "in\n1978. Blinn".
        if (!open_.empty() && lists_.empty() && start.marker != "*" && start.marker != "1.") return false;
        finish();
        const size_t indent = indent_of(line());
        while (!lists_.empty() && indent < lists_.back()) lists_.pop_back();
        lists_.push_back(std::max(start.text, indent + 1));
        pending_ = {.kind = BlockKind::item, .level = int(lists_.size()) - 1, .marker = start.marker};
        open_ = line().substr(start.text);
        is_open_ = true;
        ++at_;
        return true;
    }

    // A line of a paragraph, an item or a quote, or the first of one.
    void text() {
        std::string_view content = trimmed(line());
        const bool quote = content.starts_with('>');
        if (quote) content = trimmed(content.substr(1));
        const bool goes_on = is_open_ && (!quote || pending_.kind == BlockKind::quote);
        if (!goes_on) {
            finish();
            pending_ = {.kind = quote ? BlockKind::quote : BlockKind::paragraph, .level = depth_at(indent_of(line()))};
            is_open_ = true;
            open_.clear();
        } else {
            const bool break_here = open_.ends_with("  ") || open_.ends_with('\\');
            while (!open_.empty() && (is_space(open_.back()) || (break_here && open_.back() == '\\'))) open_.pop_back();
            if (!open_.empty()) open_ += break_here ? '\n' : ' ';
        }
        open_ += content;
        if (line().ends_with("  ")) open_ += "  ";
        ++at_;
    }

    /// In how many lists a line stands by its indent; less indent than a list's text ends the list.
    int depth_at(size_t indent) {
        while (!lists_.empty() && indent < lists_.back()) lists_.pop_back();
        return int(lists_.size());
    }

    void finish() {
        if (!is_open_) return;
        is_open_ = false;
        pending_.spans = Inline::parse(trimmed(open_));
        open_.clear();
        add(std::move(pending_));
    }
    void add(Block block) { blocks_.push_back(std::move(block)); }

    std::vector<std::string> lines_;
    size_t at_ = 0;
    bool is_open_ = false;  ///< `pending_` and the text of its lines so far
    Block pending_;
    std::string open_;
    std::vector<size_t> lists_;  ///< the column of the text in each list that stands open
    std::vector<Block> blocks_;
};

}  // namespace

std::vector<Block> parse_markdown(std::string_view text) { return Reader(text).read(); }

}  // namespace relief
