// Which labs this executable has. A lab enters by being in a folder of `labs` with a lab.toml; nothing else lists it.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace relief {

class Lab;

struct LabEntry {
    int number = 0;      ///< 1
    std::string name;    ///< "specular_highlights"
    std::string folder;  ///< "01_specular_highlights", below `labs` and `shaders`
    std::unique_ptr<Lab> (*make)() = nullptr;

    std::string two_digits() const { return (number < 10 ? "0" : "") + std::to_string(number); }
};

/// By number.
const std::vector<LabEntry>& registry();

/// "7", "07", "planet", "07_planet" or any part of a name that only one lab has. Throws UsageError that suggests.
const LabEntry& find_lab(std::string_view text);

/// "1-5", "1,3,10-12", "normal_map,4": the labs of every part, by number and once each; a range takes the labs that
/// there are between its ends. Throws UsageError for a part that names none.
std::vector<const LabEntry*> find_labs(const std::string& text);

/// Puts a lab into the registry; RELIEF_LAB makes one.
struct LabRegistration {
    LabRegistration(const char* folder, std::unique_ptr<Lab> (*make)());
};

// The build gives each lab's files the name of their folder.
#define RELIEF_LAB(Type)                                             \
    static const ::relief::LabRegistration registration_of_this_lab( \
        RELIEF_LAB_FOLDER, [] { return std::unique_ptr<::relief::Lab>(std::make_unique<Type>()); })

}  // namespace relief
