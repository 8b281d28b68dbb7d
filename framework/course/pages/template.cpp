#include "framework/course/pages/template.h"

#include <fmt/format.h>

#include <kainjow/mustache.hpp>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/course/pages/markdown.h"

namespace relief::pages {
namespace {

using Mustache = kainjow::mustache::mustache;
using Data = kainjow::mustache::data;

Data as_data(const Value& value) {
    switch (value.kind) {
        case Value::Kind::text:
            return value.text;
        case Value::Kind::fields: {
            Data data(Data::type::object);
            for (const auto& [name, field] : value.fields) data[name] = as_data(field);
            return data;
        }
        case Value::Kind::list: {
            Data data(Data::type::list);
            for (const Value& one : value.list) data.push_back(as_data(one));
            return data;
        }
        default:
            return value.kind == Value::Kind::yes;
    }
}

/// Looks up values and templates by name. A misspelt name is an error, not an empty text.
class Names final : public kainjow::mustache::context<std::string> {
public:
    Names(const Data* values, const std::string& page) : context(values), page_(page) {}

    const Data* get(const std::string& name) const override {
        if (const Data* value = context::get(name)) return value;
        throw Error(fmt::format("the template {} has no value for {}", page_, name));
    }
    const Data* get_partial(const std::string& name) const override {
        const std::string file = name.starts_with('*') ? get(name.substr(1))->string_value() : name;
        const auto [place, is_new] = templates_.try_emplace(file);
        if (is_new) place->second = page_file(file, ".mustache");
        return &place->second;
    }

private:
    const std::string& page_;
    mutable std::map<std::string, Data> templates_;
};

}  // namespace

Value rows(List list) { return list.empty() ? Value() : Fields{{"rows", std::move(list)}}; }
Value rows(const std::vector<std::string>& texts) { return rows(List(texts.begin(), texts.end())); }

Value with_code(const std::string& text) {
    List parts;
    for (const Span& span : line_with_code(text))
        parts.push_back(Fields{{"code", span.code ? span.text : ""}, {"text", span.code ? "" : span.text}});
    return parts;
}

std::string html(const std::string& text) {
    std::string result;
    for (const char c : escaped_markup(text)) result += c == '\'' ? "&#39;" : std::string(1, c);
    return result;
}

std::string page_file(const std::string& name, const char* kind) {
    const bool is_named = name.find('/') != std::string::npos;
    std::string text = read_file(course_root() / (is_named ? "" : "framework/course/pages") / (name + kind));
    if (text.ends_with('\n')) text.pop_back();
    return text;
}

std::string render(const std::string& name, const Fields& values) {
    Mustache page(page_file(name, ".mustache"));
    page.set_custom_escape(html);
    const Data data = as_data(values);
    Names names(&data, name);
    std::ostringstream text;
    if (page.is_valid()) page.render(names, text);
    if (!page.is_valid()) throw Error(fmt::format("the template {}: {}", name, page.error_message()));
    return std::move(text).str();
}

}  // namespace relief::pages
