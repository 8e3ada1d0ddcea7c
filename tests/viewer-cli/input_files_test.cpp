// SPDX-License-Identifier: MIT
// What the program says of files that it cannot read, and what it takes to read large ones.

#include "effort.h"
#include "program.h"
#include "told_problem.h"

#include <fmt/core.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

TEST_F(ProgramTest, ErrorsHaveFileLineColumnAndCaret) {
    write("bad.json", "{\"vertices\": {\"A\": [2, 5]},\n \"trinagles\": [\"AAA\"]}\n");
    EXPECT_THAT(
        run("trace bad.json -o t.json"),
        Ends(
            2, "",
            "rastertrace: bad.json:2:2: expected a key out of title, canvas, background, vertices, "
            "colors, triangles, polygons, outlines, lines, circles, points, meshes, model, camera, "
            "projection, viewport, light, convention, method, keep, vary, found \"trinagles\"\n"
            " \"trinagles\": [\"AAA\"]}\n"
            " ^\n"
            "hint: did you mean \"triangles\"?\n"));
    EXPECT_EQ(visible_files(), 1u) << "nothing was written";
}

TEST_F(ProgramTest, HintsSayHowJsonWritesIt) {
    struct Slip {
        std::string text, message, hint = {};
    };
    const std::vector<Slip> slips{
        {R"({"A": [2, 5,]})", "13: expected a value, found ']'",
         "JSON has no comma behind the last value"},
        {R"({"A": [2, 5], })", "15: expected a key in double quotes, found '}'",
         "JSON has no comma behind the last value"},
        {R"({'A': [2, 5]})", "2: expected a key in double quotes or '}', found '''",
         "JSON has double quotes: \"A\""},
        {R"({"triangles": ['ABC']})", "16: expected a value or ']', found '''",
         "JSON has double quotes: \"A\""},
        {R"({"A": [25/8, 5]})", "10: expected ',' or ']', found '/'",
         "a fraction is written \"25/8\", in quotes"},
        {R"({"A": (2, 5)})", "7: expected a value, found '('", "JSON has square brackets: [2, 5]"},
        {R"({"A": [2, 5]} // a)", "15: expected the end of the file, found '/'",
         "JSON has no comments"},
        {R"({"A": [2, /* x */ 5]})", "11: expected a value, found '/'", "JSON has no comments"},
        {R"(# the first triangle)", "1: expected a JSON value, found '#'", "JSON has no comments"},
    };
    for (const auto& [text, message, hint] : slips) {
        write("scene.json", text);
        EXPECT_THAT(
            run("show scene.json"),
            Refused("rastertrace: " + told_problem(text, "scene.json:1:" + message, hint) + "\n"))
            << text;
    }
}

TEST_F(ProgramTest, HintsSayWhereAKeyOfTheMethodBelongs) {
    write("root.json", R"({"rounding": "floor"})");
    EXPECT_THAT(run("show root.json").err,
                AllOf(StartsWith("rastertrace: root.json:1:2: expected a key out of title, "),
                      EndsWith(", found \"rounding\"\n"
                               "{\"rounding\": \"floor\"}\n"
                               " ^\n"
                               "hint: \"rounding\" belongs in \"method\": {\"rounding\": ...}\n")));
    write("line.json", R"({"line": ["AB"]})");
    EXPECT_THAT(
        run("show line.json").err,
        EndsWith(
            "hint: \"line\" belongs in \"method\": {\"line\": ...}; did you mean \"lines\"?\n"));
    write("canvas.json", R"({"vertices": {"A": [0, 0]}, "points": ["A"], "canvas": {"fill": 1}})");
    EXPECT_THAT(run("show canvas.json").err,
                EndsWith("hint: \"fill\" belongs in \"method\": {\"fill\": ...}\n"));
}

TEST_F(ProgramTest, ADecimalCommaIsRemarkedOn) {
    write("scene.json", "{\"vertices\": {\"A\": [2, 5], \"B\": [-4, -3],\n"
                        "              \"C\": [5,5, -3]},\n"
                        " \"triangles\": [\"ABC\"]}");
    EXPECT_THAT(run("show scene.json"),
                Ends(0, _,
                     "rastertrace: scene.json:2:20: remark: expected [x, y] as of other vertices, "
                     "found three numbers; nothing in this scene uses z\n"
                     "              \"C\": [5,5, -3]},\n"
                     "                   ^\n"
                     "hint: a decimal comma? JSON has a point: 5.5\n"));
    EXPECT_EQ(run("show scene.json --cull back").err, "");
    EXPECT_EQ(run("show scene.json --depth linear-z").err, "");
    write("all.json", R"({"vertices": {"A": [2, 5, 1], "B": [4, 3, 1]}, "lines": ["AB"]})");
    EXPECT_EQ(run("show all.json").err, "");
}

TEST_F(ProgramTest, FilesThatCannotBeRead) {
    EXPECT_THAT(run("show no-such-file.json"),
                Refused("rastertrace: no-such-file.json: expected a file that can be read, found: "
                        "No such file or directory\n"));
    EXPECT_THAT(run("show ."), Refused("rastertrace: .: expected a file, found a folder\n"));
    EXPECT_EQ(run("show - <&-").status, 3);
    EXPECT_EQ(shell("head -c 3000 $rastertrace >binary; $rastertrace show binary").status, 2);
}

// What stands behind a zero byte would go unseen.
TEST_F(ProgramTest, AZeroByteIsRefusedInEveryFile) {
    write("scene.json", R"({"vertices":{"A":[1,1]},"points":["A"]})" + std::string("\0?", 2));
    EXPECT_EQ(run("trace scene.json").err,
              "rastertrace: scene.json:1:40: expected text, found a zero byte\n"
              "{\"vertices\":{\"A\":[1,1]},\"points\":[\"A\"]}<U+0000>?\n" +
                  std::string(39, ' ') + "^\n");
    run("trace $examples/t0-fill/first-triangle.json -o t.jsonl; printf '\\000?' >> t.jsonl");
    EXPECT_THAT(run("show t.jsonl"), Refused(HasSubstr("expected text, found a zero byte")));
    write("a.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n# \0\nf 9 9 9\n", 44));
    write("mesh.json", R"({"canvas":{"width":9,"height":9},"meshes":[{"obj":"a.obj"}]})");
    EXPECT_THAT(run("trace mesh.json"),
                Refused(HasSubstr("a.obj:5:3: expected text, found a zero byte")));
}

TEST_F(ProgramTest, ATraceThatContradictsItselfIsTold) {
    write("t.json", R"({"rastertrace":1,"canvas":{"width":3,"height":3},"steps":[
{"step":"pixel","x":0,"y":0}
],
"end":{"steps":1,"pixels":99}})");
    for (const std::string command : {"show", "stats"})
        EXPECT_THAT(
            run(command + " t.json"),
            Refused("rastertrace: t.json:4:7: expected 99 pixels as the end record says, found 1\n"
                    "\"end\":{\"steps\":1,\"pixels\":99}}\n"
                    "      ^\n"));
}

TEST_F(ProgramTest, WhatNeverEndsIsRefusedAtOnce) {
    EXPECT_EQ(shell("timeout 20 $rastertrace show /dev/zero").err.substr(0, 64),
              "rastertrace: /dev/zero:1:1: expected text, found a zero byte\n<U+");
    EXPECT_THAT(shell("timeout 20 $rastertrace plan /dev/urandom"),
                Refused(StartsWith("rastertrace: /dev/urandom:")));
    EXPECT_THAT(shell("yes word | timeout 20 $rastertrace stats -"),
                Refused("rastertrace: standard input:1:1: expected a JSON value, found 'word'\n"
                        "word\n"
                        "^\n"));
    EXPECT_THAT(
        shell("yes '' | timeout 20 $rastertrace show - --max-input 1MB"),
        Refused("rastertrace: standard input: expected a file of at most 1 MB, found a larger one\n"
                "hint: --max-input SIZE raises the limit\n"));
    EXPECT_EQ(shell("mkfifo pipe; cat $examples/t0-fill/first-triangle.json >pipe & "
                    "timeout 20 $rastertrace show pipe")
                  .status,
              0);
}

TEST_F(ProgramTest, TheLimitOnInputCanBeRaised) {
    const std::string scene = R"({"canvas":{"width":9,"height":9},"meshes":[{"obj":"a.obj"}]})";
    write("scene.json", std::string(1500, ' ') + scene);
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n" + std::string(2500, '#'));
    EXPECT_THAT(run("plan scene.json"), Ends(0));
    EXPECT_THAT(
        run("plan scene.json --max-input 1kB"),
        Refused(
            "rastertrace: scene.json: expected a file of at most 1000 bytes, found a larger one\n"
            "hint: --max-input SIZE raises the limit\n"));
    EXPECT_THAT(run("plan scene.json --max-input 2kB").err,
                HasSubstr("expected a file of at most 2000 bytes, found a larger one (a.obj)"));
    EXPECT_EQ(run("plan scene.json --max-input 3kB").status, 0);

    // A trace may have any size.
    EXPECT_EQ(run("trace scene.json -o t.json; $rastertrace stats t.json --max-input 1kB").status,
              0);
    EXPECT_EQ(
        run("show scene.json --max-input lots").err,
        "rastertrace: --max-input: expected a size in kB, MB or GB, like 512MB, found \"lots\"\n");
}

TEST_F(ProgramTest, StepsThatAreHeldHaveALimitThatCanBeRaised) {
    write("scene.json", R"({"canvas":{"width":17,"height":14},
        "vertices":{"A":[2,5],"B":[-4,-3],"C":[5,-3]},"triangles":["ABC"],
        "method":{"fill":"barycentric"}})");
    const std::string hint =
        "hint: --max-steps N holds more of them, about 150 bytes each; `trace` "
        "writes any number of them\n";
    for (const std::string words :
         {"show scene.json", "stats scene.json", "explain scene.json --step last",
          "figure scene.json -o o.png", "figure scene.json -o o.html", "play scene.json",
          "diff scene.json --against scalar=exact"})
        EXPECT_THAT(
            run(words + " --max-steps 50"),
            Ends(2, "",
                 "rastertrace: scene.json: expected at most 50 steps to hold, found more\n" + hint))
            << words;
    EXPECT_EQ(shell("ls").out, "scene.json\n");

    EXPECT_EQ(run("show scene.json --max-steps 500").status, 0);
    EXPECT_EQ(run("trace scene.json -o t.jsonl").status, 0);
    EXPECT_EQ(run("stats t.jsonl --max-steps 50").err,
              "rastertrace: t.jsonl: expected at most 50 steps to hold, found more\n" + hint);
    EXPECT_EQ(run("show scene.json --max-steps few").err,
              "rastertrace: --max-steps: expected a number of steps, from 1, found \"few\"\n");
}

TEST_F(ProgramTest, ALineOfATraceHasAnEnd) {
    EXPECT_THAT(
        shell("(echo '{\"rastertrace\":1,\"canvas\":{\"width\":3,\"height\":3}}'; head -c 16000001 "
              "/dev/zero | tr '\\000' ' '; echo '{\"step\":\"pixel\"}') | $rastertrace stats -"),
        Refused(HasSubstr(
            "standard input:2:1: expected lines of at most 16 MB in a trace, found a longer one")));
}

// The largest file that the file system makes has no byte on the disk.
TEST_F(ProgramTest, AFileOfAnySizeIsReadBlockByBlock) {
    EXPECT_THAT(shell("for size in 9223372036854775807 17592186040320 1099511627776; do truncate "
                      "-s $size huge 2>/dev/null && break; done; $rastertrace show huge"),
                Refused(StartsWith("rastertrace: huge:1:1: expected text, found a zero byte\n")));
}

// 8 bytes for each byte of input, and what the program itself needs.
TEST_F(ProgramTest, ReadingTakesLittleMemory) {
    if (is_sanitized)
        GTEST_SKIP() << "the sanitizer needs memory of its own";
    constexpr long of_program = 16'000'000;
    const auto peak = [this](const std::string& name) {
        const Outcome outcome = run("plan " + name);
        EXPECT_LE(outcome.peak_memory,
                  8 * static_cast<long>(fs::file_size(folder_ / name)) + of_program)
            << name;
        return outcome;
    };
    // Straight to the disk: a program that is started counts the memory of the one that starts it.
    const auto write_around = [this](const std::string& name, std::string_view before,
                                     std::string_view after, const auto& item) {
        std::ofstream file(folder_ / name);
        file << before;
        for (int i = 0; i < 300'000; ++i)
            file << item(i) << ',';
        file << after;
    };
    const auto numbers = [](int) { return "1,1,1,1,1,1,1,1,1,1,1,1"; };
    write_around("unknown.json", "{\"unknown\":[", "1]}", numbers);
    EXPECT_THAT(peak("unknown.json").err, HasSubstr("expected a key out of"));
    write_around("wrong.json", "{\"vertices\":{\"A\":[", "1]}}", numbers);
    EXPECT_THAT(peak("wrong.json").err, HasSubstr("found an array of 3600001"));
    write_around("broken.json", "{\"vertices\":{\"A\":[", "1}}", numbers);
    EXPECT_THAT(peak("broken.json").err, HasSubstr("expected ',' or ']', found '}'"));
    write_around("keys.json", "{", "\"last\":1}",
                 [](int i) { return "\"" + std::to_string(1'000'000 + i) + "\":1"; });
    EXPECT_THAT(peak("keys.json").err, HasSubstr("expected a key out of"));
    write_around("mesh.json", R"({"canvas":{"width":9,"height":9},"meshes":[{"vertices":{)",
                 R"("A":[0,0,1],"B":[3,0,1],"C":[0,3,1]},"faces":["ABC"]}]})", [](int i) {
                     return "\"v" + std::to_string(i) + "\":[" + std::to_string(i % 89) + ".25,-" +
                            std::to_string(i % 97) + ".125,0.5]";
                 });
    EXPECT_EQ(peak("mesh.json").status, 0);
}

// Of each pixel its color, the step that drew it, and of a bitmap in twice the size four pixels of four bytes; and 256 MB,
// however many steps there are: pixels of a row are one step.
TEST_F(ProgramTest, ALargeCanvasTakesBytesForItsPixelsAndNotForItsSteps) {
    if (is_sanitized)
        GTEST_SKIP() << "the sanitizer needs memory of its own";
    constexpr long width = 8192;
    constexpr long height = 2048;
    write("scene.json", R"({"canvas":{"width":8192,"height":2048},
        "vertices":{"A":[-4000,-1000],"B":[4000,-1000],"C":[0,1000],"D":[0,-1000]},
        "triangles":["ABC","ADC"],"outlines":["ABC"]})");
    constexpr long frame = 4 + 8;
    constexpr long bitmap = 4 * 4;
    for (const auto& [command, bytes] : {std::pair("stats scene.json", frame),
                                         {"explain scene.json --pair ABC,ADC", frame},
                                         {"figure scene.json -o o.png --cell 1", frame + bitmap}}) {
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, 0) << command << outcome.err;
        EXPECT_LE(outcome.peak_memory, bytes * width * height + 256'000'000) << command;
    }
}

// Each took gigabytes, or half a minute.
TEST_F(ProgramTest, ASmallFileTakesLittleMemoryOrIsRefusedWithWhatIsTooLarge) {
    if (is_sanitized)
        GTEST_SKIP() << "the sanitizer needs memory and time of its own";
    constexpr long most_bytes = 1'300'000'000;
    const std::string within = "ulimit -t 20; $rastertrace ";
    // An exact depth takes memory where something is drawn. The picture takes four bytes a pixel: newer kernels count pages
    // of zeros that are only read, too.
    write("depths.json", R"({"canvas":{"width":16384,"height":4096,"origin":"top-left"},
        "vertices":{"A":[1,1,2],"B":[6,1,2],"C":[1,5,2]},"triangles":["ABC"],
        "method":{"scalar":"exact","depth":"inverse-z"},"keep":["depth"]})");
    const Outcome few = shell(within + "trace depths.json");
    EXPECT_EQ(few.status, 0) << few.err;
    EXPECT_LT(few.peak_memory, 4L * 16384 * 4096 + 100'000'000);
    // Pixels of a row are held as one step, and played one by one.
    std::string triangles = R"("ABC")";
    for (int i = 1; i < 4000; ++i)
        triangles += R"(,"ABC")";
    write("layers.json", R"({"canvas":{"width":600,"height":600,"origin":"top-left"},
        "vertices":{"A":[0,0],"B":[599,0],"C":[300,599]},"triangles":[)" +
                             triangles + "]}");
    const std::string hint = "hint: --max-steps N, above 10 million, holds more; `trace` writes "
                             "any number of steps\n";
    for (const std::string command : {"show layers.json --bare", "stats layers.json"}) {
        const Outcome layers = shell(within + command);
        EXPECT_THAT(layers, Refused("rastertrace: layers.json: expected steps to hold of at most "
                                    "200000000 pixels, found more\n" +
                                    hint))
            << command;
        EXPECT_LT(layers.peak_memory, most_bytes);
    }
    // Steps with weights of all digits are long.
    std::string far = R"({"canvas":{"width":600,"height":600,"origin":"top-left"},"triangles":[)";
    for (int i = 0; i < 100; ++i)
        far += i == 0 ? R"("ABC")" : R"(,"ABC")";
    write("long.json", far + R"(],"vertices":{"A":[0.1,0.3],"B":[599.7,598.9],"C":[598.3,599.1]},
        "colors":{"A":"#ff0000","B":"#00ff00","C":"#0000ff"},
        "method":{"fill":"barycentric","scalar":"double"}})");
    const Outcome steps = shell(within + "show long.json");
    EXPECT_THAT(steps,
                Refused(HasSubstr("long.json: expected at most 10000000 steps to hold, found "
                                  "more\nhint: --max-steps N")));
    EXPECT_LT(steps.peak_memory, most_bytes);
    // Every exact depth is kept.
    write("planes.json",
          R"({"canvas":{"width":600,"height":600,"origin":"top-left"},"triangles":[)" +
              triangles.substr(0, 40 * 6 - 1) + R"(],
        "vertices":{"A":[0,0,1],"B":[599,0,2],"C":[0,599,3]},
        "method":{"scalar":"exact","depth":"inverse-z"}})");
    const Outcome planes = shell("ulimit -t 60; $rastertrace show planes.json --bare");
    EXPECT_EQ(planes.status, 0) << planes.err;
    EXPECT_LT(planes.peak_memory, most_bytes);
    // A face is cut into triangles, each of which tells its names.
    for (const int corners : {27'000, 81'000}) {
        std::string vertices;
        std::string face = "f";
        for (int i = 1; i <= corners; ++i) {
            vertices += fmt::format("v {} {} 0\n", i, static_cast<double>(i) * i);
            face += fmt::format(" {}", i);
        }
        write("face.obj", vertices + face + "\n");
        write("face.json", R"({"canvas":{"width":64,"height":64},"meshes":[{"obj":"face.obj"}]})");
        const Outcome cut = shell(within + "stats face.json");
        EXPECT_EQ(cut.status, 0) << cut.err;
        EXPECT_LT(cut.peak_memory, most_bytes);
    }
}

// A scene from somewhere else cannot look around.
TEST_F(ProgramTest, AnObjFileLiesInTheFolderOfItsScene) {
    shell("mkdir -p scenes/models; ln -s ../../outside.obj scenes/models/link.obj; "
          "ln -s models/inside.obj scenes/alias.obj");
    const std::string obj = "v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 3\n";
    write("outside.obj", obj);
    write("scenes/models/inside.obj", obj);
    const auto scene = [](const std::string& path) {
        return R"({"canvas":{"width":9,"height":9},"meshes":[{"obj":")" + path + "\"}]}";
    };
    for (const std::string path : {"models/inside.obj", "alias.obj", "models/../models/inside.obj",
                                   "../scenes/models/inside.obj"}) {
        write("scenes/scene.json", scene(path));
        EXPECT_THAT(run("plan scenes/scene.json"), Ends(0)) << path;
        EXPECT_EQ(shell("cd scenes; $rastertrace plan - <scene.json").status, 0) << path;
    }
    const std::string absolute = folder_ / "outside.obj";
    for (const std::string& path :
         {std::string("../outside.obj"), std::string("models/link.obj"), absolute}) {
        write("scenes/scene.json", scene(path));
        EXPECT_THAT(run("plan scenes/scene.json"),
                    Refused(AllOf(
                        HasSubstr("expected an OBJ file in the scene's folder or below, found \""),
                        EndsWith("hint: --allow-outside lets it lie anywhere\n"))))
            << path;
        for (const std::string command : {"plan", "trace", "show", "stats", "stress"})
            EXPECT_THAT(run(command + " scenes/scene.json --allow-outside"), Ends(0)) << path;
    }
    write("scenes/scene.json", scene("../no-such-file.obj"));
    EXPECT_THAT(run("plan scenes/scene.json").err, HasSubstr("or below, found"))
        << "nothing is told about files outside";

    write("scenes/shadow", "root:$6$secret:19000:0:99999:7:::\n");
    write("scenes/scene.json", scene("shadow"));
    EXPECT_EQ(
        run("plan scenes/scene.json").err,
        "rastertrace: scenes/shadow:1:1: expected an OBJ file, found a line that is none of it\n"
        "hint: its statements are v, vt, vn, f, l, p, g, o, s, usemtl, mtllib\n");
}

TEST_F(ProgramTest, CaretsAndTitlesCountColumns) {
    write("scene.json", "{\"title\":\"三e\u0301\", \"tile\":1}");
    EXPECT_EQ(
        run("plan scene.json").err,
        "rastertrace: scene.json:1:17: expected a key out of title, canvas, background, vertices, "
        "colors, triangles, polygons, outlines, lines, circles, points, meshes, model, camera, "
        "projection, viewport, light, convention, method, keep, vary, found \"tile\"\n"
        "{\"title\":\"三e\u0301\", \"tile\":1}\n"
        "                ^\n"
        "hint: did you mean \"title\"?\n");

    // A wide title moves nothing, and a wide name marks no pixel, which is one column.
    const auto shown = [this](const std::string& title, const std::string& name) {
        write("scene.json", "{\"title\":\"" + title + "\",\"vertices\":{\"" + name +
                                "\":[1,1]},\"points\":[[\"" + name +
                                "\"]],\"canvas\":{\"width\":5,\"height\":5}}");
        std::string out = run("show scene.json --step last").out;
        EXPECT_THAT(out, HasSubstr("\n\n* " + name + " (1, 1)\n"));
        return out.substr(0, out.find("* ")).replace(0, title.size(), "TITLE");
    };
    EXPECT_EQ(shown("三角e\u0301", "三"), shown("abcde", "long"));
}

TEST_F(ProgramTest, NamesThatDifferLookDifferent) {
    write("scene.json", "{\"vertices\":{\"A\":[1,1]},\"points\":[[\"A\u200B\"]]}");
    EXPECT_EQ(run("plan scene.json").err,
              "rastertrace: scene.json:1:36: expected the name of a vertex, found \"A<U+200B>\"\n"
              "{\"vertices\":{\"A\":[1,1]},\"points\":[[\"A<U+200B>\"]]}\n"
              "                                   ^\n"
              "hint: the scene has the vertices A\n");
}

// Zero width, a tag, C1, the other direction: in the name of a file, a title, and the names in a scene.
TEST_F(ProgramTest, WhatNobodySeesIsInNoLineThatAPersonReads) {
    const std::vector<std::string> unseen{"\u200B", "\U000E0041", "\u0085", "\u202E"};
    std::string name = "n";
    for (const std::string& one : unseen)
        name += one;
    const auto scene = [&](const std::string& x) {
        return fmt::format(R"({{"title": "{0}", "canvas": {{"width": 8, "height": 8}},
            "vertices": {{"A{0}": [0, 0], "B{0}": [{1}, 0], "C{0}": [0, 3]}},
            "triangles": [{{"vertices": ["A{0}", "B{0}", "C{0}"], "name": "T{0}"}}],
            "lines": [{{"vertices": ["A{0}", "B{0}"], "name": "L{0}"}}]}})",
                           name, x);
    };
    write(name + ".json", scene("3"));
    write("other.json", scene("2"));
    for (const std::string& command : std::vector<std::string>{
             "show FILE", "show FILE --all", "show FILE --every edge --json",
             "explain FILE --pixel 1,1", "explain FILE --pixel 1,1 --json", "plan FILE",
             "plan FILE --json", "stats FILE", "stats FILE --json", "sheet FILE",
             "sheet FILE --format csv", "stress FILE --json", "trace FILE", "trace FILE --flat",
             "trace FILE --only pixel", "diff FILE other.json", "diff FILE other.json --json",
             "figure FILE --format svg -o -", "diff FILE none" + name}) {
        const Outcome told = run(std::regex_replace(command, std::regex("FILE"), name + ".json"));
        for (const std::string& one : unseen)
            EXPECT_THAT(told.out + told.err, Not(HasSubstr(one))) << command;
    }
    // What is escaped is read again.
    for (const std::string sheet : {"sheet.csv", "sheet.txt"})
        EXPECT_THAT(
            run("sheet other.json -o " + sheet + "; $rastertrace check other.json " + sheet),
            Ends(0, HasSubstr("open")))
            << content(sheet);
}

// Not under the sanitizers, which need memory and loading of their own.
#ifdef RASTERTRACE_FAILING_CALLS
TEST_F(ProgramTest, ASystemThatCannotOpenFilesIsNoBadInput) {
    write("bad.json", "not JSON");
    // 5: EIO, 12: ENOMEM, 23: ENFILE, 24: EMFILE
    for (const std::string error : {"5", "12", "23", "24"})
        EXPECT_THAT(
            shell("FAIL_CALL=open FAIL_AT=1 FAIL_ERRNO=" + error +
                  " LD_PRELOAD=" RASTERTRACE_FAILING_CALLS " $rastertrace show bad.json"),
            Ends(3, _,
                 StartsWith("rastertrace: bad.json: expected a file that can be read, found: ")))
            << error;
    write("mesh.json", R"({"canvas": {"width": 9, "height": 9}, "meshes": [{"obj": "c.obj"}]})");
    EXPECT_THAT(
        shell("FAIL_CALL=open FAIL_AT=3 LD_PRELOAD=" RASTERTRACE_FAILING_CALLS
              " $rastertrace show mesh.json"),
        Ends(3, _,
             "rastertrace: c.obj: expected a file that can be read, found: Too many open files\n"));
}

// A depth for each of 500,000 pixels, each a fraction whose digits GMP keeps.
TEST_F(ProgramTest, LackOfMemoryIsAMessage) {
    write("deep.json", R"({"canvas": {"width": 1000, "height": 1000, "origin": "top-left"},
        "vertices": {"A": [0, 0, "1/123456789012345678901234567890123456789"], "B": [2000, 0, 1],
                     "C": [0, 2000, "2/3"]},
        "triangles": ["ABC"], "keep": ["depth"],
        "method": {"scalar": "exact", "depth": "linear-z", "fill": "top-left"}})");
    write("old.json", "old");
    EXPECT_THAT(shell("ulimit -c 0; ulimit -v 80000; $rastertrace trace deep.json --only primitive "
                      "-o old.json"),
                Ends(3, _, "rastertrace: out of memory\n"));
    EXPECT_EQ(content("old.json"), "old");
    EXPECT_EQ(visible_files(), 2u);
}
#endif

// What small files could ask for, in processor time that even a slow build does not need (ulimit -t).
TEST_F(ProgramTest, ManyMeshesOfOneFileAreNamedQuickly) {
    write("one.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n");
    std::string meshes = R"({"obj":"one.obj"},{"obj":"one.obj","name":"one-3"})";
    for (int i = 2; i < 8000; ++i)
        meshes += R"(,{"obj":"one.obj"})";
    write("many.json", R"({"canvas":{"width":8,"height":8},"meshes":[)" + meshes + "]}");
    const Outcome trace = shell("ulimit -t 20; $rastertrace trace many.json --only primitive");
    EXPECT_EQ(trace.status, 0) << trace.err;
    const std::vector<std::string> names{"one.f1", "one-3.f1", "one-2.f1", "one-4.f1", "one-5.f1"};
    std::size_t at = 0;
    for (const std::string& name : names) {
        at = trace.out.find(R"("name":")" + name + "\"", at);
        ASSERT_NE(at, std::string::npos) << name;
    }
    EXPECT_THAT(trace.out, HasSubstr(R"("name":"one-8000.f1")"));
    EXPECT_THAT(trace.out, Not(HasSubstr(R"("name":"one-8001.f1")")));
}

TEST_F(ProgramTest, ManyUnknownKindsOfStepAreCountedQuickly) {
    std::string steps;
    for (int i = 0; i < 200000; ++i)
        steps += "{\"step\":\"kind" + std::to_string(i) + "\"}\n";
    write("many.jsonl", R"({"rastertrace":1,"canvas":{"width":1,"height":1}})"
                        "\n" +
                            steps + R"({"end":{"steps":200000}})" + "\n");
    EXPECT_THAT(shell("ulimit -t 20; $rastertrace stats many.jsonl"),
                Prints(HasSubstr("  kind199999 1\n")));
    EXPECT_THAT(shell("ulimit -t 20; $rastertrace show many.jsonl --every kind"),
                Refused(HasSubstr("(kind0, kind1, kind2, ")));
}

TEST_F(ProgramTest, AModelOfManyLongNumbersIsRefusedAtOnce) {
    // A 1 above and 997 bits below the bar, and two times 1/1: 1002 bits each step.
    const auto model = [](int steps) {
        const std::string large = "1" + std::string(300, '0');
        std::string text;
        for (int i = 0; i < steps; ++i)
            text += (i == 0 ? "\n" : ",\n") + (R"({"scale":["1/)" + large + R"(",1,1]})");
        return R"({"canvas":{"width":4,"height":4},"vertices":{"A":[0,0],"B":[1,0],"C":[0,1]},)"
               R"("triangles":["ABC"],"model":[)" +
               text + "]}";
    };
    write("long.json", model(64));
    EXPECT_THAT(
        shell("ulimit -t 20; $rastertrace plan long.json"),
        Refused(StartsWith("rastertrace: long.json:34:1: expected a model whose numbers have at "
                           "most 32768 bits as fractions, all together; found more\n")));
}

TEST_F(ProgramTest, AFanWiderThanEveryCanvasIsRefusedAtOnce) {
    const auto fan = [](const std::string& x) {
        return R"({"canvas":{"width":16,"height":16},"vertices":{"A":[0,0],"B":[)" + x +
               R"(,1],"C":[1,9]},"triangles":["ABC"],"method":{"fill":"fan"}})";
    };
    write("wide.json", fan("16384"));
    EXPECT_EQ(run("stats wide.json").status, 0);
    write("wider.json", fan("16385"));
    EXPECT_THAT(
        run("trace wider.json -o wider.trace.json"),
        Refused(StartsWith(
            "rastertrace: wider.json:1:58: expected edges of at most 16384 pixels for the fan, "
            "which draws a line for each, found vertex A at (0, 0) and vertex B at (16385, 1)\n")));
}

} // namespace
} // namespace rastertrace
