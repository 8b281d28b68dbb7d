#include "framework/staff/class/csv.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/text.h"
#include "framework/staff/grade/strangers_text.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;

constexpr size_t max_bytes = size_t{1} << 26;
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

char separator_of(std::string_view text) {
    const std::string_view first = text.substr(0, text.find_first_of("\r\n"));
    char best = ',';
    for (const char one : {';', '\t'})
        if (std::count(first.begin(), first.end(), one) > std::count(first.begin(), first.end(), best)) best = one;
    return best;
}

std::string without_blanks(const std::string& text) {
    const size_t first = text.find_first_not_of(" \t\r\n"), last = text.find_last_not_of(" \t\r\n");
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// Returns whether a spreadsheet reads a cell with this start as a formula. Some accept the wide forms of = + - @, too.
bool is_formula(std::string_view text) {
    for (const std::string_view start :
         {"=", "+", "-", "@", "\t", "\r", "\xef\xbc\x9d", "\xef\xbc\x8b", "\xef\xbc\x8d", "\xef\xbc\xa0"})
        if (text.starts_with(start)) return true;
    return false;
}

class Reader {
public:
    Reader(const fs::path& file, std::string_view text) : file_(file), text_(text), separator_(separator_of(text)) {}

    bool at_end() const { return at_ == text_.size(); }

    CsvRow row() {
        CsvRow row{.line = line_, .cells = {}};
        do row.cells.push_back(cell());
        while (take(separator_));
        take('\r');
        if (!take('\n') && !at_end() && text_[at_ - 1] != '\r')
            throw Error({file_, line_}, "text follows a quoted cell: write a quote inside of one twice");
        return row;
    }

private:
    std::string cell() {
        size_t quote = at_;
        while (quote < text_.size() && text_[quote] == ' ') ++quote;
        if (quote < text_.size() && text_[quote] == '"') {
            at_ = quote + 1;
            return quoted();
        }
        std::string text;
        while (!at_end() && text_[at_] != separator_ && text_[at_] != '\n' && text_[at_] != '\r') text += text_[at_++];
        return without_blanks(text);
    }

    std::string quoted() {
        const int begin = line_;
        std::string text;
        for (; !at_end(); ++at_) {
            if (text_[at_] == '"') {
                if (text_.substr(at_ + 1, 1) != "\"") break;
                ++at_;
            }
            line_ += text_[at_] == '\n';
            text += text_[at_];
        }
        if (at_end()) throw Error({file_, begin}, "a quoted cell has no end");
        ++at_;
        while (!at_end() && text_[at_] == ' ') ++at_;
        return text;
    }

    bool take(char wanted) {
        if (at_end() || text_[at_] != wanted) return false;
        line_ += wanted == '\n';
        ++at_;
        return true;
    }

    const fs::path& file_;
    std::string_view text_;
    char separator_;
    size_t at_ = 0;
    int line_ = 1;
};

}  // namespace

int CsvTable::column(std::string_view name) const {
    const auto found = std::find(columns.begin(), columns.end(), name);
    return found == columns.end() ? -1 : int(found - columns.begin());
}

const std::string& CsvTable::cell(const CsvRow& row, std::string_view name) const {
    static const std::string nothing;
    const int at = column(name);
    return at < 0 ? nothing : row.cells[size_t(at)];
}

void CsvTable::refuse_columns(std::span<const std::string> known, std::span<const std::string> needed) const {
    for (const std::string& name : columns)
        if (std::find(known.begin(), known.end(), name) == known.end())
            throw Error({file, 1}, unknown("column", printable(name), known));
    for (const std::string& name : needed)
        if (column(name) < 0) throw Error({file, 1}, fmt::format("needs a column '{}'", name));
}

CsvTable read_csv(const fs::path& file) { return parse_csv(read_file(file, max_bytes), file); }

CsvTable parse_csv(std::string_view text, const fs::path& file) {
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    if (utf8_of_bytes(text) != text || text.find('\0') != std::string_view::npos)
        throw Error({file}, "is not UTF-8: in a spreadsheet, save it as 'CSV UTF-8'");
    Reader reader(file, text);
    CsvTable table{.file = file, .columns = {}, .rows = {}};
    if (!reader.at_end()) table.columns = reader.row().cells;
    for (size_t i = 0; i < table.columns.size(); ++i)
        if (!table.columns[i].empty() && table.column(table.columns[i]) != int(i))
            throw Error({file, 1}, fmt::format("has the column '{}' twice", printable(table.columns[i])));
    while (!table.columns.empty() && table.columns.back().empty()) table.columns.pop_back();
    if (table.columns.empty()) throw Error({file, 1}, "is empty: its first line must name the columns");
    while (!reader.at_end()) {
        CsvRow row = reader.row();
        const auto is_empty = [](const std::string& cell) { return cell.empty(); };
        if (std::all_of(row.cells.begin(), row.cells.end(), is_empty)) continue;
        const size_t count = table.columns.size();
        if (row.cells.size() > count &&
            !std::all_of(row.cells.begin() + std::ptrdiff_t(count), row.cells.end(), is_empty))
            throw Error({file, row.line}, fmt::format("has {} cells, and the first line names {} columns: put quotes "
                                                      "around a cell that has a separator in it",
                                                      row.cells.size(), count));
        row.cells.resize(count);
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::string defused(std::string_view text) {
    std::string result;
    bool begins = true;  // a spreadsheet may begin a cell here
    for (size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const bool separates = c == ',' || c == ';' || c == '\t' || c == '\n' || c == '\r';
        if (begins && is_formula(text.substr(i))) result += '\'';
        result += c;
        begins = separates || (begins && (c == ' ' || c == '"'));
    }
    return result;
}

std::string csv_line(std::span<const std::string> cells) {
    std::string line;
    for (size_t i = 0; i < cells.size(); ++i) {
        if (i > 0) line += ',';
        if (cells[i].find_first_of(",;\t\"\r\n") == std::string::npos && !cells[i].starts_with(' ') &&
            !cells[i].ends_with(' ')) {
            line += cells[i];
            continue;
        }
        line += '"';
        for (const char c : cells[i]) line += c == '"' ? std::string("\"\"") : std::string(1, c);
        line += '"';
    }
    return line + "\n";
}

}  // namespace relief::grade
