// SPDX-License-Identifier: MIT
// Traces that are damaged, large, or changed while they are read: whatever is in the file, a command ends by itself, and
// says the same of a trace in a file as of the same trace from a pipe. scripts/check-big-traces.sh runs these tests with many more cases.

#include "effort.h"
#include "program.h"
#include "random_choice.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {
namespace {

/// RASTERTRACE_LONG is set by the script.
bool is_long() {
    return std::getenv("RASTERTRACE_LONG") !=
           nullptr; // NOLINT(concurrency-mt-unsafe): no other thread sets it
}

/// What is asked of a trace, each of one that lies beside a sound one.
constexpr std::array<std::string_view, 5> questions{
    "stats --json t", "validate t", "diff --json t sound", "explain t --pixel 0,0 --json",
    "show t --step last"};

class BigTrace : public ProgramTest {
protected:
    /// All answers about the trace t, in its file and from a pipe.
    std::vector<std::string> answers(const std::string& text, const std::string& sound) const {
        write("t", text);
        write("sound", sound);
        std::string of_file;
        std::string of_pipe;
        for (const std::string_view question : questions) {
            const std::size_t name = question.find(" t") + 1;
            std::string piped(question);
            // explain holds only the steps about its pixel of a pipe, so it cannot compare the picture's hash.
            if (!question.starts_with("explain"))
                piped[name] = '-';
            const std::string end = " 2>&1; echo \"status $?\"; ";
            of_file += "$rastertrace " + std::string(question) + end;
            of_pipe += "cat t | $rastertrace " + piped + end;
        }
        return {shell(of_file).out, shell("(" + of_pipe + ") | sed 's/standard input/t/g'").out};
    }

    /// That they are the same, and that every command has ended by itself and not for lack of something.
    void expect_same_answers(const std::string& text, const std::string& sound,
                             const std::string& what) const {
        const auto all = answers(text, sound);
        EXPECT_EQ(all[1], all[0]) << what << "\n" << text;
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
                    run("trace '" + examples[i].string() + "' --format " + layout);
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

// --- from a file and from a pipe ----------------------------------------------------------------

TEST_F(BigTrace, EveryExampleIsTheSameFromAPipe) {
    const auto traces = traces_of_examples();
    ASSERT_GT(traces.size(), 20U);
    for (std::size_t i = 0; i < traces.size(); ++i)
        expect_same_answers(traces[i], traces[(i + 1) % traces.size()], std::to_string(i));
}

TEST_F(BigTrace, DamagedTracesAreTheSameFromAPipe) {
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

TEST_F(BigTrace, RandomLinesAreTheSameFromAPipe) {
    const std::string sound = run("trace $examples/t0-fill/first-triangle.json").out;
    const int cases = is_long() ? 10'000 : random_cases(50);
    for (int seed = 1; seed <= cases && !HasFailure(); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        expect_same_answers(random_lines(random), sound, "seed " + std::to_string(seed));
    }
}

// What unpacks a trace is another program.
TEST_F(BigTrace, APackedTraceIsRefusedWithWhatUnpacksIt) {
    run("trace $examples/t0-fill/first-triangle.json -o t.jsonl; gzip -k t.jsonl; printf "
        "'\\050\\265\\057\\375 and so on' > t.jsonl.zst");
    for (const std::string_view question :
         {"stats", "validate", "diff t.jsonl", "explain --pixel 0,0", "show", "play --print 80x24",
          "trace", "plan"})
        EXPECT_EQ(run(std::string(question) + " t.jsonl.gz").err,
                  "rastertrace: t.jsonl.gz: expected a file that is not packed, found one packed "
                  "by gzip\nhint: `zcat FILE | rastertrace show -` unpacks it on the way\n")
            << question;
    EXPECT_THAT(
        shell("cat t.jsonl.zst | $rastertrace show -"),
        Refused("rastertrace: standard input: expected a file that is not packed, found one packed "
                "by zstd\nhint: `zstdcat FILE | rastertrace show -` unpacks it on the way\n"));
    EXPECT_EQ(shell("zcat t.jsonl.gz | $rastertrace show - >piped; $rastertrace show t.jsonl | "
                    "cmp - piped")
                  .status,
              0);
    for (const std::string flat : {"", " --flat"})
        EXPECT_EQ(
            run("trace t.jsonl -o u.jsonl.gz" + flat + "; s=$?; test ! -e u.jsonl.gz && exit $s")
                .err,
            "rastertrace: u.jsonl.gz: expected a name that ends in .json or .jsonl, found "
            ".gz\nhint: --format says what to write\n");
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

/// A line of a trace has an end: what is longer is refused without being held, from a file or a pipe.
TEST_F(BigTraceMemory, ALineOfAnyLengthIsRefusedInBoundedMemory) {
    const std::string size = is_long() ? "1000000000" : "40000000";
    shell("(echo '{\"rastertrace\":1,\"canvas\":{\"width\":3,\"height\":3}}'; "
          "printf '{\"step\":\"pixel\",\"x\":0,\"y\":0,\"code\":\"'; head -c " +
          size +
          " /dev/zero | tr '\\000' x; printf '\"}\\n{\"end\":{}}\\n') > t; "
          "(head -n 1 t; echo '{\"step\":\"pixel\",\"x\":0,\"y\":0}'; tail -n 1 t) > sound");
    for (const std::string_view question : questions) {
        const Outcome told = run(std::string(question));
        EXPECT_EQ(told.status, 2) << question;
        EXPECT_THAT(told.err, HasSubstr("expected lines of at most 16 MB in a trace")) << question;
        if (!is_sanitized) {
            EXPECT_LT(told.peak_memory, 150'000'000) << question;
        }
    }
    EXPECT_THAT(run("stats - < t"),
                Refused(HasSubstr("expected lines of at most 16 MB in a trace")));
}

/// More steps than may be held are refused with the option that holds more, in bounded memory.
TEST_F(BigTraceMemory, MoreStepsThanMayBeHeldAreRefused) {
    shell("(echo '{\"rastertrace\":1,\"title\":\"dot\",\"canvas\":{\"width\":3,\"height\":3}}'; "
          "yes '{\"step\":\"pixel\",\"x\":0,\"y\":0}' | head -n 3000000; echo '{\"end\":{}}') > t");
    for (const std::string command : {"stats --json", "show --bare", "validate", "diff t"}) {
        const Outcome told = run(command + " t --max-steps 1000000");
        EXPECT_THAT(told,
                    Refused("rastertrace: t: expected at most 1000000 steps to hold, found more\n"
                            "hint: --max-steps N holds more of them, about 150 bytes each; "
                            "`trace` writes any number of them\n"))
            << command;
        if (!is_sanitized) {
            EXPECT_LT(told.peak_memory, 200'000'000) << command;
        }
        EXPECT_THAT(shell("cat t | $rastertrace " + command + " - --max-steps 3000000").status,
                    AnyOf(0, 1))
            << command;
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

/// Blank lines, or one line of blanks, without end behind the header of a trace.
TEST_F(BigTraceMemory, BlanksBehindAHeaderAreRefusedInBoundedMemory) {
    const std::string header = "{\"rastertrace\":1,\"canvas\":{\"width\":3,\"height\":3}}\n";
    const std::size_t size = is_long() ? 300'000'000 : 60'000'000;
    for (const char filling : {'\n', ' '}) {
        write("t", header + std::string(size, filling));
        write("sound", header + std::string(size, filling));
        for (const std::string_view question : questions) {
            const Outcome told = run(std::string(question));
            EXPECT_EQ(told.status, 2) << question;
            EXPECT_THAT(told.err, HasSubstr("rastertrace: ")) << question;
            if (!is_sanitized) {
                EXPECT_LT(told.peak_memory, static_cast<long>(3 * size + 100'000'000)) << question;
            }
        }
    }
}

} // namespace
} // namespace rastertrace
