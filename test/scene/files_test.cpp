// "Output files are written whole or not at all": what a name may stand for.
#include "cob/files.hpp"

#include "cob/error.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

namespace cob {
namespace {

namespace fs = std::filesystem;

std::size_t count_entries(const std::string& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
}

TEST(OutputFile, AppearsWholeWhenCommitted) {
    const test::TemporaryFolder folder;
    write_file(folder / "table.csv", "before\n");
    {
        OutputFile abandoned(folder / "table.csv");
        abandoned.write("half");
    }
    EXPECT_EQ(read_file(folder / "table.csv"), "before\n");
    OutputFile file(folder / "table.csv");
    file.write("after\n");
    EXPECT_EQ(read_file(folder / "table.csv"), "before\n");
    file.commit();
    EXPECT_EQ(read_file(folder / "table.csv"), "after\n");
    EXPECT_EQ(count_entries(folder.path()), 1u);
}

// A rename over a device node or a pipe would take it away from everybody else.
TEST(OutputFile, NeverReplacesWhatIsNoOrdinaryFile) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    create_folder(folder / "folder");
    fs::create_symlink("pipe", folder / "link");
    for (const char* name : {"pipe", "link", "folder"}) {
        try {
            write_file(folder / name, "text");
            ADD_FAILURE() << name;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(folder / name), std::string::npos) << error.what();
        }
    }
    EXPECT_TRUE(fs::is_fifo(folder / "pipe"));
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_TRUE(fs::is_empty(folder / "folder"));
    EXPECT_EQ(count_entries(folder.path()), 3u);
}

TEST(OutputFile, ALinkStaysALink) {
    const test::TemporaryFolder folder;
    create_folder(folder / "elsewhere");
    write_file(folder / "elsewhere/table.csv", "before\n");
    fs::create_symlink("elsewhere/table.csv", folder / "link.csv");
    write_file(folder / "link.csv", "after\n");
    EXPECT_TRUE(fs::is_symlink(folder / "link.csv"));
    EXPECT_EQ(read_file(folder / "elsewhere/table.csv"), "after\n");
    EXPECT_EQ(count_entries(folder / "elsewhere"), 1u);
}

// A name may be as long as file systems allow, although a temporary one made from it would not fit; and two such names
// that differ at their ends are written at once.
TEST(OutputFile, NamesMayHave255Bytes) {
    for (const std::size_t length : {240u, 241u, 242u, 243u, 254u, 255u}) {
        const test::TemporaryFolder folder;
        const std::string start = folder / std::string(length - 5, 'n');
        write_file(start + "1.csv", "before\n");
        OutputFile one(start + "1.csv"), other(start + "2.csv");
        one.write("one\n");
        other.write("other\n");
        EXPECT_EQ(count_entries(folder.path()), 3u);
        one.commit();
        other.commit();
        EXPECT_EQ(read_file(start + "1.csv"), "one\n");
        EXPECT_EQ(read_file(start + "2.csv"), "other\n");
        EXPECT_EQ(count_entries(folder.path()), 2u);
        EXPECT_THROW(write_file(folder / std::string(256, 'n'), "too long"), InputError);
        EXPECT_EQ(count_entries(folder.path()), 2u);
    }
}

}  // namespace
}  // namespace cob
