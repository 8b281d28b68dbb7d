#include "framework/staff/originality/originality.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <numeric>
#include <set>
#include <unordered_map>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/log.h"
#include "framework/core/base/parallel.h"
#include "framework/core/base/paths.h"
#include "framework/course/manifest/manifest.h"
#include "framework/course/task/starter.h"
#include "framework/staff/class/authorship.h"
#include "framework/staff/grade/overlay.h"
#include "framework/staff/grade/strangers_text.h"
#include "framework/staff/grade/submission.h"
#include "framework/staff/originality/winnowing.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;

/// A task file with more tokens is not compared. The longest solution has 3,000.
constexpr size_t most_tokens = 20'000;

/// The functions and names that the course gives in one task file.
struct GivenFile {
    std::map<std::string, std::string> task_of_function;
    GivenNames names;
    Grams grams;
    std::map<std::string, std::vector<TaskCode>> known;  ///< by task: the solution, then the variants that differ
};

bool have_equal_tokens(const TaskCode& a, const TaskCode& b) {
    return std::equal(a.tokens.begin(), a.tokens.end(), b.tokens.begin(), b.tokens.end(),
                      [](const NormalToken& one, const NormalToken& other) { return one.text == other.text; });
}

/// Returns the texts that students of the lab get beside this task file.
std::vector<std::string> texts_beside(const LabEntry& lab, const std::set<std::string>& tasks, bool shader) {
    std::vector<std::string> texts;
    const auto add_folder = [&](const fs::path& folder) {
        if (!fs::is_directory(course_root() / folder)) return;
        for (const auto& entry : fs::directory_iterator(course_root() / folder))
            if (entry.is_regular_file() && !tasks.contains((folder / entry.path().filename()).generic_string()) &&
                (shader || entry.path().extension() == ".h" || entry.path().extension() == ".cpp"))
                texts.push_back(read_file(entry.path()));
    };
    add_folder((shader ? "shaders" : "labs") / fs::path(lab.folder));
    if (shader) add_folder("shaders/common");
    return texts;
}

GivenFile given_file(const LabEntry& lab, const Manifest& manifest, const std::string& file) {
    const fs::path path = course_root() / file;
    const std::string solution = read_file(path), starter = check::starter_of(solution, path);
    GivenFile given;
    given.task_of_function = tasks_of_functions(starter);
    given.names.add(starter);
    std::set<std::string> tasks;
    for (const TaskInfo& task : manifest.tasks) tasks.insert(task.file);
    const std::vector<std::string> beside = texts_beside(lab, tasks, is_shader(file));
    // A shader may include few files. A C++ task may use all that its header declares.
    if (is_shader(file))
        for (const std::string& name : manifest.task_includes)
            given.names.add(read_file(course_root() / "shaders" / name));
    else
        for (const std::string& text : beside) given.names.add(text);
    const auto add = [&](const std::vector<NormalToken>& tokens) {
        for (const uint64_t hash : gram_hashes(tokens)) given.grams.insert(hash);
    };
    for (const std::string& text : beside) add(normal_tokens(text, given.names));
    for (const auto& [task, code] : code_by_task(starter, given.task_of_function, given.names)) add(code.tokens);

    for (auto& [task, code] : code_by_task(solution, given.task_of_function, given.names))
        given.known[task].push_back(std::move(code));
    for (const EquivalentInfo& variant : manifest.equivalents) {
        const CourseFiles files = edited(variant.edits);
        if (const auto edited_file = files.find(file); edited_file != files.end())
            for (auto& [task, code] : code_by_task(edited_file->second, given.task_of_function, given.names))
                if (std::vector<TaskCode>& known = given.known[task];
                    known.empty() || !have_equal_tokens(known.front(), code))
                    known.push_back(std::move(code));
    }
    return given;
}

/// One submission's code of one task.
struct ComparedText {
    size_t author;
    const TaskCode* code;
    std::vector<uint64_t> grams;
    Grams all;                              ///< without the starter's
    std::vector<CodeFingerprint> own = {};  ///< each hash once
    std::vector<double> weights = {};       ///< of each of `own`: see bits_of_copy()
    size_t own_tokens = 0;                  ///< number of tokens in `all`

    ComparedText(size_t whose, const TaskCode& task, const Grams& given)
        : author(whose), code(&task), grams(gram_hashes(task.tokens)) {
        size_t counted = 0;  // tokens before this one are counted
        for (size_t i = 0; i < grams.size(); ++i) {
            if (given.contains(grams[i])) continue;
            all.insert(grams[i]);
            own_tokens += i + gram_tokens - std::max(counted, i);
            counted = i + gram_tokens;
        }
        std::set<uint64_t> seen;
        for (const CodeFingerprint& one : winnow(grams, given))
            if (seen.insert(one.hash).second) own.push_back(one);
        // A change of one token changes all grams that contain it, which are 2 gram_tokens - 1 tokens long.
        for (size_t i = 0; i < own.size(); ++i) {
            const size_t gap = i + 1 < own.size() ? own[i + 1].token - own[i].token : gram_tokens;
            weights.push_back(double(std::min(gap, gram_tokens)) / double(2 * gram_tokens - 1));
        }
    }
};

/// The sum of all weights of the fingerprints that another text has.
double weight_of(const Having& having, const std::vector<double>& weights) {
    double sum = 0;
    for (size_t i = 0; i < weights.size(); ++i) sum += having[i] ? weights[i] : 0;
    return sum;
}

/// All submissions' code of one task.
class TaskComparison {
public:
    TaskComparison(std::string file, const TaskInfo& info, std::vector<ComparedText> texts,
                   const std::vector<TaskCode>& known, const Grams& given)
        : file_(std::move(file)), info_(info), texts_(std::move(texts)) {
        std::erase_if(texts_, [](const ComparedText& text) { return text.own.empty(); });
        for (size_t i = 0; i < texts_.size(); ++i)
            for (const uint64_t hash : texts_[i].all) holders_[hash].push_back(i);
        for (size_t i = 0; i < known.size(); ++i)
            for (const uint64_t hash : ComparedText(0, known[i], given).all)
                holders_[hash].push_back(texts_.size() + i);
        all_ = texts_.size() + known.size();
    }

    const TaskInfo& info() const { return info_; }
    ComparedTask summary(double alarm_bits) const {
        ComparedTask task;
        task.id = info_.id;
        task.title = info_.title;
        task.texts = texts_.size();
        task.known = all_ - texts_.size();
        if (texts_.empty()) return task;
        std::vector<const ComparedText*> sorted;
        for (const ComparedText& text : texts_) sorted.push_back(&text);
        std::nth_element(sorted.begin(), sorted.begin() + std::ptrdiff_t(sorted.size() / 2), sorted.end(),
                         [](auto* a, auto* b) { return a->own_tokens < b->own_tokens; });
        const ComparedText& median = *sorted[sorted.size() / 2];
        task.own_tokens = median.own_tokens;
        const Having whole(median.weights.size(), true), nothing(median.weights.size(), false);
        const std::vector<const Having*> others(all_ - std::min<size_t>(all_, 2), &nothing);
        task.is_too_short = bits_of_copy(median.weights, whole, others) - task_toll_bits < alarm_bits;
        return task;
    }

    /// Finds the bits of all pairs that are near each other in both directions. `usual_count` is that of the report.
    void compare(const std::vector<Author>& authors, size_t usual_count) {
        std::map<std::pair<size_t, size_t>, double> one_way;
        for (size_t a = 0; a < texts_.size(); ++a) {
            const std::vector<Having> having = having_of(a);
            std::vector<std::pair<double, size_t>> nearest;
            for (size_t c = 0; c < texts_.size(); ++c)
                if (c != a) nearest.emplace_back(-weight_of(having[c], texts_[a].weights), c);
            const size_t taken = std::min(usual_count + 1, nearest.size());
            std::partial_sort(nearest.begin(), nearest.begin() + std::ptrdiff_t(taken), nearest.end());
            for (size_t i = 0; i < taken; ++i) {
                const size_t b = nearest[i].second;
                if (authors[texts_[a].author].is_earlier && authors[texts_[b].author].is_earlier) continue;
                std::set<size_t> left_out = {a, b};
                for (size_t k = 0; k < taken && left_out.size() < 2 + usual_count; ++k)
                    left_out.insert(nearest[k].second);
                std::vector<const Having*> others;
                for (size_t c = 0; c < all_; ++c)
                    if (!left_out.contains(c)) others.push_back(&having[c]);
                one_way[{a, b}] = bits_of_copy(texts_[a].weights, having[b], others);
            }
        }
        for (const auto& [pair, bits] : one_way) {
            const auto [a, b] = pair;
            const auto back = one_way.find({b, a});
            if (a < b && back != one_way.end())
                bits_[{texts_[a].author, texts_[b].author}] = std::min(bits, back->second);
        }
    }

    /// Returns the bits of each pair. A key is two authors, the smaller first.
    const std::map<std::pair<size_t, size_t>, double>& bits() const { return bits_; }

    SharedTask shared(const std::array<size_t, 2>& authors, const std::vector<Author>& all, size_t usual_count) const {
        const ComparedText* texts[2] = {&text_of(authors[0]), &text_of(authors[1])};
        SharedTask task;
        task.task = info_.id;
        task.file = file_;
        task.bits = bits_.at({authors[0], authors[1]});
        for (const CodeFingerprint& one : texts[0]->own) {
            if (!texts[1]->all.contains(one.hash)) continue;
            ++task.shared;
            task.rare += is_rare(one.hash, usual_count);
        }
        for (const size_t side : {0, 1})
            task.sides[side] = side_of(*texts[side], *texts[1 - side], all[authors[side]].files.at(file_), usual_count);
        return task;
    }

private:
    const ComparedText& text_of(size_t author) const {
        return *std::find_if(texts_.begin(), texts_.end(), [&](const auto& text) { return text.author == author; });
    }

    bool is_rare(uint64_t hash, size_t usual_count) const { return holders_.at(hash).size() <= usual_count + 2; }

    /// Returns for each text and each known solution which fingerprints of text `a` it has.
    std::vector<Having> having_of(size_t a) const {
        const std::vector<CodeFingerprint>& own = texts_[a].own;
        std::vector<Having> having(all_, Having(own.size(), false));
        for (size_t i = 0; i < own.size(); ++i)
            for (const size_t holder : holders_.at(own[i].hash)) having[holder][i] = true;
        return having;
    }

    SharedSide side_of(const ComparedText& text, const ComparedText& other, const std::string& file,
                       size_t usual_count) const {
        SharedSide side;
        const auto found = std::count_if(text.own.begin(), text.own.end(),
                                         [&](const CodeFingerprint& one) { return other.all.contains(one.hash); });
        side.share = double(found) / double(text.own.size());
        for (const TaskCode::Piece& piece : text.code->pieces) side.pieces.emplace_back(piece.begin, piece.end);
        enum Mark { none, common, rare };
        std::vector<Mark> marks(text.code->tokens.size(), none);
        for (size_t i = 0; i < text.grams.size(); ++i)
            if (other.all.contains(text.grams[i]))
                for (size_t k = i; k < i + gram_tokens; ++k)
                    marks[k] = std::max(marks[k], is_rare(text.grams[i], usual_count) ? rare : common);
        for (size_t i = 0; i < marks.size(); ++i) {
            if (marks[i] == none) continue;
            const NormalToken& token = text.code->tokens[i];
            const bool goes_on = i > 0 && marks[i] == marks[i - 1] && !begins_piece(*text.code, token.begin);
            if (!goes_on) side.ranges.push_back({token.begin, token.end, marks[i] == rare});
            side.ranges.back().end = token.end;
        }
        for (const SharedRange& range : side.ranges) {
            const int first = line_at(file, range.begin), last = line_at(file, range.end - 1);
            if (!side.lines.empty() && first <= side.lines.back().second + 1)
                side.lines.back().second = std::max(side.lines.back().second, last);
            else
                side.lines.emplace_back(first, last);
        }
        return side;
    }

    static bool begins_piece(const TaskCode& code, size_t at) {
        return std::any_of(code.pieces.begin(), code.pieces.end(),
                           [&](const auto& piece) { return piece.begin == at; });
    }
    static int line_at(const std::string& text, size_t at) {
        return 1 + int(std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n'));
    }

    std::string file_;
    TaskInfo info_;
    std::vector<ComparedText> texts_;
    size_t all_ = 0;  ///< number of texts and known solutions
    /// The texts that have a gram; from texts_.size() on they are known solutions.
    std::unordered_map<uint64_t, std::vector<size_t>> holders_;
    std::map<std::pair<size_t, size_t>, double> bits_;
};

/// Reads submissions, and remembers the files that cannot be compared.
class AuthorReader {
public:
    AuthorReader(OriginalityReport& report, std::set<std::string> wanted)
        : report_(report), wanted_(std::move(wanted)) {}

    void read(const std::vector<fs::path>& paths, const std::string& folder, const ClassFile& policy,
              Progress& progress) {
        const HandIns hand_ins = hand_ins_of(paths, policy);
        for (const HandIn& hand_in : hand_ins.all)
            add(read_submission(hand_in.name, hand_in.parts, wanted_), folder + printable(hand_in.name), hand_in,
                folder, progress);
        // Of equal names, all are compared, since each may be of somebody else.
        for (const HandIns::Doubled& one : hand_ins.doubled)
            for (const fs::path& path : one.paths)
                add(read_submission(path, wanted_), printable(path.string()), {}, folder, progress);
    }

private:
    void add(Submission submission, const std::string& name, const HandIn& hand_in, const std::string& folder,
             Progress& progress) {
        progress.next("reading");
        Author& author = report_.authors.emplace_back();
        author.name = name;
        author.team = hand_in.team;
        author.is_earlier = !folder.empty();
        author.files = std::move(submission.files);
        author.problems = hand_in.remarks;
        if (!submission.problem.empty()) author.problems.push_back(submission.problem);
        author.problems.insert(author.problems.end(), submission.remarks.begin(), submission.remarks.end());
        for (const auto& [file, reason] : submission.refused) author.problems.push_back(file + ": " + reason);
        if (submission.problem.empty() && author.files.empty() && submission.refused.empty())
            author.problems.push_back("there is no task file in it");
    }

    OriginalityReport& report_;
    std::set<std::string> wanted_;
};

/// Returns the submissions of an earlier class: all entries of a folder but hidden ones.
std::vector<fs::path> entries_of(const fs::path& folder, const std::vector<fs::path>& this_class) {
    if (!fs::is_directory(folder))
        throw UsageError(
            fmt::format("--earlier takes a folder with the submissions of another class; there is no folder '{}'",
                        printable(folder.string())));
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(folder))
        if (!entry.path().filename().string().starts_with(".")) paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    if (paths.empty()) throw UsageError(fmt::format("there are no submissions in '{}'", printable(folder.string())));
    std::error_code unknown;
    for (const fs::path& path : paths)
        for (const fs::path& own : this_class)
            if (fs::equivalent(path, own, unknown))
                throw UsageError(fmt::format("'{}' is a submission of this class and also in --earlier: name it once",
                                             printable(own.string())));
    return paths;
}

/// Puts authors that pairs connect into clusters, in the order of the pairs.
void cluster_pairs(OriginalityReport& report) {
    std::vector<size_t> root(report.authors.size());
    std::iota(root.begin(), root.end(), size_t{0});
    const auto find = [&](size_t i) {
        while (root[i] != i) i = root[i] = root[root[i]];
        return i;
    };
    for (const SimilarPair& pair : report.pairs) root[find(pair.authors[1])] = find(pair.authors[0]);
    std::map<size_t, int> numbers;
    for (SimilarPair& pair : report.pairs) {
        int& number = numbers[find(pair.authors[0])];
        if (number == 0) {
            number = int(report.clusters.size()) + 1;
            std::vector<size_t>& cluster = report.clusters.emplace_back();
            for (size_t i = 0; i < root.size(); ++i)
                if (find(i) == find(pair.authors[0])) cluster.push_back(i);
        }
        pair.cluster = number;
    }
}

/// The class, task by task.
class ClassComparison {
public:
    explicit ClassComparison(OriginalityReport& report) : report_(report) {}

    void add_lab(const LabEntry& lab, const Manifest& manifest) {
        std::set<std::string> files;
        for (const TaskInfo& task : manifest.tasks) files.insert(task.file);
        for (const std::string& file : files) {
            const bool is_handed_in = std::any_of(report_.authors.begin(), report_.authors.end(),
                                                  [&](const Author& one) { return one.files.contains(file); });
            if (is_handed_in) add_file(lab, manifest, file);
        }
        std::stable_sort(
            tasks_.end() - std::ptrdiff_t(added_), tasks_.end(),
            [&](const TaskComparison& a, const TaskComparison& b) { return place(manifest, a) < place(manifest, b); });
        added_ = 0;
    }

    void compare() {
        const size_t earlier = size_t(std::count_if(report_.authors.begin(), report_.authors.end(),
                                                    [](const Author&one) { return one.is_earlier; })),
                     own = report_.authors.size() - earlier;
        report_.compared = own * (own - 1) / 2 + own * earlier;
        report_.usual_count = std::max<size_t>(1, report_.authors.size() / 20);
        report_.alarm_bits = std::log2(double(report_.compared) / alarm_by_chance);
        parallel_each(tasks_.size(), 0, [&](size_t i) { tasks_[i].compare(report_.authors, report_.usual_count); });
        list_pairs();
        cluster_pairs(report_);
        for (const TaskComparison& task : tasks_) report_.tasks.push_back(task.summary(report_.alarm_bits));
    }

private:
    static size_t place(const Manifest& manifest, const TaskComparison& task) {
        return size_t(&manifest.task(task.info().id) - manifest.tasks.data());
    }

    void add_file(const LabEntry& lab, const Manifest& manifest, const std::string& file) {
        const GivenFile given = given_file(lab, manifest, file);
        std::vector<std::map<std::string, TaskCode>> codes(report_.authors.size());
        parallel_each(codes.size(), 0, [&](size_t i) {
            const auto text = report_.authors[i].files.find(file);
            if (text != report_.authors[i].files.end())
                codes[i] = code_by_task(text->second, given.task_of_function, given.names);
        });
        for (size_t i = 0; i < codes.size(); ++i) {
            size_t tokens = 0;
            for (const auto& [task, code] : codes[i]) tokens += code.tokens.size();
            if (tokens <= most_tokens) continue;
            report_.authors[i].problems.push_back(fmt::format("{}: more than {} tokens", file, most_tokens));
            codes[i].clear();
        }
        codes_.push_back(std::move(codes));
        for (const TaskInfo& task : manifest.tasks) {
            if (task.file != file) continue;
            std::vector<ComparedText> texts;
            for (size_t i = 0; i < codes_.back().size(); ++i)
                if (const auto code = codes_.back()[i].find(task.id); code != codes_.back()[i].end())
                    texts.emplace_back(i, code->second, given.grams);
            const auto known = given.known.find(task.id);
            tasks_.emplace_back(file, task, std::move(texts),
                                known == given.known.end() ? std::vector<TaskCode>() : known->second, given.grams);
            ++added_;
        }
    }

    void list_pairs() {
        std::map<std::pair<size_t, size_t>, double> sums;
        for (const TaskComparison& task : tasks_)
            for (const auto& [pair, bits] : task.bits())
                if (bits > task_toll_bits) sums[pair] += bits - task_toll_bits;
        for (const auto& [pair, bits] : sums) {
            const Author &one_author = report_.authors[pair.first], &other = report_.authors[pair.second];
            if (!one_author.team.empty() && one_author.team == other.team) {
                report_.of_teams += bits >= report_.alarm_bits;
                continue;
            }
            if (bits < report_.alarm_bits) {
                report_.below_alarm_bits = std::max(report_.below_alarm_bits, bits);
                continue;
            }
            SimilarPair& one = report_.pairs.emplace_back();
            one.authors = {pair.first, pair.second};
            one.bits = bits;
            one.by_chance = double(report_.compared) * std::exp2(-bits);
            for (const TaskComparison& task : tasks_)
                if (const auto found = task.bits().find(pair);
                    found != task.bits().end() && found->second > task_toll_bits)
                    one.tasks.push_back(task.shared(one.authors, report_.authors, report_.usual_count));
            std::stable_sort(one.tasks.begin(), one.tasks.end(),
                             [](const SharedTask& a, const SharedTask& b) { return a.bits > b.bits; });
        }
        std::stable_sort(report_.pairs.begin(), report_.pairs.end(),
                         [](const SimilarPair& a, const SimilarPair& b) { return a.bits > b.bits; });
    }

    OriginalityReport& report_;
    std::deque<std::vector<std::map<std::string, TaskCode>>> codes_;  ///< by file and author; tasks_ point into it
    std::vector<TaskComparison> tasks_;
    size_t added_ = 0;  ///< tasks of the lab that is being added
};

double log2_of_sum(double a, double b) {
    const double larger = std::max(a, b);
    return std::isinf(larger) ? larger : larger + std::log2(std::exp2(a - larger) + std::exp2(b - larger));
}

}  // namespace

double bits_of_copy(const std::vector<double>& weights, const Having& b, const std::vector<const Having*>& others) {
    const size_t count = weights.size();
    // Alone, B writes like one of the others, but for this share of the fingerprints.
    constexpr double own_ideas = 0.25;
    // A fingerprint that nobody else has is still no rarer than this: rare ones depend on each other.
    constexpr double rarest = 1.0 / 16;
    const auto log_of = [&](size_t i, double chance) { return weights[i] * std::log2(b[i] ? chance : 1 - chance); };
    std::vector<double> with(count), without(count);  // if the other one has fingerprint i, and if not
    double by_shares = 0;                             // as if fingerprints did not depend on each other
    for (size_t i = 0; i < count; ++i) {
        const auto have = std::count_if(others.begin(), others.end(), [&](const Having* one) { return (*one)[i]; });
        const double share = std::max((double(have) + 0.5) / (double(others.size()) + 1), rarest);
        with[i] = log_of(i, 1 - own_ideas + own_ideas * share);
        without[i] = log_of(i, own_ideas * share);
        by_shares += log_of(i, share);
    }
    double alone = by_shares;
    for (const Having* one : others) {
        double like_this = 0;
        for (size_t i = 0; i < count; ++i) like_this += (*one)[i] ? with[i] : without[i];
        alone = log2_of_sum(alone, like_this);
    }
    alone -= std::log2(double(others.size()) + 1);
    // With A's text at hand, B has taken some share of it, each equally likely.
    double copied = -std::numeric_limits<double>::infinity();
    constexpr double taken[] = {0.1, 0.3, 0.5, 0.7, 0.9, 0.98};
    for (const double share : taken) {
        double sum = 0;
        for (size_t i = 0; i < count; ++i) sum += log_of(i, share);
        copied = log2_of_sum(copied, sum);
    }
    return copied - std::log2(double(std::size(taken))) - alone;
}

OriginalityReport compare_class(const std::vector<fs::path>& paths, const std::vector<fs::path>& earlier,
                                const std::vector<const LabEntry*>& labs, const ClassFile& policy) {
    const Stopwatch watch;
    OriginalityReport report;
    std::vector<std::pair<const LabEntry*, Manifest>> compared;
    std::set<std::string> wanted;
    for (const LabEntry& lab : registry()) {
        if (!labs.empty() && std::find(labs.begin(), labs.end(), &lab) == labs.end()) continue;
        compared.emplace_back(&lab, load_manifest(lab));
        for (const TaskInfo& task : compared.back().second.tasks) wanted.insert(task.file);
    }
    std::vector<std::vector<fs::path>> before;
    size_t count = paths.size();
    for (const fs::path& folder : earlier) count += before.emplace_back(entries_of(folder, paths)).size();
    if (count < 2) throw UsageError("--originality compares submissions: name at least two");
    {
        Progress progress{int(count)};
        AuthorReader reader(report, wanted);
        reader.read(paths, "", policy, progress);
        for (size_t i = 0; i < earlier.size(); ++i)
            reader.read(before[i], submission_name(earlier[i]) + "/", {}, progress);
    }
    ClassComparison comparison(report);
    {
        Progress progress{int(compared.size())};
        for (const auto& [lab, manifest] : compared) {
            progress.next("lab " + lab->two_digits());
            comparison.add_lab(*lab, manifest);
        }
    }
    comparison.compare();
    report.seconds = watch.milliseconds() / 1000;
    return report;
}

}  // namespace relief::grade
