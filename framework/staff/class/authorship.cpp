#include "framework/staff/class/authorship.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

#include "framework/core/base/text.h"
#include "framework/course/task/task_names.h"
#include "framework/staff/class/csv.h"
#include "framework/staff/class/progress.h"
#include "framework/staff/grade/results.h"
#include "framework/staff/grade/strangers_text.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

/// Returns the words of a person's name in each rotation, folded: "ginarossi" and "rossigina".
Names rotations_of(const std::string& name) {
    std::vector<std::string> words;
    std::istringstream text(name);
    for (std::string word; text >> word;)
        if (word = folded(word); !word.empty()) words.push_back(word);
    Names all;
    for (size_t i = 0; i < words.size(); ++i) {
        all.insert(join(words, ""));
        std::rotate(words.begin(), words.begin() + 1, words.end());
    }
    return all;
}

/// Finds students and teams by the names of files.
class Finder {
public:
    explicit Finder(const ClassFile& policy) : policy_(policy) {
        for (const Student& one : policy.students) {
            exact_.insert(one.student);
            if (!one.team.empty()) exact_.insert(one.team);
            if (!one.canvas_id.empty()) by_canvas_[one.canvas_id] = one.student;
            for (const std::string& key : rotations_of(one.name)) near_[key].insert(one.student);
            for (const std::string* word : {&one.student, &one.login, &one.email, &one.sis_id})
                if (const std::string key = folded(*word); !key.empty()) near_[key].insert(one.student);
            if (const std::string key = folded(one.team); !key.empty()) near_[key].insert(one.team);
        }
        for (const AssignedLab& lab : policy.labs)
            if (!lab.moodle.empty()) read_worksheet(lab.moodle);
    }

    bool is_exact(const std::string& name) const { return exact_.contains(name); }

    /// Returns the students and teams that a name fits. `is_copy`: only without the mark of a copy.
    Names find(const DownloadName& name, bool& is_copy) const {
        is_copy = false;
        if (is_exact(name.author)) return {name.author};
        const auto& by_number = name.from == DownloadName::From::canvas ? by_canvas_ : by_moodle_;
        if (name.from != DownloadName::From::nowhere)
            if (const auto found = by_number.find(name.number); found != by_number.end()) return {found->second};
        if (Names found = near(name.author); !found.empty()) return found;
        const check::CopyName copy = check::copy_name(name.author);
        is_copy = copy.number > 0;
        if (!is_copy) return {};
        return is_exact(copy.original) ? Names{copy.original} : near(copy.original);
    }

private:
    Names near(const std::string& word) const {
        Names found;
        for (const std::string& key : rotations_of(word))
            if (const auto entry = near_.find(key); entry != near_.end())
                found.insert(entry->second.begin(), entry->second.end());
        if (const auto entry = near_.find(folded(word)); entry != near_.end())
            found.insert(entry->second.begin(), entry->second.end());
        return found;
    }

    /// Reads the participants' numbers. A number that has two students is of another assignment, too, and counts for
    /// none.
    void read_worksheet(const fs::path& file) {
        const CsvTable sheet = read_csv(file);
        for (const CsvRow& row : sheet.rows) {
            const std::string& identifier = sheet.cell(row, "Identifier");
            const size_t space = identifier.rfind(' ');
            const std::string number = space == std::string::npos ? identifier : identifier.substr(space + 1);
            Names students;
            for (const char* column : {"Email address", "Username", "ID number", "Full name"})
                if (const std::string& value = sheet.cell(row, column); students.size() != 1 && !value.empty())
                    students = near(value);
            if (students.size() != 1 || number.empty()) continue;
            const auto [before, is_new] = by_moodle_.try_emplace(number, *students.begin());
            if (!is_new && before->second != *students.begin()) before->second.clear();
        }
        std::erase_if(by_moodle_, [](const auto& one) { return one.second.empty(); });
    }

    const ClassFile& policy_;
    Names exact_;
    std::map<std::string, std::string> by_canvas_, by_moodle_;  ///< students by numbers
    std::map<std::string, Names> near_;                         ///< students and teams by folded names
};

/// A path of the command line.
struct Path {
    fs::path path;
    DownloadName name;
    std::string owner = {};   ///< see HandIn::name
    std::string source = {};  ///< paths of one source are files of one download, and belong together
    check::CopyName copy = {};
};

Path read_path(const fs::path& path, const Finder& finder) {
    using From = DownloadName::From;
    Path one{path, {}};
    const std::string name = submission_name(path);
    std::error_code unknown;
    const bool is_folder = fs::is_directory(path, unknown);
    one.name = parse_download_name(is_folder ? name : composed(path.filename().string()));
    if (finder.is_exact(name) || one.name.from == From::nowhere || (is_folder && one.name.from == From::canvas))
        one.name = {.author = name};
    one.copy = check::copy_name(one.name.author);
    return one;
}

/// Keeps the paths that count, and remarks why. Returns false if nothing tells which ones do.
bool choose(std::vector<Path>& paths, HandIn& hand_in) {
    std::map<std::string, std::vector<Path>> sources;
    for (Path& one : paths) sources[one.source].push_back(std::move(one));
    paths.clear();
    const auto number = [](const std::vector<Path>& source) { return source.front().copy.number; };
    const auto best = std::max_element(sources.begin(), sources.end(), [&](const auto& a, const auto& b) {
        return number(a.second) < number(b.second);
    });
    std::vector<std::string> others;
    bool is_clear = true;
    for (const auto& [source, found] : sources) {
        if (&found == &best->second) continue;
        is_clear &= number(found) < number(best->second);
        others.push_back(printable(found.front().path.filename().string()));
    }
    paths = best->second;
    if (is_clear && paths.size() > 1)
        hand_in.remarks.push_back(fmt::format("{} from {} are graded together: '{}' and the others",
                                              amount_of(double(paths.size()), "upload"), best->first,
                                              printable(paths.front().path.filename().string())));
    if (is_clear && !others.empty())
        hand_in.remarks.push_back(fmt::format("'{}' counts, and not {}: its number is that of the later copy",
                                              printable(paths.front().path.filename().string()),
                                              "'" + join(others, "', '") + "'"));
    return is_clear;
}

}  // namespace

DownloadName parse_download_name(const std::string& name) {
    using From = DownloadName::From;
    static const std::regex moodle("(.*?)(?:_([0-9]+))?_assignsubmission_([a-z]+)(?:_(.*))?"),
        canvas("([^ .,-]+?)(?:_LATE)?_([0-9]+)_([0-9]{1,18})_(.+)", std::regex::icase),
        anonymous("(?:LATE_)?anon_([A-Za-z0-9]+)_([0-9]{1,18})_(.+)"),
        text("(.+?)(?:_LATE)?_([0-9]+)_(?:text|link)\\.html", std::regex::icase);
    std::smatch match;
    if (std::regex_match(name, match, moodle) && !(match[1].length() == 0 && match[2].length() == 0))
        return {.from = From::moodle,
                .author = match[1] == "Participant" && match[2].matched ? "" : match[1].str(),
                .number = match[2],
                .file = match[4],
                .is_text = match[3] != "file"};
    if (std::regex_match(name, match, anonymous))
        return {
            .from = From::canvas, .number = "anon_" + match[1].str(), .file = match[3], .upload = std::stoll(match[2])};
    if (std::regex_match(name, match, canvas))
        return {.from = From::canvas,
                .author = match[1],
                .number = match[2],
                .file = match[4],
                .upload = std::stoll(match[3])};
    if (std::regex_match(name, match, text))
        return {.from = From::canvas, .author = match[1], .number = match[2], .is_text = true};
    return {.author = name};
}

HandIns hand_ins_of(const std::vector<fs::path>& paths, const ClassFile& policy) {
    HandIns result;
    const Finder finder(policy);
    std::vector<Path> read;
    std::vector<std::string> renamed, texts;
    Names plain;  // names without a mark, to which copies belong if there is no roster
    for (const fs::path& path : paths) {
        Path one = read_path(path, finder);
        if (one.name.is_text) {
            texts.push_back(printable(path.filename().string()));
            continue;
        }
        if (one.name.from == DownloadName::From::nowhere) plain.insert(one.name.author);
        read.push_back(std::move(one));
    }
    for (Path& one : read) {
        const DownloadName& name = one.name;
        const bool is_download = name.from != DownloadName::From::nowhere;
        const std::string numbered = name.author.empty()   ? name.number
                                     : name.number.empty() ? name.author
                                                           : name.author + "_" + name.number;
        one.owner = is_download ? numbered : name.author;
        one.source = name.from == DownloadName::From::moodle   ? "Moodle"
                     : name.from == DownloadName::From::canvas ? "Canvas"
                                                               : "/" + one.path.string();
        bool is_copy = false;
        const Names found = finder.find(name, is_copy);
        if (found.size() > 1)
            result.notes.push_back(fmt::format("'{}' may be of {}: rename it", printable(one.owner),
                                               join(std::vector<std::string>(found.begin(), found.end()), " or ")));
        if (found.size() == 1) {
            if (*found.begin() != one.owner)
                renamed.push_back(
                    fmt::format("'{}' is {}", printable(one.path.filename().string()), printable(*found.begin())));
            one.owner = *found.begin();
            if (!is_copy) one.copy = {name.author, 0};
        } else if (!is_download && one.copy.number > 0 && plain.contains(one.copy.original)) {
            one.owner = one.copy.original;
        } else {
            one.copy = {one.name.author, 0};
        }
    }
    if (!texts.empty())
        result.notes.push_back(fmt::format("{} of text written in a browser {} left out: {}",
                                           amount_of(double(texts.size()), "hand-in"), texts.size() == 1 ? "is" : "are",
                                           some_of(texts)));
    if (!renamed.empty())
        result.notes.push_back(fmt::format("{} assigned to the roster by their names: {}",
                                           amount_of(double(renamed.size()), "hand-in"), some_of(renamed)));
    std::vector<std::pair<std::string, std::vector<Path>>> owners;
    std::map<std::string, size_t> places;  // by the name of the result's file, which must be unique
    for (Path& one : read) {
        const auto [place, is_new] = places.try_emplace(file_name_of(one.owner), owners.size());
        if (is_new) owners.push_back({one.owner, {}});
        owners[place->second].second.push_back(std::move(one));
    }
    std::map<std::string, std::string> teams;
    for (const Student& one : policy.students) {
        teams[one.student] = one.team;
        if (!one.team.empty()) teams[one.team] = one.team;
    }
    for (auto& [owner, own] : owners) {
        HandIn hand_in{.name = owner, .team = teams.contains(owner) ? teams[owner] : "", .parts = {}, .remarks = {}};
        std::vector<fs::path> own_paths;
        std::vector<std::string> shown;
        for (const Path& one : own) own_paths.push_back(one.path), shown.push_back(printable(one.path.string()));
        if (!choose(own, hand_in)) {
            result.doubled.push_back(
                {owner, own_paths,
                 fmt::format("{} submissions are named '{}', so none of them is graded: {}; keep one, or rename",
                             shown.size(), printable(owner), join(shown, ", "))});
            continue;
        }
        for (const Path& one : own) hand_in.parts.push_back({one.path, one.name.file, one.name.upload});
        result.all.push_back(std::move(hand_in));
    }
    return result;
}

}  // namespace relief::grade
