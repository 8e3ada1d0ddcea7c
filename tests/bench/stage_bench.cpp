// SPDX-License-Identifier: MIT
// What each stage costs where the scene does not need it: planning and drawing with no sink, by the
// plan, with one stage kept, and with all. scripts/stage-table.sh makes tables from it, and
// docs/performance.md has results.

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/trace/record/step_tracer.h>
#include <rastertrace/trace/record/step_writer.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/stage_name.h>

#include <benchmark/benchmark.h>

#include <malloc.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace {

std::size_t held_bytes = 0;
std::size_t peak_bytes = 0;

} // namespace

// Every allocation of this program is counted: those by `new`, and those of pictures (BlankVector), which
// are made by calloc. The linker puts __wrap_calloc and __wrap_free in the place of calloc and free.
extern "C" {
void* __real_calloc(std::size_t count, std::size_t size); // NOLINT: the linker's names
void __real_free(void* place);                            // NOLINT

[[gnu::noinline]] void* __wrap_calloc(std::size_t count, std::size_t size) { // NOLINT
    void* const place = __real_calloc(count, size);
    held_bytes += malloc_usable_size(place);
    peak_bytes = std::max(peak_bytes, held_bytes);
    return place;
}
[[gnu::noinline]] void __wrap_free(void* place) { // NOLINT
    held_bytes -= malloc_usable_size(place);
    __real_free(place);
}
}
[[gnu::noinline]] void* operator new(std::size_t size) {
    void* const place = std::malloc(size);
    if (place == nullptr)
        throw std::bad_alloc();
    held_bytes += malloc_usable_size(place);
    peak_bytes = std::max(peak_bytes, held_bytes);
    return place;
}
[[gnu::noinline]] void operator delete(void* place) noexcept {
    std::free(place);
}
[[gnu::noinline]] void operator delete(void* place, std::size_t) noexcept {
    operator delete(place);
}

namespace rastertrace {
namespace {

void add_triangle(Scene& scene, std::size_t a, std::size_t b, std::size_t c) {
    scene.primitives.push_back({.kind = PrimitiveKind::triangle,
                                .name = "T" + std::to_string(scene.primitives.size()),
                                .vertices = {a, b, c},
                                .color = {200, 80, 20}});
}

std::size_t add_vertex(Scene& scene, Number x, Number y, Number z) {
    scene.vertices.push_back({"V" + std::to_string(scene.vertices.size()), x, y, {}, z});
    return scene.vertices.size() - 1;
}

Scene canvas_scene(int side) {
    Scene scene;
    scene.canvas = {.width = side, .height = side, .origin = Origin::top_left};
    scene.method.fill = Fill::top_left;
    return scene;
}

Scene one_triangle() {
    Scene scene = canvas_scene(64);
    add_triangle(scene, add_vertex(scene, 5, 5, 0), add_vertex(scene, 60, 20, 0),
                 add_vertex(scene, 20, 58, 0));
    return scene;
}

/// A thousand triangles that fill the canvas, each in its own box of 32 x 32 pixels, against a depth
/// buffer.
Scene disjoint() {
    Scene scene = canvas_scene(1024);
    scene.method.depth = Depth::inverse_z;
    for (int i = 0; i < 1000; ++i) {
        const int x = 32 * (i % 32) + 1;
        const int y = 32 * (i / 32) + 1;
        add_triangle(scene, add_vertex(scene, x, y, 2), add_vertex(scene, x + 29, y + 1, 3),
                     add_vertex(scene, x + 1, y + 29, 4));
    }
    return scene;
}

Scene orthographic_cube() {
    Scene scene = canvas_scene(256);
    for (int corner = 0; corner < 8; ++corner)
        add_vertex(scene, (corner & 1) * 2 - 1, (corner & 2) - 1, (corner & 4) / 2 - 1);
    for (const auto& [a, b, c, d] : std::vector<std::array<std::size_t, 4>>{
             {0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}) {
        add_triangle(scene, a, b, c);
        add_triangle(scene, a, c, d);
    }
    scene.camera = Camera{.position = {2, 3, 4}, .look_at = {0, 0, 0}, .up = {0, 1, 0}};
    scene.projection = {.type = ProjectionType::orthographic};
    scene.projection.left = scene.projection.bottom = -2;
    scene.projection.right = scene.projection.top = 2;
    scene.viewport = {.type = ViewportType::pixels, .pixels_per_unit = 1};
    return scene;
}

/// A relief of 2 x 40 x 40 triangles, `scale` times as large as what can be seen of it.
Scene relief(int scale) {
    Scene scene = canvas_scene(512);
    constexpr int side = 40;
    for (int row = 0; row <= side; ++row)
        for (int column = 0; column <= side; ++column)
            add_vertex(scene, Number::fraction(Rational(scale * (2 * column - side)) / side),
                       Number::fraction(Rational(scale * (2 * row - side)) / side),
                       Number::fraction(Rational(-4) - Rational(scale * ((row * column) % 7)) / 2 +
                                        (scale > 1 ? 3 : 0)));
    for (std::size_t row = 0; row < side; ++row)
        for (std::size_t column = 0; column < side; ++column) {
            const std::size_t a = row * (side + 1) + column;
            add_triangle(scene, a, a + 1, a + side + 1);
            add_triangle(scene, a + 1, a + side + 2, a + side + 1);
        }
    scene.projection = {.type = ProjectionType::frustum, .near = Number(2), .far = Number(9)};
    scene.projection.left = scene.projection.bottom = -1;
    scene.projection.right = scene.projection.top = 1;
    scene.viewport = {.type = ViewportType::pixels, .pixels_per_unit = 1};
    return scene;
}

Image draw_planned(const Scene& scene) {
    const Plan plan = plan_for(scene);
    return draw(scene, plan);
}

/// Counts bytes and keeps none.
class CountedOutput : public Output {
public:
    void write(std::string_view bytes) override { count += bytes.size(); }

    std::size_t count = 0;
};

void stages(benchmark::State& state, const Scene& scene) {
    held_bytes = 0;
    peak_bytes = 0;
    benchmark::DoNotOptimize(draw_planned(scene));
    state.counters["memory"] = static_cast<double>(peak_bytes);
    CountedOutput output;
    write_trace(scene, {}, output);
    state.counters["trace"] = static_cast<double>(output.count);
    for (auto _ : state)
        benchmark::DoNotOptimize(draw_planned(scene));
}

/// Writing the steps that a filter lets through: what it does not is not formatted.
void filtered(benchmark::State& state, const StepFilter& filter) {
    const Scene scene = relief(1);
    const Plan plan = plan_for(scene);
    CountedOutput output;
    for (auto _ : state) {
        StepWriter writer(output, TraceLayout::json);
        Arena arena;
        StepTracer<StepWriter> tracer(writer, arena, false, filter);
        benchmark::DoNotOptimize(draw(scene, plan, tracer));
    }
}
void unwatched(benchmark::State& state) {
    const Scene scene = relief(1);
    const Plan plan = plan_for(scene);
    for (auto _ : state)
        benchmark::DoNotOptimize(draw(scene, plan));
}

BENCHMARK(unwatched)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(filtered, only_skip, {.only = {{StepKind::skip}}})->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(filtered, one_pixel, {.region = Region{256, 256, 256, 256}})
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(filtered, one_primitive, {.primitive = "T7"})->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(filtered, everything, {})->Unit(benchmark::kMicrosecond);

const bool stages_are_registered = [] {
    const std::vector<std::pair<std::string, Scene>> scenes{
        {"one triangle", one_triangle()},
        {"1000 disjoint triangles", disjoint()},
        {"an orthographic cube", orthographic_cube()},
        {"a mesh in view", relief(1)},
        {"a mesh across every plane", relief(4)}};
    for (const auto& entry : scenes) {
        const std::string& name = entry.first;
        const Scene& scene = entry.second;
        const auto add = [&name](const std::string& kept, Scene kept_scene) {
            benchmark::RegisterBenchmark(
                ("stages/" + name + "/" + kept).c_str(),
                [kept_scene](benchmark::State& state) { stages(state, kept_scene); })
                ->Unit(benchmark::kMicrosecond);
        };
        add("plan", scene);
        for (const std::string_view stage : stage_names()) {
            Scene kept_scene = scene;
            kept_scene.keep.add(*stage_named(stage));
            add(std::string(stage), kept_scene);
        }
        Scene full = scene;
        full.keep = StageSet::all();
        add("full", full);
    }
    return true;
}();

} // namespace
} // namespace rastertrace
