// CSV: reads tables by people and spreadsheets, and writes lines that spreadsheets can open safely.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace relief::grade {

struct CsvRow {
    int line = 0;                    ///< first line of the row, counted from 1
    std::vector<std::string> cells;  ///< one per column; surrounding blanks are removed unless quoted
};

struct CsvTable {
    std::filesystem::path file;
    std::vector<std::string> columns;
    std::vector<CsvRow> rows;  ///< without empty rows

    /// Returns the index of a column, or -1.
    int column(std::string_view name) const;
    /// Returns a cell; an empty text if there is no such column.
    const std::string& cell(const CsvRow& row, std::string_view name) const;
    /// Throws Error at the first line if a column is not in `known`, or if a column of `needed` is missing.
    void refuse_columns(std::span<const std::string> known, std::span<const std::string> needed) const;
};

/// Reads a table with a line of column names (RFC 4180). The separator is the most frequent of comma, semicolon and tab
/// in the first line: a spreadsheet chooses it by its language. Accepts UTF-8, with or without a byte order mark.
/// Throws Error with the line for any other encoding, for a duplicate column, and for a row longer than the first.
CsvTable read_csv(const std::filesystem::path& file);
/// Parses a table from a text; `file` names it in errors.
CsvTable parse_csv(std::string_view text, const std::filesystem::path& file);

/// Returns the text with formulas disabled for spreadsheets. Inserts an apostrophe before each = + - @, tab and
/// carriage return (and wide = + - @) that may begin a cell. A cell may begin at the start, and after a comma,
/// semicolon, tab or line break, since a spreadsheet may split at any of them; preceding blanks and quotes change
/// nothing. Source: OWASP, "CSV Injection".
std::string defused(std::string_view text);

/// Returns a line of a table, with quotes around cells that need them (RFC 4180). Does not disable formulas: see
/// defused().
std::string csv_line(std::span<const std::string> cells);

}  // namespace relief::grade
