// `relief grade` as an instructor runs it, for a class with careless and hostile submissions. On a machine without
// namespaces it grades with --trust, and omits the cases that need namespaces; the first lines of output say so.
#include <fcntl.h>
#include <sys/file.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

#include "framework/core/base/descriptor.h"
#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/core/lab/registry.h"
#include "framework/course/task/code_definitions.h"
#include "framework/course/task/starter.h"
#include "framework/staff/grade/attempt.h"
#include "framework/staff/grade/check_views.h"
#include "framework/staff/grade/sandbox.h"
#include "framework/staff/grade/stage.h"
#include "framework/staff/grade/submission.h"
#include "framework/staff/grade/transplant.h"
#include "tests/course/app/course_copy.h"
#include "tests/process.h"
#include "tests/support.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* shader = "shaders/02_normal_map_storage/task.glsl";
// Lab 01 has only shaders: grading it once takes an eighth of the time, which for lab 02 is that of a compiler.
constexpr const char* quick = "shaders/01_specular_highlights/task.glsl";
constexpr const char* cpp = "labs/05_tangent_basis/task.cpp";

bool has_namespaces() {
    static const IsolationReport isolation = [] {
        const IsolationReport report = probe_isolation();
        std::printf("isolation: %s %s\n", name_of(report.level), report.reason.c_str());
        return report;
    }();
    return isolation.level != Isolation::limits;
}

std::vector<std::string> grade(std::vector<std::string> words) {
    words.insert(words.begin(), {relief_program(), "grade"});
    if (!has_namespaces()) words.push_back("--trust");
    return words;
}

std::string course_file(const std::string& name) { return read_file(course_root() / name); }

/// Returns the solution of the C++ tasks with `lines` at the start of task 5.2's function, and `top` at file scope.
std::string cpp_that(const std::string& lines, const std::string& top = "") {
    const std::string text = replaced(course_file(cpp), "    const auto& p = triangle.position;\n",
                                      lines + "\n    const auto& p = triangle.position;\n");
    return "#include <cstdio>\n#include <cstdlib>\n#include <unistd.h>\n" + top + text;
}

json result_of(const fs::path& output, const std::string& name) {
    try {
        return json::parse(read_file(output / "results" / (name + ".json")));
    } catch (const std::exception& error) {
        ADD_FAILURE() << name << ": " << error.what();
        return {};
    }
}

/// Returns the different outcomes of a submission's checks, of one task or of all. Leaves out hidden checks that wait:
/// a picture needs all tasks of its lab, also those that the submission lacks.
std::set<std::string> outcomes(const json& result, const std::string& task = "") {
    std::set<std::string> all;
    for (const json& lab : result.value("labs", json::array()))
        for (const json& one : lab["tasks"])
            if (task.empty() || one["id"] == task)
                for (const json& check : one["checks"])
                    if (!check["hidden"] || check["outcome"] != "waiting") all.insert(check["outcome"]);
    return all;
}

std::string found(const json& result, const std::string& outcome) {
    for (const json& lab : result.value("labs", json::array()))
        for (const json& task : lab["tasks"])
            for (const json& check : task["checks"])
                if (check["outcome"] == outcome) return check["found"];
    return "nothing of that kind";
}

using Outcomes = std::set<std::string>;

TEST(Grade, AClassOfShadersGetsTheExpectedMarks) {
    const TemporaryFolder folder;
    const fs::path output = folder.path() / "out";
    const std::string solution = course_file(shader);
    const std::string odd = "o'd \"d\"\n<b>";
    // The software renderer ends a loop by itself after 65,535 iterations. So each iteration must be slow to reach the
    // limit of six seconds, which the solution needs on a busy machine.
    std::string slow;
    for (int i = 0; i < 16; ++i) slow += "x += sin(cos(sin(cos(x + float(j)))));";
    std::map<std::string, std::string> works = {
        {"good", solution},
        {odd, solution},
        {"untouched", check::starter_of(solution, shader)},
        {"truncated", replaced(solution, "(0.5 * normal + 0.5) + 0.5)", "(0.5 * normal + 0.5))")},
        {"begun",
         replaced(solution, "return floor(255.0 * (0.5 * normal + 0.5) + 0.5);", "return unfinished(normal);")},
        {"misspelt", replaced(solution, "return code / 255.0", "retrun code / 255.0")},
        {"nan", replaced(solution, "return code / 255.0 * 2.0 - 1.0;", "return sqrt(code - 1e9);")},
        // A probe has one sample a pixel, a picture has four.
        {"right-in-probes", replaced(solution, "return code / 255.0 * 2.0 - 1.0;",
                                     "return gl_SampleID > 0 ? vec3(0.0, 0.0, 1.0) : code / 255.0 * 2.0 - 1.0;")},
        {"loops", replaced(solution, "return code / 255.0 * 2.0 - 1.0;",
                           "float x = 0.0; for (int i = 0; i < 60000; ++i) for (int j = 0; j < 60000; ++j) {" + slow +
                               "} return code / 255.0 * 2.0 - 1.0 + x;")},
        {"huge", solution + std::string(10 << 20, ' ')},
        {"binary", std::string("\0\xff\xfe\x01", 4)},
    };
    std::vector<std::string> words;
    for (const auto& [name, text] : works) {
        folder.write(name + "/" + shader, text);
        words.push_back((folder.path() / name).string());
    }
    folder.write("nothing/readme.txt", "sorry");
    folder.write("flat/task.glsl", solution);
    folder.write("damaged.zip", "PK\x03\x04 no more");
    for (const char* name : {"nothing", "flat", "damaged.zip"}) words.push_back((folder.path() / name).string());
    words.insert(words.end(), {"-o", output.string(), "--seconds", "6"});
    const Result graded = run(grade(words));
    EXPECT_EQ(graded.code, 0) << graded.err;

    // Task 2.5 is in a file of its own, which nobody hands in here.
    EXPECT_EQ(outcomes(result_of(output, "good")), (Outcomes{"passed", "unfinished"}));
    EXPECT_EQ(result_of(output, "good")["points"], 11);
    EXPECT_EQ(outcomes(result_of(output, "untouched")), Outcomes{"unfinished"});
    EXPECT_EQ(result_of(output, "untouched")["points"], 0);
    const json truncated = result_of(output, "truncated");
    EXPECT_EQ(truncated["labs"][0]["tasks"][0]["mistake"], "truncated");
    EXPECT_LT(truncated["labs"][0]["tasks"][0]["points"], 3);
    EXPECT_EQ(truncated["labs"][0]["tasks"][3]["points"], 4);
    const auto at_the_rim = [](const json& result) { return result["labs"][0]["tasks"][2]["checks"][1]; };  // needs 2.1
    // Task 2.3 loses no points if 2.1 has a mistake, is unfinished, or does not compile.
    for (const char* name : {"truncated", "begun", "misspelt"}) {
        EXPECT_EQ(at_the_rim(result_of(output, name))["outcome"], "passed") << name;
        EXPECT_EQ(at_the_rim(result_of(output, name))["found"], "passed with the solution of the other tasks") << name;
    }
    EXPECT_EQ(result_of(output, "right-in-probes")["labs"][0]["tasks"][0]["points"], 2.4)
        << "only the check of the picture fails";
    EXPECT_EQ(result_of(output, "right-in-probes")["points"], 10.4);
    EXPECT_EQ(outcomes(result_of(output, "begun"), "2.2"), Outcomes{"passed"});
    EXPECT_EQ(outcomes(result_of(output, "misspelt"), "2.1"), Outcomes{"broken"});
    const auto begin = solution.begin(), spelt = begin + std::ptrdiff_t(solution.find("return code / 255.0"));
    const std::string place = "task.glsl:" + std::to_string(1 + std::count(begin, spelt, '\n'));
    EXPECT_TRUE(contains(found(result_of(output, "misspelt"), "broken"), place))
        << found(result_of(output, "misspelt"), "broken");
    EXPECT_TRUE(contains(found(result_of(output, "nan"), "broken"), "not finite")) << result_of(output, "nan").dump(1);
    EXPECT_TRUE(outcomes(result_of(output, "loops"), "2.1").contains("out_of_time"));
    EXPECT_EQ(outcomes(result_of(output, "huge")), (Outcomes{"broken", "unfinished"}));
    EXPECT_TRUE(contains(found(result_of(output, "huge"), "broken"), "larger than 1 MiB"));
    EXPECT_FALSE(outcomes(result_of(output, "binary")).contains("passed"));
    EXPECT_EQ(result_of(output, "nothing")["problem"], "there is no task file in it: only readme.txt");
    EXPECT_EQ(result_of(output, "flat")["remarks"], json::array({std::string("'task.glsl' is graded as ") + shader +
                                                                 ", since there is no file of that name and place"}));
    EXPECT_TRUE(contains(std::string(result_of(output, "damaged")["problem"]), "damaged"));

    // A submission's name is only data in every file, and becomes a plain file name.
    int odd_ones = 0;
    for (const auto& entry : fs::directory_iterator(output / "results"))
        odd_ones += json::parse(read_file(entry.path()))["name"] == odd &&
                    entry.path().filename().string().starts_with("o-d--d");
    EXPECT_EQ(odd_ones, 1);
    EXPECT_TRUE(contains(read_file(output / "results.csv"), "\"o'd \"\"d\"\"\\x0a<b>\",graded,11,"));
    EXPECT_TRUE(contains(read_file(output / "junit.xml"), "o'd &quot;d&quot;\\x0a&lt;b&gt;"));
    const std::string page = read_file(output / "report.html");
    EXPECT_TRUE(contains(page, "<bdi>o&#39;d &quot;d&quot;\\x0a&lt;b&gt;</bdi></a>"));
    EXPECT_FALSE(contains(page, "\n<b>")) << "a name has become markup";
    EXPECT_TRUE(contains(page, "<code>2.1\u00a0truncated</code>"));
    EXPECT_FALSE(contains(page, "<img")) << "the class's page must stay small";
    // Each submission has a page. It has pictures only of failed checks that drew something without the solutions:
    // three per check of 2.1. The check of its picture needs 2.5, which is missing here.
    const std::map<std::string, size_t> figures = {
        {"good", 0}, {"untouched", 0}, {"truncated", 9}, {"misspelt", 0}, {"nan", 6}};
    for (const auto& [name, count] : figures) {
        const std::string own = read_file(output / "submissions" / (name + ".html"));
        size_t found = 0;
        for (size_t at = 0; (at = own.find("src=\"data:image/png;base64,", at)) != std::string::npos; ++at) ++found;
        EXPECT_EQ(found, count) << name;
        EXPECT_TRUE(contains(page, "href=\"submissions/" + name + ".html\"")) << name;
    }
    // So do the exports, without those of hidden checks and views.
    for (const char* kind : {"prairielearn", "gradescope"}) {
        const std::string text = read_file(output / kind / "truncated.json");
        EXPECT_TRUE(contains(text, "data:image/png;base64,")) << kind;
        EXPECT_LT(text.size(), 1'000'000u);
        EXPECT_FALSE(contains(read_file(output / kind / "good.json"), "base64"));
        for (const json& test : json::parse(text)["tests"])
            EXPECT_FALSE(contains(test["name"].get<std::string>(), "hidden") && contains(test.dump(), "base64"));
    }
    const std::string truncated_page = read_file(output / "students/truncated.html");
    EXPECT_TRUE(contains(truncated_page, "You truncate"));
    EXPECT_TRUE(contains(truncated_page, "hidden check: passed"));
    EXPECT_FALSE(contains(truncated_page, "href=\"..")) << "its folder can be published as it is";
    EXPECT_FALSE(contains(truncated_page, std::string(json::parse(read_file(output / "class.json"))["seed"])));
    EXPECT_TRUE(contains(read_file(output / "students/misspelt.html"), place));
    EXPECT_EQ(size_t(std::distance(fs::directory_iterator(output / "students"), {})), works.size() + 3);
    const json scope = json::parse(read_file(output / "gradescope/good.json"));
    EXPECT_EQ(scope["score"], 11);
    bool some_hidden = false;
    for (const json& test : scope["tests"]) some_hidden |= test["visibility"] == "hidden";
    EXPECT_TRUE(some_hidden) << "a hidden check must not be shown to its student";
}

// A flip of green before task 1.2 gives the same pictures as a flipped bitangent in 1.2.
TEST(Grade, NoMistakeIsNamedForACorrectTask) {
    const TemporaryFolder folder;
    const char* const file = "shaders/01_specular_highlights/task.glsl";
    folder.write(std::string("jane/") + file, replaced(course_file(file), "vec3(direction.xy * strength,",
                                                       "vec3(direction.xy * strength * vec2(1.0, -1.0),"));
    folder.write(std::string("joe/") + file,
                 replaced(course_file(file), "+ direction.y * bitangent", "- direction.y * bitangent"));
    const fs::path output = folder.path() / "out";
    const Result graded =
        run(grade({(folder.path() / "jane").string(), (folder.path() / "joe").string(), "-o", output}));
    ASSERT_EQ(graded.code, 0) << graded.err;
    const json jane = result_of(output, "jane")["labs"][0]["tasks"], joe = result_of(output, "joe")["labs"][0]["tasks"];
    EXPECT_EQ(jane[0]["mistake"], "green-flipped");
    EXPECT_EQ(jane[1]["mistake"], "") << "1.2 is right";
    EXPECT_EQ(jane[1]["points"], jane[1]["of"]);
    EXPECT_EQ(joe[0]["points"], joe[0]["of"]);
    EXPECT_EQ(joe[1]["mistake"], "bitangent-flipped");

    // A wrong public check tells how the picture relates to the expected one. A hidden one must not: a relation has
    // numbers of the picture.
    size_t told = 0, hidden = 0;
    for (const json& tasks : {jane, joe})
        for (const json& task : tasks)
            for (const json& check : task["checks"]) {
                if (check["outcome"] != "wrong") continue;
                const bool is_told = contains(std::string(check["look_at"]), "ours is ");
                hidden += check["hidden"].get<bool>(), told += is_told;
                EXPECT_FALSE(is_told && check["hidden"].get<bool>()) << check.dump(1);
            }
    EXPECT_TRUE(contains(joe[1].dump(), "In tangent space, yours is the expected direction with y negated"))
        << joe[1].dump(1);
    EXPECT_GE(told, 2u);
    EXPECT_GE(hidden, 1u);
}

TEST(Grade, HostileProgramsAreClassifiedAndContained) {
    const TemporaryFolder folder;
    const fs::path output = folder.path() / "out";
    const fs::path secret = folder.write("secret.txt", "the answer is 42");
    const std::string forged =
        "char frame[20] = \"1RLF\"; for (int i = 0; i < 1000; ++i) fwrite(frame, 1, 20, stdout);";
    std::map<std::string, std::string> works = {
        {"good", course_file(cpp)},
        {"loops", cpp_that("for (volatile int i = 0;; i = i + 1) {}")},
        {"exits", cpp_that("std::exit(0);")},
        {"crashes", cpp_that("*(volatile int*)nullptr = 1;")},
        {"eats", cpp_that("for (;;) { volatile char* more = new char[100 << 20]; more[0] = 1; }")},
        {"prints", cpp_that("for (;;) std::puts(\"much\");")},
        {"forges", cpp_that("", "static const int before = [] { " + forged + " std::fflush(stdout); return 0; }();\n")},
        {"never-compiles", cpp_that("", "template <int n> struct A : A<n - 1>, B<n> {};\n")},
        // Before main() there is no request to read on any descriptor where one might look for it.
        {"looks-early", cpp_that("", R"(#include <poll.h>
static const int before = [] {
    char text[400] = {};
    for (const int from : {0, 97}) {
        pollfd one{from, POLLIN, 0};
        if (poll(&one, 1, 200) > 0 && read(from, text, 399) < 0) text[0] = 0;
        std::fprintf(stderr, "[%s]", text);
    }
    _exit(1);
    return 0;
}();
)")},
        // A program that asks before main() gets its request. The student must not see the request of a hidden view.
        {"asks-early", cpp_that("", R"(
static const int before = [] {
    static char text[1 << 20];
    if (write(1, "1RLF\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0", 20) < 0) _exit(2);
    ssize_t size = 0;
    for (ssize_t got = 0; (got = read(97, text + size, sizeof text - 1 - size)) > 0;) size += got;
    std::fprintf(stderr, "asked: %s", size > 190 ? text + size - 190 : "");
    _exit(1);
    return 0;
}();
)")},
        {"compiles-forever",
         cpp_that("",
                  "template <int depth, long n> struct T { T<depth - 1, 2 * n> a; T<depth - 1, 2 * n + 1> b; };\n"
                  "template <long n> struct T<0, n> {};\nT<60, 1> tree;\n")},
    };
    if (has_namespaces()) {  // without namespaces, these attacks would succeed
        works["bombs"] = cpp_that("for (;;) fork();");
        works["reads"] =
            cpp_that("std::ifstream file(\"" + secret.string() +
                         "\"); std::string text; std::getline(file, text); throw std::runtime_error(\"read \" + text "
                         "+ (socket(AF_INET, SOCK_STREAM, 0) < 0 || system(\"ls / /tmp\") < 0 ? \"\" : \".\"));",
                     "#include <sys/socket.h>\n#include <fstream>\n#include <string>\n");
        works["refers"] = cpp_that("relief::generate_tangents_of_the_course();",
                                   "namespace relief { void generate_tangents_of_the_course(); }\n");
    }
    // The compiler gets ten seconds, enough for honest code. Programs that end by themselves get time for a process a
    // picture, also on a busy machine.
    const auto grade_all = [&](const std::vector<std::string>& names, const char* seconds) {
        std::vector<std::string> words;
        for (const std::string& name : names) {
            folder.write(name + "/" + cpp, works.at(name));
            words.push_back((folder.path() / name).string());
        }
        words.insert(words.end(), {"-o", output.string(), "--seconds", seconds});
        const Result graded = run(grade(words));
        EXPECT_EQ(graded.code, 0) << graded.err;
    };
    const std::vector<std::string> short_ones = {"exits", "crashes", "eats"};
    grade_all(short_ones, "40");
    std::map<std::string, json> short_results;
    for (const std::string& name : short_ones) short_results[name] = result_of(output, name);
    fs::remove_all(output);
    std::vector<std::string> others;
    for (const auto& [name, text] : works)
        if (!short_results.contains(name)) others.push_back(name);
    grade_all(others, "4");
    const auto of = [&](const std::string& name) {
        return outcomes(short_results.contains(name) ? short_results.at(name) : result_of(output, name), "5.2");
    };
    EXPECT_EQ(of("good"), Outcomes{"passed"});
    EXPECT_EQ(of("loops"), Outcomes{"out_of_time"});
    EXPECT_EQ(of("exits"), Outcomes{"crashed"});
    EXPECT_EQ(of("crashes"), Outcomes{"crashed"});
    EXPECT_EQ(of("eats"), Outcomes{"out_of_memory"});
    EXPECT_FALSE(of("prints").contains("passed"));
    Outcomes forges = of("forges");
    forges.erase("waiting");
    EXPECT_EQ(forges, Outcomes{"broken"});
    EXPECT_EQ(found(result_of(output, "looks-early"), "crashed"),
              "the program ends in the middle, with exit code 1: [][]");
    const json asked = result_of(output, "asks-early");
    const std::string students = read_file(output / "students/asks-early.html");
    size_t public_ones = 0, hidden_ones = 0;
    for (const json& check : asked["labs"][0]["tasks"][1]["checks"]) {
        if (check["outcome"] == "waiting") continue;
        const std::string said = check["found"];
        const size_t at = said.find("\"set\":[");
        ASSERT_NE(at, std::string::npos) << said;
        const std::string knobs = said.substr(at, said.find("]]", at) - at);
        const bool is_shown = contains(students, join(split(knobs, '"'), "&quot;"));
        EXPECT_EQ(is_shown, !check["hidden"]) << said;
        ++(check["hidden"] ? hidden_ones : public_ones);
    }
    EXPECT_TRUE(public_ones > 0 && hidden_ones > 0);
    EXPECT_EQ(of("never-compiles"), Outcomes{"broken"});
    EXPECT_TRUE(contains(found(result_of(output, "never-compiles"), "broken"),
                         "does not compile: labs/05_tangent_basis/task.cpp:"))
        << found(result_of(output, "never-compiles"), "broken");
    // Checks of this task that depend on its neighbour, which is not compiled either, wait for that.
    Outcomes compiles = of("compiles-forever");
    compiles.erase("waiting");
    EXPECT_TRUE(compiles == Outcomes{"out_of_time"} || compiles == Outcomes{"out_of_memory"});
    if (!has_namespaces()) {
        std::printf("not looked at without namespaces: a fork bomb, and what a submission can read\n");
        return;
    }
    EXPECT_FALSE(of("bombs").contains("passed"));
    EXPECT_TRUE(contains(found(result_of(output, "reads"), "broken"), "it throws: read "))
        << found(result_of(output, "reads"), "broken");
    EXPECT_FALSE(contains(result_of(output, "reads").dump(), "the answer is"))
        << "a submission has read a file of ours";
    EXPECT_FALSE(of("refers").contains("passed"));
    // The submission lacks the shader, and so only the task in it.
    EXPECT_EQ(outcomes(result_of(output, "good"), "5.4"), Outcomes{"unfinished"});
}

/// Returns the lines of the lab's solutions that are long enough to be nobody else's, without those of task 5.2.
std::vector<std::string> secret_lines() {
    std::vector<std::string> lines;
    for (const char* file : {cpp, "shaders/05_tangent_basis/task.glsl"})
        for (const check::TaskPart& part : check::task_parts(course_file(file)))
            if (part.task != "5.2" && !part.task.empty())
                for (const std::string& line : check::solution_lines(part.text, file))
                    if (line.size() > 24) lines.push_back(line);
    return lines;
}

/// Returns the starter with an own function 5.2. Its `lines` may call found(), which returns the text around a line of
/// another task's solution in any file that the program can find, or nothing.
std::string cpp_that_searches(const std::string& lines) {
    std::string text = check::starter_of(course_file(cpp), cpp);
    text = replaced(text,
                    "    static_cast<void>(weight), static_cast<void>(triangle), static_cast<void>(corner);\n"
                    "    unfinished(\"5.2\");\n",
                    lines);
    return "#include <errno.h>\n#include <filesystem>\n#include <fstream>\n#include <iterator>\n#include <string>\n"
           "#include \"task.h\"\n"
           "static std::string found() {\n"
           "    namespace fs = std::filesystem;\n"
           "    const std::string secret = std::string(\"const glm::dvec3 across\") + \" = sum\";\n"
           "    for (const fs::path root : {fs::path(program_invocation_name).parent_path(), fs::path(\"/tmp\"),\n"
           "                                fs::path(\"/proc/self\"), fs::path(\".\")}) {\n"
           "        std::error_code ignored;\n"
           "        for (fs::recursive_directory_iterator at(root, fs::directory_options::skip_permission_denied, "
           "ignored);\n"
           "             at != fs::recursive_directory_iterator(); at.increment(ignored)) {\n"
           "            if (!at->is_regular_file(ignored) || at->file_size(ignored) > 9999999) continue;\n"
           "            std::ifstream file(at->path(), std::ios::binary);\n"
           "            const std::string text{std::istreambuf_iterator<char>(file), {}};\n"
           "            if (const size_t place = text.find(secret); place != text.npos) return text.substr(place, "
           "99);\n"
           "        }\n"
           "    }\n"
           "    return {};\n"
           "}\n" +
           text;
}

// A student's C++ is linked with the solutions of other tasks, and can show whatever its process and its compiler read.
TEST(Grade, NoTextOfASolutionReachesAStudent) {
    const LabEntry& lab = find_lab("05");
    const std::string solution = course_file(cpp);
    std::string weight = solution.substr(solution.find("    const auto& p = triangle.position;"));
    weight.resize(weight.find("    //]starter"));
    const std::map<std::string, std::string> works = {
        // Right as soon as it finds a solution, so that a mark tells it.
        {"searches", cpp_that_searches("    static const bool is_found = !found().empty();\n"
                                       "    if (!is_found) return 0.5 + corner;\n" +
                                       weight)},
        {"throws", cpp_that_searches("    throw std::runtime_error(\"found \" + found());\n")},
        {"embeds", cpp_that_searches("    asm(\".incbin \\\"\" __FILE__ \"\\\"\");\n    return 1 + corner;\n")}};
    {
        Stage stage(has_namespaces() ? Isolation::namespaces : Isolation::limits);
        stage.add(lab);
        const Manifest manifest = load_manifest(lab);
        const auto text = with_one_task("", works.at("searches"), manifest.tasks, manifest.task("5.2"));
        StagedCourse course = stage.course(lab, {{cpp, text.value_or("")}}, "5.2");
        EXPECT_EQ(stage.compile(lab, course, 60, 60).message, "") << "the other tasks come from their objects";
        size_t files = 0;
        for (const fs::path& folder : course.readable)
            for (const auto& entry : fs::recursive_directory_iterator(folder)) {
                if (!entry.is_regular_file() || entry.path().extension() == ".gch") continue;
                const std::string content = read_file(entry.path());
                ++files;
                for (const std::string& line : secret_lines())
                    EXPECT_FALSE(contains(content, line)) << entry.path() << ": " << line;
            }
        EXPECT_GT(files, 100u);
    }
    if (!has_namespaces()) {
        std::printf("not looked at without namespaces: what a submission can read\n");
        return;
    }
    const TemporaryFolder folder;
    const fs::path output = folder.path() / "out";
    std::vector<std::string> words;
    for (const auto& [name, text] : works) {
        folder.write(name + "/" + cpp, text);
        words.push_back((folder.path() / name).string());
    }
    words.insert(words.end(), {"-o", output.string()});
    const Result graded = run(grade(words));
    ASSERT_EQ(graded.code, 0) << graded.err;
    const json searches = result_of(output, "searches");
    EXPECT_EQ(searches["points"], 0) << searches.dump(1);
    size_t drawn = 0;
    for (const json& check : searches["labs"][0]["tasks"][1]["checks"])
        drawn += check["found"] == "wrong with the solution of the other tasks, too";
    EXPECT_GE(drawn, 4u) << searches["labs"][0]["tasks"][1].dump(1);
    const std::string page = read_file(output / "students/searches.html");
    EXPECT_TRUE(contains(page, "wrong with the solution of the other tasks, too"));
    EXPECT_FALSE(contains(page, "data:image")) << "its own drawing has no picture";
    EXPECT_TRUE(contains(read_file(output / "students/embeds.html"), "has &#39;asm&#39;, which can read files"));
    EXPECT_FALSE(outcomes(result_of(output, "throws"), "5.2").contains("passed"));
    for (const auto& entry : fs::recursive_directory_iterator(output)) {
        if (!entry.is_regular_file()) continue;
        const std::string content = read_file(entry.path());
        for (const std::string& line : secret_lines()) {
            EXPECT_FALSE(contains(content, line)) << entry.path() << ": " << line;
            EXPECT_FALSE(contains(content, join(split(line, '&'), "&amp;"))) << entry.path() << ": " << line;
        }
    }
}

// So a student's C++ among solutions needs no text of a shader's solution, unless its check depends on one.
TEST(Grade, ChecksOfCppTasksNeedNoShaderOfATaskThatTheyDoNotName) {
    if (!tests_all()) GTEST_SKIP() << "uses 30 seconds of processor time: ./relief test --all";
    for (const char* number : {"02", "05", "08", "09", "15"}) {
        const LabEntry& lab = find_lab(number);
        Stage stage(has_namespaces() ? Isolation::namespaces : Isolation::limits);
        stage.add(lab);
        const LabViews views(lab, stage, {.isolation = stage.isolation(), .seed = "x"});
        const Manifest& manifest = views.manifest();
        const auto is_in_shader = [&](const std::string& task) { return is_shader(manifest.task(task).file); };
        std::vector<bool> wanted;
        for (const CheckInfo& check : manifest.checks)
            wanted.push_back(!is_in_shader(check.task) &&
                             std::none_of(check.needs.begin(), check.needs.end(), is_in_shader) &&
                             std::none_of(check.leans_on.begin(), check.leans_on.end(), is_in_shader));
        CourseFiles files = solution_files(manifest);
        std::erase_if(files, [](const auto& file) { return is_shader(file.first); });
        const DrawnChecks drawn = views.draw(files, wanted, WhichViews::both);
        for (size_t i = 0; i < wanted.size(); ++i) {
            if (!wanted[i]) continue;
            EXPECT_EQ(views.judge(views.own(i, drawn)).outcome, check::Outcome::passed) << manifest.checks[i].name;
            if (!views.has_hidden(i)) continue;
            EXPECT_EQ(views.judge(views.hidden(i, drawn)).outcome, check::Outcome::passed) << manifest.checks[i].name;
        }
        EXPECT_TRUE(std::find(wanted.begin(), wanted.end(), true) != wanted.end()) << number;
    }
}

// Otherwise the grader would wait for each such submission twice.
TEST(Grade, AProgramThatStallsBeforeItsFirstRequestIsNotRestarted) {
    const LabEntry& lab = find_lab("05");
    Stage stage(has_namespaces() ? Isolation::namespaces : Isolation::limits);
    stage.add(lab);
    const Manifest manifest = load_manifest(lab);
    CourseFiles files = solution_files(manifest);
    files[cpp] =
        cpp_that("", "static const int before = [] { for (volatile int i = 0;; i = i + 1) {} return 0; }();\n");
    const std::vector<Shot> shots(2, manifest.checks.front().shot);
    const Attempt stalled = attempt(stage, lab, files, shots, {}, {.cpu = 2}, 1);
    for (const DrawnAttempt& shot : stalled.shots) EXPECT_EQ(shot.outcome, check::Outcome::out_of_time) << shot.error;
    EXPECT_EQ(stalled.shots[1].error, "not drawn, since a check before it is out of time: " + stalled.shots[0].error);
}

/// Draws all own views of a lab, and keeps the compiled shaders. Draws twice, and each view twice in turn, because Mesa
/// writes its cache in the background, and may not have written the last ones.
Attempt draw_own(const Stage& stage, const LabEntry& lab, const CourseFiles& files,
                 const check::CompiledShaders& known = {}) {
    std::vector<Shot> shots;
    for (int round = 0; round < 2; ++round)
        for (const CheckInfo& check : load_manifest(lab).checks) shots.push_back(check.shot);
    Attempt drawn = attempt(stage, lab, files, shots, {}, {}, size_t(-1), known, true);
    drawn.compiled.merge(attempt(stage, lab, files, shots, {}, {}, size_t(-1), known, true).compiled);
    return drawn;
}

/// Returns how many names two sets of compiled shaders share.
size_t common_names(const check::CompiledShaders& one, const check::CompiledShaders& other) {
    return size_t(
        std::count_if(one.begin(), one.end(), [&](const auto& entry) { return other.contains(entry.first); }));
}

// Otherwise a class takes longer, or a submission could read the code of another.
TEST(Grade, ASubmissionCompilesNoShaderAgainThatIsEverybodysAndSeesNoneOfAnothers) {
    if (!has_namespaces()) GTEST_SKIP() << "without namespaces no shader is cached";
    const LabEntry& lab = find_lab("05");  // a program of C++ tasks can be drawn from this process
    Stage stage(Isolation::namespaces);
    stage.add(lab);
    LabViews views(lab, stage, {.isolation = Isolation::namespaces});
    views.reuse_shaders();
    const check::CompiledShaders& known = views.reused_shaders();
    // Programs that use no function of a task are everybody's.
    const auto submission = [&](const char* more) {
        CourseFiles files = solution_files(load_manifest(lab));
        for (auto& [file, text] : files)
            for (size_t at = 0; (at = text.find(") {\n", at)) != std::string::npos; at += 4) text.insert(at + 4, more);
        return files;
    };
    const Attempt alone = draw_own(stage, lab, submission("float two = 2.0;\n")),
                  first = draw_own(stage, lab, submission("float one = 1.0;\n"), known),
                  second = draw_own(stage, lab, submission("float two = 2.0; // as another\n"), known);
    EXPECT_GE(known.size(), 10u);
    EXPECT_EQ(common_names(known, alone.compiled), known.size()) << "it would have compiled them";
    EXPECT_LT(common_names(first.compiled, alone.compiled), first.compiled.size()) << "the first has text of its own";
    EXPECT_EQ(common_names(second.compiled, alone.compiled), second.compiled.size())
        << "it has another's shaders, or compiles a comment";
    for (size_t i = 0; i < alone.shots.size(); ++i) {
        ASSERT_TRUE(alone.shots[i].image && second.shots[i].image) << alone.shots[i].error << second.shots[i].error;
        EXPECT_EQ(alone.shots[i].image->values, second.shots[i].image->values) << i;
    }
}

TEST(Grade, AProgramOfStartersAndSolutionsIsCompiledOnceARun) {
    const LabEntry& lab = find_lab("05");
    Stage stage(has_namespaces() ? Isolation::namespaces : Isolation::limits);
    stage.add(lab);
    const auto seconds = [&](const CourseFiles& files) {
        StagedCourse course = stage.course(lab, files);
        const Compiled compiled = stage.compile(lab, course, 60, 60);
        EXPECT_EQ(compiled.message, "");
        EXPECT_TRUE(fs::exists(course.folder->path() / "program"));
        return compiled.seconds;
    };
    CourseFiles files = solution_files(load_manifest(lab));
    EXPECT_GT(seconds(files), 0);
    EXPECT_EQ(seconds(files), 0);
    EXPECT_GT(seconds({}), 0) << "the starters";
    files.at(cpp) += "// a student's\n";
    EXPECT_GT(seconds(files), 0);
    EXPECT_GT(seconds(files), 0);
}

// A C++ task could read them.
TEST(Grade, ACppTaskGetsOnlyShadersThatTheStarterCompilesToo) {
    if (!has_namespaces()) GTEST_SKIP() << "without namespaces no shader is cached";
    const LabEntry& lab = find_lab("05");
    Stage stage(Isolation::namespaces);
    stage.add(lab);
    LabViews views(lab, stage, {.isolation = Isolation::namespaces});
    views.reuse_shaders();
    CourseFiles starter = solution_files(load_manifest(lab));
    std::erase_if(starter, [](const auto& file) { return is_shader(file.first); });
    EXPECT_FALSE(views.reused_shaders().empty());
    EXPECT_EQ(common_names(views.reused_shaders(), draw_own(stage, lab, starter).compiled),
              views.reused_shaders().size());
}

// Otherwise a submission could compute for longer on a busy machine than on an idle one.
TEST(Grade, ProcessorTimeIsLimitedByTheSolutionsTimeOnTheFirstMachine) {
    if (!tests_all()) GTEST_SKIP() << "uses a minute of processor time: ./relief test --all";
    const TemporaryFolder folder;
    const fs::path output = folder.path() / "out";
    folder.write(std::string("slow/") + cpp, course_file(cpp));
    const std::vector<std::string> words = {(folder.path() / "slow").string(), "-o", output.string(), "--seed", "x"};
    EXPECT_EQ(run(grade(words)).code, 0);
    json roster = json::parse(read_file(output / "class.json"));
    json& figure = roster["solution_cpu_seconds"]["05_tangent_basis"];
    EXPECT_GT(figure.get<double>(), 0);
    // Uses 11 seconds of processor time, on any machine. The lowest limit is 10.
    folder.write(std::string("slow/") + cpp,
                 cpp_that("for (timespec used{}; used.tv_sec < 11;) clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);",
                          "#include <time.h>\n"));
    const auto with = [&](double seconds, const std::vector<std::string>& how) {
        figure = seconds;
        write_file(output / "class.json", roster.dump());
        const Result graded = run(grade(how));
        EXPECT_EQ(graded.code, 0) << graded.err;
        EXPECT_EQ(json::parse(read_file(output / "class.json"))["solution_cpu_seconds"],
                  roster["solution_cpu_seconds"]);
        return result_of(output, "slow");
    };
    const json on_a_fast_machine = with(1, words);
    EXPECT_EQ(outcomes(on_a_fast_machine, "5.2"), Outcomes{"out_of_time"});
    EXPECT_TRUE(contains(on_a_fast_machine.dump(), "it needs more processor time than is allowed"))
        << on_a_fast_machine.dump(1);
    // A slower machine's measurement holds in every part of the class.
    fs::remove(output / "results/slow.json");
    EXPECT_EQ(outcomes(with(4, {"--resume", "--shard", "1/2", "-o", output.string()}), "5.2"), Outcomes{"passed"});
}

TEST(Grade, ResumesAfterBeingKilled) {
    const TemporaryFolder folder;
    const fs::path output = folder.path() / "out";
    std::vector<std::string> words;
    constexpr int count = 5;
    for (int i = 0; i < count; ++i) {
        const std::string name = "s" + std::to_string(i);
        folder.write(name + "/" + quick, course_file(quick) + "// " + name + "\n");
        words.push_back((folder.path() / name).string());
    }
    words.insert(words.end(), {"-o", output.string(), "--jobs", "1"});
    const auto results = [&] {
        std::vector<fs::path> files;
        std::error_code ignored;
        for (const auto& entry : fs::directory_iterator(output / "results", ignored))
            if (entry.path().extension() == ".json") files.push_back(entry.path());
        return files;
    };
    {
        Process first(grade(words));
        for (int i = 0; i < 6000 && results().empty() && first.running(); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        first.signal(SIGKILL);
        first.wait();
    }
    const std::vector<fs::path> before = results();
    ASSERT_GE(before.size(), 1u);
    ASSERT_LT(before.size(), size_t(count)) << "it was too fast to be killed";
    const auto page_of = [&](const fs::path& result) {
        return output / "students" / result.filename().replace_extension(".html");
    };
    for (const fs::path& result : before) EXPECT_TRUE(fs::exists(page_of(result))) << "a result without its page";
    const std::string kept = read_file(before[0]);
    const auto written = fs::last_write_time(before[0]), page_written = fs::last_write_time(page_of(before[0]));
    const Result second = run(grade(words));
    EXPECT_EQ(second.code, 0) << second.err;
    EXPECT_EQ(results().size(), size_t(count));
    EXPECT_EQ(read_file(before[0]), kept);
    EXPECT_EQ(fs::last_write_time(before[0]), written) << "it was graded twice";
    EXPECT_EQ(fs::last_write_time(page_of(before[0])), page_written) << "its pictures are lost";
    EXPECT_TRUE(contains(second.out, std::to_string(before.size()) + " unchanged")) << second.out;
    // A changed submission is graded again, and a truncated result counts as missing.
    folder.write(std::string("s1/") + quick, check::starter_of(course_file(quick), quick));
    fs::resize_file(output / "results/s2.json", 100);
    const Result third = run(grade(words));
    EXPECT_TRUE(contains(third.out, std::to_string(count - 2) + " unchanged")) << third.out;
    EXPECT_EQ(result_of(output, "s1")["points"], 0);
    EXPECT_EQ(result_of(output, "s2")["points"], 5);
}

TEST(Grade, AResultNeverExistsWithoutItsPage) {
    const TemporaryFolder folder;
    const fs::path output = folder.path() / "out";
    folder.write(std::string("jane/") + quick, check::starter_of(course_file(quick), quick));
    folder.write("out/students/jane.html/in the way", "");
    const Result graded = run(grade({(folder.path() / "jane").string(), "-o", output.string()}));
    EXPECT_EQ(graded.code, 1);
    EXPECT_TRUE(contains(graded.err, "students/jane.html")) << graded.err;
    EXPECT_FALSE(fs::exists(output / "results/jane.json"));
}

TEST(Grade, CodeTunedToTheKnownViewsFailsInHiddenOnes) {
    const TemporaryFolder folder;
    const fs::path output = folder.path() / "out";
    const char* const file = "shaders/03_height_to_normal/task.glsl";
    folder.write(std::string("honest/") + file, course_file(file));
    folder.write(std::string("tuned/") + file,
                 replaced(course_file(file), "return normalize(vec3(-slope * texels, 1.0));",
                          "return normalize(vec3(-slope * (texels.x == texels.y ? vec2(14.0) : texels), 1.0));"));
    // Correct, but includes a file that may contain answers.
    folder.write(std::string("borrows/") + file, "  # include \"common/height_cell.glsl\"\n" + course_file(file));
    // Renames the lab's main(), which would then not be called.
    folder.write(std::string("takes-over/") + file, course_file(file) + "#define main labs_main\n");
    std::vector<std::string> words = {"-o", output.string()};
    for (const char* name : {"honest", "tuned", "borrows", "takes-over"})
        words.push_back((folder.path() / name).string());
    std::vector<std::string> seeded = words;
    seeded.insert(seeded.end(), {"--seed", "midterm"});
    const Result graded = run(grade(seeded));
    ASSERT_EQ(graded.code, 0) << graded.err;
    EXPECT_EQ(outcomes(result_of(output, "honest")), Outcomes{"passed"});
    const json borrows = result_of(output, "borrows");
    EXPECT_EQ(outcomes(borrows), Outcomes{"broken"});
    EXPECT_TRUE(contains(found(borrows, "broken"), "includes common/height_cell.glsl, which is not part of this task"));
    const json takes_over = result_of(output, "takes-over");
    EXPECT_EQ(outcomes(takes_over), Outcomes{"broken"});
    EXPECT_TRUE(contains(found(takes_over, "broken"), "defines 'main', which the lab's shaders use"));
    const json tuned = result_of(output, "tuned");
    EXPECT_EQ(outcomes(tuned, "3.2"), (Outcomes{"passed", "wrong"}));
    EXPECT_TRUE(contains(found(tuned, "wrong"), "correct in the check's own view; in a hidden one: "))
        << found(tuned, "wrong");
    EXPECT_TRUE(contains(tuned.dump(), "\"view\":\"camera ") && contains(tuned.dump(), "; depth 1")) << tuned.dump(1);
    std::string on_gradescope;
    const json scope = json::parse(read_file(output / "gradescope/tuned.json"));
    for (const json& test : scope["tests"])
        if (test["visibility"] == "visible") on_gradescope += test.dump() + '\n';
    for (const std::string& students : {on_gradescope, read_file(output / "students/tuned.html")}) {
        EXPECT_TRUE(contains(students, "correct in the view that you know, but not in another one")) << students;
        for (const char* secret : {"; depth 1", "in a hidden one", "midterm"})
            EXPECT_FALSE(contains(students, secret)) << "who may hand in again must not read '" << secret << "'";
    }
    EXPECT_LT(tuned["points"], 9);
    const std::string page = read_file(output / "submissions/tuned.html");
    EXPECT_TRUE(contains(page, "hidden view</span>")) << "its pictures are of the view that is right";
    EXPECT_TRUE(contains(page, "src=\"data:image/png;base64,"));

    // The folder keeps its seed. Another seed requires new marks.
    const Result again = run(grade(words));
    EXPECT_TRUE(contains(again.out, "0 graded, 4 unchanged")) << again.out;
    EXPECT_EQ(json::parse(read_file(output / "class.json"))["seed"], "midterm");
    for (const std::string& text : {graded.out, graded.err, again.out, read_file(output / "report.html")})
        EXPECT_FALSE(contains(text, "midterm")) << "a log or a page that others can read names the seed";
    std::vector<std::string> other = words;
    other.insert(other.end(), {"--seed", "final"});
    EXPECT_TRUE(contains(run(grade(other)).out, "4 graded, 0 unchanged"));
}

TEST(Grade, PartsMergeIntoTheWholeClassAndNoStudentIsLost) {
    const TemporaryFolder folder;
    std::vector<std::string> paths;
    for (int i = 0; i < 5; ++i) {
        const std::string name = "s" + std::to_string(i);
        folder.write(name + "/" + quick, course_file(quick) + "// " + name + "\n");
        paths.push_back((folder.path() / name).string());
    }
    const fs::path output = folder.path() / "out";
    const auto part = [&](const fs::path& into, std::vector<std::string> more, const Circumstances& where = {}) {
        std::vector<std::string> words = paths;
        words.insert(words.end(), {"-o", into.string()});
        words.insert(words.end(), more.begin(), more.end());
        return run(grade(words), where);
    };
    const auto merged = [&] { return run({relief_program(), "grade", "--merge", output.string()}); };
    const Result seedless = part(output, {"--shard", "1/2"});
    EXPECT_EQ(seedless.code, 2);
    EXPECT_TRUE(contains(seedless.err, "RELIEF_SEED=WORD")) << seedless.err;

    const Result first = part(output / "one", {"--shard", "1/2", "--seed", "x"});
    EXPECT_EQ(first.code, 0) << first.err;
    EXPECT_TRUE(contains(first.out, "3 graded")) << first.out;
    EXPECT_EQ(fs::status(output / "one").permissions(), fs::perms::owner_all) << "marks are nobody else's to read";
    EXPECT_FALSE(fs::exists(output / "one/results.csv")) << "a part is not the class";
    const Result early = merged();
    EXPECT_EQ(early.code, 1);
    EXPECT_TRUE(contains(early.err, "of 5 submissions 2 without a result: s1, s3")) << early.err;

    const Result second =
        part(output / "two", {"--seed", "x"},
             {.folder = {},
              .environment = {
                  {"SLURM_ARRAY_TASK_ID", "8"}, {"SLURM_ARRAY_TASK_MIN", "7"}, {"SLURM_ARRAY_TASK_COUNT", "2"}}});
    EXPECT_TRUE(contains(second.out, "2 graded")) << second.out << second.err;
    const Result whole = merged();
    EXPECT_EQ(whole.code, 0) << whole.err;
    EXPECT_TRUE(contains(whole.out, "5 graded")) << whole.out;
    const std::string csv = read_file(output / "results.csv");
    for (int i = 0; i < 5; ++i) EXPECT_TRUE(contains(csv, "\ns" + std::to_string(i) + ",graded,5,")) << csv;
    EXPECT_TRUE(fs::exists(output / "report.html"));
    for (int i = 0; i < 5; ++i) {
        for (const char* kind : {"students", "submissions"}) {
            const std::string page = std::string(kind) + "/s" + std::to_string(i) + ".html";
            EXPECT_EQ(read_file(output / page), read_file(output / (i % 2 == 0 ? "one" : "two") / page));
        }
        EXPECT_TRUE(contains(read_file(output / "report.html"), "href=\"submissions/s" + std::to_string(i) + ".html"));
    }

    const fs::path result = output / "one/results/s0.json";
    const std::string kept = read_file(result);
    const auto with_points = [&](double points, int of) {
        json changed = json::parse(kept);
        json& task = changed["labs"][0]["tasks"][0];
        task["points"] = points, task["of"] = of;
        folder.write("out/one/results/s0.json", changed.dump());
        const Result refused = merged();
        EXPECT_EQ(refused.code, 1) << points;
        return refused.err;
    };
    EXPECT_TRUE(contains(with_points(999, 2), "s0.json: task 1.1 has 999 of 2 points, with "));
    EXPECT_TRUE(contains(with_points(1e308, 2), " of 2 points, with "));
    EXPECT_TRUE(contains(with_points(-1, 2), "has -1 of 2 points"));
    EXPECT_TRUE(
        contains(with_points(999, 999), "s0.json: has a task 1.1 of 999 points, which this course does not have"));
    folder.write("out/one/results/s0.json", kept.substr(0, kept.size() / 2));
    EXPECT_TRUE(contains(merged().err, "s0.json: is not a whole result of grading: remove it, and run "));
    folder.write("out/one/results/s0.json", kept);

    fs::copy_file(output / "one/results/s0.json", output / "two/results/s0.json");
    EXPECT_TRUE(contains(merged().err, "1 with several results: s0"));
    fs::remove(output / "two/results/s0.json");
    folder.write(std::string("s1/") + quick, course_file(quick));
    part(output / "two", {"--shard", "1/2", "--seed", "x"});
    EXPECT_TRUE(contains(merged().err, "names other submissions"));
}

TEST(Grade, AMachineFailureCostsNoMarks) {
    if (!has_namespaces()) GTEST_SKIP() << "without namespaces a removed program cannot be told from one that crashed";
    const TemporaryFolder folder;
    const fs::path output = folder.path() / "out", temporary = folder.path() / "tmp";
    fs::create_directory(temporary);
    fs::permissions(folder.path(), fs::perms(0755)), fs::permissions(temporary, fs::perms(0755));
    std::vector<std::string> words;
    for (const char* name : {"a", "b", "c"}) {
        folder.write(std::string(name) + "/" + quick, course_file(quick) + "// " + name + "\n");
        words.push_back((folder.path() / name).string());
    }
    words.insert(words.end(), {"-o", output.string(), "--jobs", "1"});
    {
        Process grader(grade(words), {.folder = {}, .environment = {{"TMPDIR", temporary.string()}}});
        for (int i = 0; i < 6000 && !fs::exists(output / "results/a.json") && grader.running(); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        // Simulates a person who cleans up temporary files.
        for (const auto& entry : fs::directory_iterator(temporary)) fs::remove_all(entry.path() / "bin");
        const Result failed = grader.wait();
        EXPECT_EQ(failed.code, 1);
        EXPECT_TRUE(contains(failed.err, "run the same command again")) << failed.err;
    }
    EXPECT_EQ(outcomes(result_of(output, "a")), Outcomes{"passed"});
    EXPECT_TRUE(outcomes(result_of(output, "c")).contains("machine"));
    EXPECT_TRUE(contains(read_file(output / "results.csv"), "c,not graded: the machine failed,,"))
        << read_file(output / "results.csv");
    const Result again = run({relief_program(), "grade", "--resume", "-o", output.string()});
    EXPECT_EQ(again.code, 0) << again.err;
    for (const char* name : {"a", "b", "c"}) EXPECT_EQ(result_of(output, name)["points"], 5) << name;
}

TEST(Grade, AnAutograderForGradescopeHasTheCourseAndTwoScripts) {
    const TemporaryFolder folder;
    const fs::path output = folder.path() / "autograder/source";
    const Result made =
        run({relief_program(), "grade", "--gradescope", "-o", output.string(), "--lab", "2", "--seed", "o'x"});
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_EQ(read_file(output / "course" / shader), course_file(shader)) << "it grades with the solutions";
    EXPECT_FALSE(fs::exists(output / "course/build"));
    for (const char* script : {"setup.sh", "run_autograder"}) {
        EXPECT_NE(fs::status(output / script).permissions() & fs::perms::owner_exec, fs::perms::none);
        EXPECT_EQ(run({"/bin/bash", "-n", (output / script).string()}).code, 0) << script;
    }
    EXPECT_EQ(run({relief_program(), "grade", "--gradescope", "-o", output.string()}).code, 0) << "made anew";
    folder.write("taken/thesis.txt", "years of work");
    const Result refused = run({relief_program(), "grade", "--gradescope", "-o", (folder.path() / "taken").string()});
    EXPECT_EQ(refused.code, 2);
    EXPECT_TRUE(contains(refused.err, "has other files in it")) << refused.err;

    // Runs the script for Gradescope with a stand-in for the grader that records its arguments.
    run({relief_program(), "grade", "--gradescope", "-o", output.string(), "--lab", "2", "--seed", "o'x"});
    folder.write("autograder/source/course/relief",
                 "#!/bin/sh\nprintf '%s\\n' \"$RELIEF_SEED\" \"$@\" > called\n[ -e fail ] && exit 1\n"
                 "mkdir -p marks/gradescope && echo graded > marks/gradescope/submission.json\n");
    const Circumstances here{.folder = folder.path(),
                             .environment = {{"AUTOGRADER", (folder.path() / "autograder").string()}}};
    const std::string script = (output / "run_autograder").string();
    EXPECT_EQ(run({script}, here).code, 0);
    EXPECT_EQ(read_file(folder.path() / "autograder/results/results.json"), "graded\n");
    const std::string called = read_file(folder.path() / "autograder/called");
    EXPECT_TRUE(called.starts_with("o'x\n") && called.ends_with("--trust\n--lab\n02\n")) << called;
    EXPECT_EQ(fs::status(script).permissions() & (fs::perms::group_all | fs::perms::others_all), fs::perms::none)
        << "a submission could read the seed";
    fs::remove_all(folder.path() / "autograder/results");
    folder.write("autograder/fail", "");
    EXPECT_NE(run({script}, here).code, 0);
    EXPECT_FALSE(fs::exists(folder.path() / "autograder/results/results.json"))
        << "when the machine fails there is no mark";
}

TEST(Grade, RefusesToRunWithoutIsolationUnlessTrusted) {
    const TemporaryFolder folder;
    folder.write(std::string("jane/") + quick, course_file(quick));
    const std::string jane = (folder.path() / "jane").string(), output = (folder.path() / "out").string();
    const Circumstances without{.folder = {}, .environment = {{"RELIEF_NO_NAMESPACES", "1"}}};
    const Result refused = run({relief_program(), "grade", jane, "-o", output}, without);
    EXPECT_EQ(refused.code, 1);
    EXPECT_TRUE(contains(refused.err, "--trust")) << refused.err;
    EXPECT_FALSE(fs::exists(folder.path() / "out/results/jane.json"));
    // Where AppArmor is the cause, the profile that allows bubblewrap comes along.
    folder.write("proc/sys/kernel/apparmor_restrict_unprivileged_userns", "1\n");
    const Circumstances ubuntu{.folder = {}, .environment = {{"RELIEF_NO_NAMESPACES", folder.path().string()}}};
    for (const Result& told :
         {run({relief_program(), "grade", jane, "-o", output}, ubuntu), run({relief_program(), "info"}, ubuntu)}) {
        EXPECT_TRUE(contains(told.err + told.out, "AppArmor forbids them")) << told.err << told.out;
        EXPECT_TRUE(contains(told.err + told.out, "profile relief-bwrap /usr/bin/bwrap")) << told.err << told.out;
    }
    const Result trusted = run({relief_program(), "grade", jane, "-o", output, "--trust"}, without);
    EXPECT_EQ(trusted.code, 0) << trusted.err;
    EXPECT_TRUE(contains(trusted.err, "isolation: limits")) << trusted.err;
    EXPECT_EQ(result_of(output, "jane")["isolation"], "limits");
    EXPECT_EQ(result_of(output, "jane")["points"], 5);
}

TEST(Grade, TwoGradersDoNotShareAFolder) {
    const TemporaryFolder folder;
    const fs::path output = folder.path() / "out";
    folder.write("jane/notes.txt", "");
    fs::create_directories(output);
    const std::vector<std::string> words = grade({(folder.path() / "jane").string(), "-o", output.string()});
    {
        const Descriptor other(open(output.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
        ASSERT_EQ(flock(other, LOCK_EX | LOCK_NB), 0);
        const Result refused = run(words);
        EXPECT_EQ(refused.code, 1);
        EXPECT_TRUE(contains(refused.err, "another grader is at work in '" + output.string() + "'")) << refused.err;
        EXPECT_TRUE(fs::is_empty(output)) << "something was written beside the other one";
        flock(other, LOCK_SH);  // the lock that a part of a class holds
        std::vector<std::string> part = words;
        part.insert(part.end(), {"--shard", "1/2", "--seed", "x"});
        EXPECT_EQ(run(part).code, 0);
        EXPECT_EQ(run({relief_program(), "grade", "--merge", output.string()}).code, 1);
    }
    EXPECT_EQ(run(words).code, 0);
}

TEST(Grade, ANameOfAnyBytesIsGradedShownAndResumed) {
    const TemporaryFolder folder;
    const fs::path output = folder.path() / "out";
    folder.write("m\xfcller/notes.txt", "");
    folder.write("jane \xe2\x80\xae/notes.txt", "");
    std::vector<std::string> words;
    for (const auto& entry : fs::directory_iterator(folder.path())) words.push_back(entry.path());
    words.insert(words.end(), {"-o", output.string()});
    ASSERT_EQ(run(grade(words)).code, 0);
    const std::string csv = read_file(output / "results.csv");
    EXPECT_TRUE(contains(csv, "\nm\\xfcller,there is no task file in it: only notes.txt,")) << csv;
    EXPECT_TRUE(contains(csv, "\njane \\u202e,")) << csv;
    const Result resumed = run({relief_program(), "grade", "--resume", "-o", output.string()});
    EXPECT_EQ(resumed.code, 0) << resumed.err;
    EXPECT_TRUE(contains(resumed.out, "0 graded, 2 unchanged")) << resumed.out;
}

TEST(Grade, SubmissionsOfEqualNameAreSkippedAndTheOthersGraded) {
    const TemporaryFolder folder;
    const std::string output = (folder.path() / "out").string();
    folder.write("a/jane\u0301/notes.txt", "");  // the same name in two characters, and below in one
    folder.write("b/jan\u00e9/notes.txt", "");
    folder.write("c/joe/notes.txt", "");
    std::vector<std::string> words;
    for (const char* one : {"a/jane\u0301", "c/joe", "b/jan\u00e9"}) words.push_back((folder.path() / one).string());
    words.insert(words.end(), {"-o", output});
    const Result graded = run(grade(words));
    EXPECT_EQ(graded.code, 1);
    EXPECT_TRUE(contains(graded.err, "2 submissions are named 'jan\u00e9', so none of them is graded: ")) << graded.err;
    EXPECT_TRUE(contains(graded.out, "1 graded, 0 unchanged, 1 not graded")) << graded.out;
    EXPECT_TRUE(fs::exists(output + "/results/joe.json"));
    EXPECT_FALSE(fs::exists(output + "/results/jan\u00e9.json"));
}

TEST(Grade, DownloadsAndNearNamesAreGradedAndExplained) {
    const TemporaryFolder folder;
    const fs::path output = folder.path() / "out";
    const auto at = [&](const std::string& name) { return (folder.path() / name).string(); };
    const std::string solution = course_file(quick);
    folder.write("Gina Rossi_12345_assignsubmission_file_/task (1).glsl", solution);
    folder.write("doejane_LATE_1001_500_task.glsl", check::starter_of(solution, quick));
    folder.write("doejane_1001_501_task-1.glsl", solution);
    folder.write(std::string("kim/") + quick, check::starter_of(solution, quick));
    folder.write(std::string("kim (1)/") + quick, solution);
    folder.write("stranger_7_8_lab01.glsl", solution);
    folder.write("class.toml",
                 "[[assigned]]\nlab = 1\n[[assigned]]\nlab = 2\n"
                 "[[student]]\nstudent = \"gina\"\nname = \"Rossi, Gina\"\nteam = \"red\"\n"
                 "[[student]]\nstudent = \"lea\"\nname = \"Lea O'Hara\"\nteam = \"red\"\n"
                 "[[student]]\nstudent = \"jane\"\ncanvas_id = \"1001\"\n[[student]]\nstudent = \"kim\"\n");
    const Result graded =
        run(grade({at("Gina Rossi_12345_assignsubmission_file_"), at("doejane_LATE_1001_500_task.glsl"),
                   at("doejane_1001_501_task-1.glsl"), at("kim"), at("kim (1)"), at("stranger_7_8_lab01.glsl"), "-o",
                   output.string(), "--class", at("class.toml")}));
    EXPECT_EQ(graded.code, 0) << graded.err;
    for (const char* note :
         {"gina: 'task (1).glsl' is graded as shaders/01_specular_highlights/task.glsl, since there is no file of",
          "jane: 2 uploads from Canvas are graded together", "'task-1.glsl' is graded as", "it was uploaded later",
          "kim: 'kim (1)' counts, and not 'kim': its number is that of the later copy",
          "'Gina Rossi_12345_assignsubmission_file_' is gina", "1 submission is not on the roster: stranger_7"})
        EXPECT_TRUE(contains(graded.err, note)) << note << "\n" << graded.err;
    const std::string csv = read_file(output / "results.csv");
    for (const char* name : {"gina", "lea", "jane", "kim", "stranger_7"})
        EXPECT_TRUE(contains(csv, "\n" + std::string(name) + ",graded,5,16")) << name << "\n" << csv;
    const std::string page = read_file(output / "students/gina.html"), mate = read_file(output / "students/lea.html");
    EXPECT_TRUE(contains(page, "&#39;task (1).glsl&#39; is graded as shaders/01_specular_highlights/task.glsl"));
    EXPECT_TRUE(contains(mate, "<h1><bdi>lea</bdi></h1>"));
    EXPECT_TRUE(contains(mate, "the submission &#39;gina&#39; counts for team red"));
    EXPECT_TRUE(contains(mate, "5 of 16 points"));
    EXPECT_TRUE(contains(mate, "id=\"task-1.1\"")) << "the team's results";
    const std::string report = read_file(output / "report.html");
    EXPECT_FALSE(contains(report, "all passed")) << "lab 02 is missing";
    EXPECT_TRUE(contains(report, "1 lab not handed in"));

    const Result resumed = run(grade({"--resume", "-o", output.string()}));
    EXPECT_EQ(resumed.code, 0) << resumed.err;
    EXPECT_TRUE(contains(resumed.out, "0 graded, 4 unchanged")) << resumed.out;
    // With the right name the files are the same, so only the sentence goes.
    fs::create_directories((folder.path() / "gina" / quick).parent_path());
    fs::copy_file(folder.path() / "Gina Rossi_12345_assignsubmission_file_/task (1).glsl",
                  folder.path() / "gina" / quick);
    const Result renamed = run(grade({at("gina"), "-o", output.string()}));
    EXPECT_TRUE(contains(renamed.out, "0 graded, 1 unchanged")) << renamed.out;
    EXPECT_FALSE(contains(read_file(output / "students/gina.html"), "task (1)"));
}

TEST(Grade, ALinkInPlaceOfATaskFileIsReportedAsALink) {
    const TemporaryFolder folder;
    const fs::path output = folder.path() / "out";
    const fs::path work = folder.write("work/task.glsl", course_file(shader)).parent_path();
    fs::create_directories((folder.path() / "jane" / shader).parent_path().parent_path());
    fs::create_directory_symlink(work, (folder.path() / "jane" / shader).parent_path());
    const Result graded = run(grade({(folder.path() / "jane").string(), "-o", output.string()}));
    EXPECT_EQ(graded.code, 0) << graded.err;
    EXPECT_EQ(result_of(output, "jane")["problem"],
              "there is no task file in it: 'shaders/02_normal_map_storage' is a link, and links are not followed");
}

// Simulates a machine on which other programs have used up a user's processes.
TEST(Grade, ACompilerThatCannotForkIsAMachineFailure) {
    if (geteuid() != 0) GTEST_SKIP() << "only root's submissions run as another user, who alone can be bounded";
    const TemporaryFolder folder;
    folder.write(std::string("jane/") + cpp, course_file(cpp));
    const Result graded = run({"prlimit", "--nproc=1:1", relief_program(), "grade", "--trust",
                               (folder.path() / "jane").string(), "-o", (folder.path() / "out").string()},
                              {.folder = {}, .environment = {{"RELIEF_NO_NAMESPACES", "1"}}});
    EXPECT_EQ(graded.code, 1);
    EXPECT_TRUE(contains(graded.err, "(machine: the machine failed: ")) << graded.err;
}

TEST(Grade, AClassFileAndAdjustmentsChangePointsButNoVerdict) {
    const TemporaryFolder folder;
    const fs::path output = folder.path() / "out";
    folder.write(std::string("jane/") + quick, course_file(quick));
    folder.write(std::string("bo/") + quick, check::starter_of(course_file(quick), quick));
    folder.write(
        "class.toml",
        "hand_ins = \"times.csv\"\n[late]\npercent_per_day = 10\n[[assigned]]\nlab = 2\n[[assigned]]\nlab = 1\ndue = "
        "2027-03-01T12:00:00Z\n[[student]]\nstudent = \"jane\"\nlogin = \"jd\"\n[[student]]\nstudent = \"kim\"\n");
    folder.write("times.csv", "student,handed_in\njane,2027-03-01T13:00Z\n");
    const std::vector<std::string> words = {(folder.path() / "jane").string(), (folder.path() / "bo").string(), "-o",
                                            output.string()};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), words.begin(), words.end());
        return run(grade(more));
    };
    const Result plain = with({});
    EXPECT_EQ(plain.code, 0) << plain.err;
    EXPECT_TRUE(contains(plain.out, "5/5")) << plain.out;
    const std::string verdict = read_file(output / "results/jane.json");

    // Labs 01 and 02 have 5 and 11 points, without the optional ones. The submissions have only the former.
    const Result first = with({"--class", (folder.path() / "class.toml").string()});
    EXPECT_EQ(first.code, 0) << first.err;
    EXPECT_TRUE(contains(first.out, "2 unchanged")) << first.out;
    EXPECT_TRUE(contains(first.out, "4.5/16  late: 0.5 less")) << first.out;
    EXPECT_TRUE(contains(first.err, "1 student of the roster handed nothing in: kim")) << first.err;
    EXPECT_TRUE(contains(first.err, "1 submission is not on the roster: bo")) << first.err;
    EXPECT_TRUE(contains(read_file(output / "canvas.csv"), "jane,,,jd,,4.5,0\n")) << read_file(output / "canvas.csv");

    // Later runs know the class file, and apply the adjustments that people add.
    folder.write("out/adjustments.csv", "student,task,points,note\njane,1.1,-1,\"see, me\"\nkim,1.1,2,on paper\n");
    const Result second = run(grade({"--resume", "-o", output.string()}));
    EXPECT_EQ(second.code, 0) << second.err;
    EXPECT_TRUE(contains(second.out, "3.6/16  adjusted by -1  late: 0.4 less")) << second.out;
    EXPECT_TRUE(contains(second.out, "2/16    nothing handed in  adjusted by 2")) << second.out;
    for (const char* kind : {"students", "submissions"}) {
        const std::string page = read_file(output / kind / "jane.html");
        for (const char* part : {"3.6 of 16 points", "see, me", "5 by the checks", "4 with adjustments",
                                 "1 day late: 10 % less, 3.6 of 4", "nothing handed in"})
            EXPECT_TRUE(contains(page, part)) << kind << part;
        EXPECT_TRUE(contains(read_file(output / kind / "kim.html"), "on paper"));
    }
    EXPECT_TRUE(contains(read_file(output / "report.html"), "see, me"));
    const Result again = run(grade({"--resume", "-o", output.string(), "--fresh"}));
    EXPECT_TRUE(contains(again.out, "3.6/16  adjusted by -1")) << again.out << "\nadjustments survive";
    EXPECT_TRUE(contains(read_file(output / "students/jane.html"), "see, me"));
    EXPECT_EQ(json::parse(read_file(output / "results/jane.json"))["labs"][0]["tasks"],
              json::parse(verdict)["labs"][0]["tasks"])
        << "results stay the grader's verdict";
    const Result merged = run({relief_program(), "grade", "--merge", output.string()});
    EXPECT_TRUE(contains(merged.out, "3.6/16  adjusted by -1")) << merged.out << merged.err;

    // A run that does not name a student says so and gives no mark, but keeps the student's page for the next run.
    const Result without_jane = run(grade({words[1], "-o", output.string()}));
    EXPECT_TRUE(contains(without_jane.err, "1 student handed in before")) << without_jane.err;
    EXPECT_TRUE(contains(read_file(output / "results.csv"), "\njane,not graded yet,,"))
        << read_file(output / "results.csv");
    const Result with_jane = run(grade({words[0], words[1], "-o", output.string()}));
    EXPECT_TRUE(contains(with_jane.out, "2 unchanged")) << with_jane.out;
    const std::string page = read_file(output / "students/jane.html");
    EXPECT_TRUE(contains(page, "3.6 of 16 points"));
    EXPECT_FALSE(contains(page, "Nothing was handed in")) << "the page is that of her submission";

    // A mistake in the adjustments is reported before anything is graded.
    folder.write("out/adjustments.csv", "student,task,points,note\njane,1.1,lots,x\n");
    const Result refused = run(grade({"--resume", "-o", output.string()}));
    EXPECT_EQ(refused.code, 1);
    EXPECT_TRUE(contains(refused.err, "adjustments.csv:2: 'lots' is no number of points")) << refused.err;
    fs::remove(output / "adjustments.csv");
    const Result none = run(grade({"--resume", "-o", output.string(), "--class", "none"}));
    EXPECT_TRUE(contains(none.out, "5/5")) << none.out;
    EXPECT_FALSE(fs::exists(output / "canvas.csv")) << "without a roster there is none to upload";
    const Result other =
        run(grade({words[0], "-o", output.string(), "--lab", "5", "--class", (folder.path() / "class.toml").string()}));
    EXPECT_EQ(other.code, 2);
    EXPECT_TRUE(contains(other.err, "lab 05 is not assigned in ")) << other.err;
}

/// Returns a task file without comments, its functions in reversed order below their prototypes.
std::string rearranged(const std::string& text) {
    std::string head, prototypes, functions;
    for (const CodeDefinition& one : definitions_of(text).list) {
        std::string code;
        for (size_t i = 0, end = 0; i < one.tokens.size(); end = one.tokens[i++].end)
            code += (one.tokens[i].begin > end ? " " : "") + one.tokens[i].text;  // "<=" is two tokens
        if (one.kind != CodeDefinition::function) {
            head += (code.empty() ? text.substr(one.begin, one.end - one.begin) : code) + '\n';
        } else {
            prototypes += code.substr(0, code.find('{')) + ";\n";
            functions.insert(0, code + '\n');
        }
    }
    return head + prototypes + functions;
}

TEST(Grade, CommentsAndTheOrderOfFunctionsCostNothingAndAMissingFunctionIsNamed) {
    const TemporaryFolder folder;
    const fs::path output = folder.path() / "out";
    const std::string solution = course_file(shader),
                      wrong = replaced(solution, "return code / 255.0 * 2.0 - 1.0;", "return code / 255.0;");
    folder.write("good/" + std::string(shader), rearranged(solution));
    folder.write("wrong/" + std::string(shader), wrong);
    folder.write("wrong2/" + std::string(shader), rearranged(wrong));
    folder.write("lacks/" + std::string(shader),
                 replaced(solution, "float z_from_xy(vec2 xy) {", "float z_of(vec2 xy) {"));
    std::vector<std::string> words;
    for (const char* name : {"good", "wrong", "wrong2", "lacks"}) words.push_back((folder.path() / name).string());
    for (const char* word : {"-o", output.c_str(), "--lab", "2"}) words.emplace_back(word);
    const Result result = run(grade(words));
    ASSERT_EQ(result.code, 0) << result.err;
    const auto points = [&](const char* name) { return result_of(output, name).value("points", -1.0); };
    EXPECT_GT(points("good"), points("wrong"));
    EXPECT_GT(points("wrong"), 0);
    EXPECT_EQ(points("wrong"), points("wrong2"));
    EXPECT_EQ(points("lacks"), points("good") - 2) << "task 2.3 alone";
    EXPECT_TRUE(contains(read_file(output / "students/lacks.html"), "z_from_xy(vec2)"));
}

TEST(Grade, AHandInBeyondTheLimitOfTheDayKeepsTheEarlierMark) {
    const TemporaryFolder folder;
    const fs::path output = folder.path() / "out";
    const std::string solution = course_file(quick), starter = check::starter_of(solution, quick),
                      lab_4 = "shaders/04_object_space/task.glsl";
    folder.write("class.toml",
                 "utc_offset = \"+00:00\"\n[attempts]\nper_day = 2\n[[assigned]]\nlab = 1\n[[assigned]]\nlab = 4\n");
    const auto hand_in = [&](const std::string& text) {
        folder.write(std::string("jane/") + quick, text);
        const Result result = run(grade({(folder.path() / "jane").string(), "-o", output.string(), "--class",
                                         (folder.path() / "class.toml").string()}));
        EXPECT_EQ(result.code, 0) << result.err;
        return result;
    };
    const auto hand_ins = [&] {
        const std::string log = read_file(output / "hand_ins/jane.csv");
        return std::count(log.begin(), log.end(), '\n') - 1;
    };
    const auto points = [&] { return result_of(output, "jane").value("points", -1.0); };
    hand_in(starter);
    EXPECT_EQ(hand_ins(), 1);
    EXPECT_TRUE(contains(hand_in(starter).out, "1 unchanged"));
    EXPECT_EQ(hand_ins(), 1) << "the same files are no hand-in";
    hand_in(starter + "// again\n");
    EXPECT_EQ(points(), 0);
    EXPECT_EQ(hand_ins(), 2);

    const std::string page = read_file(output / "submissions/jane.html");
    const Result third = hand_in(solution);
    EXPECT_EQ(points(), 0) << "the mark of the second hand-in";
    EXPECT_EQ(hand_ins(), 2);
    EXPECT_TRUE(contains(third.err, "1 submission is beyond the limit of hand-ins and keeps an earlier mark: jane"))
        << third.err;
    EXPECT_TRUE(contains(third.out, "lab 01: beyond the limit of hand-ins")) << third.out;
    for (const char* file : {"students/jane.html", "submissions/jane.html", "report.html", "results.csv",
                             "late_days.csv", "gradescope/jane.json", "prairielearn/jane.json"})
        EXPECT_TRUE(
            contains(read_file(output / file), "the last hand-in is not graded, because of the limit of 2 on 20"))
            << file;
    EXPECT_GT(read_file(output / "submissions/jane.html").size(), page.size()) << "the pictures of the mark stay";
    const Result merged = run({relief_program(), "grade", "--merge", output.string()});
    EXPECT_EQ(merged.code, 0) << merged.err;

    // Another lab has its own limit.
    folder.write("jane/" + lab_4, course_file(lab_4));
    hand_in(solution);
    EXPECT_EQ(points(), 10);
    EXPECT_EQ(hand_ins(), 3);
    hand_in(solution);
    EXPECT_EQ(points(), 10) << "still the same day";

    // A hand-in of another day is graded: here the logged ones move to an earlier day.
    std::string log = read_file(output / "hand_ins/jane.csv");
    for (size_t at = 0; (at = log.find(",20", at)) != log.npos; at += 3) log.replace(at, 5, ",1999");
    folder.write("out/hand_ins/jane.csv", log);
    const Result next = hand_in(solution);
    EXPECT_EQ(points(), 10 + 5);
    EXPECT_EQ(hand_ins(), 4);
    EXPECT_FALSE(contains(next.err, "beyond the limit")) << next.err;
}

TEST(Grade, TheScriptOfTheGuideCollectsTheLastCommitBeforeTheDeadline) {
    const TemporaryFolder folder;
    const std::string guide = course_file("labs/staff/README.md"), begin = "```bash collect.sh\n";
    const size_t at = guide.find(begin);
    ASSERT_NE(at, std::string::npos);
    folder.write("collect.sh", guide.substr(at + begin.size(), guide.find("```", at + 3) - at - begin.size()));
    const auto in = [&](const std::string& script, const std::string& date = "2027-03-01T12:00:00Z") {
        const Result result = run({"bash", "-ec", script}, {.folder = folder.path(),
                                                            .environment = {{"GIT_COMMITTER_DATE", date},
                                                                            {"GIT_CONFIG_GLOBAL", "/dev/null"},
                                                                            {"GIT_AUTHOR_NAME", "x"},
                                                                            {"GIT_AUTHOR_EMAIL", "x@x.org"},
                                                                            {"GIT_COMMITTER_NAME", "x"},
                                                                            {"GIT_COMMITTER_EMAIL", "x@x.org"}}});
        return result;
    };
    const auto commit = [&](const std::string& student, const std::string& text, const std::string& date) {
        folder.write(student + "/" + shader, text);
        const Result result = in("git init -q -b trunk " + student + "; cd " + student +
                                     "; git add -A; git commit -q -m x; git clone -q --bare . ../" + student +
                                     ".git 2>/dev/null || git push -q ../" + student + ".git trunk",
                                 date);
        EXPECT_EQ(result.code, 0) << result.err;
    };
    commit("jane", "first", "2027-03-01T10:00:00Z");
    commit("jane", "last", "2027-03-01T20:00:00Z");
    commit("jane", "late", "2027-03-02T10:00:00Z");
    commit("joe", "late", "2027-03-02T10:00:00Z");
    // Kim has an old hand-in, and a hook and a filter that must not run.
    folder.write("kim/.gitattributes", "* filter=evil\n");
    commit("kim", "kim", "2027-02-28T10:00:00Z");
    folder.write("kim.git/hooks/post-checkout", "#!/bin/sh\ntouch " + (folder.path() / "ran").string() + "\n");
    folder.write("bo/readme.txt", "nothing");
    EXPECT_EQ(in("git init -q bo; cd bo; git add -A; git commit -q -m x; git clone -q --bare . ../bo.git").code, 0);
    std::string table = "student,url\r\n";
    for (const char* student : {"jane", "joe", "kim", "bo", "ann"})
        table += std::string(student) + "," + (folder.path() / student).string() + ".git\n";
    folder.write("repositories.csv", table.substr(0, table.size() - 1));  // without a final line break

    const Result collected = in("bash collect.sh repositories.csv 2027-03-02T00:00:00+01:00");
    EXPECT_EQ(collected.code, 1) << "some have nothing";
    EXPECT_TRUE(contains(collected.err, "joe: no commit before 2027-03-02T00:00:00+01:00")) << collected.err;
    EXPECT_TRUE(contains(collected.err, "bo: no task file")) << collected.err;
    EXPECT_TRUE(contains(collected.err, "ann: cannot fetch ")) << collected.err;
    const auto handed_in = [&](const char* student) {
        return read_submission(folder.path() / "submissions" / (std::string(student) + ".tar"), {shader}).files;
    };
    EXPECT_EQ(handed_in("jane"), (std::map<std::string, std::string>{{shader, "last"}}));
    EXPECT_EQ(handed_in("kim").at(shader), "kim");
    for (const char* student : {"joe", "bo", "ann"})
        EXPECT_FALSE(fs::exists(folder.path() / "submissions" / (std::string(student) + ".tar"))) << student;
    EXPECT_FALSE(fs::exists(folder.path() / "ran"));
    const std::string times = read_file(folder.path() / "hand_ins.csv");
    EXPECT_TRUE(contains(times, "student,handed_in\njane,2027-03-01T20:00:00")) << times;
    EXPECT_FALSE(contains(times, "joe")) << times;

    // A later deadline takes the later commits, from the repositories that are there.
    const Result later = in("bash collect.sh repositories.csv 2027-03-03");
    EXPECT_EQ(handed_in("jane").at(shader), "late") << later.err;
    EXPECT_EQ(handed_in("joe").at(shader), "late") << later.err;
    EXPECT_EQ(in("bash collect.sh repositories.csv").code, 2);
    EXPECT_EQ(in("bash collect.sh repositories.csv someday").code, 2);
}

TEST(Grade, WrongUseIsOneClearLine) {
    const TemporaryFolder folder;
    folder.write(std::string("a/jane/") + shader, "");
    folder.write(std::string("b/jane/") + shader, "");
    const std::string a = (folder.path() / "a/jane").string(), b = (folder.path() / "b/jane").string(),
                      output = (folder.path() / "out").string();
    const struct {
        std::vector<std::string> words;
        const char* said;
    } cases[] = {{{"-o", output}, "grade needs submissions"},
                 {{a}, "-o FOLDER"},
                 {{a, "-o", output, "--jobs", "0"}, "--jobs takes a whole number from 1 to 256, not '0'"},
                 {{a, "-o", output, "--lab", "99"}, "unknown lab"},
                 {{a + "x", "-o", output}, "there is no '"},
                 {{a, "-o", output, "--shard", "3/2"}, "--shard asks for part 3 of 2"},
                 {{a, "-o", output, "--shard", "2"}, "--shard takes i/n, like 2/8, not '2'"},
                 {{"--resume", "-o", output + "/nowhere"}, "there is nothing to resume"},
                 {{"--merge", output + "/nowhere"}, "there is no class.json"},
                 {{a, "--merge", output}, "--merge takes no submissions: '"},
                 {{"--mutate", "2", a}, "--mutate takes no submissions: '"},
                 {{"--mutate", "99"}, "unknown lab"},
                 {{"--mutate", "2", "-o", output}, "--mutate takes neither -o nor --lab"},
                 {{a, "-o", output, "--class", "nowhere.toml"}, "there is no class file 'nowhere.toml'"},
                 {{"--self-test", "--class", a}, "--class goes with submissions, --resume or --merge"},
                 {{a, "-o", output, "--json"}, "--json goes with --mutate or --status"},
                 {{"--status", output + "/nowhere"}, "there is no class.json"},
                 {{"--status", output, a}, "--status takes no submissions: '"},
                 {{"--self-test", "--mutate", "1"}, "--self-test and --mutate do not go together"},
                 {{"--merge", output, "--slurm", "2"}, "--merge and --slurm do not go together"},
                 {{"--self-test", a}, "--self-test takes no submissions: '"},
                 {{"--gradescope", a, "-o", output}, "--gradescope takes no submissions: '"},
                 {{a, "-o", output, "--context", "window"}, "grade draws without a window"},
                 {{a, "-o", output, "--sample", "2"}, "--sample goes with --self-test or --mutate"},
                 {{"--self-test", "--sample", "0"}, "--sample takes a whole number from 1 to 1000, not '0'"}};
    for (const auto& [words, said] : cases) {
        const Result result = run(grade(words));
        EXPECT_EQ(result.code, 2) << said;
        EXPECT_TRUE(contains(result.err, said)) << result.err;
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    }
}

TEST(Grade, TestsItselfOnAWholeLab) {
    const Result tested = run(grade({"--self-test", "--lab", "1"}));
    EXPECT_EQ(tested.code, 0) << tested.err;
    EXPECT_TRUE(
        contains(tested.out,
                 "lab 01: 12 of 12 known mistakes caught, 12 named, 6 examples tried; 7 of 7 correct variants get all "
                 "points"))
        << tested.out;
    EXPECT_TRUE(contains(tested.out, "kill rate 100 %, 7 of 7 correct variants get all points, 0 wrong verdicts"))
        << tested.out;
    EXPECT_FALSE(contains(tested.out, "a sample")) << tested.out;
}

TEST(Grade, KillsMutantsOfASolution) {
    const Result tested = run(grade({"--mutate", "2", "--sample", "6", "--jobs", "2", "--json"}));
    EXPECT_EQ(tested.code, 0) << tested.err;
    const json all = json::parse(tested.out);
    EXPECT_EQ(all["mutants"].size(), 6u);
    EXPECT_GE(all["kill_rate"].get<double>(), 0.97);
}

// Checks that ignore a vector's length let some mutants pass, if no example sees them. The comparison of pictures then
// finds the difference. A sample of 11 has one of them.
TEST(Grade, AMutantThatNoCheckSeesIsFoundByItsPicture) {
    if (!tests_all()) GTEST_SKIP() << "uses 20 seconds of processor time: ./relief test --all";
    const CourseCopy blind;
    for (const char* needed : {"framework/core", "framework/course/check"})  // the grader compiles task 2.5
        fs::copy(fs::path(source_folder) / needed, blind.path() / needed, fs::copy_options::recursive);
    const fs::path grading = blind.path() / "labs/02_normal_map_storage/staff/grading.toml";
    write_file(grading, read_file(grading).substr(0, read_file(grading).find("[[example]]")));
    blind.edit("labs/02_normal_map_storage/lab.toml", "name = \"normal\"\n", "name = \"normal\"\nany_length = true\n");
    std::vector<std::string> words = {"grade", "--mutate", "2", "--sample", "11", "--jobs", "2"};
    if (!has_namespaces()) words.push_back("--trust");
    const Result blindly = blind.relief(words);
    EXPECT_EQ(blindly.code, 1) << blindly.err;
    EXPECT_TRUE(contains(blindly.out, "% of the pixels differ, by ")) << blindly.out;
    EXPECT_TRUE(contains(blindly.out, "\n2.2 line ")) << blindly.out;
    EXPECT_TRUE(contains(blindly.err, "fewer than 97 % of the mutants that can be seen are killed")) << blindly.err;
}

// Two labs, one of them with tasks in C++. `relief test --all` tests all labs completely.
TEST(Grade, TestsItselfOnASampleOfSomeLabs) {
    const std::vector<std::string> labs = {"06", "15"};
    std::vector<std::string> words = {"--self-test", "--sample", "1", "--jobs", "2"};
    for (const std::string& number : labs) words.insert(words.end(), {"--lab", number});
    const Result tested = run(grade(words));
    EXPECT_EQ(tested.code, 0) << tested.err;
    for (const std::string& number : labs)
        EXPECT_TRUE(contains(tested.out, "lab " + number +
                                             ": 1 of 1 known mistakes caught, names not tested; 1 of 1 "
                                             "correct variants get all points"))
            << number << '\n'
            << tested.out;
    EXPECT_TRUE(contains(tested.out, "0 wrong verdicts")) << tested.out;
    EXPECT_TRUE(contains(tested.out, "\nonly a sample: ")) << tested.out;
}

TEST(Grade, TheBenchmarkTimesAGraderThatPassesTheSolution) {
    if (!tests_all()) GTEST_SKIP() << "uses 20 seconds of processor time: ./relief test --all";
    const TemporaryFolder folder;
    const Result timed = run({relief_program(), "bench", "grade", "--set", "tasks=shaders", "--quick", "--repeats", "1",
                              "-o", folder.path().string()});
    EXPECT_EQ(timed.code, 0) << timed.err;
    const std::string csv = read_file(folder.path() / "grade.csv");
    for (const char* hidden : {"no", "yes"})
        EXPECT_TRUE(contains(csv, std::string("tasks=shaders,relief,hidden_views=") + hidden + ",measured,")) << csv;
}

}  // namespace
}  // namespace relief::grade
