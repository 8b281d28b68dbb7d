#include "framework/course/pages/markdown.h"

#include <md4c.h>

#include <new>
#include <stdexcept>
#include <utility>

#include "framework/core/base/text.h"

namespace relief::pages {
namespace {

/// Makes blocks of the tree that md4c reports. Blocks are a flat list: an item's further paragraphs follow it, and each
/// block states its depth.
class Builder {
public:
    void enter(MD_BLOCKTYPE type, const void* detail) {
        styles_.clear();
        switch (type) {
            case MD_BLOCK_UL:
                open_ = nullptr;
                lists_.push_back({});
                break;
            case MD_BLOCK_OL:
                open_ = nullptr;
                lists_.push_back({.numbered = true, .next = static_cast<const MD_BLOCK_OL_DETAIL*>(detail)->start});
                break;
            case MD_BLOCK_LI: {
                List& list = lists_.back();
                const std::string marker = list.numbered ? std::to_string(list.next++) + "." : "*";
                begin({.kind = BlockKind::item, .level = depth() - 1, .marker = marker});
                fresh_item_ = true;
                break;
            }
            case MD_BLOCK_P:
                if (!fresh_item_) open_ = nullptr;  // the first paragraph of an item is the item's own text
                break;
            case MD_BLOCK_QUOTE:
                open_ = nullptr;
                ++quotes_;
                break;
            case MD_BLOCK_H:
                begin({.kind = BlockKind::heading, .level = int(static_cast<const MD_BLOCK_H_DETAIL*>(detail)->level)});
                break;
            case MD_BLOCK_CODE:
                begin({.kind = BlockKind::code, .level = depth()});
                blocks_.back().language = text_of(static_cast<const MD_BLOCK_CODE_DETAIL*>(detail)->lang);
                open_ = nullptr, code_ = true;
                break;
            case MD_BLOCK_HR:
                begin({.kind = BlockKind::rule, .level = depth()});
                open_ = nullptr;
                break;
            case MD_BLOCK_TABLE:
                begin({.kind = BlockKind::table, .level = depth()});
                break;
            case MD_BLOCK_TR:
                blocks_.back().rows.emplace_back();
                break;
            case MD_BLOCK_TH:
            case MD_BLOCK_TD:
                open_ = &blocks_.back().rows.back().emplace_back();
                break;
            default:
                break;
        }
    }

    void leave(MD_BLOCKTYPE type) {
        if (type == MD_BLOCK_UL || type == MD_BLOCK_OL) lists_.pop_back();
        if (type == MD_BLOCK_QUOTE) --quotes_;
        if (type == MD_BLOCK_CODE) code_ = false;
        open_ = nullptr, fresh_item_ = false;
    }

    void enter(MD_SPANTYPE type, const void* detail) {
        Span style = this->style();
        if (type == MD_SPAN_STRONG) style.bold = true;
        if (type == MD_SPAN_EM) style.italic = true;
        if (type == MD_SPAN_CODE) style.code = true;
        if (type == MD_SPAN_A) style.target = text_of(static_cast<const MD_SPAN_A_DETAIL*>(detail)->href);
        if (type == MD_SPAN_IMG) {
            style.image = true, style.target = text_of(static_cast<const MD_SPAN_IMG_DETAIL*>(detail)->src);
            spans().push_back(style);  // an image needs a span even without a text
        }
        styles_.emplace_back(type, std::move(style));
    }
    /// Ends the innermost span of this type. Where emphasis and links overlap, md4c 0.4.8 leaves spans in another order
    /// than it entered them, or never leaves them.
    void leave(MD_SPANTYPE type) {
        for (size_t i = styles_.size(); i-- > 0;)
            if (styles_[i].first == type)
                return void(styles_.erase(styles_.begin() + std::ptrdiff_t(i), styles_.end()));
    }

    void text(MD_TEXTTYPE type, std::string_view text) {
        if (type == MD_TEXT_BR) text = "\n";
        if (type == MD_TEXT_SOFTBR) text = " ";
        if (type == MD_TEXT_NULLCHAR) text = "\xef\xbf\xbd";
        if (code_) {
            blocks_.back().text += text;
            return;
        }
        Spans& all = spans();
        const Span& now = style();
        // An image's text is plain: drop bold and links in it.
        const bool goes_on = !all.empty() && (now.image ? all.back().image : same_style(all.back(), now));
        if (!goes_on) all.push_back(now);
        std::string& grows = all.back().text;
        // In a table, a bar needs a backslash even in code. The backslash is not part of the code, but md4c keeps it.
        if (now.code && blocks_.back().kind == BlockKind::table)
            for (size_t bar; (bar = text.find("\\|")) != text.npos; text.remove_prefix(bar + 1))
                grows += text.substr(0, bar);
        grows += text;
    }

    std::vector<Block> blocks() { return std::move(blocks_); }

private:
    struct List {
        bool numbered = false;
        unsigned next = 1;
    };

    static std::string text_of(const MD_ATTRIBUTE& attribute) { return {attribute.text, attribute.size}; }

    static bool same_style(const Span& a, const Span& b) {
        return a.bold == b.bold && a.italic == b.italic && a.code == b.code && a.image == b.image &&
               a.target == b.target;
    }
    const Span& style() const { return styles_.empty() ? plain_ : styles_.back().second; }

    int depth() const { return int(lists_.size()); }

    void begin(Block block) {
        blocks_.push_back(std::move(block));
        open_ = &blocks_.back().spans;
        fresh_item_ = false;
    }

    /// Returns the spans that take text; begins a paragraph if none are open. md4c reports no paragraphs in a list
    /// without blank lines.
    Spans& spans() {
        if (!open_) begin({.kind = quotes_ > 0 ? BlockKind::quote : BlockKind::paragraph, .level = depth()});
        return *open_;
    }

    std::vector<Block> blocks_;
    Spans* open_ = nullptr;    ///< of the last block, or of its last cell; null: none
    bool fresh_item_ = false;  ///< the last block is an item without a paragraph so far
    bool code_ = false;        ///< inside a block of code
    int quotes_ = 0;
    std::vector<List> lists_;  ///< the open ones
    const Span plain_{};
    std::vector<std::pair<MD_SPANTYPE, Span>> styles_;  ///< the open ones within the block, innermost last
};

/// Returns whether a paragraph is one of the tags between which GitHub folds measured blocks. Pages and the window fold
/// these blocks by themselves.
bool is_fold(const Block& block) {
    const std::string text = block.kind == BlockKind::paragraph ? plain_text(block.spans) : "";
    return text == "<details><summary>How it was measured</summary>" || text == "</details>";
}

}  // namespace

std::vector<Block> parse_markdown(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);  // UTF-8's byte order mark, which some editors write
    if (text.size() > 0xffffffffu) throw std::length_error("Markdown of more than 4 GiB");
    MD_PARSER parser{};
    // Treat HTML as text: a menu cannot display it.
    parser.flags = MD_FLAG_TABLES | MD_FLAG_NOHTML;
    parser.enter_block = [](MD_BLOCKTYPE type, void* detail, void* builder) {
        static_cast<Builder*>(builder)->enter(type, detail);
        return 0;
    };
    parser.leave_block = [](MD_BLOCKTYPE type, void*, void* builder) {
        static_cast<Builder*>(builder)->leave(type);
        return 0;
    };
    parser.enter_span = [](MD_SPANTYPE type, void* detail, void* builder) {
        static_cast<Builder*>(builder)->enter(type, detail);
        return 0;
    };
    parser.leave_span = [](MD_SPANTYPE type, void*, void* builder) {
        static_cast<Builder*>(builder)->leave(type);
        return 0;
    };
    parser.text = [](MD_TEXTTYPE type, const MD_CHAR* begin, MD_SIZE size, void* builder) {
        static_cast<Builder*>(builder)->text(type, {begin, size});
        return 0;
    };
    Builder builder;
    if (md_parse(text.data(), MD_SIZE(text.size()), &parser, &builder) != 0) throw std::bad_alloc();
    std::vector<Block> blocks = builder.blocks();
    std::erase_if(blocks, is_fold);
    return blocks;
}

Spans line_with_code(std::string_view line) {
    Spans spans;
    const std::vector<std::string> pieces = split(line, '`');
    for (size_t i = 0; i < pieces.size(); ++i)
        if (!pieces[i].empty()) spans.push_back({.text = pieces[i], .code = i % 2 == 1 && i + 1 < pieces.size()});
    return spans;
}

std::string plain_text(const Spans& spans) {
    std::string text;
    for (const Span& span : spans) text += span.text;
    return text;
}

}  // namespace relief::pages
