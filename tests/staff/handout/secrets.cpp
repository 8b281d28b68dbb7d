#include "tests/staff/handout/secrets.h"

#include <gtest/gtest.h>

#include <bitset>
#include <cstring>
#include <memory>
#include <unordered_map>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/course/manifest/manifest.h"
#include "framework/course/task/starter.h"
#include "tests/support.h"

namespace relief::handout {

std::vector<std::string> trimmed_lines(const std::string& text) {
    std::vector<std::string> lines;
    for (const std::string& line : split(text, '\n'))
        if (const size_t begin = line.find_first_not_of(' '); begin != std::string::npos)
            lines.push_back(line.substr(begin));
    return lines;
}

namespace {

/// Searches texts of many megabytes for thousands of secrets in one pass, by the first bytes of each.
class Secrets {
public:
    /// `but`: the ending of files that may have it.
    void add(const std::string& secret, const std::string& but) {
        const size_t number = list_.size();
        list_.push_back({secret, but});
        if (secret.size() < sizeof(Key)) return short_.push_back(number);
        by_key_.emplace(key_at(secret.data()), number);
        may_begin_.set(slot_of(key_at(secret.data())));
    }
    void expect_none(const std::string& path, const std::string& text) const {
        for (const size_t number : short_)
            if (contains(text, list_[number].text)) found(path, number);
        for (size_t at = 0; at + sizeof(Key) <= text.size(); ++at) {
            const Key key = key_at(text.data() + at);
            if (!may_begin_.test(slot_of(key))) continue;
            for (auto [one, end] = by_key_.equal_range(key); one != end; ++one)
                if (text.compare(at, list_[one->second].text.size(), list_[one->second].text) == 0)
                    found(path, one->second);
        }
    }

private:
    using Key = uint64_t;
    struct Secret {
        std::string text, but;
    };
    static Key key_at(const char* bytes) {
        Key key = 0;
        std::memcpy(&key, bytes, sizeof key);
        return key;
    }
    static size_t slot_of(Key key) { return size_t(key * 0x9e3779b97f4a7c15 >> 46); }
    void found(const std::string& path, size_t number) const {
        EXPECT_TRUE(path.ends_with(list_[number].but)) << "'" << list_[number].text << "' can be read in " << path;
    }

    std::vector<Secret> list_;
    std::vector<size_t> short_;
    std::unordered_multimap<Key, size_t> by_key_;
    std::bitset<size_t{1} << 18> may_begin_;
};

}  // namespace

void expect_no_secrets(const std::map<std::string, std::string>& texts, const std::vector<std::string>& labs) {
    const auto secrets = std::make_unique<Secrets>();
    const auto nowhere = [&](const std::string& secret, const std::string& but = "no file") {
        secrets->add(secret, but);
    };
    // `relief check` names mistakes by fingerprints.json, which contains the hints and nothing else from the staff.
    size_t lines = 0, hidden = 0, mistakes = 0, variants = 0;
    for (const std::string& lab : labs) {
        const Manifest manifest = load_manifest(course_root() / "labs" / lab / "lab.toml");
        for (const TaskInfo& task : manifest.tasks)
            for (const std::string& line : check::solution_lines(read_file(course_root() / task.file), task.file))
                // Shorter lines are harmless, such as "if (x == 0) return {};". A loop of six iterations is no secret.
                if (line.size() >= 24 && !line.starts_with("for (int i = 0;")) nowhere(line), ++lines;
        for (const CheckInfo& check : manifest.checks)
            if (check.hidden) nowhere('"' + check.name + '"'), ++hidden;
        for (const ExampleInfo& example : manifest.examples)
            if (example.hidden)
                for (const std::string& call : example.calls) nowhere(call);
        for (const MistakeInfo& mistake : manifest.mistakes) nowhere(mistake.hint, "fingerprints.json"), ++mistakes;
        for (const EquivalentInfo& equivalent : manifest.equivalents) {
            nowhere(equivalent.why), ++variants;
            for (const Edit& edit : equivalent.edits)
                for (const std::string& line : trimmed_lines(edit.replace))
                    if (line.size() >= 24 && !line.starts_with("for (int ") && !contains(edit.find, line))
                        nowhere(line);
        }
    }
    for (const auto& [path, text] : texts) secrets->expect_none(path, text);
    EXPECT_GT(lines, 30u);
    EXPECT_GT(hidden, 8u);
    EXPECT_GT(mistakes, 60u);
    EXPECT_GT(variants, 54u);
}

}  // namespace relief::handout
