// Which files of a submission are read. Hostile submissions must not harm the reader.
#include "framework/staff/grade/submission.h"

#include <fmt/format.h>
#include <unistd.h>

#include "framework/core/base/sha256.h"
#include "tests/process.h"
#include "tests/support.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;

const std::set<std::string> wanted = {"shaders/01_a/task.glsl", "labs/05_b/task.cpp"};
constexpr const char* shader = "shaders/01_a/task.glsl";
using Remarks = std::vector<std::string>;

/// Makes an archive with a few lines of Python, such as no honest program would write.
fs::path python(const TemporaryFolder& folder, const std::string& name, const std::string& lines) {
    const fs::path path = folder.path() / name;
    const Result made =
        run({"python3", "-c", "import io, sys, tarfile, zipfile\npath = sys.argv[1]\n" + lines, path.string()});
    EXPECT_EQ(made.code, 0) << made.err;
    return path;
}

TEST(Sha256, IsThatOfThePublishedExamples) {  // the examples of FIPS 180-4, and the empty text
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Submission, OfAFolderIsItsTaskFilesAtAnyDepth) {
    const TemporaryFolder folder;
    folder.write("jane/my work/shaders/01_a/task.glsl", "mine");
    folder.write("jane/old/my work/shaders/01_a/task.glsl", "older");
    folder.write("jane/labs/05_b/task.cpp", "int x;");
    folder.write("jane/notes.txt", "");
    const Submission found = read_submission(folder.path() / "jane", wanted);
    EXPECT_EQ(found.name, "jane");
    EXPECT_EQ(found.files, (std::map<std::string, std::string>{{shader, "mine"}, {"labs/05_b/task.cpp", "int x;"}}));
    EXPECT_EQ(found.ignored_count, 2u);
    EXPECT_EQ(found.problem, "");
}

TEST(Submission, OfAnArchiveEqualsThatOfItsFolder) {
    const TemporaryFolder folder;
    folder.write("jane/shaders/01_a/task.glsl", "mine");
    folder.write("jane/build/huge.o", std::string(3 << 20, 'x'));
    const Submission plain = read_submission(folder.path() / "jane", wanted);
    EXPECT_EQ(plain.hash.size(), 64u);
    for (const char* kind : {"tar", "tar.gz", "tgz", "tar.xz"}) {
        const fs::path archive = folder.path() / (std::string("jane.") + kind);
        // Python packs by itself, while tar needs another program (xz-utils).
        ASSERT_EQ(run({"python3", "-m", "tarfile", "-c", archive.string(), "jane"}, {folder.path(), {}}).code, 0);
        const Submission packed = read_submission(archive, wanted);
        EXPECT_EQ(packed.problem, "") << kind;
        EXPECT_EQ(packed.name, "jane") << kind;
        EXPECT_EQ(packed.hash, plain.hash) << kind;
        EXPECT_EQ(packed.ignored_count, plain.ignored_count) << kind;
    }
    const fs::path zip = python(folder, "jane.zip", R"(
with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as z:
    z.writestr("jane\\shaders\\01_a\\task.glsl", "mine"))");
    EXPECT_EQ(read_submission(zip, wanted).hash, plain.hash);
    EXPECT_EQ(submission_name("a/JANE.ZIP"), "JANE") << "as some systems write it";
    EXPECT_EQ(submission_name("a/Zoe\u0308.zip"), "Zo\u00eb") << "as macOS writes it";
    folder.write("jane/shaders/01_a/task.glsl", "mine!");
    EXPECT_NE(read_submission(folder.path() / "jane", wanted).hash, plain.hash);
}

TEST(Submission, MayBePackedInAFolderOfAnyName) {
    const TemporaryFolder folder;
    const char* const place =
        "\xc3\x9c"
        "bung f\xc3\xbcr J\xc3\xb6rg/shaders/01_a/task.glsl";
    const std::string name = std::string("'") + place + "'";
    const fs::path zip =
        python(folder, "a.zip", "z = zipfile.ZipFile(path, 'w'); z.writestr(" + name + ", 'mine'); z.close()");
    const fs::path pax = python(folder, "b.tar",
                                "t = tarfile.open(path, 'w', format=tarfile.PAX_FORMAT); i = tarfile.TarInfo(" + name +
                                    "); i.size = 4; t.addfile(i, io.BytesIO(b'mine')); t.close()");
    for (const fs::path& archive : {zip, pax}) {
        const Submission found = read_submission(archive, wanted);
        EXPECT_EQ(found.problem, "") << archive;
        EXPECT_EQ(found.files, (std::map<std::string, std::string>{{shader, "mine"}})) << archive;
    }
}

TEST(Submission, ReportsWhichOfSeveralFoldersIsGraded) {
    const TemporaryFolder folder;
    for (const char* name : {"jane", "joe"}) folder.write(name + std::string("/") + shader, name);
    const auto remarks = [&](const fs::path& path) { return read_submission(path, wanted).remarks; };
    EXPECT_EQ(remarks(folder.path()),
              Remarks{"'jane/shaders/01_a/task.glsl' is graded, and not 'joe/shaders/01_a/task.glsl': it is the first "
                      "by name. Are these several submissions?"});
    folder.write(shader, "mine");
    EXPECT_EQ(remarks(folder.path()), Remarks{"'shaders/01_a/task.glsl' is graded, and not "
                                              "'jane/shaders/01_a/task.glsl' and 1 more: it is in fewer folders"});
    EXPECT_EQ(remarks(folder.path() / "joe"), Remarks{});
    folder.write("twin/a/" + std::string(shader), "mine");
    folder.write("twin/b/" + std::string(shader), "mine");
    EXPECT_EQ(remarks(folder.path() / "twin"), Remarks{}) << "the same text is no other version";
    folder.write("late/work (1)/" + std::string(shader), "new");
    folder.write("late/work/" + std::string(shader), "old");
    EXPECT_EQ(read_submission(folder.path() / "late", wanted).files.at(shader), "new");
    EXPECT_EQ(remarks(folder.path() / "late"),
              Remarks{"'work (1)/shaders/01_a/task.glsl' is graded, and not 'work/shaders/01_a/task.glsl': its number "
                      "is that of the later copy"});
}

TEST(Submission, AFileWithANearNameIsGradedIfThereIsNoOther) {
    const std::string told = "// TASK 1.2 (3 points): what?\nmine";
    for (const auto& [name, text] :
         std::vector<std::pair<std::string, std::string>>{{"shaders/01_a/task (1).glsl", "mine"},
                                                          {"shaders/01_a/Task.glsl", "mine"},
                                                          {"shaders/01_a/task.glsl.txt", "mine"},
                                                          {"SHADERS/01_A/TASK.GLSL", "mine"},
                                                          {"01_a/task.glsl", "mine"},
                                                          {"lab01.glsl", "mine"},
                                                          {"Lab 1 task.glsl", "mine"},
                                                          {"task.glsl", told},
                                                          {"my work/task_final.glsl", told},
                                                          {"\u00dcbung/lab_1/task-2.glsl", "mine"}}) {
        const TemporaryFolder folder;
        folder.write("jane/" + name, text);
        folder.write("jane/shaders/01_a/surface.frag", "");
        const Submission found = read_submission(folder.path() / "jane", wanted);
        EXPECT_EQ(found.files, (std::map<std::string, std::string>{{shader, text}})) << name;
        EXPECT_EQ(found.remarks, Remarks{"'" + name +
                                         "' is graded as shaders/01_a/task.glsl, since there is no file "
                                         "of that name and place"});
        folder.write(std::string("jane/") + shader, "right");
        const Submission both = read_submission(folder.path() / "jane", wanted);
        EXPECT_EQ(both.files, (std::map<std::string, std::string>{{shader, "right"}})) << name;
        EXPECT_EQ(both.remarks, Remarks{"'shaders/01_a/task.glsl' is graded, and not '" + name +
                                        "': it has the name that is asked for"});
    }
}

TEST(Submission, OfNearNamesTheLatestCopyCounts) {
    const TemporaryFolder folder;
    for (const char* number : {"1", "10", "2"})
        folder.write(std::string("shaders/01_a/task (") + number + ").glsl", number);
    const Submission found = read_submission(folder.path(), wanted);
    EXPECT_EQ(found.files.at(shader), "10");
    EXPECT_EQ(
        found.remarks,
        Remarks{"'shaders/01_a/task (10).glsl' is graded as shaders/01_a/task.glsl, since there is no file of that "
                "name and place; and not 'shaders/01_a/task (2).glsl' and 1 more: its number is that of the later "
                "copy"});
}

TEST(Submission, AFileOfAnUnknownLabIsReported) {
    const TemporaryFolder folder;
    const std::set<std::string> two = {"shaders/01_a/task.glsl", "shaders/02_b/task.glsl"};
    folder.write("task.glsl", "float x;");
    const Submission found = read_submission(folder.path(), two);
    EXPECT_TRUE(found.files.empty());
    EXPECT_EQ(found.remarks, Remarks{"'task.glsl' is not graded: neither its folder nor a line // TASK 1.1 in it names "
                                     "its lab"});
    folder.write("task.glsl", "// TASK 3.1");
    EXPECT_TRUE(read_submission(folder.path(), two).files.empty()) << "of a lab that is not graded";
    folder.write("task.glsl", "// TASK 2.1");
    EXPECT_EQ(read_submission(folder.path(), two).files.begin()->first, "shaders/02_b/task.glsl");
}

TEST(Submission, LeftoversOfEditorsAreNoVersions) {
    const TemporaryFolder folder;
    folder.write(shader, "mine");
    for (const char* ending : {"~", ".bak", ".orig", ".new"}) folder.write(shader + std::string(ending), "older");
    folder.write("shaders/01_a/._task.glsl", "Mac OS X");
    const Submission found = read_submission(folder.path(), wanted);
    EXPECT_EQ(found.files.at(shader), "mine");
    EXPECT_EQ(found.remarks, Remarks{});
    fs::remove(folder.path() / shader);
    EXPECT_EQ(read_submission(folder.path(), wanted).files.at(shader), "older")
        << "but of these .bak is better than none";
}

TEST(Submission, AnArchiveInsideIsReadIfThereIsNoTaskFileBesideIt) {
    const TemporaryFolder folder;
    const auto zipped = [&](const std::string& place, const std::string& inside) {
        fs::create_directories((folder.path() / place).parent_path());
        return python(folder, place, "z = zipfile.ZipFile(path, 'w'); " + inside + "; z.close()");
    };
    const std::string task = "z.writestr('shaders/01_a/task.glsl', 'packed')";
    zipped("jane/hand-in.zip", task);
    zipped("jane/older/broken.zip", "z.writestr('x', '')");
    folder.write("jane/damaged.zip", "no archive");
    const Submission found = read_submission(folder.path() / "jane", wanted);
    EXPECT_EQ(found.files, (std::map<std::string, std::string>{{shader, "packed"}}));
    ASSERT_EQ(found.remarks.size(), 1u);
    EXPECT_TRUE(contains(found.remarks[0], "'damaged.zip' cannot be read: not a zip or tar archive"));
    const Submission outer = read_submission(
        zipped("outer.zip", "z.write('" + (folder.path() / "jane/hand-in.zip").string() + "', 'x/hand-in.zip')"),
        wanted);
    EXPECT_EQ(outer.files, (std::map<std::string, std::string>{{shader, "packed"}})) << outer.problem;
    const Submission third = read_submission(
        zipped("third.zip", "z.write('" + (folder.path() / "outer.zip").string() + "', 'outer.zip')"), wanted);
    EXPECT_TRUE(third.files.empty()) << "an archive in an archive in an archive is not opened";
    folder.write(std::string("jane/") + shader, "mine");
    EXPECT_EQ(read_submission(folder.path() / "jane", wanted).files.at(shader), "mine");
    zipped("joe/work.zip", task);
    zipped("joe/work (1).zip", "z.writestr('shaders/01_a/task.glsl', 'newer')");
    const Submission later = read_submission(folder.path() / "joe", wanted);
    EXPECT_EQ(later.files.at(shader), "newer");
    ASSERT_EQ(later.remarks.size(), 1u);
    EXPECT_TRUE(contains(later.remarks[0], "its number is that of the later copy")) << later.remarks[0];
    zipped("bad/escape.zip",
           "z.writestr('../shaders/01_a/task.glsl', 'bad'); z.writestr('/shaders/01_a/task.glsl', 'bad')");
    EXPECT_TRUE(read_submission(folder.path() / "bad", wanted).files.empty());
}

TEST(Submission, OfSeveralUploadsTheLaterOneCounts) {
    const TemporaryFolder folder;
    const fs::path first = folder.write("rossigina_1_20_task.glsl", "older"),
                   second = folder.write("rossigina_1_30_task.glsl", "newer"),
                   third = folder.write("rossigina_1_40_task.cpp", "int x;");
    const Submission found =
        read_submission("gina", {{second, "task.glsl", 30}, {first, "task.glsl", 20}, {third, "task.cpp", 40}}, wanted);
    EXPECT_EQ(found.files, (std::map<std::string, std::string>{{shader, "newer"}, {"labs/05_b/task.cpp", "int x;"}}));
}

TEST(Submission, TakesTheLastOfDuplicateFilesInAnArchive) {
    const TemporaryFolder folder;
    const fs::path tar = python(folder, "a.tar", R"(
with tarfile.open(path, "w") as t:
    for text in (b"older", b"newer"):
        i = tarfile.TarInfo("shaders/01_a/task.glsl"); i.size = 5; t.addfile(i, io.BytesIO(text)))");
    EXPECT_EQ(read_submission(tar, wanted).files.at(shader), "newer");
}

TEST(Submission, IsReadDespiteBrokenOrCyclicLinks) {
    const TemporaryFolder folder;
    folder.write("jane/shaders/01_a/task.glsl", "mine");
    fs::create_symlink("loop", folder.path() / "jane/loop");
    fs::create_symlink("nowhere", folder.path() / "jane/dangling");
    fs::create_directory_symlink("..", folder.path() / "jane/up");
    const Submission found = read_submission(folder.path() / "jane", wanted);
    EXPECT_EQ(found.problem, "");
    EXPECT_EQ(found.files.at(shader), "mine");
    EXPECT_EQ(found.ignored_count, 3u);
}

TEST(Submission, IgnoresLinksAndPathsThatLeadOutside) {
    const TemporaryFolder folder;
    const fs::path secret = folder.write("secret/01_a/task.glsl", "secret");
    fs::create_directories(folder.path() / "jane/shaders/01_a");
    fs::create_symlink(secret, folder.path() / "jane" / shader);
    fs::create_directories(folder.path() / "joe");
    fs::create_directory_symlink(folder.path() / "secret", folder.path() / "joe/shaders");
    fs::create_directories(folder.path() / "jim/shaders/01_a");
    ASSERT_EQ(run({"mkfifo", (folder.path() / "jim" / shader).string()}).code, 0);
    for (const char* name : {"jane", "joe", "jim"}) {
        const Submission found = read_submission(folder.path() / name, wanted);
        EXPECT_TRUE(found.files.empty()) << name;
        EXPECT_EQ(found.problem, "") << name;
        EXPECT_EQ(found.ignored_count, 1u) << name;
    }
    const std::map<std::string, std::string> a_link{{shader, "a link, and links are not followed"}};
    EXPECT_EQ(read_submission(folder.path() / "jane", wanted).refused, a_link);
    EXPECT_EQ(read_submission(folder.path() / "joe", wanted).links, std::vector<std::string>{"shaders"});
    EXPECT_TRUE(read_submission(folder.path() / "jim", wanted).links.empty());
    folder.write("jane/work/shaders/01_a/task.glsl", "mine");
    EXPECT_EQ(read_submission(folder.path() / "jane", wanted).files.at(shader), "mine");
    EXPECT_TRUE(read_submission(folder.path() / "jane", wanted).refused.empty());
    const fs::path archive = python(folder, "links.tar", R"(
with tarfile.open(path, "w") as t:
    for name in ["../shaders/01_a/task.glsl", "/shaders/01_a/task.glsl", "a/../shaders/01_a/task.glsl"]:
        info = tarfile.TarInfo(name); info.size = 3; t.addfile(info, io.BytesIO(b"bad"))
    for kind in [tarfile.SYMTYPE, tarfile.LNKTYPE, tarfile.CHRTYPE, tarfile.FIFOTYPE]:
        info = tarfile.TarInfo("x/shaders/01_a/task.glsl"); info.type = kind; info.linkname = "/etc/passwd"; t.addfile(info))");
    const Submission found = read_submission(archive, wanted);
    EXPECT_TRUE(found.files.empty());
    EXPECT_EQ(found.problem, "");
    EXPECT_EQ(found.ignored_count, 7u);
    EXPECT_EQ(found.refused, a_link);
    EXPECT_FALSE(fs::exists(folder.path() / "shaders")) << "something was unpacked";
}

TEST(Submission, NamesWithQuotesAndNewlinesAreShownOnOneLine) {
    const TemporaryFolder folder;
    const std::string odd = "it's \"odd\"\n\x1b[31m & <b>.txt";
    folder.write("jane/" + odd, "");
    folder.write("jane/a\nb/shaders/01_a/task.glsl", "mine");
    const Submission found = read_submission(folder.path() / "jane", wanted);
    EXPECT_EQ(found.files.count(shader), 1u);
    ASSERT_EQ(found.ignored.size(), 1u);
    EXPECT_EQ(found.ignored[0], "it's \"odd\"\\x0a\\x1b[31m & <b>.txt");
}

TEST(Submission, AnUnreadableTaskIsAProblemAndNotMissing) {
    if (geteuid() == 0) GTEST_SKIP() << "root may read everything";
    const TemporaryFolder folder;
    folder.write("shaders/01_a/task.glsl", "mine");
    folder.write("notes/secret.txt", "");
    for (const char* name : {"shaders/01_a/task.glsl", "shaders/01_a", "notes"}) {
        const fs::path path = folder.path() / name;
        const fs::perms before = fs::status(path).permissions();
        fs::permissions(path, fs::perms::none);
        const Submission found = read_submission(folder.path(), wanted);
        fs::permissions(path, before);
        const bool is_others = std::string(name) == "notes";
        EXPECT_EQ(found.problem, is_others ? "" : fmt::format("cannot read '{}': Permission denied", name));
        EXPECT_EQ(found.files.size(), is_others ? 1u : 0u) << name;
    }
}

TEST(Submission, RefusesATaskFileOfMoreThanAMebibyte) {
    const TemporaryFolder folder;
    folder.write(std::string("jane/") + shader, std::string(10 << 20, ' '));
    folder.write(std::string("joe/") + shader, std::string(1 << 20, ' '));
    const fs::path archive = folder.path() / "jane.tar.gz";
    ASSERT_EQ(run({"tar", "-caf", archive.string(), "-C", folder.path().string(), "jane"}).code, 0);
    for (const fs::path& path : {folder.path() / "jane", archive}) {
        const Submission found = read_submission(path, wanted);
        EXPECT_TRUE(found.files.empty()) << path;
        ASSERT_EQ(found.refused.count(shader), 1u) << path;
        EXPECT_EQ(found.refused.at(shader), "larger than 1 MiB");
    }
    EXPECT_EQ(read_submission(folder.path() / "joe", wanted).files.count(shader), 1u);
}

TEST(Submission, StopsUnpackingAnArchiveThatExceedsTheLimit) {
    const TemporaryFolder folder;
    // A gzip file may consist of several concatenated ones: here 600 times the same MiB of zeros after a tar header.
    const fs::path tar = python(folder, "bomb.tar.gz", R"(
import gzip
info = tarfile.TarInfo("zeros"); info.size = 600 << 20
with open(path, "wb") as f: f.write(gzip.compress(info.tobuf()) + gzip.compress(bytes(1 << 20)) * 600))");
    EXPECT_LT(fs::file_size(tar), 1u << 20);
    EXPECT_EQ(read_submission(tar, wanted).problem, "unpacks to more than 512 MiB");
    // In a zip, the task file itself is the bomb.
    const fs::path zip = python(folder, "bomb.zip", R"(
with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as z:
    with z.open("shaders/01_a/task.glsl", "w") as f:
        for i in range(20): f.write(bytes(1 << 20)))");
    const Submission found = read_submission(zip, wanted);
    EXPECT_EQ(found.problem, "");
    EXPECT_EQ(found.refused.at(shader), "larger than 1 MiB");
    const fs::path many = python(folder, "many.zip", R"(
with zipfile.ZipFile(path, "w") as z:
    for i in range(20001): z.writestr(str(i), ""))");
    EXPECT_EQ(read_submission(many, wanted).problem, "has more than 20000 entries");
}

TEST(Submission, NamesAndFoldersCountTowardsAnArchivesBounds) {
    const TemporaryFolder folder;
    const auto tar = [&](const std::string& name, const std::string& entries) {
        return read_submission(python(folder, name, R"(
with tarfile.open(path, "w:gz", format=tarfile.PAX_FORMAT) as t:
    def add(name, folder=False, **more):
        info = tarfile.TarInfo(name); info.type = tarfile.DIRTYPE if folder else tarfile.REGTYPE
        info.pax_headers = more; t.addfile(info)
)" + entries),
                               wanted)
            .problem;
    };
    EXPECT_EQ(tar("long.tar.gz", "    add('x' * 5000)"), "has a name of more than 4096 bytes");
    EXPECT_EQ(tar("folders.tar.gz", "    for i in range(5000): add('d/' * 2000 + str(i), True)"),
              "has names of more than 16 MiB in all");
    const fs::path headers = python(folder, "headers.tar.gz", R"(
import gzip
info = tarfile.TarInfo("x"); info.pax_headers = {"comment": "x" * (800 << 10)}
with open(path, "wb") as f: f.write(gzip.compress(info.tobuf(tarfile.PAX_FORMAT)) * 700))");
    EXPECT_EQ(read_submission(headers, wanted).problem, "unpacks to more than 512 MiB");
    for (int i = 0; i < 20001; ++i) fs::create_directories(folder.path() / "many" / std::to_string(i));
    EXPECT_EQ(read_submission(folder.path() / "many", wanted).problem, "has more than 20000 files and folders");
}

TEST(Submission, AnInvalidOrDamagedArchiveIsReported) {
    const TemporaryFolder folder;
    const fs::path text = folder.write("a.zip", "no archive");
    EXPECT_TRUE(contains(read_submission(text, wanted).problem, "not a zip or tar archive, or damaged"));
    EXPECT_FALSE(read_submission(folder.write("empty.zip", ""), wanted).files.size());
    folder.write(std::string("jane/") + shader, std::string(100000, 'x'));
    const fs::path archive = folder.path() / "jane.tar.gz";
    ASSERT_EQ(run({"tar", "-caf", archive.string(), "-C", folder.path().string(), "jane"}).code, 0);
    fs::resize_file(archive, fs::file_size(archive) / 2);
    const Submission cut = read_submission(archive, wanted);
    EXPECT_TRUE(contains(cut.problem, "damaged")) << cut.problem;
    EXPECT_TRUE(cut.files.empty()) << "half a file was taken for a whole one";
    EXPECT_TRUE(contains(read_submission(folder.path() / "missing.zip", wanted).problem, "cannot read"));
    EXPECT_TRUE(contains(read_submission("/dev/null", wanted).problem, "neither a folder nor a file"));
}

}  // namespace
}  // namespace relief::grade
