// SPDX-License-Identifier: MIT
// A pixel explained from a trace that is read step by step and not kept, against counting the lines of its file:
// `explain/lines` and `explain/pixel`, on a head of 38,080 triangles.

#include <rastertrace/trace/explain.h>
#include <rastertrace/trace/output.h>
#include <rastertrace/trace/scene_file.h>
#include <rastertrace/trace/step_stream.h>
#include <rastertrace/trace/steps_of_pixel.h>
#include <rastertrace/trace/write_trace.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <variant>

namespace rastertrace {
namespace {

/// The trace of a head of 38,080 triangles, in a file that is removed in the end.
class TraceFile {
public:
    TraceFile() : path_(std::filesystem::temp_directory_path() / "rastertrace-bench.json") {
        const std::string json = R"({
  "canvas": {"width": 1024, "height": 1024},
  "meshes": [{"obj": ")" + std::filesystem::path(RASTERTRACE_HEAD).filename().string() +
                                 R"("}],
  "camera": {"position": [0, 0, 6], "look_at": [0, 0, 0], "up": [0, 1, 0]},
  "projection": {"type": "frustum", "fov_y": 32, "near": 1, "far": 10},
  "method": {"depth": "inverse-z"}})";
        const auto scene = read_scene({RASTERTRACE_HEAD ".json", json});
        if (!scene)
            std::abort();
        FileOutput output(path_.string());
        write_trace(scene.value().scene, scene.value().plan, {}, output);
        output.commit();
    }
    TraceFile(const TraceFile&) = delete;
    TraceFile& operator=(const TraceFile&) = delete;
    ~TraceFile() { std::filesystem::remove(path_); }

    std::string path() const { return path_.string(); }

private:
    std::filesystem::path path_;
};

const std::string& trace_path() {
    static const TraceFile file;
    static const std::string path = file.path();
    return path;
}

void explain_lines(benchmark::State& state) {
    const std::string& path = trace_path();
    for (auto _ : state) {
        std::ifstream file(path, std::ios::binary);
        std::string block(1 << 16, '\0');
        std::ptrdiff_t lines = 0;
        while (file.read(block.data(), static_cast<std::streamsize>(block.size())) ||
               file.gcount() > 0)
            lines += std::count(block.begin(), block.begin() + file.gcount(), '\n');
        benchmark::DoNotOptimize(lines);
    }
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                            static_cast<std::int64_t>(std::filesystem::file_size(path)));
}

void explain_pixel(benchmark::State& state) {
    const std::string& path = trace_path();
    const Question question{.about = Topic::pixel, .pixel = {10, 20}};
    for (auto _ : state) {
        auto opened = open_steps(path, {});
        auto& stream = std::get<StepStream>(opened);
        StepsOfPixel chosen(stream.header(), question.pixel);
        while (stream.next())
            chosen.take(stream.step(), stream.kind(), stream.number());
        benchmark::DoNotOptimize(explain(std::move(chosen).finish(), question));
    }
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                            static_cast<std::int64_t>(std::filesystem::file_size(path)));
}

BENCHMARK(explain_lines)->Name("explain/lines")->Unit(benchmark::kMillisecond);
BENCHMARK(explain_pixel)->Name("explain/pixel")->Unit(benchmark::kMillisecond);

} // namespace
} // namespace rastertrace
