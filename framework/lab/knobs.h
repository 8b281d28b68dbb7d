// A lab's adjustable values. The lab names them once; the menu, --set and --help all read them there.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace relief {

/// The visitor to which a lab shows its values, with their ranges (inclusive) and one line of help each.
class Knobs {
public:
    virtual ~Knobs() = default;
    virtual void slider(const char* name, float& value, float low, float high, const char* help) = 0;
    virtual void steps(const char* name, int& value, int low, int high, const char* help) = 0;
    virtual void toggle(const char* name, bool& value, const char* help) = 0;
    virtual void choice(const char* name, int& value, std::span<const char* const> names, const char* help) = 0;
};

/// One knob as text.
struct KnobText {
    std::string name, value, range, help;
};

class Lab;

/// All knobs of a lab, with their present values.
std::vector<KnobText> describe_knobs(Lab& lab);

/// Sets one knob from text. Throws UsageError that names the nearest knob, or the range, or the choices.
void set_knob(Lab& lab, const std::string& name, const std::string& value);

}  // namespace relief
