// Reads TOML files table by table and key by key. Errors have a line; unknown keys are errors.
#pragma once

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "framework/core/base/error.h"
#include "framework/core/base/text.h"

namespace relief {

/// Parses a TOML text. Throws Error with the line of a syntax error.
inline toml::table parse_toml(const std::string& text, const std::filesystem::path& file) {
    try {
        return toml::parse(text, file.string());
    } catch (const toml::parse_error& error) {
        std::string what(error.description());
        if (what.find("parsing date") != what.npos || what.find("parsing time") != what.npos)
            what += "; a date is 2027-03-01, one with a time 2027-03-01T23:59:00";
        throw Error({file, int(error.source().begin.line)}, what);
    }
}

class Table {
public:
    Table(const std::filesystem::path& file, const toml::table& table, std::string what)
        : file_(file), table_(table), what_(std::move(what)) {}

    std::string text(const char* key) { return value<std::string>(need(key), key, "a text in quotes"); }

    void read(const char* key, std::string& result) {
        if (const toml::node* node = find(key)) result = value<std::string>(*node, key, "a text in quotes");
    }
    void read(const char* key, bool& result) {
        if (const toml::node* node = find(key)) result = value<bool>(*node, key, "true or false");
    }
    void read(const char* key, double& result, double low, double high) {
        if (const toml::node* node = find(key)) result = number(*node, key, low, high);
    }
    void read(const char* key, int& result, int low, int high) {
        const toml::node* node = find(key);
        if (!node) return;
        const auto whole = node->value_exact<int64_t>();
        if (!whole || *whole < low || *whole > high)
            fail(*node, fmt::format("'{}' must be a whole number from {} to {}", key, low, high));
        result = int(*whole);
    }
    void read(const char* key, std::vector<std::string>& result) {
        const toml::node* node = find(key);
        if (!node) return;
        const toml::array* array = node->as_array();
        if (!array) fail(*node, fmt::format("'{}' must be a list of texts", key));
        for (const toml::node& element : *array) result.push_back(value<std::string>(element, key, "a list of texts"));
    }
    /// Returns a date, with or without a time and an offset, as the file has it: "2027-03-01T23:59:00+01:00". Returns
    /// an empty string when the key is missing.
    std::string date(const char* key) {
        const toml::node* node = find(key);
        if (!node) return {};
        std::ostringstream text;
        if (node->is_date())
            text << *node->as_date();
        else if (node->is_date_time())
            text << *node->as_date_time();
        else
            fail(*node, fmt::format("'{}' must be a date without quotes, such as 2027-03-01T23:59:00", key));
        return text.str();
    }
    /// Reads a list of `count` numbers. Returns false when the key is missing.
    template <int count>
    bool read(const char* key, std::array<double, count>& result, double low, double high) {
        const toml::node* node = find(key);
        if (!node) return false;
        const toml::array* array = node->as_array();
        if (!array || array->size() != count) fail(*node, fmt::format("'{}' must be {} numbers", key, count));
        for (int i = 0; i < count; ++i) result[i] = number((*array)[size_t(i)], key, low, high);
        return true;
    }

    std::optional<Table> table(const char* key) {
        const toml::node* node = find(key);
        if (!node) return {};
        if (!node->as_table()) fail(*node, fmt::format("'{}' must be a table, {{ key = value }}", key));
        return Table(file_, *node->as_table(), fmt::format("{}.{}", what_, key));
    }
    /// Returns the table of each [[key]], in order.
    std::vector<Table> tables(const char* key) {
        std::vector<Table> result;
        const toml::node* node = find(key);
        if (!node) return result;
        const toml::array* array = node->as_array();
        if (!array || !array->is_array_of_tables()) fail(*node, fmt::format("write each {0} as [[{0}]]", key));
        for (const toml::node& element : *array)
            result.emplace_back(file_, *element.as_table(), fmt::format("[[{}]]", key));
        return result;
    }

    /// Returns each { ... } of a list, in order.
    std::vector<Table> inline_tables(const char* key) {
        std::vector<Table> result;
        const toml::node* node = find(key);
        if (!node) return result;
        const toml::array* array = node->as_array();
        if (!array) fail(*node, fmt::format("'{}' must be a list of {{ key = value }}", key));
        for (const toml::node& element : *array) {
            if (!element.as_table()) fail(element, fmt::format("'{}' must be a list of {{ key = value }}", key));
            result.emplace_back(file_, *element.as_table(), fmt::format("{}.{}", what_, key));
        }
        return result;
    }

    /// Returns all keys with their values as text, for the knobs of a shot.
    std::vector<std::pair<std::string, std::string>> all_as_text() {
        std::vector<std::pair<std::string, std::string>> result;
        for (const auto& [key, node] : table_) {
            read_.emplace_back(key.str());
            std::string text;
            if (const auto string = node.value_exact<std::string>())
                text = *string;
            else if (const auto flag = node.value_exact<bool>())
                text = *flag ? "on" : "off";
            else
                text = fmt::format("{}", number(node, read_.back().c_str(), std::numeric_limits<double>::lowest(),
                                                std::numeric_limits<double>::max()));
            result.emplace_back(key.str(), text);
        }
        return result;
    }

    bool has(const char* key) const { return table_.contains(key); }
    std::vector<std::string> keys() const {
        std::vector<std::string> result;
        for (const auto& [key, node] : table_) result.emplace_back(key.str());
        return result;
    }
    bool is_whole(const char* key) const { return table_[key].is_integer(); }
    /// Returns whether the key has a non-empty list of texts.
    bool is_texts(const char* key) const {
        const toml::array* const array = table_[key].as_array();
        return array && !array->empty() && array->is_homogeneous<std::string>();
    }

    /// Call this last. Throws Error for a key that was not read.
    void finish() const {
        for (const auto& [key, node] : table_)
            if (std::find(read_.begin(), read_.end(), key.str()) == read_.end())
                throw Error({file_, int(key.source().begin.line)}, unknown("key of " + what_ + ",", key.str(), read_));
    }

    /// Returns the line of a key's value, or of the table when the key is missing.
    int line(const char* key) const {
        const toml::node* const node = table_.get(key);
        return int((node ? *node : table_).source().begin.line);
    }
    [[noreturn]] void fail(const std::string& message) const { fail(table_, message); }
    /// Throws at a key's value, or at the table when the key is missing.
    [[noreturn]] void fail(const char* key, const std::string& message) const {
        const toml::node* const node = table_.get(key);
        fail(node ? *node : table_, message);
    }
    [[noreturn]] void fail(const toml::node& node, const std::string& message) const {
        throw Error({file_, int(node.source().begin.line)}, message);
    }

private:
    const toml::node* find(const char* key) {
        read_.emplace_back(key);
        return table_.get(key);
    }
    const toml::node& need(const char* key) {
        const toml::node* node = find(key);
        if (!node) fail(table_, fmt::format("{} must have a '{}'", what_, key));
        return *node;
    }
    template <class Type>
    Type value(const toml::node& node, const char* key, const char* wanted) const {
        auto result = node.value_exact<Type>();
        if (!result) fail(node, fmt::format("'{}' must be {}", key, wanted));
        return *std::move(result);
    }
    double number(const toml::node& node, const char* key, double low, double high) const {
        const auto result = node.is_number() ? node.value<double>() : std::nullopt;
        if (!result) fail(node, fmt::format("'{}' must be a number", key));
        if (!(*result >= low && *result <= high))
            fail(node, fmt::format("'{}' must be from {} to {}", key, plain(low), plain(high)));
        return *result;
    }

    const std::filesystem::path& file_;
    const toml::table& table_;
    std::string what_;
    std::vector<std::string> read_;
};

}  // namespace relief
