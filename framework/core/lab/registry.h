// The labs of this executable. A folder of `labs` with a lab.toml is a lab; no other list exists.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace relief {

class Lab;

struct LabEntry {
    int number = 0;      ///< such as 1
    std::string name;    ///< such as "specular_highlights"
    std::string folder;  ///< such as "01_specular_highlights", below `labs` and `shaders`
    std::unique_ptr<Lab> (*make)() = nullptr;

    std::string two_digits() const { return (number < 10 ? "0" : "") + std::to_string(number); }
};

/// Returns all labs, by number.
const std::vector<LabEntry>& registry();

/// Finds a lab by "9", "09", "planet", "09_planet" or a beginning of words in a name, such as "plan" or "exact", if
/// only one lab has it. Throws UsageError that suggests a name.
const LabEntry& find_lab(std::string_view text);

/// Finds the labs of a list such as "1-5", "1,3,10-12" or "normal_map,4". Returns each lab once, by number. A range
/// takes the labs that exist between its ends. Throws UsageError for a part that matches no lab.
std::vector<const LabEntry*> find_labs(const std::string& text);

/// Adds a lab to the registry; RELIEF_LAB defines an object of this type.
struct LabRegistration {
    LabRegistration(const char* folder, std::unique_ptr<Lab> (*make)());
};

// The build defines RELIEF_LAB_FOLDER for the files of each lab.
#define RELIEF_LAB(Type)                                             \
    static const ::relief::LabRegistration registration_of_this_lab( \
        RELIEF_LAB_FOLDER, [] { return std::unique_ptr<::relief::Lab>(std::make_unique<Type>()); })

}  // namespace relief
