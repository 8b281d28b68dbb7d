// A lab's adjustable values. The lab declares them once; the menu, --set and --help all read this declaration.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "framework/core/lab/knob_help.h"

namespace relief {

class OwnFile;

/// The visitor that a lab declares its values to, with inclusive ranges and a help each.
class Knobs {
public:
    virtual ~Knobs() = default;
    /// Begins a group with a heading, which contains the knobs up to the next group.
    virtual void group(const char*) {}
    virtual void slider(const char* name, float& value, float low, float high, const KnobHelp& help) = 0;
    virtual void steps(const char* name, int& value, int low, int high, const KnobHelp& help) = 0;
    virtual void toggle(const char* name, bool& value, const KnobHelp& help) = 0;
    virtual void choice(const char* name, int& value, std::span<const char* const> names, const KnobHelp& help) = 0;
    /// A choice that also accepts a file; the value is then names.size(). The default is a choice() with the file's
    /// name as one more name, if a file was read.
    virtual void choice_or_file(const char* name, int& value, OwnFile& own, std::span<const char* const> names,
                                const KnobHelp& help);
};

/// Passes knobs on, such as those of a part that only some views draw, with a condition: they have an effect only while
/// the knob `knob` has one of `values`. A knob with a condition of its own keeps that one.
class KnobsOnly final : public Knobs {
public:
    KnobsOnly(Knobs& to, const char* knob, std::vector<std::string> values)
        : to_(to), knob_(knob), values_(std::move(values)) {}

    void group(const char* heading) override { to_.group(heading); }
    void slider(const char* name, float& value, float low, float high, const KnobHelp& help) override;
    void steps(const char* name, int& value, int low, int high, const KnobHelp& help) override;
    void toggle(const char* name, bool& value, const KnobHelp& help) override;
    void choice(const char* name, int& value, std::span<const char* const> names, const KnobHelp& help) override;
    void choice_or_file(const char* name, int& value, OwnFile& own, std::span<const char* const> names,
                        const KnobHelp& help) override;

private:
    KnobHelp with_condition(const KnobHelp& help) const;

    Knobs& to_;
    const char* knob_;
    std::vector<std::string> values_;
};

/// A knob as text.
struct KnobText {
    std::string name;
    std::string value;  ///< as text, from which set_knob() restores it exactly
    KnobHelp help;
    std::string group;                 ///< the heading above it; may be empty
    std::vector<std::string> choices;  ///< the values that have names; "off" and "on" of a toggle; none of a number
    float low = 0, high = 0;           ///< the range of a number
    bool is_whole = false;             ///< it is an integer

    bool is_number() const { return choices.empty(); }
    bool is_toggle() const;
    /// Returns its values in words: "0 to 1", "1 to 8, whole", "on, off", "linear, secant".
    std::string range() const;
};

class Lab;

/// Returns all knobs of a lab with their current values.
std::vector<KnobText> describe_knobs(Lab& lab);

/// Returns the condition, such as "view = one", without which the knob `name` has no effect at the current values of
/// `knobs`, according to its help; "" if it has an effect. A knob whose condition names a knob without effect has none.
/// Conditions must not form a circle.
std::string unmet_condition(const std::string& name, std::span<const KnobText> knobs);
inline bool is_ignored(const std::string& name, std::span<const KnobText> knobs) {
    return !unmet_condition(name, knobs).empty();
}

/// Returns the current values of all knobs, in the same order.
std::vector<std::string> knob_values(Lab& lab);

/// Sets a knob from text. Throws UsageError that suggests the nearest knob, or names the range or the choices.
void set_knob(Lab& lab, const std::string& name, const std::string& value);

/// Returns the user's files that a lab's knobs have now, with the names of the knobs.
std::vector<std::pair<std::string, const OwnFile*>> files_of(Lab& lab);

/// Returns the notes of the user's files that a lab's knobs have now, each once. A knob without effect does not count.
std::vector<std::string> notes_of_files(Lab& lab);

/// Gives a file to the first knob that accepts it: an OBJ file, or a picture. Returns that knob's name, or an empty
/// string if the lab has none. Throws as OwnFile::read() does.
std::string set_file(Lab& lab, const std::filesystem::path& file);

}  // namespace relief
