// SPDX-License-Identifier: MIT
// Writing a trace: ten million steps (80 % pixel, 10 % depth, 10 % scanline) to memory, by the
// StepWriter, by emit.h to /dev/null, and by nlohmann-json's dump() of the same steps. "dyadic": quantities are multiples of
// 1/1024; "full": any 53-bit double.

#define RT_NO_CODE
#include <rastertrace/emit.h>
#include <rastertrace/trace/record/step_tracer.h>
#include <rastertrace/trace/record/step_writer.h>

#include <benchmark/benchmark.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <random>
#include <vector>

namespace rastertrace {
namespace {

constexpr std::size_t step_count = 10'000'000;

/// The numbers of one step; what they mean depends on its kind.
struct Numbers {
    int x, y;
    double a, b;
};

/// A thousand steps' worth of numbers, drawn over and over.
std::vector<Numbers> numbers(bool dyadic) {
    std::mt19937_64 random(1);
    std::vector<Numbers> result;
    for (int i = 0; i < 1000; ++i) {
        const auto quantity = [&random, dyadic] {
            const auto bits = static_cast<std::int64_t>(random() >> 11);
            return dyadic ? static_cast<double>(bits % 1'048'576) / 1024
                          : static_cast<double>(bits) / static_cast<double>(std::int64_t{1} << 43);
        };
        const auto index = [&random] { return static_cast<int>(random() % 512); };
        const int x = index();
        const int y = index();
        const double a = quantity();
        const double b = quantity();
        result.push_back({x, y, a, b});
    }
    return result;
}

/// Counts bytes and forgets them.
class CountingOutput final : public Output {
public:
    void write(std::string_view bytes) override { total += bytes.size(); }
    std::size_t total = 0;
};

/// Step i of the mixture, to one of two writers: pixel, depth, scanline.
template <typename Pixel, typename Depth, typename Scanline>
void for_each_step(const std::vector<Numbers>& all, Pixel&& pixel, Depth&& depth,
                   Scanline&& scanline) {
    std::size_t next = 0;
    for (std::size_t i = 0; i < step_count; i += 10) {
        for (int k = 0; k < 8; ++k)
            pixel(all[next++ % all.size()]);
        depth(all[next++ % all.size()]);
        scanline(all[next++ % all.size()]);
    }
}

void write_with_step_writer(benchmark::State& state, bool dyadic) {
    const auto all = numbers(dyadic);
    for (auto _ : state) {
        CountingOutput output;
        StepWriter writer(output, TraceLayout::jsonl);
        Arena arena;
        StepTracer<StepWriter> tracer(writer, arena, false);
        const std::array<std::string_view, 3> names{"A", "B", "C"};
        const std::array<Vec<Quantity, 2>, 3> places{};
        tracer(PrimitiveBegan<>{.kind = PrimitiveKind::triangle,
                                .name = "ABC",
                                .vertices = names,
                                .at = if_any(places)});
        for_each_step(
            all, [&](const Numbers& n) { tracer(PixelPlotted<>{.x = n.x, .y = n.y}); },
            [&](const Numbers& n) {
                tracer(DepthTested<>{.x = n.x,
                                     .y = n.y,
                                     .depth = n.a,
                                     .stored = OrNull<Quantity>(n.b),
                                     .pass = true});
            },
            [&](const Numbers& n) {
                tracer(ScanlineSpanned<>{.y = n.y,
                                         .left = n.a,
                                         .right = n.b,
                                         .from = n.x,
                                         .to = n.x + 9,
                                         .left_edge = {0, 1},
                                         .right_edge = {0, 2}});
            });
        writer.flush();
        state.counters["bytes per step"] =
            static_cast<double>(output.total) / static_cast<double>(step_count);
    }
    state.counters["steps"] = benchmark::Counter(static_cast<double>(step_count) *
                                                     static_cast<double>(state.iterations()),
                                                 benchmark::Counter::kIsRate);
}

/// emit.h of a foreign rasterizer, without a place in the code, as the other two.
void write_with_emit(benchmark::State& state, bool dyadic) {
    const auto all = numbers(dyadic);
    const auto trace = std::make_unique<rt_trace>();
    for (auto _ : state) {
        std::FILE* const nowhere = std::fopen("/dev/null", "w");
        rt_open_file(trace.get(), nowhere);
        rt_header(trace.get(), 512, 512, "top-left");
        for_each_step(
            all, [&](const Numbers& n) { rt_pixel(trace.get(), n.x, n.y); },
            [&](const Numbers& n) { rt_depth(trace.get(), n.x, n.y, n.a, n.b, 1); },
            [&](const Numbers& n) {
                rt_scanline(trace.get(), n.y, n.a, n.b, n.x, n.x + 9);
                rt_text(trace.get(), "left_edge", "AB");
                rt_text(trace.get(), "right_edge", "AC");
            });
        if (rt_end(trace.get()) != 0)
            state.SkipWithError(rt_error(trace.get()));
        std::fclose(nowhere);
    }
    state.counters["steps"] = benchmark::Counter(static_cast<double>(step_count) *
                                                     static_cast<double>(state.iterations()),
                                                 benchmark::Counter::kIsRate);
}

void write_with_nlohmann(benchmark::State& state, bool dyadic) {
    using nlohmann::ordered_json;
    const auto all = numbers(dyadic);
    for (auto _ : state) {
        std::size_t total = 0;
        const auto line = [&total](const ordered_json& step) { total += step.dump().size() + 1; };
        for_each_step(
            all,
            [&](const Numbers& n) {
                line({{"step", "pixel"}, {"x", n.x}, {"y", n.y}});
            },
            [&](const Numbers& n) {
                line({{"step", "depth"},
                      {"x", n.x},
                      {"y", n.y},
                      {"depth", n.a},
                      {"stored", n.b},
                      {"pass", true}});
            },
            [&](const Numbers& n) {
                line({{"step", "scanline"},
                      {"y", n.y},
                      {"left", n.a},
                      {"right", n.b},
                      {"from", n.x},
                      {"to", n.x + 9},
                      {"left_edge", "AB"},
                      {"right_edge", "AC"}});
            });
        benchmark::DoNotOptimize(total);
        state.counters["bytes per step"] =
            static_cast<double>(total) / static_cast<double>(step_count);
    }
    state.counters["steps"] = benchmark::Counter(static_cast<double>(step_count) *
                                                     static_cast<double>(state.iterations()),
                                                 benchmark::Counter::kIsRate);
}

BENCHMARK_CAPTURE(write_with_nlohmann, dyadic, true)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK_CAPTURE(write_with_step_writer, dyadic, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(write_with_emit, dyadic, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(write_with_nlohmann, full, false)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK_CAPTURE(write_with_step_writer, full, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(write_with_emit, full, false)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace rastertrace
