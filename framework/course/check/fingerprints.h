// Fingerprints of known mistakes: a few pixel values that each mistake draws in the checks of its task. They name a
// mistake in the grader and, for public checks, on a student's machine: `relief handout` writes them to
// labs/NN_name/expected/fingerprints.json. They do not reveal the mistake's code.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "framework/course/check/agreement.h"
#include "framework/course/check/check.h"

namespace relief::check {

struct Fingerprints {
    /// The compared values of one check.
    struct Places {
        std::vector<size_t> values;  ///< indices into the picture's values
        Sample solution;             ///< the solution's values at these indices
    };
    struct Mistake {
        std::string task;
        std::string id;  ///< empty in a student's course
        std::string hint;
        Samples draws;  ///< one for every check of its task that has places
    };
    std::map<size_t, Places> checks = {};  ///< by the check's index in the manifest
    std::vector<Mistake> mistakes = {};
};

/// Returns the file that a student's course has. In the staff's course, returns the file in the build folder that
/// `relief handout` makes.
std::filesystem::path fingerprints_file(const LabEntry& lab);
/// Returns the place of a lab's file in a student's course, relative to the course.
std::filesystem::path handed_fingerprints(const LabEntry& lab);

/// Reads a lab's fingerprints. Empty if there is no such file. Throws Error with the file if it is damaged or does not
/// fit the manifest.
Fingerprints load_fingerprints(const LabEntry& lab, const Manifest& manifest);
Fingerprints parse_fingerprints(const std::string& text, const std::filesystem::path& file, const Manifest& manifest);

/// Returns the text that load_fingerprints() reads.
std::string text_of(const Fingerprints& fingerprints, const Manifest& manifest);

/// Returns the picture's values at these indices. An empty picture gives the error instead.
Sample sample_at(const Image& drawn, const std::string& error, const std::vector<size_t>& values);

/// The known mistake that a task's pictures show.
struct Recognised {
    const Fingerprints::Mistake* mistake = nullptr;
    bool is_certain = false;  ///< see Agreement::is_certain()
};

/// Returns the known mistake that each task's pictures show, by task. Every drawn check of the task must match the
/// mistake; see is_like(). `drawn`: samples by check, without the checks that wait for other tasks.
std::map<std::string, Recognised> name_mistakes(const Fingerprints& fingerprints, const Manifest& manifest,
                                                const std::vector<Verdict>& said, const Samples& drawn,
                                                const Exactness& exactness = {});

}  // namespace relief::check
