// Pages from mustache templates: files beside the code that fills them. Values are text, and escaped when shown.
//
//     {{name}}    the value, escaped
//     {{#name}} ... {{/name}}  for each element of a list; once for any other value that is not empty
//     {{^name}} ... {{/name}}  if the value is empty
//     {{> name}}  another template; {{> *name}}: the template that the value names
//     {{{name}}}  not escaped: only for the course's own text; tests/course/pages/template_test.cpp lists all of them
//
// A file's name without a folder means framework/course/pages; one with folders is relative to the course's top folder.
#pragma once

#include <concepts>
#include <map>
#include <string>
#include <vector>

namespace relief::pages {

class Value;
using Fields = std::map<std::string, Value>;
using List = std::vector<Value>;

/// The value of a name in a template. An empty text and an empty list count as nothing, like false.
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

/// Return a value for markup around a list, which is omitted with an empty list:
/// {{#name}}<ul>{{#rows}}<li>{{.}}</li>{{/rows}}</ul>{{/name}}.
Value rows(List list);
Value rows(const std::vector<std::string>& texts);
/// Returns a hint; {{#name}}{{> with_code}}{{/name}} shows `code` between backticks as code.
Value with_code(const std::string& text);

/// Returns a text escaped for a page, between tags or in a quoted attribute.
std::string html(const std::string& text);

/// Returns the template filled with these values. Throws Error for a missing file, a malformed template, and a name
/// without a value.
std::string render(const std::string& name, const Fields& values);

/// Returns a file of a page without its final line break. `kind` is ".css", ".js" or ".mustache".
std::string page_file(const std::string& name, const char* kind);

}  // namespace relief::pages
