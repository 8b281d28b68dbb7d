// Fingerprints of a task's code that survive comments, layout and new names: winnowing (Schleimer, Wilkerson and Aiken,
// "Winnowing: Local Algorithms for Document Fingerprinting", 2003) over tokens in a normal form. Reads GLSL and C++.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <unordered_set>
#include <vector>

namespace relief::grade {

/// The names in the code that students were given. Their own code must use these as they are, so they are not
/// replaced. A parameter or a local variable is none of them: everybody can rename it.
class GivenNames {
public:
    void add(const std::string& text);
    bool has_function(const std::string& name) const { return functions_.contains(name); }
    bool has_field(const std::string& name) const { return fields_.contains(name); }
    bool has_global(const std::string& name) const { return globals_.contains(name); }

private:
    std::set<std::string> functions_, fields_, globals_;  ///< names before "(", after ".", and outside of functions
};

/// A token in its normal form, with the half-open range [begin, end) of the text that it stands for.
struct NormalToken {
    std::string text;
    size_t begin, end;
};

/// A task's code in a task file: the functions that the task asks for, and the student's own definitions beside them.
struct TaskCode {
    struct Piece {
        size_t begin, end;  ///< range of the text
    };
    std::vector<Piece> pieces;  ///< in the text's order
    std::vector<NormalToken> tokens;
};

/// Returns all tokens of a text in the normal form of code_by_task().
std::vector<NormalToken> normal_tokens(const std::string& text, const GivenNames& given);

/// Returns the task of each function that a starter defines, by the function's name.
std::map<std::string, std::string> tasks_of_functions(const std::string& starter);

/// Returns a file's code by task. A function of the starter belongs to its task wherever it is. Any other definition
/// belongs to the first task that uses it, or if none does to the task of the next function.
///
/// In the normal form a name that the student chose is "I", and a number is its value: "1." and "1.0f" are "1".
/// Swizzles of colours (rgba) and texture coordinates (stpq) are written xyzw. Comments, white space and preprocessor
/// lines are left out.
std::map<std::string, TaskCode> code_by_task(const std::string& text,
                                             const std::map<std::string, std::string>& task_of_function,
                                             const GivenNames& given);

/// Number of tokens in a fingerprint. A shorter match is never reported.
constexpr size_t gram_tokens = 8;
/// Number of neighbouring grams of which at least one is a fingerprint.
constexpr size_t window_grams = 4;
/// Any run of so many equal tokens is found.
constexpr size_t guaranteed_tokens = window_grams + gram_tokens - 1;

using Grams = std::unordered_set<uint64_t>;

/// Returns the hash of each run of gram_tokens tokens; empty for shorter code. Equal on all machines.
std::vector<uint64_t> gram_hashes(const std::vector<NormalToken>& tokens);

struct CodeFingerprint {
    uint64_t hash;
    size_t token;  ///< index of its first token
};
/// Returns the smallest hash of each window of window_grams hashes, the last one if it occurs twice; each place once.
/// Never takes a hash of `given`, the code that everybody has: so its neighbours are found in its place. Treats fewer
/// hashes as one window.
std::vector<CodeFingerprint> winnow(const std::vector<uint64_t>& grams, const Grams& given);

}  // namespace relief::grade
