// SPDX-License-Identifier: MIT
// A player in a trace of some 2 million steps, on a canvas of 512 x 512 with a depth buffer: `play/read` is reading
// it and going to its end with keyframes, against `play/lines`, which counts the lines of the file; `play/step` is one step
// forward, `play/jump` a step anywhere.

#include "player/player_screen.h"
#include "random_choice.h"
#include "trace_file.h"

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

namespace rastertrace {
namespace {

constexpr int triangles = 95;

/// Random triangles over each other, in front of and behind each other.
std::string many_triangles() {
    Random random(4);
    std::string vertices;
    std::string names;
    for (int i = 0; i < triangles; ++i) {
        const std::string n = std::to_string(i);
        for (const char corner : {'A', 'B', 'C'})
            vertices += (vertices.empty() ? "\"" : ",\"") + (corner + n) + "\":[" +
                        std::to_string(random.whole(0, 511)) + "," +
                        std::to_string(random.whole(0, 511)) + "," +
                        std::to_string(random.whole(1, 90)) + "]";
        names += (names.empty() ? "[\"A" : ",[\"A") + n + "\",\"B" + n + "\",\"C" + n + "\"]";
    }
    return R"({"canvas":{"width":512,"height":512,"origin":"top-left"},"method":{"depth":"linear-z"},"vertices":{)" +
           vertices + "},\"triangles\":[" + names + "]}";
}

/// The path of their trace, which is written when it is first asked for. RASTERTRACE_PLAY_TRACE may name another one.
const std::string& long_trace_path() {
    static const TemporaryFile file("rastertrace-play-bench.jsonl");
    static const std::string path = [] {
        if (const char* const other = std::getenv("RASTERTRACE_PLAY_TRACE"))
            return std::string(other);
        const auto scene = read_scene({"many.json", many_triangles()});
        if (!scene)
            std::abort();
        FileOutput output(file.path());
        write_trace(scene.value().scene, scene.value().plan,
                    {.layout = TraceLayout::jsonl, .filter = {}}, output);
        output.commit();
        return file.path();
    }();
    return path;
}

Trace long_trace() {
    return std::move(read_trace(read_source(long_trace_path()).value()).value());
}

void play_lines(benchmark::State& state) {
    const std::string& path = long_trace_path();
    for (auto _ : state)
        benchmark::DoNotOptimize(count_lines(path));
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                            static_cast<std::int64_t>(std::filesystem::file_size(path)));
}

void play_read(benchmark::State& state) {
    long_trace_path();
    for (auto _ : state) {
        Playback playback(long_trace());
        playback.go_to(1);
        playback.go_to(0);
        playback.go_to(playback.trace().size());
        state.counters["steps"] = static_cast<double>(playback.trace().size());
        state.counters["MB"] = static_cast<double>(playback.replay().bytes()) / 1e6;
        state.counters["interval"] = static_cast<double>(playback.replay().interval());
    }
    state.SetBytesProcessed(
        static_cast<std::int64_t>(state.iterations()) *
        static_cast<std::int64_t>(std::filesystem::file_size(long_trace_path())));
}

/// Until the first frame is on a screen of 80 x 24.
void play_first_frame(benchmark::State& state) {
    long_trace_path();
    for (auto _ : state) {
        Player player({.open = [](std::size_t) { return long_trace(); }}, {});
        benchmark::DoNotOptimize(player_screen(player, {80, 24}, {}));
    }
}

Player player_at_end() {
    Player player({.open = [](std::size_t) { return long_trace(); }}, {});
    player.press({"G"});
    return player;
}

void play_step(benchmark::State& state) {
    Player player = player_at_end();
    player.press({"1"});
    for (auto _ : state) {
        player.press({"Right"});
        benchmark::DoNotOptimize(player_screen(player, {80, 24}, {}));
    }
}

void play_jump(benchmark::State& state) {
    Player player = player_at_end();
    Random random(1);
    const auto last = static_cast<int>(player.playback().trace().size());
    double slowest = 0;
    for (auto _ : state) {
        const auto begin = std::chrono::steady_clock::now();
        for (const char digit : std::to_string(random.whole(0, last)))
            player.press({std::string(1, digit)});
        player.press({"G"});
        benchmark::DoNotOptimize(player_screen(player, {80, 24}, {}));
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
        slowest = std::max(slowest, taken.count());
    }
    state.counters["slowest_ms"] = 1e3 * slowest;
}

BENCHMARK(play_lines)->Name("play/lines")->Unit(benchmark::kMillisecond);
BENCHMARK(play_read)->Name("play/read")->Unit(benchmark::kMillisecond);
BENCHMARK(play_first_frame)->Name("play/first-frame")->Unit(benchmark::kMillisecond);
BENCHMARK(play_step)->Name("play/step")->Unit(benchmark::kMillisecond);
BENCHMARK(play_jump)->Name("play/jump")->Unit(benchmark::kMillisecond)->Iterations(200);

} // namespace
} // namespace rastertrace
