// What a task's shader reaches for beyond its functions. It is a part of the lab's shaders: a macro could change the
// rest of them, a uniform of its own could read what the lab binds, and a condition could tell a probe from a picture.
#pragma once

#include <set>
#include <string>

#include "framework/lab/manifest.h"

namespace relief {

/// The lab's shaders besides its tasks.
class OtherShaders {
public:
    OtherShaders() = default;
    /// Those in the lab's folder, what they include, and what they lend to tasks.
    OtherShaders(const LabEntry& lab, const Manifest& manifest);
    void add(const std::string& text);
    /// Whether a task's shader may include this file, which is named as it is in its #include.
    bool lend(const std::string& file) const { return lent_.contains(file); }
    bool use(const std::string& word) const { return words_.contains(word); }
    /// Whether they call a function of this name that none of them defines.
    bool call(const std::string& name) const { return called_.contains(name) && !defined_.contains(name); }
    /// Whether this word is defined for some of their programs only, by the lab's C++: a probe, a method.
    bool switch_by(const std::string& word) const { return tested_.contains(word) && !macros_.contains(word); }

private:
    std::set<std::string> words_, called_, defined_, tested_, macros_, lent_ = {"common/unfinished.glsl"};
};

/// Why a file is not a task's shader, such as "defines 'main', which the lab's shaders use"; or empty. It may include
/// what the `others` lend it alone: the rest may hold answers. It may define macros of its own, but none of a word in
/// the others, nor a function of the language that they call, nor join words (##). It may have no word that tells one
/// of the lab's programs from another, and may declare no uniforms, inputs or outputs. What a probe shows is therefore
/// what a picture is made of.
std::string reaches_beyond(const std::string& task_file, const OtherShaders& others);

}  // namespace relief
