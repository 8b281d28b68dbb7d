// CSV: tables that people and their spreadsheets write, and lines that a spreadsheet may open without harm.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace relief {

struct CsvRow {
    int line = 0;                    ///< where it begins, from 1
    std::vector<std::string> cells;  ///< one for each column; without blanks around, unless in quotes
};

struct CsvTable {
    std::filesystem::path file;
    std::vector<std::string> columns;
    std::vector<CsvRow> rows;  ///< without those that are empty

    /// The number of a column, or -1.
    int column(std::string_view name) const;
    /// Empty where there is no such column.
    const std::string& cell(const CsvRow& row, std::string_view name) const;
    /// Throws Error at the first line if a column is not in `known`, or one of `needed` is missing.
    void refuse_columns(std::span<const std::string> known, std::span<const std::string> needed) const;
};

/// Reads a table with a line of column names (RFC 4180). The separator is the comma, semicolon or tab that the first
/// line has most often: a spreadsheet's choice follows its language. Takes UTF-8, with or without a byte order mark.
/// Throws Error with the line for anything else, for a doubled column, and for a row longer than the first.
CsvTable read_csv(const std::filesystem::path& file);
/// The same of a text; `file` names it in errors.
CsvTable parse_csv(std::string_view text, const std::filesystem::path& file);

/// The text so that no spreadsheet takes a part of it for a formula: an apostrophe stands before each = + - @, tab and
/// carriage return (and wide = + - @) that may begin a cell, at the start or after a comma, semicolon, tab or line
/// break, since a spreadsheet may split at any of them. Blanks and quotes before it change nothing. Source: OWASP, "CSV
/// Injection".
std::string defused(std::string_view text);

/// A line of a table: cells that need quotes have them (RFC 4180). Cells are not changed: see defused().
std::string csv_line(std::span<const std::string> cells);

}  // namespace relief
