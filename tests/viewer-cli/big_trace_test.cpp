// SPDX-License-Identifier: MIT
// Traces that are damaged, large, or changed while they are read: whatever is in the file, a command ends by itself, and
// says the same of a trace as of the same trace packed. scripts/check-big-traces.sh runs these tests with many more cases.

#include "effort.h"
#include "packed_text.h"
#include "program.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// RASTERTRACE_LONG is set by the script.
bool is_long() {
    return std::getenv("RASTERTRACE_LONG") !=
           nullptr; // NOLINT(concurrency-mt-unsafe): no other thread sets it
}

/// What is asked of a trace, each of one that lies beside a sound one.
constexpr std::array<std::string_view, 5> questions{
    "stats --json t", "validate t", "diff --json t sound", "explain t --pixel 0,0 --json",
    "show t --last"};

class BigTrace : public ProgramTest {
protected:
    /// All answers about a trace, as it is and packed, the files having one name in three folders.
    std::vector<std::string> answers(const std::string& text, const std::string& sound) const {
        std::vector<std::string> all;
        for (const Packing packing : {Packing::none, Packing::gzip, Packing::zstd}) {
            const std::string folder = std::to_string(static_cast<int>(packing));
            fs::create_directories(folder_ / folder);
            write(folder + "/t", packing == Packing::none ? text : packed(text, packing));
            write(folder + "/sound", packing == Packing::none ? sound : packed(sound, packing));
            std::string commands = "cd " + folder;
            for (const std::string_view question : questions)
                commands += "; $rastertrace " + std::string(question) + " 2>&1; echo \"status $?\"";
            all.push_back(shell(commands).out);
        }
        return all;
    }

    /// That they are the same, and that every command has ended by itself and not for lack of something.
    void expect_same_answers(const std::string& text, const std::string& sound,
                             const std::string& what) const {
        const auto all = answers(text, sound);
        EXPECT_EQ(all[1], all[0]) << what << ", gzip\n" << text;
        EXPECT_EQ(all[2], all[0]) << what << ", Zstandard\n" << text;
        std::size_t ended = 0;
        for (std::size_t at = 0; (at = all[0].find("\nstatus ", at)) != std::string::npos; ++at)
            ended += std::string_view("012").find(all[0][at + 8]) != std::string_view::npos &&
                             all[0][at + 9] == '\n'
                         ? 1
                         : 0;
        EXPECT_EQ(ended, questions.size()) << what << "\n" << all[0] << text;
    }

    /// The small traces of the examples, in both layouts; in short, of a twelfth of the examples.
    std::vector<std::string> traces_of_examples() const {
        std::vector<fs::path> examples;
        for (const auto& entry : fs::recursive_directory_iterator(RASTERTRACE_EXAMPLES))
            if (entry.path().extension() == ".json")
                examples.push_back(entry.path());
        std::sort(examples.begin(), examples.end()); // a folder has no order
        std::vector<std::string> traces;
        for (std::size_t i = 0; i < examples.size(); i += is_long() ? 1 : 12)
            for (const std::string layout : {"json", "jsonl"}) {
                constexpr std::size_t largest = 60'000;
                const Outcome trace =
                    shell("$rastertrace trace '" + examples[i].string() + "' --format " + layout);
                if (trace.status == 0 && trace.out.size() < largest)
                    traces.push_back(trace.out);
            }
        return traces;
    }
};

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines{""};
    for (const char c : text)
        if (c == '\n')
            lines.emplace_back();
        else
            lines.back() += c;
    return lines;
}

std::string joined_lines(const std::vector<std::string>& lines) {
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i)
        text += (i == 0 ? "" : "\n") + lines[i];
    return text;
}

/// A byte or a line changed, put in, taken out, doubled, exchanged or cut off.
std::string mutated(const std::string& text, Random& random) {
    const auto place = [&random](const auto& in) {
        return static_cast<std::size_t>(random.whole(0, static_cast<int>(in.size()) - 1));
    };
    std::string bytes = text;
    std::vector<std::string> lines = lines_of(text);
    const std::size_t line = place(lines);
    constexpr std::string_view signs = "{}[]\",:0-9\n\r\t \xff"
                                       "eE.";
    switch (random.whole(0, 7)) {
    case 0:
        bytes[place(bytes)] = static_cast<char>(random.whole(0, 255));
        return bytes;
    case 1:
        return bytes.substr(0, 1 + place(bytes));
    case 2:
        return bytes.insert(place(bytes), 1, signs[place(signs)]);
    case 3:
        return bytes.erase(place(bytes), 1);
    case 4:
        lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(line));
        break;
    case 5:
        lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(line), lines[place(lines)]);
        break;
    case 6:
        std::swap(lines[line], lines[place(lines)]);
        break;
    default:
        lines[line].resize(lines[line].size() / 2);
    }
    const std::string changed = joined_lines(lines);
    return changed.empty() ? text : changed;
}

/// A JSON value, among others with the keys and words of traces.
std::string random_value(Random& random, int depth) {
    const auto word = [&random] {
        return "\"" +
               std::string(random.pick<std::string_view>(
                   {"step",     "x",       "y",     "pixel",       "depth",   "primitive",
                    "scanline", "name",    "kind",  "color",       "#102030", "triangle",
                    "canvas",   "end",     "steps", "stored",      "pass",    "at",
                    "25/8",     "\\u0000", "NaN",   "rastertrace", "width",   "height"})) +
               "\"";
    };
    switch (random.whole(0, depth > 0 ? 7 : 4)) {
    case 0:
        return std::to_string(random.whole(-3, 12));
    case 1:
        return std::string(random.pick<std::string_view>(
            {"1e308", "-0", "9007199254740993", "0.1", "null", "true", "false", "1e999", "01"}));
    case 2:
    case 3:
    case 4:
        return word();
    case 5: {
        std::string list = "[";
        for (int i = random.whole(0, 3); i > 0; --i)
            list += random_value(random, depth - 1) + (i > 1 ? "," : "");
        return list + "]";
    }
    default: {
        std::string object = "{";
        for (int i = random.whole(0, 4); i > 0; --i)
            object += word() + ":" + random_value(random, depth - 1) + (i > 1 ? "," : "");
        return object + "}";
    }
    }
}

std::string random_lines(Random& random) {
    std::string text = random.chance(5) ? ""
                                        : "{\"rastertrace\":1,\"canvas\":{\"width\":6,\"height\":5,"
                                          "\"origin\":\"top-left\"}}\n";
    for (int i = random.whole(1, 12); i > 0; --i)
        text += (random.chance(2) ? "{\"step\":\"" +
                                        std::string(random.pick<std::string_view>(
                                            {"pixel", "depth", "primitive", "other", "edge"})) +
                                        "\",\"x\":" + std::to_string(random.whole(-1, 6)) +
                                        ",\"y\":" + std::to_string(random.whole(-1, 6)) +
                                        ",\"depth\":" + random_value(random, 0) +
                                        ",\"name\":" + random_value(random, 1) + "}"
                                  : random_value(random, 3)) +
                "\n";
    return text + (random.chance(2) ? "{\"end\":{}}\n" : "");
}

// --- packed and not -----------------------------------------------------------------------------

// Parts of a megabyte are read at once: what comes of them does not depend on how many, nor on what lies between them.
TEST_F(BigTrace, IsReadAlikeByAnyNumberOfThreads) {
    std::string vertices;
    std::string triangles;
    Random random(3);
    for (int i = 0; i < 60; ++i) {
        for (const char corner : {'A', 'B', 'C'})
            vertices += (vertices.empty() ? "\"" : ",\"") + (corner + std::to_string(i)) + "\":[" +
                        std::to_string(random.whole(0, 199)) + "," +
                        std::to_string(random.whole(0, 149)) + "," +
                        std::to_string(random.whole(1, 9)) + "]";
        const std::string n = std::to_string(i);
        triangles += (i == 0 ? "" : ",") + ("[\"A" + n + "\",\"B" + n + "\",\"C" + n + "\"]");
    }
    write("scene.json", R"({"canvas":{"width":200,"height":150,"origin":"top-left"},)"
                        R"("method":{"depth":"linear-z"},"vertices":{)" +
                            vertices + "},\"triangles\":[" + triangles + "]}");
    const std::string sound = shell("$rastertrace trace scene.json --format jsonl").out;
    ASSERT_GT(sound.size(), 4'000'000U);
    std::string damaged = sound;
    for (int i = 0; i < 3; ++i) // written otherwise, still a step
        damaged.insert(damaged.find("{\"step\"", static_cast<std::size_t>(random.whole(
                                                     0, static_cast<int>(damaged.size()) - 9999))) +
                           1,
                       " ");
    for (const std::string& text :
         {sound, damaged, damaged.substr(0, damaged.size() / 2), mutated(sound, random)}) {
        write("t", text);
        for (const std::string question :
             {"stats --json", "validate", "explain --pixel 90,70", "show --last"}) {
            const auto answer = [&](const std::string& jobs) {
                return shell("$rastertrace " + question + " t --jobs " + jobs + " 2>&1; echo $?")
                    .out;
            };
            const std::string by_one = answer("1");
            EXPECT_EQ(answer("2"), by_one) << question;
            EXPECT_EQ(answer("7"), by_one) << question;
        }
    }
    EXPECT_EQ(shell("$rastertrace stats t --jobs 0").status, 2);
}

TEST_F(BigTrace, EveryExampleIsTheSamePacked) {
    const auto traces = traces_of_examples();
    ASSERT_GT(traces.size(), 20U);
    for (std::size_t i = 0; i < traces.size(); ++i)
        expect_same_answers(traces[i], traces[(i + 1) % traces.size()], std::to_string(i));
}

TEST_F(BigTrace, DamagedTracesAreTheSamePacked) {
    const auto traces = traces_of_examples();
    const int cases = is_long() ? 10'000 : random_cases(100);
    for (int seed = 1; seed <= cases && !HasFailure(); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const auto any = [&] {
            return traces[static_cast<std::size_t>(
                random.whole(0, static_cast<int>(traces.size()) - 1))];
        };
        const std::string sound = any();
        std::string text = mutated(sound, random);
        while (random.chance(2))
            text = mutated(text, random);
        expect_same_answers(text, sound, "seed " + std::to_string(seed));
    }
}

TEST_F(BigTrace, RandomLinesAreTheSamePacked) {
    const std::string sound = shell("$rastertrace trace $examples/t0-fill/first-triangle.json").out;
    const int cases = is_long() ? 10'000 : random_cases(50);
    for (int seed = 1; seed <= cases && !HasFailure(); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        expect_same_answers(random_lines(random), sound, "seed " + std::to_string(seed));
    }
}

// --- with an index ------------------------------------------------------------------------------

/// What an index may be used for, of a trace t.jsonl.
constexpr std::array<std::string_view, 5> indexed_questions{
    "explain t.jsonl --pixel 3,2", "explain t.jsonl --pixel 0,0", "explain t.jsonl --step 40",
    "show t.jsonl --step 40 --bare", "play t.jsonl --step 40 --print 80x30"};

class IndexedTrace : public BigTrace {
protected:
    /// What all questions are answered, and how they end; with an option.
    std::string answers_to_all(const std::string& option) const {
        std::string commands;
        for (const std::string_view question : indexed_questions)
            commands += "$rastertrace " + std::string(question) + option +
                        " 2>err; echo \"status $?\"; grep -v t.jsonl.index err; ";
        return shell(commands).out;
    }

    /// The same, where there is no index.
    std::string answers_without_index() const {
        shell("mv t.jsonl.index aside");
        std::string all = answers_to_all("");
        shell("mv aside t.jsonl.index");
        return all;
    }

    void expect_same_as_without() const { EXPECT_EQ(answers_to_all(""), answers_without_index()); }
};

TEST_F(IndexedTrace, IsWrittenBesideATraceAndAnswersTheSame) {
    shell("$rastertrace trace $examples/t0-hidden/two-cubes.json -o t.jsonl --index");
    ASSERT_TRUE(fs::exists(folder_ / "t.jsonl.index"));
    expect_same_as_without();

    // Of many primitives, few are told of; their distances are all but the same, or far from that.
    shell("$rastertrace trace $examples/t3-light/lambert.json -o t.jsonl --index");
    const std::string ask = "for x in -24 -7 0 5 23; do for y in -20 0 3 18; do "
                            "$rastertrace explain t.jsonl --pixel $x,$y; done; done; ";
    const std::string by_index = shell(ask).out;
    fs::remove(folder_ / "t.jsonl.index");
    EXPECT_EQ(by_index, shell(ask).out);

    EXPECT_EQ(shell("$rastertrace stats t.jsonl --index >stats; $rastertrace stats t.jsonl | cmp - "
                    "stats")
                  .status,
              0);
    EXPECT_TRUE(fs::exists(folder_ / "t.jsonl.index"));
    expect_same_as_without();
    EXPECT_EQ(shell("$rastertrace trace t.jsonl --index").status, 2);
}

TEST_F(IndexedTrace, IsToldOfOnlyWhereItWasAskedForIfItDoesNotFit) {
    shell("$rastertrace trace $examples/t0-hidden/two-cubes.json -o other.jsonl --index; "
          "$rastertrace trace $examples/t0-fill/first-triangle.json -o t.jsonl; "
          "cp other.jsonl.index t.jsonl.index");
    expect_same_as_without();
    EXPECT_EQ(shell("$rastertrace explain t.jsonl --pixel 3,2").err, "");
    EXPECT_EQ(shell("$rastertrace explain t.jsonl --pixel 3,2 --index").err,
              "rastertrace: t.jsonl.index: expected the index of t.jsonl, found that of another "
              "trace\n");
    EXPECT_EQ(shell("$rastertrace explain t.jsonl --pixel 3,2 --index").err, ""); // made anew
    shell("touch -d '1 hour ago' t.jsonl.index");
    EXPECT_EQ(shell("$rastertrace explain t.jsonl --pixel 3,2 --index").err,
              "rastertrace: t.jsonl.index: expected the index of t.jsonl, found an older one\n");
    shell("head -c 300 other.jsonl.index > t.jsonl.index");
    EXPECT_EQ(shell("$rastertrace explain t.jsonl --pixel 3,2 --index").err,
              "rastertrace: t.jsonl.index: expected the index of t.jsonl, found something else\n");
}

TEST_F(IndexedTrace, AStepThatChangesUnderItIsReadWithoutIt) {
    shell("$rastertrace trace $examples/t0-hidden/two-cubes.json -o t.jsonl --index; "
          "sed -i 's/\"depth\",\"x\":-7,\"y\":9,/\"depth\",\"x\":-7,\"y\":8,/' t.jsonl; "
          "touch t.jsonl.index");
    expect_same_as_without();
    EXPECT_EQ(shell("$rastertrace explain t.jsonl --step 40 --index").err,
              "rastertrace: t.jsonl.index: expected the index of t.jsonl, found that of another "
              "trace\n");
}

TEST_F(IndexedTrace, DamagedTracesAreAnsweredTheSame) {
    const auto traces = traces_of_examples();
    const int cases = is_long() ? 3'000 : random_cases(40);
    for (int seed = 1; seed <= cases && !HasFailure(); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const std::string sound =
            traces[static_cast<std::size_t>(random.whole(0, static_cast<int>(traces.size()) - 1))];
        write("t.jsonl", sound);
        shell("$rastertrace validate t.jsonl --index");
        write("t.jsonl", mutated(sound, random));
        expect_same_as_without();
        EXPECT_EQ(answers_to_all(" --index"), answers_without_index()) << seed;
    }
}

// --- changed while it is read -------------------------------------------------------------------

/// A trace whose points have so many names.
constexpr std::string_view write_names =
    "names() { awk -v count=$1 'BEGIN { "
    "print \"{\\\"rastertrace\\\":1,\\\"canvas\\\":{\\\"width\\\":64,\\\"height\\\":64,"
    "\\\"origin\\\":\\\"top-left\\\"}}\"; "
    "for (i = 0; i < count; ++i) printf "
    "\"{\\\"step\\\":\\\"primitive\\\",\\\"kind\\\":\\\"point\\\","
    "\\\"name\\\":\\\"P%d\\\",\\\"vertices\\\":[\\\"P%d\\\"]}\\n{\\\"step\\\":\\\"pixel\\\","
    "\\\"x\\\":%d,"
    "\\\"y\\\":%d}\\n\", i, i, i % 64, int(i / 64) % 64; "
    "printf \"{\\\"end\\\":{\\\"steps\\\":%d}}\\n\", 2 * count }'; }; ";

/// A command has read all of it before, or what was left of it, or ends because its file has gone; never by a signal.
TEST_F(BigTrace, ATraceThatShrinksWhileItIsReadIsToldOf) {
    shell(std::string(write_names) + "names 60000 > whole");
    const std::vector<std::string> sizes{"0", "1000", "4000000"};
    const int rounds = is_long() ? 20 : 2;
    // A command takes tenths of a second, under the sanitizer seconds: some of the cuts fall into its reading.
    const std::string unit = is_sanitized ? "0." : "0.0";
    std::size_t cut_short = 0;
    for (const std::string_view question : questions)
        for (const std::string& size : sizes)
            for (int round = 0; round < rounds; ++round) {
                const std::string pause = unit + std::to_string(2 + 5 * round % 8);
                const Outcome told =
                    shell("cp whole t; cp whole sound; $rastertrace " + std::string(question) +
                          " >out & sleep " + pause + "; truncate -s " + size + " t; wait $!");
                const std::string what = std::string(question) + ", " + size + ", " + pause;
                EXPECT_THAT(told.status, AnyOf(0, 1, 2, 3)) << what << told.err;
                if (told.status == 3) {
                    ++cut_short;
                    EXPECT_EQ(told.err, "rastertrace: a trace was cut short while it was read\n")
                        << what;
                } else if (told.status == 2) {
                    EXPECT_THAT(told.err, AnyOf(HasSubstr("found the end of the file"),
                                                HasSubstr("found an empty file")))
                        << what;
                }
            }
    EXPECT_GT(cut_short, 0U);
}

/// What is added is read, or is not; no step is read twice or in halves.
TEST_F(BigTrace, ATraceThatGrowsWhileItIsReadIsReadToSomeEnd) {
    shell(std::string(write_names) + "names 30000 | head -n -1 > whole");
    for (const std::string_view question : questions) {
        const Outcome told = shell(
            "cp whole t; cp whole sound; $rastertrace " + std::string(question) +
            " >out & for i in 1 2 3 4 5 6 7 8; do "
            "printf '{\"step\":\"pixel\",\"x\":1,\"y\":1}\\n' >> t; sleep 0.01; done; wait $!");
        EXPECT_THAT(told.status, AnyOf(0, 1, 2)) << question << told.err;
        EXPECT_THAT(told.err, HasSubstr("the trace is truncated after 6000")) << question;
    }
}

// --- large --------------------------------------------------------------------------------------

/// A program that is started counts the memory of the one that starts it: a suite of its own has little.
class BigTraceMemory : public BigTrace {};

/// A line of a trace has an end: what is longer is refused without being held, from a file, a pipe or packed.
TEST_F(BigTraceMemory, ALineOfAnyLengthIsRefusedInBoundedMemory) {
    const std::string size = is_long() ? "1000000000" : "40000000";
    shell("(echo '{\"rastertrace\":1,\"canvas\":{\"width\":3,\"height\":3}}'; "
          "printf '{\"step\":\"pixel\",\"x\":0,\"y\":0,\"code\":\"'; head -c " +
          size +
          " /dev/zero | tr '\\000' x; printf '\"}\\n{\"end\":{}}\\n') > t; "
          "(head -n 1 t; echo '{\"step\":\"pixel\",\"x\":0,\"y\":0}'; tail -n 1 t) > sound");
    for (const std::string_view question : questions) {
        const Outcome told = shell("$rastertrace " + std::string(question));
        EXPECT_EQ(told.status, 2) << question;
        EXPECT_THAT(told.err, HasSubstr("expected lines of at most 16 MB in a trace")) << question;
        if (!is_sanitized) {
            EXPECT_LT(told.peak_memory, 150'000'000) << question;
        }
    }
    const Outcome piped = shell("$rastertrace stats - < t");
    EXPECT_EQ(piped.status, 2);
    EXPECT_THAT(piped.err, HasSubstr("expected lines of at most 16 MB in a trace"));
}

/// What comes from a pipe, or is packed, is read more than once, but not held in memory.
TEST_F(BigTraceMemory, ATraceFromAPipeIsNotHeldInMemory) {
    shell("(echo '{\"rastertrace\":1,\"title\":\"dot\",\"canvas\":{\"width\":3,\"height\":3}}'; "
          "yes '{\"step\":\"pixel\",\"x\":0,\"y\":0}' | head -n 9000000; echo '{\"end\":{}}') > t");
    constexpr long most = 210'000'000;
    ASSERT_GT(fs::file_size(folder_ / "t"), std::uintmax_t{most});
    for (const std::string command : {"stats --json", "show --last --bare"}) {
        const std::string answer = shell("$rastertrace " + command + " t").out;
        const Outcome piped = shell("cat t | $rastertrace " + command + " -");
        EXPECT_EQ(piped.status, 0) << piped.err;
        EXPECT_EQ(piped.out, answer);
        if (!is_sanitized) {
            EXPECT_LT(piped.peak_memory, most) << command;
        }
    }
}

/// Time and memory grow with the names and no faster: ten times as many take at most twelve times as long.
TEST_F(BigTraceMemory, ManyNamesAreReadInTheirTime) {
    if (is_sanitized)
        GTEST_SKIP() << "the sanitizer needs time and memory of its own";
    const std::string many = is_long() ? "10000000" : "1000000";
    shell(std::string(write_names) + "names " + many + " > t; cp t sound");
    const long bytes = static_cast<long>(fs::file_size(folder_ / "t"));
    const long seconds = is_long() ? 300 : 30; // of the processor
    for (const std::string_view question : questions) {
        const Outcome told = shell("ulimit -t " + std::to_string(seconds) + "; $rastertrace " +
                                   std::string(question) + " >out");
        EXPECT_EQ(told.status, 0) << question << told.err;
        EXPECT_LT(told.peak_memory, 10 * bytes) << question;
    }
}

/// A few kilobytes that would become blank lines without end behind the header of a trace.
TEST_F(BigTraceMemory, ABombBehindAHeaderIsRefusedInBoundedMemory) {
    const std::string header = "{\"rastertrace\":1,\"canvas\":{\"width\":3,\"height\":3}}\n";
    const std::size_t size = is_long() ? 300'000'000 : 60'000'000;
    for (const char filling : {'\n', ' '}) {
        const std::string text = header + std::string(size, filling);
        for (const Packing packing : {Packing::gzip, Packing::zstd}) {
            if (!is_long() && (filling == ' ') != (packing == Packing::gzip))
                continue;
            write("t", packed(text, packing));
            write("sound", packed(text, packing));
            EXPECT_LT(fs::file_size(folder_ / "t"), 2'000'000U);
            for (const std::string_view question : questions) {
                const Outcome told = shell("$rastertrace " + std::string(question));
                EXPECT_EQ(told.status, 2) << question;
                EXPECT_THAT(told.err, HasSubstr("rastertrace: ")) << question;
                if (!is_sanitized) {
                    EXPECT_LT(told.peak_memory, static_cast<long>(3 * size + 100'000'000))
                        << question;
                }
            }
        }
    }
}

} // namespace
} // namespace rastertrace
