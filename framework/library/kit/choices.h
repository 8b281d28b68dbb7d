// The choices of a knob as one table: value, name, and the definition that its programs are compiled with.
#pragma once

#include <array>
#include <cstddef>

#include "framework/core/gl/program.h"

namespace relief {

/// A row of the table. `define` is "NAME" or "NAME VALUE"; an empty one defines nothing.
template <class Value>
struct Choice {
    Value value;
    const char* name;
    const char* define = "";
};

/// The table in the form in which Knobs::choice() and Programs::with() take it. A knob keeps its value as an int.
template <size_t count>
struct Choices {
    std::array<const char*, count> names;
    std::array<const char*, count> defines;

    static constexpr size_t size() { return count; }
    /// Returns the definition of a choice, from 0 to size() - 1.
    Define define(int value) const { return defines[size_t(value)]; }
};

/// Returns the table of `rows`. A table whose rows are not in the order of their values, from 0 on, does not compile.
template <class Value, size_t count>
consteval Choices<count> choices(const Choice<Value> (&rows)[count]) {
    Choices<count> table{};
    for (size_t i = 0; i < count; ++i) {
        if (size_t(rows[i].value) != i) throw "the rows must be in the order of their values";
        table.names[i] = rows[i].name;
        table.defines[i] = rows[i].define;
    }
    return table;
}

/// Returns the names of the rows of a table with other columns, which has a member `name` for each row.
template <class Row, size_t count>
constexpr std::array<const char*, count> names_of(const std::array<Row, count>& rows) {
    std::array<const char*, count> names{};
    for (size_t i = 0; i < count; ++i) names[i] = rows[i].name;
    return names;
}

}  // namespace relief
