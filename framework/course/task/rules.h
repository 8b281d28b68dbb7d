// Finds the names in a task's shader that reach beyond its functions. A task is compiled as a part of the lab's
// shaders. So a macro could change the other parts, a uniform could read the lab's bindings, and a preprocessor
// condition could distinguish a probe from a picture.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "framework/core/base/source_text.h"
#include "framework/course/manifest/manifest.h"

namespace relief::check {

/// Returns whether this is a built-in function of GLSL 4.10 (chapter 8 of its specification). Leaves out the functions
/// of geometry shaders, and noise.
bool is_built_in_function(const std::string& name);

/// The lab's shaders besides its tasks.
class OtherShaders {
public:
    OtherShaders() = default;
    /// Reads the shaders in the lab's folder, the files that tasks may include, and all files that these include.
    OtherShaders(const LabEntry& lab, const Manifest& manifest);
    void add(const std::string& text);
    /// Returns whether a task's shader may include this file. `file`: the name in the #include.
    bool lend(const std::string& file) const { return lent_.contains(file); }
    bool use(const std::string& word) const { return words_.contains(word); }
    /// Returns whether these shaders call a function of this name, and none of them defines it.
    bool call(const std::string& name) const { return called_.contains(name) && !defined_.contains(name); }
    /// Returns whether the lab's C++ defines this word for some programs only, such as a probe or a method.
    bool switch_by(const std::string& word) const { return tested_.contains(word) && !macros_.contains(word); }

private:
    std::set<std::string> words_, called_, defined_, tested_, macros_, lent_ = {"common/unfinished.glsl"};
};

/// Returns why a file is no valid task shader, such as "defines 'main', which the lab's shaders use"; or empty. Because
/// of these rules, a probe and a picture run the same code. The file may include only the files that `others` lend:
/// other files may hold answers. It may define macros, but not with a name that the others use. It may not redefine a
/// built-in function that the others call, and may not join words (##). It may not use a word that distinguishes the
/// lab's programs, and may not declare uniforms, inputs or outputs.
std::string broken_rule(const std::string& task_file, const OtherShaders& others);

/// Returns the first fault_of_source() of a task file, or the first place where a C++ task reaches for the text of a
/// file: `asm`, `.incbin`, `#embed`, `__FILE__`, an #include of anything but a header's name, and spellings that hide
/// these, such as `##`. Nothing if there is none. The grader does not rely on it: what it compiles and runs with a
/// student's C++ holds no text of a C++ solution.
std::optional<SourceFault> fault_of_task(const std::string& text, const std::string& file);

}  // namespace relief::check
