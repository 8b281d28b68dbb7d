// Delivery of files into a folder where a student works: which file belongs to whom afterwards.
#include "framework/staff/handout/delivery.h"

#include <sys/resource.h>

#include <csignal>

#include "framework/core/base/file.h"
#include "tests/support.h"

namespace relief::handout {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

/// While an instance exists, no file of this process may become larger than 64 KiB, as on a full disk.
class SmallFilesOnly {
public:
    SmallFilesOnly() {
        getrlimit(RLIMIT_FSIZE, &before_);
        set(65536);
    }
    ~SmallFilesOnly() { set(before_.rlim_cur); }

private:
    void set(rlim_t size) const {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{size, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    rlimit before_{};
};

/// A folder into which a first version was handed out.
class DeliveryTest : public testing::Test {
protected:
    DeliveryTest() { deliver(first_, "1", folder_); }

    fs::path file(const std::string& name) const { return folder_ / name; }
    std::string text(const std::string& name) const { return read_file(folder_ / name); }
    void write(const std::string& name, const std::string& text) const {
        make_folder(file(name).parent_path());
        write_file(file(name), text);
    }
    Delivery again(const HandedFiles& files) const { return deliver(files, "1", folder_); }
    Delivery again_with(const std::string& name, const std::string& text) const {
        HandedFiles files = first_;
        files[name] = {text};
        return again(files);
    }
    /// Returns the text of every regular file below a folder.
    static std::map<std::string, std::string> all_below(const fs::path& folder) {
        std::map<std::string, std::string> all;
        for (const auto& entry : fs::recursive_directory_iterator(folder))
            if (entry.is_regular_file() && !entry.is_symlink())
                all[entry.path().lexically_relative(folder)] = read_file(entry.path());
        return all;
    }

    const TemporaryFolder outer_;
    const fs::path folder_ = outer_.path() / "a course";
    const HandedFiles first_ = {{"README.md", {"read me"}},
                                {"relief", {"#!run", true}},
                                {"labs/01/task.cpp", {"starter 1"}},
                                {"labs/01/lab.toml", {"lab 1"}}};
};

TEST_F(DeliveryTest, ANewFolderHasEveryFileAndOnlyTheRecordBesides) {
    std::map<std::string, std::string> all = all_below(folder_);
    EXPECT_EQ(all.erase(".relief-handout"), 1u);
    EXPECT_EQ(all.size(), first_.size());
    for (const auto& [name, file] : first_) EXPECT_EQ(all[name], file.bytes) << name;
    EXPECT_NE(fs::status(file("relief")).permissions() & fs::perms::owner_exec, fs::perms::none);
    EXPECT_EQ(fs::status(file("README.md")).permissions() & fs::perms::owner_exec, fs::perms::none);
    EXPECT_FALSE(fs::exists(folder_.string() + ".part"));
    EXPECT_EQ(delivered_choice(folder_), "1");
}

TEST_F(DeliveryTest, DeliveringTheSameFilesChangesNothing) {
    const auto before = fs::last_write_time(file(".relief-handout"));
    EXPECT_TRUE(again(first_).changed_nothing());
    EXPECT_EQ(fs::last_write_time(file(".relief-handout")), before);
}

TEST_F(DeliveryTest, UneditedFilesAreUpdated) {
    const Delivery done = again_with("labs/01/task.cpp", "starter 2");
    EXPECT_EQ(done.updated, Names{"labs/01/task.cpp"});
    EXPECT_EQ(text("labs/01/task.cpp"), "starter 2");
    EXPECT_TRUE(done.added.empty() && done.removed.empty() && done.kept.empty());
}

TEST_F(DeliveryTest, EditedFilesAreKeptAndTheNewTextIsWrittenBeside) {
    write("labs/01/task.cpp", "my work");
    EXPECT_TRUE(again(first_).changed_nothing()) << "the course has no news";
    EXPECT_FALSE(fs::exists(file("labs/01/task.cpp.new")));

    const Delivery done = again_with("labs/01/task.cpp", "starter 2");
    ASSERT_EQ(done.kept.size(), 1u);
    EXPECT_EQ(done.kept[0].file, "labs/01/task.cpp");
    EXPECT_EQ(done.kept[0].beside, "labs/01/task.cpp.new");
    EXPECT_EQ(text("labs/01/task.cpp"), "my work");
    EXPECT_EQ(text("labs/01/task.cpp.new"), "starter 2");

    EXPECT_TRUE(again_with("labs/01/task.cpp", "starter 2").changed_nothing()) << "said once";
    again_with("labs/01/task.cpp", "starter 3");
    EXPECT_EQ(text("labs/01/task.cpp"), "my work");
    EXPECT_EQ(text("labs/01/task.cpp.new"), "starter 3");
    EXPECT_FALSE(fs::exists(file("labs/01/task.cpp.new2"))) << "what nobody changed is renewed there too";
}

TEST_F(DeliveryTest, ExistingNewFilesAreNotOverwritten) {
    write("labs/01/task.cpp", "my work");
    write("labs/01/task.cpp.new", "my notes");
    const Delivery done = again_with("labs/01/task.cpp", "starter 2");
    EXPECT_EQ(text("labs/01/task.cpp.new"), "my notes");
    EXPECT_EQ(text("labs/01/task.cpp.new2"), "starter 2");
    write("labs/01/task.cpp.new2", "half taken over");
    again_with("labs/01/task.cpp", "starter 3");
    EXPECT_EQ(text("labs/01/task.cpp.new2"), "half taken over");
    EXPECT_EQ(text("labs/01/task.cpp.new3"), "starter 3");
}

TEST_F(DeliveryTest, AnAcceptedNewTextCountsAsUnedited) {
    write("labs/01/task.cpp", "my work");
    again_with("labs/01/task.cpp", "starter 2");
    write("labs/01/task.cpp", "starter 2");
    const Delivery done = again_with("labs/01/task.cpp", "starter 2");
    EXPECT_EQ(done.removed, Names{"labs/01/task.cpp.new"}) << "it has done its duty";
    EXPECT_EQ(again_with("labs/01/task.cpp", "starter 3").updated, Names{"labs/01/task.cpp"});
}

TEST_F(DeliveryTest, AStudentsFileIsKeptWhereTheCourseAddsOne) {
    write("labs/02/task.cpp", "what I had found before");
    const Delivery done = again_with("labs/02/task.cpp", "starter");
    EXPECT_EQ(text("labs/02/task.cpp"), "what I had found before");
    EXPECT_EQ(text("labs/02/task.cpp.new"), "starter");
    EXPECT_EQ(done.kept.size(), 1u);
}

TEST_F(DeliveryTest, MissingFilesAreRestoredAndExtraFilesAreKept) {
    fs::remove(file("README.md"));
    write("notes/mine.txt", "mine");
    EXPECT_EQ(again(first_).added, Names{"README.md"});
    EXPECT_EQ(text("README.md"), "read me");
    EXPECT_EQ(text("notes/mine.txt"), "mine");
}

TEST_F(DeliveryTest, FilesDroppedByTheCourseAreRemovedUnlessEdited) {
    write("labs/01/task.cpp", "my work");
    HandedFiles less = first_;
    less.erase("labs/01/task.cpp"), less.erase("labs/01/lab.toml"), less.erase("relief");
    const Delivery done = again(less);
    EXPECT_EQ(done.removed, (Names{"labs/01/lab.toml", "relief"}));
    ASSERT_EQ(done.kept.size(), 1u);
    EXPECT_EQ(done.kept[0].file, "labs/01/task.cpp");
    EXPECT_EQ(done.kept[0].beside, "");
    EXPECT_EQ(text("labs/01/task.cpp"), "my work");
    EXPECT_TRUE(again(less).changed_nothing());

    fs::remove(file("labs/01/task.cpp"));
    again(first_);
    again(less);
    EXPECT_FALSE(fs::exists(file("labs"))) << "a folder that is empty then goes too";
}

TEST_F(DeliveryTest, LinksAreNeverFollowed) {
    const fs::path outside = outer_.path() / "outside";
    make_folder(outside / "labs/01");
    write_file(outside / "labs/01/task.cpp", "starter 1");
    write_file(outside / "readme", "read me");
    const auto before = all_below(outside);
    fs::remove_all(file("labs")), fs::create_directory_symlink(outside / "labs", file("labs"));
    fs::remove(file("README.md")), fs::create_symlink(outside / "readme", file("README.md"));

    HandedFiles second = first_;
    second["labs/01/task.cpp"] = {"starter 2"}, second["labs/02/lab.toml"] = {"lab 2"}, second["README.md"] = {"new"};
    second.erase("labs/01/lab.toml");
    const Delivery done = again(second);
    EXPECT_EQ(all_below(outside), before);
    EXPECT_EQ(done.not_open, Names{"labs"}) << "said once, not for each file behind it";
    EXPECT_TRUE(fs::is_symlink(file("README.md")));
    EXPECT_EQ(text("README.md.new"), "new");

    fs::remove(file("labs"));
    EXPECT_EQ(again(second).added, (Names{"labs/01/task.cpp", "labs/02/lab.toml"}));
}

TEST_F(DeliveryTest, AFolderInPlaceOfAFileAndViceVersaIsKept) {
    fs::remove(file("README.md")), make_folder(file("README.md"));
    fs::remove_all(file("labs")), write("labs", "I like files");
    const Delivery done = again_with("README.md", "new");
    EXPECT_TRUE(fs::is_directory(file("README.md")));
    EXPECT_EQ(text("README.md.new"), "new");
    EXPECT_EQ(text("labs"), "I like files");
    EXPECT_EQ(done.not_open, Names{"labs"});
}

TEST_F(DeliveryTest, AnInterruptedRunIsCompletedByTheNext) {
    HandedFiles second;
    for (const auto& [name, file] : first_) second[name] = {file.bytes + ", second", file.executable};
    second["labs/02/lab.toml"] = {"lab 2"};
    write("labs/01/task.cpp", "my work");
    second["zz"] = {std::string(100000, 'z')};  // the last file is too large: the run fails before it is recorded
    {
        const SmallFilesOnly limit;
        EXPECT_THROW(again(second), Error);
    }
    EXPECT_EQ(text("README.md"), "read me, second") << "so the run had begun";
    second.erase(std::prev(second.end()));
    second["README.md"] = {"read me, third"};  // meanwhile the course changes again

    const Delivery done = again(second);
    EXPECT_EQ(text("labs/01/task.cpp"), "my work");
    EXPECT_EQ(text("labs/01/task.cpp.new"), "starter 1, second");
    EXPECT_EQ(text("README.md"), "read me, third") << "not taken for the student's work";
    EXPECT_EQ(text("labs/02/lab.toml"), "lab 2");
    ASSERT_EQ(done.kept.size(), 1u) << "what the interrupted run could not say is said now";
    EXPECT_TRUE(again(second).changed_nothing());
}

TEST_F(DeliveryTest, AnotherFolderIsRefusedAndNotTouched) {
    const TemporaryFolder other;
    other.write("thesis.txt", "years");
    const std::string message = message_of([&] { deliver(first_, "1", other.path()); });
    EXPECT_TRUE(contains(message, "is there already, not empty and not a handout")) << message;
    EXPECT_EQ(all_below(other.path()).size(), 1u);
    EXPECT_TRUE(contains(message_of([&] { deliver(first_, "1", other.path() / "thesis.txt"); }), "is there already"));
}

TEST_F(DeliveryTest, ATamperedRecordIsReportedAndReachesNothingOutside) {
    const std::string record = text(".relief-handout");
    write(".relief-handout", "nonsense\n" + record);
    const std::string message = message_of([&] { again(first_); });
    EXPECT_TRUE(contains(message, ".relief-handout:1: is not a line of a handout's record")) << message;

    write_file(outer_.path() / "outside.txt", "read me");
    const std::string mark = record.substr(record.find(" README.md") - 16, 16);  // outside.txt has the same text
    for (const std::string& path : {std::string("../outside.txt"), (outer_.path() / "outside.txt").string()}) {
        write(".relief-handout", record + mark + " " + path + "\n");
        EXPECT_TRUE(contains(message_of([&] { again(first_); }), "is not a path below a folder")) << path;
        EXPECT_TRUE(fs::exists(outer_.path() / "outside.txt"));
    }
}

}  // namespace
}  // namespace relief::handout
