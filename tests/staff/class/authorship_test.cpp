// Hand-ins are assigned to the students of the roster by the names that students, browsers, Moodle and Canvas give
// them.
#include "framework/staff/class/authorship.h"

#include <fmt/format.h>

#include "framework/core/base/text.h"
#include "tests/support.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;
using From = DownloadName::From;
using Lines = std::vector<std::string>;

class Authorship : public testing::Test {
protected:
    /// Writes files, or folders if the name ends in "/", and returns the hand-ins.
    HandIns assigned(const Lines& names, const ClassFile& policy) const {
        std::vector<fs::path> paths;
        for (const std::string& name : names) {
            if (name.ends_with("/"))
                fs::create_directories(folder.path() / name);
            else
                folder.write(name, "");
            paths.push_back((folder.path() / name).lexically_normal());
        }
        return hand_ins_of(paths, policy);
    }
    /// Returns "owner: files" of each hand-in.
    Lines owners(const Lines& names, const ClassFile& policy) const {
        Lines result;
        for (const HandIn& one : assigned(names, policy).all) {
            Lines files;
            for (const SubmissionPart& part : one.parts)
                files.push_back(part.path.has_filename() ? part.path.filename().string()
                                                         : part.path.parent_path().filename().string());
            result.push_back(one.name + ": " + join(files, " + "));
        }
        return result;
    }
    const TemporaryFolder folder;
};

ClassFile a_roster() {
    ClassFile policy;
    policy.students = {{.student = "gina", .name = "Rossi, Gina", .email = "gina@uni.example", .canvas_id = "12345"},
                       {.student = "zoe", .name = "Zo\u00eb O'Brien-Li", .login = "zb07"},
                       {.student = "ludwig", .name = "Ludwig van Beethoven", .sis_id = "900001", .team = "Team A"},
                       {.student = "anna1", .name = "Anna Berg"},
                       {.student = "anna2", .name = "Berg, Anna"}};
    return policy;
}

TEST(DownloadNames, OfMoodleAndCanvasHaveTheirParts) {
    const auto of = [](const std::string& name) {
        const DownloadName one = parse_download_name(name);
        return fmt::format("{} {}|{}|{}|{}{}", int(one.from), one.author, one.number, one.file, one.upload,
                           one.is_text ? " text" : "");
    };
    EXPECT_EQ(of("Gina Rossi_12345_assignsubmission_file_"), "1 Gina Rossi|12345||0");
    EXPECT_EQ(of("Gina Rossi_12345_assignsubmission_file"), "1 Gina Rossi|12345||0") << "since Moodle 4.1";
    EXPECT_EQ(of("Gina Rossi_12345_assignsubmission_file_my_work.zip"), "1 Gina Rossi|12345|my_work.zip|0");
    EXPECT_EQ(of("Gina Rossi_12345_assignsubmission_onlinetext_"), "1 Gina Rossi|12345||0 text");
    EXPECT_EQ(of("Participant_12345_assignsubmission_file_"), "1 |12345||0");
    EXPECT_EQ(of("Default group_assignsubmission_file"), "1 Default group|||0");
    EXPECT_EQ(of("rossigina_12345_67890_task.glsl"), "2 rossigina|12345|task.glsl|67890");
    EXPECT_EQ(of("rossigina_LATE_12345_67890_my_task-1.glsl"), "2 rossigina|12345|my_task-1.glsl|67890");
    EXPECT_EQ(of("anon_a1B2c_67890_task.glsl"), "2 |anon_a1B2c|task.glsl|67890");
    EXPECT_EQ(of("LATE_anon_a1B2c_67890_task.glsl"), "2 |anon_a1B2c|task.glsl|67890");
    EXPECT_EQ(of("rossigina_12345_text.html"), "2 rossigina|12345||0 text");
    for (const char* name : {"jane", "jane_2.zip", "lab_03_jane.zip", "_assignsubmission_file_", "", "a b_1_2_c.zip",
                             "x_1_99999999999999999999_y.zip"})
        EXPECT_EQ(of(name), fmt::format("0 {}|||0", name));
}

TEST_F(Authorship, IsFoundByEachWayToWriteAName) {
    for (const auto& [name, student] :
         std::map<std::string, std::string>{{"gina.zip", "gina"},
                                            {"Gina Rossi.zip", "gina"},
                                            {"rossi gina/", "gina"},
                                            {"gina@uni.example.tar.gz", "gina"},
                                            {"gina (2).zip", "gina"},
                                            {"\u202egina.tgz", "gina"},
                                            {"Gina Rossi_77_assignsubmission_file_/", "gina"},
                                            {"Gina Rossi_77_assignsubmission_file_hand-in.zip", "gina"},
                                            {"rossigina_12345_67890_task.glsl", "gina"},
                                            {"somebodyelse_12345_67890_task.glsl", "gina"},
                                            {"Zo\u00eb OBrien-Li_5_assignsubmission_file_/", "zoe"},
                                            {"Zoe\u0308 O'Brien-Li.zip", "zoe"},
                                            {"zo\u00ebobrienli_LATE_4_5_x.zip", "zoe"},
                                            {"obrienlizo\u00eb_4_5_x.zip", "zoe"},
                                            {"ZB07.zip", "zoe"},
                                            {"beethovenludwigvan_4_5_x.zip", "ludwig"},
                                            {"vanbeethovenludwig_4_5_x.zip", "ludwig"},
                                            {"900001.zip", "ludwig"},
                                            {"Team A_17_assignsubmission_file_/", "Team A"},
                                            {"team-a.zip", "Team A"},
                                            {"anna1.zip", "anna1"}}) {
        const HandIns found = assigned({name}, a_roster());
        ASSERT_EQ(found.all.size(), 1u) << name;
        EXPECT_EQ(found.all[0].name, student) << name;
    }
    EXPECT_EQ(assigned({"Team A.zip"}, a_roster()).all[0].team, "Team A");
    EXPECT_EQ(assigned({"ludwig.zip"}, a_roster()).all[0].team, "Team A");
    EXPECT_EQ(assigned({"gina.zip"}, a_roster()).all[0].team, "");
}

TEST_F(Authorship, ThatIsUnclearOrUnknownIsNobodys) {
    const HandIns two = assigned({"Anna Berg_5_assignsubmission_file_/"}, a_roster());
    ASSERT_EQ(two.all.size(), 1u);
    EXPECT_EQ(two.all[0].name, "Anna Berg_5");
    EXPECT_EQ(two.notes, Lines{"'Anna Berg_5' may be of anna1 or anna2: rename it"});
    for (const char* name : {"Gin Rossi.zip", "gina rossi smith.zip", "rossi.zip", "12345.zip", "...zip",
                             "$(touch x).zip", "g\xfcna.zip"}) {
        const HandIns found = assigned({name}, a_roster());
        ASSERT_EQ(found.all.size(), 1u) << name;
        const Lines students = {"gina", "zoe", "ludwig", "anna1", "anna2", "Team A"};
        EXPECT_EQ(std::find(students.begin(), students.end(), found.all[0].name), students.end()) << name;
    }
}

TEST_F(Authorship, ByTheNumberOfAMoodleWorksheetDecidesWhereNamesAreEqualOrMissing) {
    ClassFile policy = a_roster();
    policy.students[3].email = "a1@uni.example";
    policy.students[4].email = "a2@uni.example";
    const fs::path sheet =
        folder.write("sheet.csv",
                     "Identifier,Full name,Email address,Grade\nParticipant 11,Anna Berg,A2@uni.example,"
                     "\nParticipant 12,Gina Rossi,gina@uni.example,\n");
    policy.labs.push_back({.folder = "13_displacement", .tasks = {}, .due = {}, .canvas = {}, .moodle = sheet});
    EXPECT_EQ(owners({"Anna Berg_11_assignsubmission_file_/", "Participant_12_assignsubmission_file_/"}, policy),
              (Lines{"anna2: Anna Berg_11_assignsubmission_file_", "gina: Participant_12_assignsubmission_file_"}));
}

TEST_F(Authorship, TheLatestCopyCountsAndTheOthersAreNamed) {
    const HandIns found = assigned({"gina.zip", "gina (2).zip", "Gina Rossi (1).zip"}, a_roster());
    ASSERT_EQ(found.all.size(), 1u);
    EXPECT_EQ(found.all[0].name, "gina");
    ASSERT_EQ(found.all[0].parts.size(), 1u);
    EXPECT_EQ(found.all[0].parts[0].path.filename(), "gina (2).zip");
    EXPECT_EQ(found.all[0].remarks,
              Lines{"'gina (2).zip' counts, and not 'Gina Rossi (1).zip', 'gina.zip': its number is "
                    "that of the later copy"});
    ClassFile numbered;
    numbered.students = {{.student = "jane-1"}, {.student = "jane-2"}};
    EXPECT_EQ(owners({"jane-1.zip", "jane-2.zip", "jane-1 (1).zip"}, numbered),
              (Lines{"jane-1: jane-1 (1).zip", "jane-2: jane-2.zip"}))
        << "a number that is part of the name is none of a copy";
    const HandIns equal = assigned({"a/gina.zip", "b/Gina Rossi.tar"}, a_roster());
    EXPECT_TRUE(equal.all.empty());
    ASSERT_EQ(equal.doubled.size(), 1u) << "nothing tells which is newer";
    EXPECT_EQ(equal.doubled[0].name, "gina");
    EXPECT_TRUE(contains(equal.doubled[0].message, "2 submissions are named 'gina', so none of them is graded"));
}

TEST_F(Authorship, FilesFromOneDownloadAreOneSubmission) {
    EXPECT_EQ(owners({"rossigina_12345_10_task.glsl", "obrienlizo\u00eb_7_30_task.glsl",
                      "rossigina_LATE_12345_20_task.cpp", "zoeobrienli_7_text.html"},
                     a_roster()),
              (Lines{"gina: rossigina_12345_10_task.glsl + rossigina_LATE_12345_20_task.cpp",
                     "zoe: obrienlizo\u00eb_7_30_task.glsl"}));
    EXPECT_EQ(owners({"a3/Gina Rossi_1_assignsubmission_file_/", "a4/Gina Rossi_9_assignsubmission_file_/",
                      "a4/Gina Rossi_9_assignsubmission_onlinetext_/"},
                     a_roster()),
              Lines{"gina: Gina Rossi_1_assignsubmission_file_ + Gina Rossi_9_assignsubmission_file_"})
        << "of two assignments";
}

TEST_F(Authorship, WithoutARosterNumbersKeepEqualNamesApart) {
    EXPECT_EQ(
        owners({"Gina Rossi_1_assignsubmission_file_/", "Gina Rossi_2_assignsubmission_file_/",
                "rossigina_3_4_task.glsl", "jane.zip", "jane (1).zip", "joe (1).zip"},
               {}),
        (Lines{"Gina Rossi_1: Gina Rossi_1_assignsubmission_file_", "Gina Rossi_2: Gina Rossi_2_assignsubmission_file_",
               "rossigina_3: rossigina_3_4_task.glsl", "jane: jane (1).zip", "joe (1): joe (1).zip"}));
}

}  // namespace
}  // namespace relief::grade
