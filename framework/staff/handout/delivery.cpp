#include "framework/staff/handout/delivery.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/text.h"
#include "framework/staff/handout/confined_folder.h"

namespace relief::handout {
namespace {

namespace fs = std::filesystem;
using Kind = ConfinedFolder::Kind;

constexpr const char* record_name = ".relief-handout";
constexpr const char* record_head =
    "# What was handed out into this folder. A later handout renews the files that are still as listed here, and "
    "keeps\n"
    "# all others. Leave this file where it is.\n";

/// Returns a hash that distinguishes texts, but not against deliberate collisions (FNV-1a, Fowler, Noll and Vo).
std::string fingerprint(std::string_view bytes) {
    uint64_t hash = 0xcbf29ce484222325u;
    for (const char byte : bytes) hash = (hash ^ uint8_t(byte)) * 0x100000001b3u;
    return fmt::format("{:016x}", hash);
}

/// The record of delivered files. During an update a file has two fingerprints, before and after.
struct Record {
    std::string choice;
    std::map<std::string, std::set<std::string>> files;

    bool has(const std::string& path, const std::string& bytes) const {
        const auto at = files.find(path);
        return at != files.end() && at->second.contains(fingerprint(bytes));
    }
    std::string text() const {
        std::string all = record_head + ("choice " + choice + "\n");
        for (const auto& [path, fingerprints] : files)
            for (const std::string& one : fingerprints) all += one + " " + path + "\n";
        return all;
    }
};

Record parse_record(const std::string& text, const fs::path& file) {
    Record record;
    int number = 0;
    for (const std::string& line : split(text, '\n')) {
        ++number;
        const size_t space = line.find(' ');
        if (line.empty() || line.starts_with("#")) continue;
        if (line.starts_with("choice ")) {
            record.choice = line.substr(space + 1);
        } else if (space == 16 && line.size() > 17) {
            record.files[line.substr(17)].insert(line.substr(0, 16));
        } else {
            throw Error({file, number},
                        "is not a line of a handout's record: bring the file back as it was, or hand out "
                        "into a new folder");
        }
    }
    if (record.choice.empty()) throw Error({file}, "does not say which labs were handed out: bring it back as it was");
    return record;
}

std::optional<Record> read_record(const fs::path& folder) {
    std::error_code ignored;
    const fs::file_status status = fs::status(folder, ignored);
    if (status.type() == fs::file_type::not_found) return {};
    const fs::path file = folder / record_name;
    if (fs::is_directory(status)) {
        if (fs::is_regular_file(fs::symlink_status(file, ignored))) return parse_record(read_file(file), file);
        if (fs::is_empty(folder, ignored)) return {};
    }
    throw Error({folder}, "is there already, not empty and not a handout: name a new folder");
}

/// Compares the wanted files with a folder and decides on the changes. Writes nothing until carry_out().
class Plan {
public:
    Plan(const HandedFiles& files, const Record& before, const ConfinedFolder& folder)
        : before_(before), folder_(folder) {
        for (const auto& [path, file] : files) place(path, file);
        for (const auto& [path, fingerprints] : before.files)
            if (!files.contains(path) && !after.files.contains(path)) clear(path);
    }

    /// Writes in an order in which an interrupted run leaves nothing that the next run would take for the owner's work.
    void carry_out(const std::string& choice) {
        after.choice = choice;
        Record both = after;
        for (const auto& [path, fingerprints] : before_.files)
            both.files[path].insert(fingerprints.begin(), fingerprints.end());
        if (writes_.empty() && done.removed.empty() && after.text() == before_.text()) return;
        folder_.write(record_name, both.text());
        for (const auto& [path, file] : writes_) folder_.write(path, file->bytes, file->executable);
        for (const std::string& path : done.removed) folder_.remove(path);
        folder_.write(record_name, after.text());
    }

    Record after;
    Delivery done;

private:
    void place(const std::string& path, const HandedFile& file) {
        const ConfinedFolder::Found found = folder_.look(path);
        after.files[path] = {fingerprint(file.bytes)};
        if (found.kind == Kind::behind) {
            note_behind(path, found);
        } else if (found.kind == Kind::nothing) {
            writes_.emplace(path, &file);
            done.added.push_back(path);
        } else if (found.kind == Kind::file && found.bytes == file.bytes) {
            return;
        } else if (found.kind == Kind::file && before_.has(path, found.bytes)) {
            writes_.emplace(path, &file);
            done.updated.push_back(path);
        } else {
            const auto known = before_.files.find(path);
            const bool is_news = known == before_.files.end() || known->second != after.files[path];
            put_beside(path, file, is_news);
        }
    }

    static std::string beside(const std::string& path, int number) {
        return path + ".new" + (number == 1 ? "" : std::to_string(number));
    }

    /// Puts a new version beside a file that its owner has changed. An earlier version that they have not taken over
    /// yet stays where it is.
    void put_beside(const std::string& path, const HandedFile& file, bool is_news) {
        for (int i = 1;; ++i) {
            const std::string name = beside(path, i);
            const ConfinedFolder::Found found = folder_.look(name);
            const bool is_there = found.kind == Kind::file && found.bytes == file.bytes;
            const bool is_ours = is_there || (found.kind == Kind::file && before_.has(name, found.bytes));
            if (found.kind != Kind::nothing && !is_ours) {
                theirs_.insert(name);
                continue;
            }
            if (is_there || is_news) after.files[name] = {fingerprint(file.bytes)};
            if (!is_there && is_news) writes_.emplace(name, &file);
            if (is_news) done.kept.push_back({path, name});
            return;
        }
    }

    /// Handles a file that was delivered once and is no longer in the course.
    void clear(const std::string& path) {
        const ConfinedFolder::Found found = folder_.look(path);
        if (found.kind == Kind::behind)
            note_behind(path, found);
        else if (found.kind == Kind::file && before_.has(path, found.bytes))
            done.removed.push_back(path);
        else if (found.kind != Kind::nothing && !theirs_.contains(path))
            done.kept.push_back({path, ""});
    }

    /// Nothing is delivered there, so its record stays unchanged.
    void note_behind(const std::string& path, const ConfinedFolder::Found& found) {
        const auto known = before_.files.find(path);
        if (known != before_.files.end())
            after.files[path] = known->second;
        else
            after.files.erase(path);
        const std::string name = found.in_the_way.string();
        if (std::find(done.not_open.begin(), done.not_open.end(), name) == done.not_open.end())
            done.not_open.push_back(name);
    }

    const Record& before_;
    const ConfinedFolder& folder_;
    std::map<std::string, const HandedFile*> writes_;
    std::set<std::string> theirs_;  ///< once put beside a file, and changed since
};

Delivery update(const HandedFiles& files, const std::string& choice, const Record& before, const fs::path& folder) {
    const ConfinedFolder place(folder);
    Plan plan(files, before, place);
    plan.carry_out(choice);
    return plan.done;
}

}  // namespace

bool Delivery::changed_nothing() const { return added.empty() && updated.empty() && removed.empty() && kept.empty(); }

std::optional<std::string> delivered_choice(const fs::path& folder) {
    const std::optional<Record> record = read_record(folder);
    return record ? std::optional(record->choice) : std::nullopt;
}

Delivery deliver(const HandedFiles& files, const std::string& choice, const fs::path& folder) {
    if (const std::optional<Record> before = read_record(folder)) return update(files, choice, *before, folder);
    // Written beside the folder until complete: half a course must never look like a course.
    fs::path whole = fs::absolute(folder).lexically_normal();
    if (!whole.has_filename()) whole = whole.parent_path();
    const fs::path part = fs::path(whole) += ".part";
    std::error_code failure;
    fs::remove_all(part, failure);
    make_folder(part);
    const Delivery done = update(files, choice, {}, part);
    fs::rename(part, whole, failure);
    if (failure) throw Error({whole}, "cannot put the handout here: " + failure.message());
    return done;
}

}  // namespace relief::handout
