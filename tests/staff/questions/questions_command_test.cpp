// Questions about students' code, end to end: the key is right, the sheet does not tell, a rerun changes nothing.
#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/core/context/context.h"
#include "framework/core/image/compare.h"
#include "framework/core/image/file.h"
#include "framework/core/lab/registry.h"
#include "framework/course/manifest/manifest.h"
#include "framework/library/maps/visualize.h"
#include "framework/staff/grade/overlay.h"
#include "framework/staff/grade/sandbox.h"
#include "tests/course/app/course_copy.h"
#include "tests/process.h"
#include "tests/support.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* frames = "shaders/06_tangent_space/task.glsl";  // a lab that draws fast

std::vector<std::string> with_isolation(std::vector<std::string> words) {
    words.insert(words.begin(), relief_program());
    if (probe_isolation().level == Isolation::limits) words.push_back("--trust");
    return words;
}

std::string frames_with(const std::string& find, const std::string& by) {
    std::string text = read_file(course_root() / frames);
    const size_t at = text.find(find);
    EXPECT_NE(at, std::string::npos) << find;
    return text.replace(at, find.size(), by);
}

json questions_in(const fs::path& folder) { return json::parse(read_file(folder / "questions.json")); }

/// Returns what `relief explain` says about the pixel of a question.
json explained(const json& question, const fs::path& submission) {
    const std::string pixel =
        std::to_string(question["pixel"][0].get<int>()) + "," + std::to_string(question["pixel"][1].get<int>());
    const Result said = run({relief_program(), "explain", question["lab"], "--check", question["view"], "--pixel",
                             pixel, "--submission", submission.string(), "--json"});
    EXPECT_EQ(said.code, 0) << said.err;
    return said.code == 0 ? json::parse(said.out) : json();
}

/// Returns the numbers of a call in what `relief explain` says; empty if it has no such call.
std::vector<double> returned_in(const json& explanation, const json& question) {
    for (const json& function : explanation["functions"])
        if (function["name"] == question["function"] && function["pass"] == 0)
            for (const json& call : function["calls"])
                if (call["call"].get<int>() + 1 == question["call"].get<int>()) {
                    const json& value = call["results"]["returns"];
                    return value.is_array() ? value.get<std::vector<double>>() : std::vector{value.get<double>()};
                }
    return {};
}

/// Returns the numbers in "(0.1, -2)" or "0.5, 1".
std::vector<double> numbers_in(std::string text) {
    std::erase_if(text, [](char c) { return c == '(' || c == ')' || c == ' '; });
    std::vector<double> numbers;
    for (const std::string& part : split(text, ',')) numbers.push_back(std::stod(part));
    return numbers;
}

/// The questions for jane, whose work is right, and for joe, whose task 6.2 is wrong: asked once for three tests.
class AskedTwo : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder_ = new TemporaryFolder;
        folder_->write("jane/" + std::string(frames), read_file(course_root() / frames));
        folder_->write("joe/" + std::string(frames), frames_with("transpose(frame) * direction", "frame * direction"));
        const Result asked =
            run(with_isolation({"questions", work_of("jane").string(), work_of("joe").string(), "-o",
                                (folder_->path() / "out").string(), "--seed", "test", "--count", "12"}));
        ASSERT_EQ(asked.code, 0) << asked.err;
    }
    static void TearDownTestSuite() { delete folder_, folder_ = nullptr; }
    static fs::path work_of(const char* name) { return folder_->path() / name; }
    static fs::path output() { return folder_->path() / "out"; }
    static json questions_for(size_t student) { return questions_in(output())["students"][student]["questions"]; }

private:
    static inline TemporaryFolder* folder_ = nullptr;
};

TEST_F(AskedTwo, TheKeyHasTheValuesThatExplainPrintsAndTheSheetDoesNot) {
    const fs::path output = AskedTwo::output();
    const std::string sheet = read_file(output / "sheets/jane.html"), key = read_file(output / "key.html");
    size_t values = 0;
    std::map<std::string, size_t> kinds;
    const json all = questions_for(0);
    for (const json& question : all) {
        ++kinds[question["kind"]];
        if (question["kind"] != "value") continue;
        ++values;
        const auto returned = question["returned"].get<std::vector<double>>();
        const std::vector<double> said = returned_in(explained(question, work_of("jane")), question);
        const std::vector<double> answer = numbers_in(question["answer"]);
        ASSERT_EQ(said.size(), returned.size()) << question;
        ASSERT_EQ(answer.size(), returned.size()) << question;
        for (size_t i = 0; i < said.size(); ++i) {
            EXPECT_NEAR(said[i], returned[i], 1e-5) << question;  // another CPU feature may round otherwise
            EXPECT_NEAR(said[i], answer[i], question["margin"].get<double>()) << question;
        }
        EXPECT_EQ(sheet.find(question["answer"].get<std::string>()), std::string::npos) << question;
        EXPECT_NE(key.find(question["answer"].get<std::string>()), std::string::npos) << question;
        EXPECT_NE(sheet.find(question["arguments"][0].get<std::string>()), std::string::npos) << question;
    }
    EXPECT_GE(values, 3U);
    EXPECT_GE(kinds["picture"], 2U);
    EXPECT_GE(kinds["line"], 1U);
}

TEST_F(AskedTwo, AboutALostMarkAreAskedWhyAndKeepTheExpectedValueForTheTeacher) {
    const fs::path output = AskedTwo::output();
    const json first = questions_for(1)[0];
    ASSERT_TRUE(first.contains("expected")) << first;
    EXPECT_EQ(first["task"], "6.2");
    const json said = explained(first, work_of("joe"));
    const std::vector<double> drawn = numbers_in(first["drawn"]), expected = numbers_in(first["expected"]);
    EXPECT_NE(drawn, expected);
    for (size_t i = 0; i < drawn.size(); ++i) {  // three digits
        EXPECT_NEAR(drawn[i], said["value"][i].get<double>(), 0.006 * std::abs(drawn[i]) + 1e-6);
        EXPECT_NEAR(expected[i], said["expected"][i].get<double>(), 0.006 * std::abs(expected[i]) + 1e-6);
    }
    const std::string sheet = read_file(output / "sheets/joe.html");
    EXPECT_NE(sheet.find("why is the mark lost there?"), std::string::npos);
    EXPECT_EQ(sheet.find("Expected"), std::string::npos);
    EXPECT_EQ(sheet.find(first["expected"].get<std::string>()), std::string::npos);
    EXPECT_NE(read_file(output / "key.html").find(first["expected"].get<std::string>()), std::string::npos);
}

/// Returns the pictures of each question of a sheet.
std::vector<std::vector<Image>> pictures_in(const std::string& sheet) {
    std::vector<std::vector<Image>> all;
    const std::string section = "<section", uri = "data:image/png;base64,";
    for (size_t at = sheet.find(section); at != std::string::npos; at = sheet.find(section, at + 1)) {
        std::vector<Image>& pictures = all.emplace_back();
        const size_t end = sheet.find("</section", at);
        for (size_t here = sheet.find(uri, at); here < end; here = sheet.find(uri, here + 1)) {
            const size_t begin = here + uri.size();
            pictures.push_back(decode_image(from_base64(sheet.substr(begin, sheet.find('"', begin) - begin))));
        }
    }
    return all;
}

TEST_F(AskedTwo, EachLetterIsOfThePictureThatTheChangedLineDraws) {
    const std::string own = read_file(course_root() / frames);
    pin_software_renderer();
    const auto context = open_context(std::nullopt);
    const LabEntry& lab = find_lab("06");
    const Manifest manifest = load_manifest(lab);
    // Draws the view of a question, with a change or without.
    const auto drawn = [&](const json& question, const json& change, const Image& like) {
        std::vector<std::string> lines = split(own, '\n');
        if (!change.is_null()) {
            std::string& line = lines.at(change["line"].get<size_t>() - 1);
            EXPECT_NE(line.find(change["was"].get<std::string>()), std::string::npos) << line;
            line = change["now"];
        }
        std::string text;
        for (const std::string& line : lines) text += line + "\n";
        const CourseOverlay overlay({{frames, text}});
        Shot shot = manifest.check(question["view"]).shot;
        shot.probe.name = question.value("probe", "");
        shot.size = {like.width, like.height};
        const Image image = draw_shot(*make_lab(lab, shot), shot);
        return shot.probe ? visualize_probe(image, manifest.probe(shot.probe.name).colors()) : image;
    };
    const auto with_mistake = [&](const json& question, const MistakeInfo& mistake, const Image& like) {
        const CourseOverlay overlay(edited(mistake.edits));
        Shot shot = manifest.check(question["view"]).shot;
        shot.probe.name = question.value("probe", "");
        shot.size = {like.width, like.height};
        const Image image = draw_shot(*make_lab(lab, shot), shot);
        return shot.probe ? visualize_probe(image, manifest.probe(shot.probe.name).colors()) : image;
    };
    const auto is_same = [](const Image& a, const Image& b) {
        return double(difference(a, b, 2.5 / 255).pixels_over) < 0.002 * double(a.pixel_count());
    };
    const json questions = questions_for(0);
    const auto pictures = pictures_in(read_file(output() / "sheets/jane.html"));
    ASSERT_EQ(pictures.size(), questions.size());
    size_t looked_at = 0;
    std::set<std::string> letters;
    for (size_t number = 0; number < questions.size(); ++number) {
        const json& question = questions[number];
        if (question["kind"] == "value") continue;
        ++looked_at;
        const std::string letter = question["answer"];
        letters.insert(letter);
        const size_t right = size_t(letter.at(0) - 'A');
        const std::vector<Image>& shown = pictures[number];
        if (question["kind"] == "picture") {
            ASSERT_EQ(shown.size(), 4U);
            const Image changed = drawn(question, question["changes"][0], shown[0]);
            const Image unchanged = drawn(question, nullptr, shown[0]);
            size_t own_pictures = 0;
            for (size_t i = 0; i < 4; ++i) {
                EXPECT_EQ(is_same(shown[i], changed), i == right) << question << i;
                own_pictures += is_same(shown[i], unchanged);
            }
            EXPECT_EQ(own_pictures, 1U);
        } else if (question["kind"] == "mistake") {
            ASSERT_EQ(shown.size(), 2U);
            ASSERT_EQ(question["hints"].size(), 4U);
            EXPECT_TRUE(is_same(shown[0], drawn(question, nullptr, shown[0]))) << "the student's file is the solution";
            for (size_t i = 0; i < 4; ++i)
                for (const MistakeInfo& mistake : manifest.mistakes) {
                    if (!mistake.same_as.empty() || question["hints"][i] != mistake.hint) continue;
                    EXPECT_EQ(is_same(shown[1], with_mistake(question, mistake, shown[1])), i == right) << mistake.id;
                }
        } else {
            ASSERT_EQ(shown.size(), 2U);
            ASSERT_EQ(question["changes"].size(), 4U);
            EXPECT_TRUE(is_same(shown[0], drawn(question, nullptr, shown[0])));
            for (size_t i = 0; i < 4; ++i)
                EXPECT_EQ(is_same(shown[1], drawn(question, question["changes"][i], shown[1])), i == right) << question;
        }
    }
    EXPECT_GE(looked_at, 4U);
    EXPECT_GE(letters.size(), 2U);
}

TEST(QuestionsCommand, TheSameSeedAsksTheSameAndAnotherSeedOrNameDoesNot) {
    const TemporaryFolder folder;
    for (const char* name : {"jane", "joe"})
        folder.write(name + std::string("/") + frames, read_file(course_root() / frames));
    const auto asked = [&](const char* seed, const char* output, const std::vector<const char*>& names) {
        std::vector<std::string> words = {"questions", "-o", (folder.path() / output).string(), "--count", "1"};
        for (const char* name : names) words.push_back((folder.path() / name).string());
        if (seed) words.insert(words.end(), {"--seed", seed});
        const Result result = run(with_isolation(words));
        EXPECT_EQ(result.code, 0) << result.err;
        return read_file(folder.path() / output / "sheets/jane.html");
    };
    const std::string first = asked("test", "a", {"jane", "joe"});
    const json students = questions_in(folder.path() / "a")["students"];
    EXPECT_NE(students[0]["questions"], students[1]["questions"]);
    EXPECT_EQ(asked("test", "b", {"jane"}), first) << "whoever else is asked";
    EXPECT_EQ(asked(nullptr, "a", {"jane"}), first) << "the seed of the folder";
    EXPECT_NE(asked("other", "b", {"jane"}), first);
    EXPECT_EQ(fs::status(folder.path() / "a").permissions(), fs::perms::owner_all);
}

TEST(QuestionsCommand, ASeedInTheEnvironmentIsWrittenNowhere) {
    const TemporaryFolder folder;
    folder.write(std::string("jane/") + frames, read_file(course_root() / frames));
    const Result asked = run(with_isolation({"questions", (folder.path() / "jane").string(), "-o",
                                             (folder.path() / "out").string(), "--count", "1"}),
                             {.folder = {}, .environment = {{"RELIEF_SEED", "a-long-secret"}}});
    ASSERT_EQ(asked.code, 0) << asked.err;
    for (const char* file : {"sheets/jane.html", "key.html", "questions.json"})
        EXPECT_FALSE(contains(read_file(folder.path() / "out" / file), "a-long-secret")) << file;
    EXPECT_FALSE(contains(asked.out + asked.err, "a-long-secret"));
}

TEST(QuestionsCommand, ASubmissionThatDoesNotCompileCostsOneLineAndNoSheet) {
    const TemporaryFolder folder;
    folder.write("good/" + std::string(frames), read_file(course_root() / frames));
    folder.write("typo/" + std::string(frames), read_file(course_root() / frames) + "const float c = angel;\n");
    folder.write("reader/" + std::string(frames),
                 "#include \"common/light.glsl\"\n" + read_file(course_root() / frames));
    folder.write("empty/notes.txt", "nothing");
    const fs::path output = folder.path() / "out";
    folder.write("out/sheets/typo.html", "an older sheet");
    std::vector<std::string> words = {"questions", "-o", output.string(), "--count", "1", "--seed", "test"};
    for (const char* name : {"empty", "good", "reader", "typo"}) words.push_back((folder.path() / name).string());
    const Result asked = run(with_isolation(words));
    EXPECT_EQ(asked.code, 0) << asked.err;
    EXPECT_NE(asked.err.find("typo: lab 06: shaders/06_tangent_space/task.glsl:"), std::string::npos) << asked.err;
    EXPECT_NE(asked.err.find("reader: lab 06: shaders/06_tangent_space/task.glsl includes"), std::string::npos)
        << asked.err;
    EXPECT_NE(asked.err.find("empty: there is no task file in it"), std::string::npos) << asked.err;
    EXPECT_EQ(std::count(asked.err.begin(), asked.err.end(), '\n'), 3) << asked.err;
    std::set<std::string> sheets;
    for (const auto& entry : fs::directory_iterator(output / "sheets")) sheets.insert(entry.path().filename().string());
    EXPECT_EQ(sheets, std::set<std::string>{"good.html"});
    const Result none = run(with_isolation({"questions", (folder.path() / "typo").string(), "-o", output.string()}));
    EXPECT_EQ(none.code, 1);
    EXPECT_EQ(none.out, "typo: no sheet\n");
}

TEST(QuestionsCommand, AGradedClassIsAskedInAFolderThatStudentsDoNotGet) {
    const TemporaryFolder folder;
    folder.write("jane/" + std::string(frames), read_file(course_root() / frames));
    const fs::path marks = folder.path() / "marks";
    const std::vector<std::string> words =
        with_isolation({"grade", (folder.path() / "jane").string(), "-o", marks.string(), "--seed", "a-long-secret",
                        "--questions", "2"});
    const Result graded = run(words);
    ASSERT_EQ(graded.code, 0) << graded.err;
    const fs::path questions = marks / "questions";
    EXPECT_EQ(questions_in(questions)["students"][0]["questions"].size(), 2U);
    const std::string sheet = read_file(questions / "sheets/jane.html"), key = read_file(questions / "key.html");
    for (const std::string& text : {sheet, key, read_file(questions / "questions.json")})
        EXPECT_EQ(text.find("a-long-secret"), std::string::npos);
    EXPECT_EQ(read_file(marks / "students/jane.html").find("Questions about your code"), std::string::npos);
    size_t for_students = 0;
    for (const auto& entry : fs::recursive_directory_iterator(marks / "students"))
        for_students += entry.is_regular_file();
    EXPECT_EQ(for_students, 1U);
    ASSERT_EQ(run(words).code, 0);
    EXPECT_EQ(read_file(questions / "sheets/jane.html"), sheet);
}

TEST(QuestionsCommand, WrongUseIsOneClearLine) {
    const TemporaryFolder folder;
    const std::string jane = folder.write("jane/" + std::string(frames), "").parent_path().string();
    const struct {
        std::vector<std::string> words;
        std::string said;
    } cases[] = {
        {{"questions"}, "questions needs a submission: a folder or an archive of task files"},
        {{"questions", jane}, "questions needs a folder for its sheets: -o FOLDER"},
        {{"questions", jane, "-o", "q", "--count", "0"}, "--count takes a whole number from 1 to 20, not '0'"},
        {{"questions", jane, "-o", "q", "--count", "many"}, "--count takes a whole number from 1 to 20, not 'many'"},
        {{"questions", "nobody", "-o", "q"}, "there is no 'nobody'"},
        {{"questions", jane, "-o", "q", "--context", "window"},
         "questions draws without a window: choose osmesa or egl"},
        {{"grade", jane, "-o", "q", "--questions", "21"}, "--questions takes a whole number from 1 to 20, not '21'"},
        {{"grade", jane, "-o", "q", "--questions", "3", "--shard", "1/2"},
         "--shard grades parts: ask with relief questions"},
        {{"grade", "--merge", "q", "--questions", "3"}, "--merge and --questions do not go together"}};
    for (const auto& [words, said] : cases) {
        std::vector<std::string> command = words;
        command.insert(command.begin(), relief_program());
        const Result result = run(command, {.folder = folder.path(), .environment = {}});
        EXPECT_EQ(result.code, 2) << result.err;
        EXPECT_NE(result.err.find(said), std::string::npos) << result.err;
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
        EXPECT_FALSE(fs::exists(folder.path() / "q"));
    }
}

}  // namespace
}  // namespace relief::grade
