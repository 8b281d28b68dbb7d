#include "tests/code_shape.h"

#include <algorithm>
#include <cctype>
#include <regex>

#include "framework/core/base/code_text.h"
#include "framework/core/base/text.h"

namespace relief {

std::string shape_of(const std::string& text) {
    std::vector<std::string> words;
    for (const CodeToken& token : code_tokens(text)) {
        const bool ends_scope = words.size() > 2 && words.back() == ":" && words[words.size() - 2] == ":" &&
                                (words[words.size() - 3] == "glm" || words[words.size() - 3] == "std");
        if (ends_scope) words.resize(words.size() - 3);
        words.push_back(token.text);
    }
    std::string shape;
    for (size_t i = 0; i < words.size(); ++i) {
        const unsigned char first = static_cast<unsigned char>(words[i][0]);
        const bool kept = (i + 1 < words.size() && words[i + 1] == "(") || (i > 0 && words[i - 1] == ".");
        if ((std::isalpha(first) || first == '_') && !kept) words[i] = "@";
        if (std::isdigit(first)) words[i].erase(words[i].find_last_not_of("fu") + 1);
        shape += words[i] + ' ';
    }
    return shape;
}

std::vector<std::string> expressions_of(const std::vector<std::string>& solution) {
    static const std::regex dropped("//.*"), value("^\\s*(return\\b|[^=(<>!]*=(?!=))");
    std::string code;
    for (const std::string& line : solution) code += std::regex_replace(line, dropped, "") + '\n';
    std::replace_if(
        code.begin(), code.end(), [](char c) { return c == '{' || c == '}'; }, ';');
    std::vector<std::string> shapes;
    for (const std::string& statement : split(code, ';')) {
        const std::string shape =
            shape_of(std::regex_replace(statement, value, "", std::regex_constants::format_first_only));
        if (std::count(shape.begin(), shape.end(), ' ') >= 14) shapes.push_back(shape);
    }
    return shapes;
}

std::string code_in_markdown(const std::string& text) {
    std::string code;
    bool inside = false;
    for (const std::string& line : split(text, '\n'))
        if (line.starts_with("```"))
            inside = !inside;
        else if (inside)
            code += line + '\n';
    return code;
}

bool is_common(const std::string& shape) {
    static const std::string ramp = shape_of("clamp((end - at) / (end - begin), 0.0, 1.0)");
    return shape == ramp;
}

}  // namespace relief
