#include "framework/course/pages/mathml.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/course/pages/template.h"

namespace relief::pages {
namespace {

using Kind = Formula::Kind;

std::string markup_of(const Formula& part);

std::string row_of(const Formula& row) {
    std::string markup;
    for (const Formula& part : row.parts) markup += markup_of(part);
    return markup;
}

/// A prime is raised by its letter: as a superscript, it would be raised twice without a mathematical font.
bool are_primes(const Formula& scripts) {
    return !scripts.parts.empty() &&
           std::all_of(scripts.parts.begin(), scripts.parts.end(), [](const Formula& one) { return one.text == "′"; });
}

std::string scripts_of(const Formula& part) {
    if (are_primes(part.parts[2])) {
        std::string markup = part.parts[1].parts.empty()
                                 ? markup_of(part.parts[0])
                                 : scripts_of({Kind::scripts, "", {part.parts[0], part.parts[1], {}}});
        for (size_t i = 0; i < part.parts[2].parts.size(); ++i) markup += "<mo lspace=\"0\" rspace=\"0\">′</mo>";
        return "<mrow>" + markup + "</mrow>";
    }
    const std::string base = markup_of(part.parts[0]);
    const std::string low = fmt::format("<mrow>{}</mrow>", row_of(part.parts[1])),
                      high = fmt::format("<mrow>{}</mrow>", row_of(part.parts[2]));
    if (part.parts[1].parts.empty()) return fmt::format("<msup>{}{}</msup>", base, high);
    if (part.parts[2].parts.empty()) return fmt::format("<msub>{}{}</msub>", base, low);
    return fmt::format("<msubsup>{}{}{}</msubsup>", base, low, high);
}

std::string bracket_of(const Formula& part) {
    const std::string inside = row_of(part.parts[0]);
    // Without a mathematical font, a stretchy bracket grows around any content.
    const bool grows =
        part.text == "|" || inside.find("<mfrac>") != std::string::npos || inside.find("<mtable>") != std::string::npos;
    return fmt::format("<mrow><mo{0}>{1}</mo>{2}<mo{0}>{3}</mo></mrow>", grows ? "" : " stretchy=\"false\"", part.text,
                       inside, closing_of(part.text));
}

std::string matrix_of(const Formula& part) {
    std::string markup;
    for (const Formula& row : part.parts) {
        markup += "<mtr>";
        for (const Formula& cell : row.parts) markup += "<mtd>" + row_of(cell) + "</mtd>";
        markup += "</mtr>";
    }
    return "<mtable>" + markup + "</mtable>";
}

std::string markup_of(const Formula& part) {
    switch (part.kind) {
        case Kind::row:
            return "<mrow>" + row_of(part) + "</mrow>";
        case Kind::name:
            return "<mi>" + html(part.text) + "</mi>";
        case Kind::number:
            return "<mn>" + html(part.text) + "</mn>";
        case Kind::sign:
            return "<mo>" + html(part.text) + "</mo>";
        case Kind::words:
            return "<mtext>" + html(part.text) + "</mtext>";
        case Kind::gap:
            return "<mspace width=\"0.2em\"></mspace>";
        case Kind::fraction:
            return fmt::format("<mfrac>{}{}</mfrac>", markup_of(part.parts[0]), markup_of(part.parts[1]));
        case Kind::root:
            return "<msqrt>" + row_of(part.parts[0]) + "</msqrt>";
        case Kind::scripts:
            return scripts_of(part);
        case Kind::bracket:
            return bracket_of(part);
        case Kind::matrix:
            return matrix_of(part);
    }
    return {};
}

}  // namespace

std::string formula_mathml(const Formula& formula) {
    return "<math displaystyle=\"true\">" + markup_of(formula) + "</math>";
}

}  // namespace relief::pages
