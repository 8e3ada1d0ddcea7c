// SPDX-License-Identifier: MIT
#include "job_builder.h"

#include "placed_triangles.h"

#include <rastertrace/core/draw/paint/fill.h>
#include <rastertrace/trace/scene/refusal.h>
#include <rastertrace/trace/text/method_names.h>

#include <fmt/core.h>

#include <algorithm>

namespace rastertrace {

JobReport JobBuilder::finish(const ReportOptions& options) {
    if (!runs_.empty())
        time_in_turn(runs_, options.timing, [&](int round, int rounds) {
            if (options.progress)
                options.progress(
                    fmt::format("{}: round {} of {}", name_of(report_.job), round + 1, rounds));
        });
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        const auto [curve, setting] = places_[i];
        report_.curves[curve].settings[setting].timing = runs_[i].timing;
    }
    mark_fronts(report_);
    for (std::size_t measure = 0; measure < report_.measures.size(); ++measure)
        report_.advice.push_back(advice_for(report_, measure));
    return std::move(report_);
}

JobReport nothing_of(ReportJob job, std::string why) {
    JobReport report;
    report.job = job;
    report.nothing = std::move(why);
    return report;
}

Setting bits_setting(int bits) {
    Setting setting;
    setting.name = fmt::format("{} bits", bits);
    setting.label = fmt::format("{}", bits);
    return setting;
}

Setting interval_setting(int interval, std::string_view of) {
    Setting setting;
    const bool is_never = interval == without_end;
    setting.name = is_never        ? "never"
                   : interval == 1 ? fmt::format("every {}", of)
                                   : fmt::format("every {} {}s", interval, of);
    setting.label = is_never ? "never" : fmt::format("{}", interval);
    return setting;
}

Setting named_setting(std::string_view name) {
    Setting setting;
    setting.name = name;
    setting.label = name;
    return setting;
}

Setting exact_setting(Setting setting) {
    setting.never_errs = true;
    return setting;
}

Scene plain_scene(const Scene& scene, ScalarKind scalar) {
    Scene plain = scene;
    plain.method.scalar = scalar;
    plain.method.depth = Depth::none;
    plain.method.shade = Shade::flat;
    plain.keep = {};
    return plain;
}

std::vector<ScalarSetting> scalar_settings() {
    const MethodKey& key = *find_method_key("scalar");
    std::vector<ScalarSetting> others;
    std::vector<ScalarSetting> all;
    for (const std::string_view name : key.values) {
        Method method;
        key.set(method, name);
        if (method.scalar != ScalarKind::fixed)
            others.push_back({method.scalar, std::string(name), {}});
        else
            for (const int bits : subpixel_bits)
                all.push_back({method.scalar, std::string(name), bits});
    }
    all.insert(all.end(), others.begin(), others.end());
    return all;
}

std::string refusal_in_words(const Scene& scene) {
    const auto unfit = find_unfit(scene);
    return unfit ? refusal_of(scene, *unfit).message : std::string();
}

namespace {

/// Keeps the rows that a fill yields, as far as the canvas has them.
struct SpanSink {
    const Canvas& canvas;
    std::vector<PieceSpan>& spans;

    template <typename Step> void operator()(const Step&) {}
    template <typename Scalar> void operator()(const ScanlineSpanned<Scalar>& span) {
        const int from = static_cast<int>(std::max<Index>(span.from, canvas.left()));
        const int to = static_cast<int>(std::min<Index>(span.to, canvas.right()));
        if (from <= to)
            spans.push_back({span.y, from, to});
    }
    template <typename Step> bool takes() const { return false; }
};

} // namespace

std::vector<SpansOfPiece> exact_spans(const Scene& scene) {
    Scene exact = plain_scene(scene, ScalarKind::exact);
    exact.method.fill = Fill::top_left;
    exact.method.sample.reset();
    const Plan plan = plan_for(exact);
    std::vector<SpansOfPiece> pieces;
    with_scalar(plan, [&]<typename Scalar>() {
        const auto grid = sample_grid<Scalar>(exact, plan);
        for_each_placed_triangle<Scalar>(exact, plan, [&](const Piece<Scalar>& triangle) {
            auto& spans = pieces.emplace_back(SpansOfPiece{triangle.primitive, {}}).spans;
            if (!triangle.is_skipped)
                fill_top_left(Triangle<Scalar>{triangle.positions}, grid, exact.canvas,
                              SpanSink{exact.canvas, spans});
        });
    });
    return pieces;
}

std::uint64_t pixels_in(const std::vector<SpansOfPiece>& pieces) {
    std::uint64_t pixels = 0;
    for (const SpansOfPiece& piece : pieces)
        for (const PieceSpan& span : piece.spans)
            pixels += static_cast<std::uint64_t>(span.to - span.from + 1);
    return pixels;
}

} // namespace rastertrace
