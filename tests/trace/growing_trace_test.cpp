// SPDX-License-Identifier: MIT
// A trace that is read piece by piece is the trace that is read at once, wherever it comes from.

#include "random_scene.h"
#include "traces.h"

#include <rastertrace/trace/record/growing_trace.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/text/descriptor.h>
#include <rastertrace/trace/text/output.h>

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <utility>
#include <variant>

namespace rastertrace {
namespace {

class GrowingTraceTest : public testing::Test {
protected:
    GrowingTraceTest() {
        std::string pattern =
            (std::filesystem::temp_directory_path() / "rastertrace-XXXXXX").string();
        folder_ = ::mkdtemp(pattern.data());
        path_ = (folder_ / "trace.jsonl").string();
    }
    ~GrowingTraceTest() override { std::filesystem::remove_all(folder_); }

    void write(const std::string& text, std::ios::openmode mode = std::ios::out) const {
        std::ofstream(path_, mode) << text;
    }

    GrowingTrace opened() const {
        auto either = GrowingTrace::open(path_, {});
        return std::move(std::get<GrowingTrace>(either));
    }

    std::filesystem::path folder_;
    std::string path_;
};

void expect_same(const Trace& grown, const Trace& read) {
    EXPECT_EQ(steps_of(grown), steps_of(read));
    for (std::size_t n = 1; n <= read.size(); ++n)
        ASSERT_EQ(grown.kind_of(n), read.kind_of(n));
    EXPECT_EQ(grown.title, read.title);
    EXPECT_EQ(grown.method, read.method);
    EXPECT_EQ(grown.end.has_value(), read.end.has_value());
    EXPECT_EQ(damage_of(grown), damage_of(read));
}

std::string lines_of(const Scene& scene) {
    return trace_text(scene, {.layout = TraceLayout::jsonl, .filter = {}});
}

Trace read_whole(const std::string& path) {
    auto trace = read_trace(read_source(path).value());
    return std::move(trace.value());
}

TEST_F(GrowingTraceTest, IsTheTraceThatIsReadAtOnce) {
    for (const TraceLayout layout : {TraceLayout::jsonl, TraceLayout::json})
        for (std::uint64_t seed = 0; seed < 60; ++seed) {
            const auto scene = read_scene({"scene.json", RandomScene(seed).text()});
            if (!scene)
                continue;
            write(trace_text(scene.value().scene, {.layout = layout, .filter = {}}));
            GrowingTrace growing = opened();
            while (growing.read_on()) {
            }
            EXPECT_TRUE(growing.is_whole());
            expect_same(growing.trace(), read_whole(path_));
        }
}

TEST_F(GrowingTraceTest, OfALongTraceComesInPieces) {
    write(lines_of(scene_in(R"({"canvas":{"width":300,"height":300},
        "vertices":{"A":[-150,-150],"B":[149,-150],"C":[0,149]},"triangles":["ABC"]})")));
    GrowingTrace growing = opened();
    EXPECT_EQ(growing.trace().size(), 0U);
    EXPECT_TRUE(growing.read_on());
    EXPECT_FALSE(growing.is_whole());
    const std::size_t first = growing.trace().size();
    EXPECT_GT(first, 0U);
    const double share = growing.share();
    EXPECT_GT(share, 0);
    EXPECT_LT(share, 1);
    EXPECT_TRUE(growing.read_on());
    EXPECT_GT(growing.trace().size(), first);
    while (growing.read_on()) {
    }
    EXPECT_EQ(growing.share(), 1);
    expect_same(growing.trace(), read_whole(path_));
}

TEST_F(GrowingTraceTest, CutShortAnywhereTellsTheSameDamage) {
    const std::string text = lines_of(scene_in(
        R"({"canvas":{"width":9,"height":9},"vertices":{"A":[0,3],"B":[-3,-2],"C":[3,-2]},"triangles":["ABC"]})"));
    const std::size_t header = text.find('\n') + 1;
    for (std::size_t size = header; size < text.size(); size += 7) {
        write(text.substr(0, size));
        GrowingTrace growing = opened();
        while (growing.read_on()) {
        }
        expect_same(growing.trace(), read_whole(path_));
    }
}

TEST_F(GrowingTraceTest, OfAPipeHasNewLinesOnceTheyAreWhole) {
    const std::string text = lines_of(scene_in(
        R"({"canvas":{"width":9,"height":9},"vertices":{"A":[0,3],"B":[-3,-2],"C":[3,-2]},"triangles":["ABC"]})"));
    const std::size_t header = text.find('\n') + 1;
    ASSERT_EQ(::mkfifo(path_.c_str(), 0600), 0);
    // Open at both ends, so that neither waits for the other.
    Descriptor pipe(::open(path_.c_str(), O_RDWR | O_CLOEXEC));
    DescriptorOutput writer(pipe.number(), "pipe");
    writer.write(text.substr(0, header));
    GrowingTrace growing = opened();
    std::size_t written = header;
    while (written < text.size()) {
        EXPECT_FALSE(growing.is_whole());
        const std::size_t more = std::min<std::size_t>(37, text.size() - written);
        writer.write(text.substr(written, more));
        written += more;
        while (growing.read_on()) {
        }
        const std::string_view steps = std::string_view(text).substr(header, written - header);
        const auto lines = static_cast<std::size_t>(std::count(steps.begin(), steps.end(), '\n'));
        EXPECT_EQ(growing.trace().size(),
                  lines - (growing.is_whole() ? 1 : 0)); // and the end record
    }
    EXPECT_TRUE(growing.is_whole());
    std::filesystem::remove(path_);
    write(text);
    expect_same(growing.trace(), read_whole(path_));
}

TEST_F(GrowingTraceTest, OfAPipeIsTheSame) {
    const std::string text = lines_of(scene_in(R"({"canvas":{"width":300,"height":300},
        "vertices":{"A":[-150,-150],"B":[149,-150],"C":[0,149]},"triangles":["ABC"]})"));
    ASSERT_EQ(::mkfifo(path_.c_str(), 0600), 0);
    std::thread writer([&] { write(text); });
    GrowingTrace growing = opened();
    while (!growing.is_whole())
        growing.read_on();
    writer.join();
    std::filesystem::remove(path_);
    write(text);
    EXPECT_EQ(steps_of(growing.trace()), steps_of(read_whole(path_)));
    EXPECT_TRUE(growing.trace().damage.empty());
}

TEST_F(GrowingTraceTest, BeginsWithWhatIsInFrontOfALineThatIsNoStep) {
    write("{\"rastertrace\":1,\"canvas\":{\"width\":3,\"height\":3}}\n"
          "{\"step\":\"primitive\",\"kind\":\"point\",\"name\":\"A\"}\n");
    write(std::string(2 << 20, ' ') + "\n", std::ios::app);
    write("{\"step\":\"pixel\",\"x\":\"five\",\"y\":0}\n{\"end\":{}}\n", std::ios::app);
    GrowingTrace growing = opened();
    while (growing.read_on()) {
    }
    EXPECT_EQ(growing.trace().size(), 1U);
    ASSERT_EQ(growing.trace().damage.size(), 1U);
    EXPECT_EQ(growing.trace().damage[0].line, 4U);
    EXPECT_EQ(growing.trace().damage[0].message, "expected a whole number, found \"five\"");
}

TEST_F(GrowingTraceTest, HasEveryStepInFrontOfAWrongLine) {
    const std::string text = lines_of(scene_in(
        R"({"canvas":{"width":9,"height":9},"vertices":{"A":[0,3],"B":[-3,-2],"C":[3,-2]},"triangles":["ABC"]})"));
    std::size_t line = text.find('\n') + 1;
    for (std::size_t good = 0; text.find('\n', line) + 1 < text.size(); ++good) {
        write(text.substr(0, line) + "rubbish\n" + text.substr(line));
        GrowingTrace growing = opened();
        while (growing.read_on()) {
        }
        EXPECT_EQ(growing.trace().size(), good);
        ASSERT_EQ(growing.trace().damage.size(), 1U);
        EXPECT_EQ(growing.trace().damage[0].line, good + 2);
        line = text.find('\n', line) + 1;
    }
}

TEST_F(GrowingTraceTest, TellsThatItsFileIsAnotherOne) {
    const std::string text = lines_of(
        scene_in(R"({"canvas":{"width":9,"height":9},"vertices":{"A":[0,3]},"points":["A"]})"));
    write(text);
    const GrowingTrace cut = opened();
    EXPECT_EQ(cut.change(), std::nullopt);
    std::filesystem::resize_file(path_, 10);
    EXPECT_EQ(cut.change(), path_ + " was cut short");

    write(text);
    const GrowingTrace replaced = opened();
    std::filesystem::rename(path_, path_ + ".old");
    write(text);
    EXPECT_EQ(replaced.change(), path_ + " is another file now");

    const GrowingTrace longer = opened();
    write("\n", std::ios::app);
    EXPECT_EQ(longer.change(), path_ + " was changed");
}

TEST_F(GrowingTraceTest, OfASceneIsItsText) {
    write(R"({"vertices":{"A":[1,2]},"points":["A"]})");
    auto either = GrowingTrace::open(path_, {});
    EXPECT_EQ(std::get<Source>(either).text, R"({"vertices":{"A":[1,2]},"points":["A"]})");
}

} // namespace
} // namespace rastertrace
