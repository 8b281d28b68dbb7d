#include "framework/lab/knobs.h"

#include <fmt/format.h>

#include <functional>

#include "framework/base/error.h"
#include "framework/base/text.h"
#include "framework/lab/lab.h"

namespace relief {
namespace {

class Describe final : public Knobs {
public:
    std::vector<KnobText> found;

    void slider(const char* name, float& value, float low, float high, const char* help) override {
        found.push_back({name, plain(value), plain(low) + " to " + plain(high), help});
    }
    void steps(const char* name, int& value, int low, int high, const char* help) override {
        found.push_back({name, plain(value), fmt::format("{} to {}, whole", low, high), help});
    }
    void toggle(const char* name, bool& value, const char* help) override {
        found.push_back({name, value ? "on" : "off", "on, off", help});
    }
    void choice(const char* name, int& value, std::span<const char* const> names, const char* help) override {
        found.push_back({name, names[size_t(value)], fmt::format("{}", fmt::join(names, ", ")), help});
    }
};

class SetOne final : public Knobs {
public:
    SetOne(const std::string& name, const std::string& text) : name_(name), text_(text) {}
    bool done = false;

    void slider(const char* name, float& value, float low, float high, const char*) override {
        if (name != name_) return;
        const auto number = parse_number(text_);
        // In float, as the range is: 0.1 as a double lies below 0.1f.
        if (!number || float(*number) < low || float(*number) > high) refuse(plain(low) + " to " + plain(high));
        value = float(*number);
        done = true;
    }
    void steps(const char* name, int& value, int low, int high, const char*) override {
        if (name != name_) return;
        const auto number = parse_int(text_);
        if (!number || *number < low || *number > high) refuse(fmt::format("whole numbers from {} to {}", low, high));
        value = *number;
        done = true;
    }
    void toggle(const char* name, bool& value, const char*) override {
        if (name != name_) return;
        const bool on = text_ == "on" || text_ == "true" || text_ == "1";
        const bool off = text_ == "off" || text_ == "false" || text_ == "0";
        if (!on && !off) refuse("on or off");
        value = on;
        done = true;
    }
    void choice(const char* name, int& value, std::span<const char* const> names, const char*) override {
        if (name != name_) return;
        for (size_t i = 0; i < names.size(); ++i)
            if (text_ == names[i]) {
                value = int(i);
                done = true;
            }
        const std::vector<std::string> known(names.begin(), names.end());
        if (!done) throw UsageError(unknown("value of knob " + name_ + ",", text_, known));
    }

private:
    [[noreturn]] void refuse(const std::string& takes) const {
        throw UsageError(fmt::format("knob {} takes {}, not '{}'", name_, takes, text_));
    }
    const std::string& name_;
    const std::string& text_;
};

}  // namespace

std::vector<KnobText> describe_knobs(Lab& lab) {
    Describe describe;
    lab.knobs(describe);
    return std::move(describe.found);
}

void set_knob(Lab& lab, const std::string& name, const std::string& value) {
    SetOne set(name, value);
    lab.knobs(set);
    if (set.done) return;
    std::vector<std::string> names;
    for (const KnobText& knob : describe_knobs(lab)) names.push_back(knob.name);
    throw UsageError(unknown("knob", name, names));
}

}  // namespace relief
