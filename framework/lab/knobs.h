// A lab's adjustable values. The lab names them once; the menu, --set and --help all read them there.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace relief {

class OwnPicture;

/// The visitor to which a lab shows its values, with their ranges (inclusive) and one line of help each. A help may end
/// in a unit, and begin with the other knob's values for which the knob counts: see knob_help.h.
class Knobs {
public:
    virtual ~Knobs() = default;
    /// A heading over the knobs that follow, up to the next one; where they belong to no group, none.
    virtual void group(const char*) {}
    virtual void slider(const char* name, float& value, float low, float high, const char* help) = 0;
    virtual void steps(const char* name, int& value, int low, int high, const char* help) = 0;
    virtual void toggle(const char* name, bool& value, const char* help) = 0;
    virtual void choice(const char* name, int& value, std::span<const char* const> names, const char* help) = 0;
    /// A choice that takes a file with a picture, too: the value is then names.size(). For who does not override it, a
    /// picture that was read is one more name.
    virtual void choice_or_picture(const char* name, int& value, OwnPicture& own, std::span<const char* const> names,
                                   const char* help);
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

/// Gives a file to the first knob that takes a picture, and returns that knob's name; empty where the lab has none.
/// Throws what OwnPicture::read throws.
std::string set_picture(Lab& lab, const std::filesystem::path& file);

}  // namespace relief
