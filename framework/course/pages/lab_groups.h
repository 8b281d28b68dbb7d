// The sections in which the course page and the window's start page show the labs.
#pragma once

namespace relief::pages {

/// A section: the labs from number `first` up to the next section.
struct LabGroup {
    int first;
    const char *name, *title, *about;
};
inline constexpr LabGroup lab_groups[] = {
    {1, "light", "Light: normals", "What a normal map stores, where it comes from, and in which frame it is right."},
    {10, "eye", "Eye: rays in a relief", "What a view ray meets in a height map: guessed, searched, and exact."},
    {13, "shape", "Shape: triangles, and all of it together",
     "Displaced triangles, moving surfaces, whole scenes, and the cheapest method for each place."}};

}  // namespace relief::pages
