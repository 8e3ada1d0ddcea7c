// SPDX-License-Identifier: MIT
#include <rastertrace/trace/text/output.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace rastertrace {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test, gone afterwards.
class FileOutputTest : public testing::Test {
protected:
    FileOutputTest() {
        std::string pattern = (fs::temp_directory_path() / "rastertrace-XXXXXX").string();
        folder_ = ::mkdtemp(pattern.data());
    }
    ~FileOutputTest() override { fs::remove_all(folder_); }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }
    static std::string content(const std::string& path) {
        std::ostringstream text;
        text << std::ifstream(path).rdbuf();
        return text.str();
    }

    fs::path folder_;
};

TEST_F(FileOutputTest, GivesTheNameOnlyWhenComplete) {
    {
        FileOutput output(path("new"));
        output.write("half");
        EXPECT_FALSE(fs::exists(path("new")));
    }
    EXPECT_EQ(files(), 0u) << "what was not committed is gone";
    {
        FileOutput output(path("new"));
        output.write("whole");
        output.commit();
    }
    EXPECT_EQ(content(path("new")), "whole");
    EXPECT_EQ(files(), 1u);
}

TEST_F(FileOutputTest, LeavesAnOlderFileAloneUntilThen) {
    std::ofstream(path("old")) << "before";
    {
        FileOutput output(path("old"));
        output.write("after");
        EXPECT_EQ(content(path("old")), "before");
    }
    EXPECT_EQ(content(path("old")), "before");
    FileOutput output(path("old"));
    output.write("after");
    output.commit();
    EXPECT_EQ(content(path("old")), "after");
}

TEST_F(FileOutputTest, FollowsALinkAndKeepsPermissions) {
    std::ofstream(path("real")) << "before";
    fs::permissions(path("real"), fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("real", path("link"));
    FileOutput output(path("link"));
    output.write("after");
    output.commit();
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_EQ(content(path("real")), "after");
    EXPECT_EQ(fs::status(path("real")).permissions(),
              fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(FileOutputTest, SaysWhyItCannot) {
    const auto complaint = [](const std::string& name) -> std::string {
        try {
            FileOutput output(name);
            output.write("text");
            output.commit();
        } catch (const Problem& problem) {
            return problem.message;
        }
        return "no complaint";
    };
    EXPECT_EQ(complaint(path("no/such/folder")), "could not be created: No such file or directory");
    EXPECT_EQ(complaint(folder_.string()), "expected a file to write, found a folder");
    EXPECT_EQ(complaint("/dev/full"), "could not be written: No space left on device");
    EXPECT_EQ(complaint("/dev/null"), "no complaint");
}

} // namespace
} // namespace rastertrace
