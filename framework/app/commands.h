// The commands of the command line, one file each. Each returns the exit code, or throws Error.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "framework/context/context.h"

namespace relief {

using ContextChoice = std::optional<ContextKind>;  ///< nothing: OSMesa, then EGL

int list_labs(bool json);

int print_info();

struct ShotArguments {
    std::string lab, output, size, time, context = "auto", camera, probe, truth, error, mistake;
    std::vector<std::string> set;
};
int take_shot(const ShotArguments& arguments);

/// The course's web site into `folder`, or below the course's build folder when it is empty; of `labs` (see
/// find_labs()) or of all. 1 when a lab is broken: the others are there.
int make_gallery(std::filesystem::path folder, const std::string& labs, ContextChoice context);

/// All labs when `lab` is empty. With `output`, what differs is written there.
int check_golden(const std::string& lab, bool update, const std::filesystem::path& output, ContextChoice context);

/// A lab's checks on the course's files as they are. 1 when one did not pass. With `open`, or a name for it, also a
/// page with the pictures, below the course's build folder unless it is named.
int check_own_work(const std::string& lab, bool json, bool open, std::filesystem::path page);

/// `labs`: see write_handout(); empty for nothing.
int make_handout(const std::string& folder, const std::string& labs);

/// A page of the known mistakes of one lab, or of all when `lab` is empty, into `folder`, or below the course's build
/// folder when it is empty. 1 when one of them has no picture.
int show_mistakes(const std::string& lab, std::filesystem::path folder, ContextChoice context);

struct GradeArguments {
    std::vector<std::string> paths, labs;
    std::string output, jobs, seconds, sample, seed, shard, merge, context = "auto", threads = "0";
    bool trust = false, fresh = false, self_test = false, resume = false, unpinned = false, gradescope = false;
};
/// 1 when the machine failed a submission, a part of the class is missing, or the self-test finds a wrong mark.
int grade_submissions(const GradeArguments& arguments);

struct BenchArguments {
    std::vector<std::string> topics, set;
    std::string output, repeats, context = "auto";
    bool quick = false, work = false, update = false;
};
/// 1 when a method failed or, with `work`, when work or error has grown.
int run_bench(const BenchArguments& arguments);
/// A line for each topic, for --help.
std::string bench_topics_text();

struct SlidesArguments {
    std::vector<std::string> decks;
    std::string output;
    bool solutions = false, pdf = true;
};
/// 1 when a figure of a deck cannot be drawn.
int make_slides(const SlidesArguments& arguments);

int make_new_lab(const std::string& name);

}  // namespace relief
