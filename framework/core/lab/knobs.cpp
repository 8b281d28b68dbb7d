#include "framework/core/lab/knobs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include "framework/core/base/error.h"
#include "framework/core/base/own_file.h"
#include "framework/core/base/text.h"
#include "framework/core/lab/lab.h"

namespace relief {
namespace {

class Describe final : public Knobs {
public:
    std::vector<KnobText> found;

    void group(const char* heading) override { group_ = heading; }
    void slider(const char* name, float& value, float low, float high, const KnobHelp& help) override {
        found.push_back({name, fmt::format("{}", value), help, group_, {}, low, high});
    }
    void steps(const char* name, int& value, int low, int high, const KnobHelp& help) override {
        found.push_back({name, fmt::format("{}", value), help, group_, {}, float(low), float(high), true});
    }
    void toggle(const char* name, bool& value, const KnobHelp& help) override {
        found.push_back({name, value ? "on" : "off", help, group_, {"off", "on"}});
    }
    void choice(const char* name, int& value, std::span<const char* const> names, const KnobHelp& help) override {
        found.push_back({name, names[size_t(value)], help, group_, {names.begin(), names.end()}});
    }
    void choice_or_file(const char* name, int& value, OwnFile& own, std::span<const char* const> names,
                        const KnobHelp& help) override {
        int named = std::min(value, int(names.size()) - 1);
        choice(name, named, names, help);
        found.back().help.text += std::string(", or ") + own.kind();
        if (value != named) found.back().value = own.file().string();
    }

private:
    std::string group_;
};

class SetOne final : public Knobs {
public:
    SetOne(const std::string& name, const std::string& text) : name_(name), text_(text) {}
    bool done = false;

    void slider(const char* name, float& value, float low, float high, const KnobHelp&) override {
        if (name != name_) return;
        const auto number = parse_number(text_);
        // Compare as floats, like the range: the double 0.1 is below 0.1f.
        if (!number || float(*number) < low || float(*number) > high) refuse(plain(low) + " to " + plain(high));
        value = float(*number);
        done = true;
    }
    void steps(const char* name, int& value, int low, int high, const KnobHelp&) override {
        if (name != name_) return;
        const auto number = parse_int(text_);
        if (!number || *number < low || *number > high) refuse(fmt::format("whole numbers from {} to {}", low, high));
        value = *number;
        done = true;
    }
    void toggle(const char* name, bool& value, const KnobHelp&) override {
        if (name != name_) return;
        const bool on = text_ == "on" || text_ == "true" || text_ == "1";
        const bool off = text_ == "off" || text_ == "false" || text_ == "0";
        if (!on && !off) refuse("on or off");
        value = on;
        done = true;
    }
    void choice(const char* name, int& value, std::span<const char* const> names, const KnobHelp&) override {
        if (name != name_) return;
        for (size_t i = 0; i < names.size(); ++i)
            if (text_ == names[i]) {
                value = int(i);
                done = true;
            }
        if (!done) throw UsageError(unknown_choice(names));
    }
    void choice_or_file(const char* name, int& value, OwnFile& own, std::span<const char* const> names,
                        const KnobHelp& help) override {
        if (name != name_) return;
        if (std::find(names.begin(), names.end(), text_) != names.end()) return choice(name, value, names, help);
        // A word without a dot or a slash is more likely a misspelt choice than a missing file.
        if (text_.find_first_of("./\\") == std::string::npos && !std::filesystem::exists(text_))
            throw UsageError(unknown_choice(names) + ", or " + own.kind());
        own.read(text_);
        value = int(names.size());
        done = true;
    }

private:
    std::string unknown_choice(std::span<const char* const> names) const {
        return unknown("value of knob " + name_ + ",", text_, std::vector<std::string>(names.begin(), names.end()));
    }
    [[noreturn]] void refuse(const std::string& takes) const {
        throw UsageError(fmt::format("knob {} takes {}, not '{}'", name_, takes, text_));
    }
    const std::string& name_;
    const std::string& text_;
};

/// Visits the knobs that accept a file.
class FileKnobs : public Knobs {
    void slider(const char*, float&, float, float, const KnobHelp&) override {}
    void steps(const char*, int&, int, int, const KnobHelp&) override {}
    void toggle(const char*, bool&, const KnobHelp&) override {}
    void choice(const char*, int&, std::span<const char* const>, const KnobHelp&) override {}
};

class FindFiles final : public FileKnobs {
public:
    std::vector<std::pair<std::string, const OwnFile*>> found;

    void choice_or_file(const char* name, int& value, OwnFile& own, std::span<const char* const> names,
                        const KnobHelp&) override {
        if (value == int(names.size())) found.emplace_back(name, &own);
    }
};

class GiveFile final : public FileKnobs {
public:
    explicit GiveFile(const std::filesystem::path& file) : file_(file) {}
    std::string knob;

    void choice_or_file(const char* name, int& value, OwnFile& own, std::span<const char* const> names,
                        const KnobHelp&) override {
        if (!knob.empty() || !own.accepts(file_)) return;
        own.read(file_);
        value = int(names.size());
        knob = name;
    }

private:
    const std::filesystem::path& file_;
};

}  // namespace

void Knobs::choice_or_file(const char* name, int& value, OwnFile& own, std::span<const char* const> names,
                           const KnobHelp& help) {
    std::vector<const char*> all(names.begin(), names.end());
    const std::string file = own.file().filename().string();
    if (!file.empty()) all.push_back(file.c_str());
    choice(name, value, all, help);
}

KnobHelp KnobsOnly::with_condition(const KnobHelp& help) const {
    return help.knob.empty() ? KnobHelp(help).only(knob_, values_) : help;
}
void KnobsOnly::slider(const char* name, float& value, float low, float high, const KnobHelp& help) {
    to_.slider(name, value, low, high, with_condition(help));
}
void KnobsOnly::steps(const char* name, int& value, int low, int high, const KnobHelp& help) {
    to_.steps(name, value, low, high, with_condition(help));
}
void KnobsOnly::toggle(const char* name, bool& value, const KnobHelp& help) {
    to_.toggle(name, value, with_condition(help));
}
void KnobsOnly::choice(const char* name, int& value, std::span<const char* const> names, const KnobHelp& help) {
    to_.choice(name, value, names, with_condition(help));
}
void KnobsOnly::choice_or_file(const char* name, int& value, OwnFile& own, std::span<const char* const> names,
                               const KnobHelp& help) {
    to_.choice_or_file(name, value, own, names, with_condition(help));
}

bool KnobText::is_toggle() const { return choices == std::vector<std::string>{"off", "on"}; }

std::string KnobText::range() const {
    if (is_toggle()) return "on, off";
    if (!is_number()) return fmt::format("{}", fmt::join(choices, ", "));
    if (is_whole) return fmt::format("{:.0f} to {:.0f}, whole", low, high);
    return plain(low) + " to " + plain(high);
}

std::vector<KnobText> describe_knobs(Lab& lab) {
    Describe describe;
    lab.knobs(describe);
    return std::move(describe.found);
}

std::string unmet_condition(const std::string& name, std::span<const KnobText> knobs) {
    const auto find = [&](const std::string& wanted) {
        return std::find_if(knobs.begin(), knobs.end(), [&](const KnobText& knob) { return knob.name == wanted; });
    };
    const auto self = find(name);
    if (self == knobs.end()) return {};
    const auto other = find(self->help.knob);
    if (other == knobs.end()) return {};
    const std::vector<std::string>& values = self->help.values;
    const bool is_met = std::find(values.begin(), values.end(), other->value) != values.end();
    return is_met ? unmet_condition(other->name, knobs) : self->help.condition();
}

std::vector<std::string> knob_values(Lab& lab) {
    std::vector<std::string> values;
    for (KnobText& knob : describe_knobs(lab)) values.push_back(std::move(knob.value));
    return values;
}

void set_knob(Lab& lab, const std::string& name, const std::string& value) {
    SetOne set(name, value);
    lab.knobs(set);
    if (set.done) return;
    std::vector<std::string> names;
    for (const KnobText& knob : describe_knobs(lab)) names.push_back(knob.name);
    throw UsageError(unknown("knob", name, names));
}

std::vector<std::pair<std::string, const OwnFile*>> files_of(Lab& lab) {
    FindFiles find;
    lab.knobs(find);
    return std::move(find.found);
}

std::vector<std::string> notes_of_files(Lab& lab) {
    const auto files = files_of(lab);
    if (files.empty()) return {};
    const std::vector<KnobText> knobs = describe_knobs(lab);
    std::vector<std::string> notes;
    for (const auto& [name, own] : files)
        if (!is_ignored(name, knobs))
            for (const std::string& note : own->notes())
                if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
    return notes;
}

std::string set_file(Lab& lab, const std::filesystem::path& file) {
    GiveFile give(file);
    lab.knobs(give);
    return give.knob;
}

}  // namespace relief
