#include "tests/staff/handout/secrets.h"

#include <gtest/gtest.h>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/course/check/starter.h"
#include "framework/course/manifest/manifest.h"
#include "tests/support.h"

namespace relief::handout {

std::vector<std::string> trimmed_lines(const std::string& text) {
    std::vector<std::string> lines;
    for (const std::string& line : split(text, '\n'))
        if (const size_t begin = line.find_first_not_of(' '); begin != std::string::npos)
            lines.push_back(line.substr(begin));
    return lines;
}

void expect_no_secrets(const std::map<std::string, std::string>& texts, const std::vector<std::string>& labs) {
    const auto nowhere = [&](const std::string& secret, const std::string& but = "no file") {
        for (const auto& [path, text] : texts)
            EXPECT_FALSE(!path.ends_with(but) && contains(text, secret))
                << "'" << secret << "' can be read in " << path;
    };
    // `relief check` names mistakes by fingerprints.toml, which contains the hints and nothing else from the staff.
    size_t lines = 0, hidden = 0, mistakes = 0, variants = 0;
    for (const std::string& lab : labs) {
        const Manifest manifest = load_manifest(course_root() / "labs" / lab / "lab.toml");
        for (const TaskInfo& task : manifest.tasks)
            for (const std::string& line : check::solution_lines(read_file(course_root() / task.file), task.file))
                // Shorter lines are harmless, such as "if (x == 0) return {};". A loop of six iterations is no secret.
                if (line.size() >= 24 && !line.starts_with("for (int i = 0;")) nowhere(line), ++lines;
        for (const CheckInfo& check : manifest.checks)
            if (check.hidden) nowhere('"' + check.name + '"'), ++hidden;
        for (const ExampleInfo& example : manifest.examples)
            if (example.hidden)
                for (const std::string& call : example.calls) nowhere(call);
        for (const MistakeInfo& mistake : manifest.mistakes) nowhere(mistake.hint, "fingerprints.toml"), ++mistakes;
        for (const EquivalentInfo& equivalent : manifest.equivalents) {
            nowhere(equivalent.why), ++variants;
            for (const Edit& edit : equivalent.edits)
                for (const std::string& line : trimmed_lines(edit.replace))
                    if (line.size() >= 24 && !line.starts_with("for (int ") && !contains(edit.find, line))
                        nowhere(line);
        }
    }
    EXPECT_GT(lines, 30u);
    EXPECT_GT(hidden, 8u);
    EXPECT_GT(mistakes, 60u);
    EXPECT_GT(variants, 54u);
}

}  // namespace relief::handout
