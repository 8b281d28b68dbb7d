// CSV tables, as people and spreadsheets write them. Cells survive a round trip, and defusing never shortens them.
#include "framework/staff/class/csv.h"
#include "framework/staff/class/point_in_time.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t count) {
    return relief::fuzz(bytes, count, [](const std::string& text) {
        const relief::grade::CsvTable table = relief::grade::parse_csv(text, "table.csv");
        for (const relief::grade::CsvRow& row : table.rows) {
            const relief::grade::CsvTable again = relief::grade::parse_csv(
                relief::grade::csv_line(table.columns) + relief::grade::csv_line(row.cells), "again.csv");
            for (size_t i = 0; i < row.cells.size() && again.columns == table.columns; ++i)
                if (relief::grade::defused(row.cells[i]).size() < row.cells[i].size() ||
                    again.rows.at(0).cells[i] != row.cells[i])
                    __builtin_trap();
        }
        if (!table.rows.empty())
            relief::grade::parse_moment(table.rows.front().cells.front(), relief::grade::UtcOffset(60), {});
    });
}
