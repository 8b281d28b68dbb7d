// Pages as files: mustache templates beside the code that fills them. A value is text, and escaped where it is shown.
//
//     {{name}}    the value, escaped
//     {{#name}} ... {{/name}}  for each of a list; once for anything else that there is
//     {{^name}} ... {{/name}}  if there is nothing
//     {{> name}}  another template; {{> *name}}: the one that this value names
//     {{{name}}}  not escaped: only what the course itself says; tests/pages/template_test.cpp knows all of them
//
// A file's name without a folder means framework/pages, one with folders goes from the course's top folder.
#pragma once

#include <concepts>
#include <map>
#include <string>
#include <vector>

namespace relief {

class Value;
using Fields = std::map<std::string, Value>;
using List = std::vector<Value>;

/// What a template's name stands for. An empty text and an empty list are nothing, as false is.
class Value {
public:
    Value() = default;
    Value(std::same_as<bool> auto yes) : kind(yes ? Kind::yes : Kind::nothing) {}
    Value(std::string words) : kind(words.empty() ? Kind::nothing : Kind::text), text(std::move(words)) {}
    Value(const char* words) : Value(std::string(words)) {}
    template <std::integral Number>
    requires(!std::same_as<Number, bool>) Value(Number number) : Value(std::to_string(number)) {}
    Value(Fields all) : kind(Kind::fields), fields(std::move(all)) {}
    Value(List all) : kind(Kind::list), list(std::move(all)) {}

    enum class Kind { nothing, yes, text, fields, list } kind = Kind::nothing;
    std::string text;
    Fields fields;
    List list;
};

/// For what stands around a list, and not without it: {{#name}}<ul>{{#rows}}<li>{{.}}</li>{{/rows}}</ul>{{/name}}.
Value rows(List list);
Value rows(const std::vector<std::string>& texts);
/// A hint: `code` between backticks is set as code by {{#name}}{{> with_code}}{{/name}}.
Value with_code(const std::string& text);

/// A text as it may stand in a page, between tags or in a quoted attribute.
std::string html(const std::string& text);

/// The template with these values. Throws Error for a file that is not there, a template that is not well formed, and a
/// name that has no value.
std::string render(const std::string& name, const Fields& values);

/// A file of a page, without its last line's end: `kind` is ".css", ".js", ".mustache".
std::string page_file(const std::string& name, const char* kind);

}  // namespace relief
