#include "framework/staff/measure/rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <initializer_list>
#include <map>
#include <set>
#include <utility>

#include "framework/core/base/error.h"
#include "framework/core/base/text.h"
#include "framework/staff/measure/sweep.h"

namespace relief::measure {
namespace {

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"') result += '"';
        result += c;
    }
    return result + '"';
}

std::string number(double value) { return fmt::format("{}", value); }

/// Returns the records of a CSV, each with the line on which it begins.
std::vector<std::pair<int, std::vector<std::string>>> records_of(const std::string& text) {
    std::vector<std::pair<int, std::vector<std::string>>> records;
    int line = 1;
    bool is_quoted = false, is_open = false;
    for (size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (!is_open) {
            records.push_back({line, {""}});
            is_open = true;
        }
        std::string& field = records.back().second.back();
        if (c == '\n') ++line;
        if (is_quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"')
            field += text[++i];
        else if (c == '"')
            is_quoted = !is_quoted;
        else if (is_quoted || (c != ',' && c != '\n' && c != '\r'))
            field += c;
        else if (c == ',')
            records.back().second.emplace_back();
        else if (c == '\n')
            is_open = false;
    }
    return records;
}

BenchKnobs knobs_from(const std::string& text) {
    BenchKnobs knobs;
    if (text.empty()) return knobs;
    for (const std::string& one : split(text, ' ')) {
        // A value may contain spaces ("4 x 4 a patch").
        if (const size_t sign = one.find('='); sign != std::string::npos)
            knobs.emplace_back(one.substr(0, sign), one.substr(sign + 1));
        else if (!knobs.empty())
            knobs.back().second += " " + one;
    }
    return knobs;
}

constexpr const char* header =
    "topic,scene,method,knobs,state,items,item,repeats,clock,ns_per_item_median,ns_per_item_p10,ns_per_item_p90,"
    "spread,"
    "bytes_per_item,error_mean,error_p99,error_largest,error_unit,error_wrong,work,stated,places,renderer,cpu,load,"
    "processors,compiler,commit";

std::string work_text(const BenchWork& work) {
    std::string text;
    for (const auto& [name, amount] : work)
        text += fmt::format("{}{}={}", text.empty() ? "" : " ", name, plain(amount));
    return text;
}

/// Returns "hardness:error" for each point, or the kind of failure there. Three digits hide the differences between
/// compilers.
std::string places_text(const BenchSweep& sweep) {
    std::string text;
    for (const BenchSweep::Place& place : sweep.places)
        text += fmt::format("{}{}:{}", text.empty() ? "" : " ", plain(with_digits(place.hardness, 3)),
                            place.not_finite > 0 ? "not-finite"
                            : place.endless > 0  ? "endless"
                                                 : plain(with_digits(place.error, 3)));
    return text;
}

/// The columns of a table, and their widths.
struct TableColumns {
    size_t method = 6, knobs = 5;
    bool time = false, wide = false, rate = false, error = false, wrong = false;
    bool in_milliseconds = false;  ///< one unit for the whole table
};

TableColumns columns_of(std::span<const BenchRow> rows) {
    TableColumns columns;
    for (const BenchRow& row : rows) {
        columns.method = std::max(columns.method, row.method.size());
        columns.knobs = std::max(columns.knobs, knob_text(row.knobs).size());
        columns.time |= row.repeats > 0;
        columns.wide |= row.is_wide();
        columns.rate |= row.bytes_per_item > 0;
        columns.error |= !row.error.unit.empty();
        columns.wrong |= row.error.wrong.has_value();
        columns.in_milliseconds |= row.times.median >= 1e6;
    }
    return columns;
}

/// Returns the units of a scene's errors.
std::set<std::string> error_units(std::span<const BenchRow> rows, const BenchKnobs& scene) {
    std::set<std::string> units;
    for (const BenchRow& row : rows)
        if (row.scene == scene && !row.error.unit.empty()) units.insert(row.error.unit);
    return units;
}

/// The columns of numbers in a table.
enum class BenchColumn { median, p10, p90, rate, mean, p99, largest, wrong };
constexpr std::array<size_t, 8> column_widths = {13, 9, 9, 6, 12, 10, 10, 8};
using BenchCells = std::array<std::string, column_widths.size()>;

/// Returns the numbers of each row as text; a number that a row does not have is blank.
std::vector<BenchCells> cells_of(const TableColumns& columns, std::span<const BenchRow> rows) {
    std::vector<BenchCells> cells(rows.size());
    const double scale = columns.in_milliseconds ? 1e-6 : 1;
    for (size_t column = 0; column < column_widths.size(); ++column) {
        std::vector<std::string> texts;
        for (const BenchRow& row : rows) {
            const bool timed = row.repeats > 0, known = !row.error.unit.empty();
            const std::pair<bool, double> values[] = {
                {timed, scale * row.times.median},
                {timed, scale * row.times.p10},
                {timed, scale * row.times.p90},
                {timed && row.bytes_per_item > 0, row.bytes_per_item / row.times.median},
                {known, row.error.mean},
                {known, row.error.p99},
                {known, row.error.largest},
                {row.error.wrong.has_value(), row.error.wrong.value_or(0) * 100}};
            const auto& [is_there, value] = values[column];
            texts.push_back(is_there && row.is_measured() ? rounded(value, 4) : "");
        }
        texts = aligned_at_points(std::move(texts), column_widths[column]);
        for (size_t i = 0; i < rows.size(); ++i) cells[i][column] = texts[i];
    }
    return cells;
}

/// `widths`: cells of any row.
std::string table_head(const TableColumns& columns, const std::string& item, const std::string& error_title,
                       const BenchCells& widths) {
    std::string text = fmt::format("{:<{}}  {:<{}}", "method", columns.method, "knobs", columns.knobs);
    const auto put = [&](BenchColumn column, const std::string& title) {
        text += fmt::format("  {:>{}}", title, widths[size_t(column)].size());
    };
    if (columns.time) {
        put(BenchColumn::median, (columns.in_milliseconds ? "ms/" : "ns/") + item);
        put(BenchColumn::p10, "p10"), put(BenchColumn::p90, "p90");
    }
    if (columns.wide) text += "  ";
    if (columns.rate) put(BenchColumn::rate, "GB/s");
    if (columns.error) {
        put(BenchColumn::mean, "mean " + error_title);
        put(BenchColumn::p99, "p99"), put(BenchColumn::largest, "largest");
    }
    if (columns.wrong) put(BenchColumn::wrong, "wrong %");
    return text + "  work\n";
}

std::string table_line(const TableColumns& columns, const BenchRow& row, const BenchCells& cells, bool names_unit) {
    std::string text = fmt::format("{:<{}}  {:<{}}", row.method, columns.method, knob_text(row.knobs), columns.knobs);
    if (!row.is_measured()) return text + "  " + row.state + '\n';
    const auto put = [&](std::initializer_list<BenchColumn> shown) {
        for (const BenchColumn column : shown) text += "  " + cells[size_t(column)];
    };
    if (columns.time) put({BenchColumn::median, BenchColumn::p10, BenchColumn::p90});
    if (columns.wide) text += row.is_wide() ? " *" : "  ";
    if (columns.rate) put({BenchColumn::rate});
    if (columns.error) put({BenchColumn::mean, BenchColumn::p99, BenchColumn::largest});
    if (names_unit && !row.error.unit.empty()) text += " " + plural(row.error.unit);
    if (columns.wrong) put({BenchColumn::wrong});
    text += "  " + work_text(row.work);
    text.erase(text.find_last_not_of(' ') + 1);
    if (row.sweep) text += "\n    " + verdict_of(*row.sweep, row.error.unit);
    return text + '\n';
}

}  // namespace

std::vector<BenchRow> open_rows(const BenchTopic& topic, const BenchScene& scene) {
    std::vector<BenchRow> rows;
    for (const BenchMethod& method : scene.methods) {
        BenchRow& row = rows.emplace_back();
        row.topic = topic.name;
        row.scene = scene.knobs;
        row.item = scene.item;
        row.method = method.name;
        row.knobs = method.knobs;
        row.peer = method.peer;
    }
    return rows;
}

std::string cpu_name() {
    std::ifstream stream("/proc/cpuinfo");
    for (std::string line; std::getline(stream, line);)
        if (line.starts_with("model name"))
            if (const size_t colon = line.find(": "); colon != std::string::npos) return line.substr(colon + 2);
    return "unknown";
}

double load_average() {
    double load = 0;
    return getloadavg(&load, 1) == 1 ? load : 0;
}

std::string load_text(const BenchMachine& machine) {
    if (machine.load <= 0) return {};
    return "load " + rounded(machine.load, 2) +
           (machine.processors == 0 ? "" : fmt::format(" on {} processors", machine.processors));
}

std::string clocks_of(std::span<const BenchRow> rows) {
    std::set<std::string> clocks;
    for (const BenchRow& row : rows)
        if (row.is_timed()) clocks.insert(row.clock);
    return join(std::vector(clocks.begin(), clocks.end()), " and ");
}

std::string bench_table(const BenchTopic& topic, std::span<const BenchRow> rows, const BenchMachine& machine) {
    const TableColumns columns = columns_of(rows);
    std::string text = fmt::format("{}: {}\n", topic.name, topic.help);
    for (size_t begin = 0, end = 0; begin < rows.size(); begin = end) {
        const BenchRow& first = rows[begin];
        while (end < rows.size() && rows[end].scene == first.scene && rows[end].item == first.item) ++end;
        if (begin > 0) text += '\n';
        if (!first.scene.empty()) text += fmt::format("[{}]\n", knob_text(first.scene));
        const std::set<std::string> units = error_units(rows, first.scene);
        const bool names_units = units.size() > 1;  // each line names its own
        const std::string error_title = names_units ? "error" : plural(units.empty() ? "" : *units.begin());
        const std::vector<BenchCells> cells = cells_of(columns, rows.subspan(begin, end - begin));
        text += table_head(columns, first.item, error_title, cells.front());
        for (size_t i = begin; i < end; ++i) text += table_line(columns, rows[i], cells[i - begin], names_units);
    }
    if (columns.wide)
        text +=
            "* p90 is more than twice p10: other load may have decided this time. Measure again on an idle machine.\n";
    if (columns.time && machine.load > 0)
        text += fmt::format("{}: the largest average over a minute during the run, with this program\n",
                            load_text(machine));
    return text;
}

std::string bench_csv(std::span<const BenchRow> rows, const BenchMachine& machine) {
    std::string text = std::string(header) + "\r\n";
    for (const BenchRow& row : rows) {
        const BenchError& error = row.error;
        const bool timed = row.repeats > 0, known = !error.unit.empty();
        const std::string fields[] = {row.topic,
                                      knob_text(row.scene),
                                      row.method,
                                      knob_text(row.knobs),
                                      row.state,
                                      std::to_string(row.items),
                                      row.item,
                                      std::to_string(row.repeats),
                                      timed ? row.clock : "",
                                      timed ? number(row.times.median) : "",
                                      timed ? number(row.times.p10) : "",
                                      timed ? number(row.times.p90) : "",
                                      row.is_wide() ? "wide" : "",
                                      row.bytes_per_item > 0 ? number(row.bytes_per_item) : "",
                                      known ? number(error.mean) : "",
                                      known ? number(error.p99) : "",
                                      known ? number(error.largest) : "",
                                      error.unit,
                                      error.wrong ? number(*error.wrong) : "",
                                      work_text(row.work),
                                      row.sweep ? plain(row.sweep->stated) : "",
                                      row.sweep ? places_text(*row.sweep) : "",
                                      machine.renderer,
                                      machine.cpu,
                                      timed && machine.load > 0 ? number(machine.load) : "",
                                      timed && machine.processors > 0 ? std::to_string(machine.processors) : "",
                                      machine.compiler,
                                      machine.commit};
        std::string line;
        for (const std::string& field : fields) line += (line.empty() ? "" : ",") + quoted(field);
        text += line + "\r\n";
    }
    return text;
}

std::vector<BenchRow> read_bench_csv(const std::string& text) {
    const auto records = records_of(text);
    const std::vector<std::string> names = split(header, ',');
    if (records.empty() || records.front().second != names)
        throw Error(Place{{}, 1}, "not a table of relief bench: its columns are others");
    std::vector<BenchRow> rows;
    for (size_t i = 1; i < records.size(); ++i) {
        const auto& [line, fields] = records[i];
        if (fields.size() != names.size())
            throw Error(Place{{}, line}, fmt::format("{} fields instead of {}", fields.size(), names.size()));
        std::map<std::string, std::string> field;
        for (size_t k = 0; k < names.size(); ++k) field[names[k]] = fields[k];
        const auto value = [&, line = line](const std::string& of) {
            char* end = nullptr;
            const double result = std::strtod(of.c_str(), &end);
            if (of.empty() || *end) throw Error(Place{{}, line}, fmt::format("'{}' is not a number", of));
            return result;
        };
        BenchRow& row = rows.emplace_back();
        row.topic = field["topic"];
        row.scene = knobs_from(field["scene"]);
        row.method = field["method"];
        row.knobs = knobs_from(field["knobs"]);
        row.state = field["state"];
        row.item = field["item"];
        for (const auto& [name, amount] : knobs_from(field["work"])) row.work.emplace_back(name, value(amount));
        if (field["error_unit"].empty()) continue;
        row.error = {value(field["error_mean"]), value(field["error_p99"]), value(field["error_largest"]),
                     field["error_unit"]};
        if (!field["error_wrong"].empty()) row.error.wrong = value(field["error_wrong"]);
    }
    return rows;
}

std::string short_name(const BenchRow& row) {
    std::string text = row.method;
    for (const auto& [knob, value] : row.knobs) {
        std::string name = knob;
        std::replace(name.begin(), name.end(), '_', ' ');
        if (value == row.method) continue;
        if (value == "on" || value == "yes")
            text += " " + name;
        else if (value == "off" || value == "no")
            text += " no " + name;
        else if (!parse_number(value))
            text += " " + value;
        else if (knob.ends_with('s'))
            text += fmt::format(" {} {}", value, value == "1" ? name.substr(0, name.size() - 1) : name);
        else
            text += fmt::format(" {} {}", name, value);
    }
    return text;
}

std::string row_name(const BenchRow& row) {
    std::string text = row.topic;
    for (const std::string& part : {knob_text(row.scene), row.method, knob_text(row.knobs)})
        if (!part.empty()) text += ", " + part;
    return text;
}

}  // namespace relief::measure
