// Files are read as a whole, and written as a whole or not at all.
#include "framework/core/base/file.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <algorithm>
#include <csignal>

#include "framework/core/base/parallel.h"
#include "tests/support.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

TEST(Files, AreReadBackByteForByte) {
    const TemporaryFolder folder;
    std::string bytes;
    for (int i = 0; i < 70000; ++i) bytes += char(i * 7);
    for (const std::string& text : {std::string(), std::string("\0\r\n\xff", 4), bytes}) {
        write_file(folder.path() / "a.bin", text);
        EXPECT_EQ(read_file(folder.path() / "a.bin"), text) << text.size() << " bytes";
    }
    EXPECT_EQ(names_in(folder.path()), std::vector<std::string>{"a.bin"}) << "nothing is left beside it";
}

TEST(Files, ReadErrorsNameTheFileAndTheReason) {
    const TemporaryFolder folder;
    const fs::path missing = folder.path() / "missing.txt";
    EXPECT_EQ(message_of([&] { read_file(missing); }), missing.string() + ": cannot read: No such file or directory");
    EXPECT_EQ(message_of([&] { read_file(folder.path()); }), folder.path().string() + ": cannot read: not a file");
    const fs::path file = folder.write("a.txt", "12345");
    EXPECT_EQ(message_of([&] { read_file(file, 4); }), file.string() + ": cannot read: 5 bytes, the limit is 4");
    EXPECT_EQ(read_file(file, 5), "12345");
}

TEST(Files, AnUnwritablePlaceIsNamedAndLeftAlone) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("a.txt", "x");
    // Not even root can write into /proc, below a file, or below a folder that does not exist.
    for (const fs::path& target : {fs::path("/proc/relief.txt"), file / "b.txt", folder.path() / "no" / "b.txt"}) {
        const std::string message = message_of([&] { write_file(target, "y"); });
        EXPECT_TRUE(message.starts_with(target.string() + ": cannot write: ")) << message;
    }
    EXPECT_EQ(message_of([&] { write_file(folder.path(), "y"); }),
              folder.path().string() + ": cannot write: it is a folder, name a file in it");
    EXPECT_EQ(names_in(folder.path()), std::vector<std::string>{"a.txt"});
}

TEST(Files, ATerminatedWriteKeepsTheOldFileAndLeavesNoTemporary) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("a.txt", "old");
    const auto terminated = [&] {
        clean_up_when_interrupted();
        const rlimit small{1000, 1000};  // of a file's size
        setrlimit(RLIMIT_FSIZE, &small);
        std::signal(SIGXFSZ, [](int) { std::raise(SIGTERM); });  // arrives during the write
        write_file(file, std::string(5000, 'n'));
    };
    EXPECT_EXIT(terminated(), testing::ExitedWithCode(128 + SIGTERM), "");
    EXPECT_EQ(read_file(file), "old");
    EXPECT_EQ(names_in(folder.path()), std::vector<std::string>{"a.txt"});
}

// Processes in different PID namespaces, or on different machines, can have the same process id.
TEST(Files, WritersWithEqualProcessIdsDoNotCollide) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "a.txt";
    const auto text = [](size_t writer) { return std::string(20000, char('a' + writer)); };
    parallel_each(400, 4, [&](size_t i) { EXPECT_NO_THROW(write_file(file, text(i % 4))); });
    const std::string left = read_file(file);
    EXPECT_EQ(left, text(size_t(left.at(0) - 'a'))) << "half of one and half of another";
    EXPECT_EQ(names_in(folder.path()), std::vector<std::string>{"a.txt"});
}

TEST(Files, PrivateOnesAreReadableOnlyByTheirOwner) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("a.txt", "for all");
    fs::permissions(file, fs::perms(0644));
    write_private_file(file, "for me");
    EXPECT_EQ(read_file(file), "for me");
    EXPECT_EQ(fs::status(file).permissions(), fs::perms(0600));
}

TEST(Files, APipeOrADeviceIsWrittenIntoNotReplaced) {
    const TemporaryFolder folder;
    const fs::path pipe = folder.path() / "pipe", full = folder.path() / "full";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const int reader = open(pipe.c_str(), O_RDWR | O_NONBLOCK);
    write_file(pipe, "x");
    char got = 0;
    EXPECT_EQ(read(reader, &got, 1), 1);
    EXPECT_EQ(got, 'x');
    EXPECT_TRUE(fs::is_fifo(pipe));
    close(reader);
    fs::create_symlink("/dev/full", full);  // through a link, so that a bug cannot replace the device
    EXPECT_EQ(message_of([&] { write_file(full, "x"); }), full.string() + ": cannot write: No space left on device");
    EXPECT_TRUE(fs::is_symlink(full));
}

TEST(Files, APipeWithoutAWriterIsRefusedNotWaitedFor) {
    const TemporaryFolder folder;
    const std::filesystem::path pipe = folder.path() / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_TRUE(contains(message_of([&] { read_file(pipe); }), "pipe: cannot read: not a file"));
}

TEST(Files, ALinkStaysALink) {
    const TemporaryFolder folder;
    folder.write("real.txt", "old");
    std::filesystem::create_symlink("real.txt", folder.path() / "link.txt");
    write_file(folder.path() / "link.txt", "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link.txt"));
    EXPECT_EQ(read_file(folder.path() / "real.txt"), "new");
}

TEST(Folders, AreCreatedWithTheirParentsAndMayExist) {
    const TemporaryFolder folder;
    make_folder(folder.path() / "a" / "b");
    make_folder(folder.path() / "a" / "b");
    EXPECT_TRUE(fs::is_directory(folder.path() / "a" / "b"));
    const fs::path below_file = folder.write("file", "x") / "c";
    const std::string message = message_of([&] { make_folder(below_file); });
    EXPECT_TRUE(message.starts_with(below_file.string() + ": cannot make this folder: ")) << message;
}

}  // namespace
}  // namespace relief
