// SPDX-License-Identifier: MIT
// Traces packed by gzip and Zstandard, as a user has them.

#include "packed_text.h"
#include "program.h"
#include "random_choice.h"

#include <rastertrace/trace/text/input_file.h>
#include <rastertrace/trace/text/packed.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <fstream>
#include <iterator>
#include <string>

namespace rastertrace {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class PackedTest : public ProgramTest {
protected:
    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    std::string content(const std::string& name) const {
        std::ifstream file(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    /// What is read of a file that is opened by its name.
    std::string read(const std::string& name) const {
        auto file = InputFile::open(path(name));
        std::string text;
        while (file.value().read_into(text)) {
        }
        return text;
    }
};

TEST_F(PackedTest, WhatIsPackedIsReadAsItWas) {
    Random random(2);
    for (const std::size_t size : {0U, 1U, 1000U, 1U << 20, (1U << 20) + 1, 3'500'000U}) {
        std::string text(size, ' ');
        for (char& c : text)
            c = static_cast<char>(random.whole(0, 15) * random.whole(0, 16));
        for (const Packing packing : {Packing::none, Packing::gzip, Packing::zstd}) {
            write("packed", packed(text, packing));
            EXPECT_EQ(read("packed"), text) << size;
        }
    }
}

TEST_F(PackedTest, TheEndingOfANameDecides) {
    EXPECT_EQ(packing_named("a.jsonl.gz"), Packing::gzip);
    EXPECT_EQ(packing_named("a.zst"), Packing::zstd);
    EXPECT_EQ(packing_named("a.gz.json"), Packing::none);
    EXPECT_EQ(without_packing("a.jsonl.gz"), "a.jsonl");
    EXPECT_EQ(without_packing("a.jsonl"), "a.jsonl");
}

TEST_F(PackedTest, APictureIsSeenInWhatIsPacked) {
    write("picture", "..#\n.##\n");
    const Outcome plain = shell("$rastertrace show picture");
    EXPECT_EQ(plain.status, 0) << plain.err;
    write("picture", packed("..#\n.##\n", Packing::gzip));
    EXPECT_EQ(shell("$rastertrace show picture").out, plain.out);
}

/// Other programs read what is written, and what they write is read.
TEST_F(PackedTest, GzipReadsWhatIsWritten) {
    const Outcome both =
        shell("$rastertrace trace $examples/t0-hidden/cube-painter.json -o t.jsonl && "
              "$rastertrace trace $examples/t0-hidden/cube-painter.json -o t.jsonl.gz && "
              "gzip -dc t.jsonl.gz | cmp - t.jsonl && "
              "gzip -c t.jsonl > other.gz && $rastertrace show other.gz --last > other && "
              "$rastertrace show t.jsonl --last | tail -n +2 > plain && "
              "tail -n +2 other | cmp - plain");
    EXPECT_EQ(both.status, 0) << both.err;
}

/// Whatever is asked, a packed trace answers as the plain one.
TEST_F(PackedTest, EveryCommandAnswersAsOfThePlainTrace) {
    const std::string scene = "$examples/t0-hidden/cube-inverse-z.json";
    for (const std::string layout : {"json", "jsonl"})
        for (const std::string ending : {"gz", "zst"}) {
            const std::string name = "trace." + layout;
            ASSERT_EQ(shell("mkdir -p plain packed && $rastertrace trace " + scene + " -o plain/" +
                            name + " && $rastertrace trace " + scene + " -o packed/" + name + "." +
                            ending + " && mv packed/" + name + "." + ending + " packed/" + name)
                          .status,
                      0);
            for (const std::string command :
                 {"show trace.X", "show trace.X --last",
                  "show trace.X --every depth --format table", "stats trace.X", "validate trace.X",
                  "explain trace.X --pixel 0,0", "explain trace.X --face ABC",
                  "play trace.X --print 80x24 --step 96", "figure trace.X --format svg -o -",
                  "trace trace.X --only scanline", "diff trace.X trace.X", "show - < trace.X",
                  "stats - < trace.X"}) {
                std::string one = command;
                for (std::size_t at = 0; (at = one.find(".X", at)) != std::string::npos;)
                    one.replace(at, 2, "." + layout);
                const Outcome plain = shell("cd plain && $rastertrace " + one);
                const Outcome packed = shell("cd packed && $rastertrace " + one);
                EXPECT_EQ(packed.out, plain.out) << one << " " << ending;
                EXPECT_EQ(packed.err, plain.err) << one << " " << ending;
                EXPECT_EQ(packed.status, plain.status) << one << " " << ending;
                EXPECT_EQ(plain.status, 0) << one << plain.err;
            }
        }
}

/// Of a packed trace that was cut off, every whole line is used.
TEST_F(PackedTest, ATraceThatIsCutAtAnyByteIsUsedAsFarAsItGoes) {
    ASSERT_EQ(shell("$rastertrace trace $examples/t0-fill/first-triangle.json -o t.jsonl").status,
              0);
    const std::string text = content("t.jsonl");
    for (const Packing packing : {Packing::gzip, Packing::zstd}) {
        const std::string whole = packed(text, packing);
        std::size_t most = 0;
        for (std::size_t size = 4; size < whole.size(); ++size) {
            write("cut", whole.substr(0, size));
            const std::string part = read("cut");
            ASSERT_THAT(text, StartsWith(part)) << size;
            EXPECT_GE(part.size(), most);
            most = part.size();
        }
        // What has been packed as one by Zstandard, up to 128 kB, is there whole or not at all.
        EXPECT_GE(most, packing == Packing::gzip ? text.size() / 2 : 0);
    }
    write("cut.gz", packed(text, Packing::gzip).substr(0, 900));
    const std::string part = read("cut.gz");
    write("cut.jsonl", part);
    const Outcome of_packed = shell("cp cut.gz cut && $rastertrace show cut --last");
    const Outcome of_plain = shell("cp cut.jsonl cut && $rastertrace show cut --last");
    EXPECT_EQ(of_packed.out, of_plain.out);
    EXPECT_EQ(of_packed.err, of_plain.err);
    EXPECT_THAT(of_packed.err, HasSubstr("cut:"));
}

TEST_F(PackedTest, ASceneThatIsCutOffSaysSo) {
    const std::string scene =
        R"({"canvas": {"width": 4, "height": 4}, "vertices": {"A": [0, 0]}, "points": ["A"]})";
    write("scene.json.gz", packed(scene, Packing::gzip));
    EXPECT_EQ(shell("$rastertrace show scene.json.gz").status, 0);
    write("scene.json.gz", packed(scene, Packing::gzip).substr(0, 60));
    const Outcome cut = shell("$rastertrace show scene.json.gz");
    EXPECT_EQ(cut.status, 2);
    EXPECT_EQ(cut.err,
              "rastertrace: scene.json.gz: expected the end of what is packed, found the end of "
              "the file\n");
}

TEST_F(PackedTest, DamagedBytesAreRefusedWithTheirPlace) {
    for (const Packing packing : {Packing::gzip, Packing::zstd}) {
        std::string bytes = packed(std::string(5000, 'a') + "bcd", packing);
        bytes[bytes.size() / 2] ^= 0x55;
        bytes[bytes.size() / 2 + 1] ^= 0x55;
        write("damaged", bytes);
        const Outcome told = shell("$rastertrace show damaged");
        EXPECT_EQ(told.status, 2);
        EXPECT_THAT(
            told.err,
            StartsWith("rastertrace: damaged: expected packed bytes, found damage at byte "));
    }
    write("rest", packed("{}", Packing::gzip) + "what else");
    EXPECT_THAT(shell("$rastertrace show rest").err, HasSubstr("found damage at byte "));
}

/// A few kilobytes that would become more than anybody has.
TEST_F(PackedTest, ABombIsRefusedInBoundedMemory) {
    const std::string much(400'000'000, '\n');
    for (const Packing packing : {Packing::gzip, Packing::zstd}) {
        write("bomb", packed(much, packing));
        for (const std::string command : {"show bomb", "stats bomb", "play bomb --print 80x24"}) {
            const Outcome told = shell("$rastertrace " + command);
            EXPECT_EQ(told.status, 2) << command;
            EXPECT_LT(told.peak_memory, 1'000'000'000) << command;
            EXPECT_THAT(told.err, HasSubstr("rastertrace: bomb")) << command;
        }
    }
}

TEST_F(PackedTest, EachFrameOfASequenceIsPacked) {
    ASSERT_EQ(
        shell("$rastertrace trace $examples/t0-projection/turning.json -o t.jsonl.zst").status, 0);
    const Outcome listed =
        shell("ls | head -n 1; $rastertrace show t-1.jsonl.zst --last | head -n 1");
    EXPECT_THAT(listed.out, StartsWith("t-1.jsonl.zst\n"));
    EXPECT_EQ(packing_of(content("t-1.jsonl.zst")), Packing::zstd);
}

} // namespace
} // namespace rastertrace
