// Fingerprints of known mistakes: what each mistake draws at a few pixels of the public checks of its task. By them
// everybody's `relief check` names a mistake; no edit can be read from them. The staff's `relief mistakes LAB --update`
// makes them, labs/NN_name/fingerprints.toml.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "framework/check/check.h"
#include "framework/check/likeness.h"

namespace relief {

struct Fingerprints {
    /// Of one check.
    struct Places {
        std::vector<size_t> values;  ///< which of the picture's values are compared
        Sample solution;             ///< what the solution draws there
    };
    struct Mistake {
        std::string task, hint;
        Samples draws;  ///< in every check of its task that has places
    };
    std::string made_of;  ///< a hash of the manifest's part, from which the staff sees that it is up to date
    std::map<size_t, Places> checks;  ///< by the check's place in the manifest
    std::vector<Mistake> mistakes;
};

std::filesystem::path fingerprints_file(const LabEntry& lab);

/// Empty if there is no such file. Throws Error with file and line for one that does not fit the manifest.
Fingerprints load_fingerprints(const LabEntry& lab, const Manifest& manifest);
Fingerprints parse_fingerprints(const std::string& text, const std::filesystem::path& file, const Manifest& manifest);

/// As load_fingerprints() reads it. Numbers are rounded, to a tenth of what a likeness allows.
std::string text_of(const Fingerprints& fingerprints, const LabEntry& lab, const Manifest& manifest);

/// The picture's values at these places; without a picture the error.
Sample sample_at(const Image& drawn, const std::string& error, const std::vector<size_t>& values);

/// The known mistake that each task's pictures show, by task: every check of the task that was drawn is like it (see
/// is_like()). `drawn`: what was drawn, by check, without checks that wait for other tasks.
std::map<std::string, const Fingerprints::Mistake*> name_mistakes(const Fingerprints& fingerprints,
                                                                  const Manifest& manifest,
                                                                  const std::vector<Judgement>& said,
                                                                  const Samples& drawn);

}  // namespace relief
