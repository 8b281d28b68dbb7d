// The bibliography (labs/sources.toml), and the citations of its entries in handouts, slides and comments.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace relief::pages {

struct Source {
    std::string key;                   ///< surname of the first author and year: "Mikkelsen 2008"
    std::vector<std::string> authors;  ///< surnames
    std::string title, in, year;
    std::string doi = {};  ///< empty if it has none, or none is known
};

/// Parses a bibliography. Throws Error with the line of an entry that is incomplete, or whose key is not its first
/// author and a year.
std::vector<Source> parse_sources(const std::string& text, const std::filesystem::path& file);
/// Reads labs/sources.toml.
std::vector<Source> load_sources();

/// Returns authors, title, place and year.
std::string source_text(const Source& source);

/// A year after one or more names: "Mikkelsen 2008", "Cohen, Olano and Manocha (1998", "Cigolle et al. 2014".
struct Citation {
    size_t begin = 0, end = 0;       ///< from the first name to the end of the year
    const Source* source = nullptr;  ///< null if no entry has this year and these names
};
/// Returns the citations of a text in order. A capitalised word that is not a name ("SIGGRAPH 1998") is a citation
/// without a source. A name in `sources` may begin with a small letter.
std::vector<Citation> citations_in(std::string_view text, std::span<const Source> sources);

/// Returns a handout in which the entries replace the keys of its list under "## Sources", whose items are "- KEY" or
/// "- KEY: why". Throws Error with the line of an unknown key.
std::string with_sources(const std::string& handout, std::span<const Source> sources,
                         const std::filesystem::path& file);

}  // namespace relief::pages
