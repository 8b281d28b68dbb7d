#include "framework/core/lab/registry.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "framework/core/base/error.h"
#include "framework/core/base/text.h"
#include "framework/core/lab/lab.h"

namespace relief {
namespace {

std::vector<LabEntry>& entries() {
    static std::vector<LabEntry> labs;
    return labs;
}

}  // namespace

const std::vector<LabEntry>& registry() { return entries(); }

LabRegistration::LabRegistration(const char* folder, std::unique_ptr<Lab> (*make)()) {
    const std::string text(folder);
    const size_t end = text.find('_');
    LabEntry entry{parse_int(text.substr(0, end)).value_or(0), text.substr(end + 1), text, make};
    const auto place = std::upper_bound(entries().begin(), entries().end(), entry,
                                        [](const LabEntry& a, const LabEntry& b) { return a.number < b.number; });
    entries().insert(place, std::move(entry));
}

const LabEntry& find_lab(std::string_view text) {
    std::vector<const LabEntry*> exact, partial;
    const auto number = parse_int(text);
    for (const LabEntry& lab : registry()) {
        if (lab.number == number || lab.name == text || lab.folder == text) exact.push_back(&lab);
        if (!text.empty() && !number && ("_" + lab.folder).find("_" + std::string(text)) != std::string::npos)
            partial.push_back(&lab);  // from the beginning of a word: "all" is not meant to be "parallax"
    }
    if (exact.size() == 1) return *exact.front();
    if (exact.empty() && partial.size() == 1) return *partial.front();

    std::vector<std::string> folders;
    const auto& candidates = exact.empty() ? partial : exact;
    for (const LabEntry* lab : candidates) folders.push_back(lab->folder);
    if (!folders.empty()) throw UsageError(fmt::format("'{}' may be any of: {}", text, join(folders, ", ")));

    // A typo resembles a name, or a word of a name. The suggestion is the whole folder.
    std::vector<std::string> words;
    std::map<std::string, std::string> folder_of;
    for (const LabEntry& lab : registry()) {
        folders.push_back(lab.folder);
        std::vector<std::string> parts = split(lab.name, '_');
        parts.insert(parts.begin(), lab.name);
        for (const std::string& part : parts)
            if (folder_of.emplace(part, lab.folder).second) words.push_back(part);
    }
    const std::vector<std::string> parts = split(std::string(text), '.');
    for (const LabEntry& lab : registry())
        if (parts.size() == 2 && parse_int(parts[0]) == lab.number && parse_int(parts[1]))
            throw UsageError(fmt::format("'{}' is a task of lab {}: say {}", text, lab.number, lab.number));
    std::string line = fmt::format("unknown lab '{}'", text);
    const auto guess = nearest(text, words);
    line += guess ? fmt::format(": did you mean '{}'? There are: ", folder_of.at(*guess)) : "; there are: ";
    throw UsageError(line + join(folders, ", "));
}

std::vector<const LabEntry*> find_labs(const std::string& text) {
    std::map<int, const LabEntry*> found;
    for (const std::string& part : split(text, ',')) {
        const std::vector<std::string> ends = split(part, '-');
        if (ends.size() != 2) {
            const LabEntry& lab = find_lab(part);
            found[lab.number] = &lab;
            continue;
        }
        const auto first = parse_int(ends[0]), last = parse_int(ends[1]);
        bool any = false;
        for (const LabEntry& lab : registry())
            if (first && last && *first <= lab.number && lab.number <= *last) {
                found[lab.number] = &lab;
                any = true;
            }
        if (!any)
            throw UsageError(
                fmt::format("'{}' contains no lab: a range is two numbers, the smaller first, like 1-5", part));
    }
    std::vector<const LabEntry*> labs;
    for (const auto& [number, lab] : found) labs.push_back(lab);
    return labs;
}

}  // namespace relief
