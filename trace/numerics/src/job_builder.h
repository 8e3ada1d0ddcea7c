// SPDX-License-Identifier: MIT
#pragma once

// What the jobs of the report have in common: curves are put together, then all their settings are
// timed in turn.

#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/numerics/knobs.h>
#include <rastertrace/numerics/report.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

/// An exact value in two doubles: the nearest one, and what is nearest to the rest. The error of a
/// double against it is exact but for its own last place.
struct ExactValue {
    double near = 0;
    double rest = 0;

    ExactValue() = default;
    explicit ExactValue(const Rational& exact)
        : near(nearest_double(exact)),
          rest(std::isfinite(near) ? nearest_double(exact - Rational(near)) : 0) {}

    double error_of(double value) const { return std::abs((value - near) - rest); }
};

/// A job being measured.
class JobBuilder {
public:
    explicit JobBuilder(ReportJob job) { report_.job = job; }

    JobReport& report() { return report_; }

    /// Begins a curve: what is added next belongs to it.
    void begin_curve(std::string method, std::string knob, bool is_apart = false) {
        report_.curves.push_back({std::move(method), std::move(knob), {}, is_apart});
    }

    /// Adds a setting; `run` does the whole work once, so many units.
    void add(Setting setting, std::function<void()> run, std::uint64_t units) {
        for (const ErrorValue& error : setting.errors)
            if (error.value && !std::isfinite(*error.value))
                setting.failure = "its error is infinite, or no number";
        setting.units = units;
        if (setting.failure.empty()) {
            places_.emplace_back(report_.curves.size() - 1, report_.curves.back().settings.size());
            runs_.push_back({std::move(run), static_cast<double>(units)});
        } else {
            setting.errors.clear();
        }
        report_.curves.back().settings.push_back(std::move(setting));
    }

    /// Adds one that cannot be measured.
    void add_failure(Setting setting, std::string failure) {
        setting.never_errs = false;
        setting.failure = std::move(failure);
        add(std::move(setting), {}, 0);
    }

    /// Times everything, and draws the conclusions.
    JobReport finish(const ReportOptions& options);

private:
    JobReport report_;
    std::vector<TimedRun> runs_;
    std::vector<std::pair<std::size_t, std::size_t>> places_; ///< of their curves and settings
};

/// A job that has nothing to measure.
JobReport nothing_of(ReportJob job, std::string why);

/// The settings of knobs.
inline constexpr std::array subpixel_bits{0, 4, 8, 12, 16};
inline constexpr std::array reseed_intervals{1, 4, 16, 64, without_end};
inline constexpr std::array divide_intervals{1, 8, 16, 64};
inline constexpr std::array depth_buffer_bits{16, 24, 32};

/// A setting's name and label: "8 bits" and "8"; "every 16 rows" and "16", or "never".
Setting bits_setting(int bits);
Setting interval_setting(int interval, std::string_view of);
Setting named_setting(std::string_view name);
Setting exact_setting(Setting setting); ///< of a method that never errs

/// The scene with other numbers, and nothing but the fill of its primitives: no depths, no colors of
/// vertices.
Scene plain_scene(const Scene& scene, ScalarKind scalar);

/// One kind of scalar as the scene's method names it; of `fixed`, so many bits behind the point.
struct ScalarSetting {
    ScalarKind kind = ScalarKind::double_precision;
    std::string name;
    std::optional<int> bits;

    /// True if nothing that it decides is rounded: of a scene as typed.
    bool never_errs() const {
        return kind != ScalarKind::single_precision && kind != ScalarKind::double_precision &&
               kind != ScalarKind::fixed;
    }
};

/// Every scalar that a method can name, `fixed` with every grid before the others.
std::vector<ScalarSetting> scalar_settings();

/// Why a scene cannot be drawn with its scalar, or "".
std::string refusal_in_words(const Scene& scene);

/// The pixels of the exact top-left fill, in rows: depths and colors are measured on these, so that
/// nothing but depth or color can be wrong.
struct PieceSpan {
    int y = 0;
    int from = 0;
    int to = 0;
};
struct SpansOfPiece {
    std::size_t primitive = 0; ///< its place in the scene
    std::vector<PieceSpan> spans;
};
std::vector<SpansOfPiece> exact_spans(const Scene& scene);
std::uint64_t pixels_in(const std::vector<SpansOfPiece>& pieces);

/// Why a method has no part in a job: its pieces are not those of exact_spans.
inline constexpr auto clipped_otherwise =
    "clipping has left other triangles than in exact arithmetic";

JobReport measure_edges(const Scene& scene, const ReportOptions& options);
JobReport measure_coverage(const Scene& scene, const ReportOptions& options);
JobReport measure_depth(const Scene& scene, const ReportOptions& options);
JobReport measure_color(const Scene& scene, const ReportOptions& options);

} // namespace rastertrace
