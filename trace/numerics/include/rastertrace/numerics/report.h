// SPDX-License-Identifier: MIT
#pragma once

// Error against run time: every method for a job, on the same scene, with the settings of its knob.
// A work-precision report, as Hairer and Wanner made them for solvers of differential equations
// ("Solving Ordinary Differential Equations II").
//
//     const SceneReport report = report_of(scene, {});
//     report.jobs[0].curves[0].settings[0].errors[0];
//
// Errors are against exact arithmetic on the scene as typed, never against double. All but the
// times, and what follows from times, is the same whenever it is run.

#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/numerics/counted.h>
#include <rastertrace/numerics/timing.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// What a rasterizer does, taken apart so that each error has one cause.
enum class ReportJob {
    edge,     ///< x of every edge in every row of pixels
    coverage, ///< which pixels a triangle has
    depth,    ///< which triangle is seen in a pixel
    color,    ///< what the colors of the vertices mix to in a pixel
};

/// All jobs, in the order in which they are reported, and their names.
const std::vector<ReportJob>& report_jobs();
std::string_view name_of(ReportJob job);
std::optional<ReportJob> report_job_named(std::string_view name);

/// What is called an error.
struct ErrorMeasure {
    std::string_view key;          ///< "wrong_rows"
    std::string_view name;         ///< "wrong rows / rows"
    std::string_view unit;         ///< "px"; empty where there is none
    std::string_view against = {}; ///< of a ratio: what the wrong ones are counted against: "rows"
    double unseen = 0; ///< an error up to this is enough: nothing that is drawn shows it
    std::string_view unseen_as = {}; ///< why, if it is not 0: "what rounding to a float may change"
};

/// In pixels. Graphics hardware snaps vertices to 1/256 px (Direct3D 11, 3.4.1) and so moves them by up to
/// half of that: nobody misses what is less in x.
inline constexpr double unseen_x = 1.0 / 512;

/// Relative to 1/z. No depth buffer in use holds more than a float does, which rounds by up to 2^-24.
inline constexpr double unseen_inverse_z = 0x1p-24;

/// In levels of 255. An eye can hardly tell a level from the next one.
inline constexpr double unseen_level = 1;

/// Times. What never errs, on no scene, is chosen if it takes at most so many times as long as the fastest
/// that is enough on this one.
inline constexpr double price_of_safety = 2;

/// One error of one method.
struct ErrorValue {
    std::optional<double> value;             ///< none where the method has no such error
    std::optional<std::uint64_t> count = {}; ///< of a ratio: so many are wrong
    std::uint64_t of = 0;                    ///< out of these

    static ErrorValue ratio(std::uint64_t wrong, std::uint64_t of) {
        return {static_cast<double>(wrong) / static_cast<double>(of), wrong, of};
    }
};

/// A method with its knob in one position: a mark on the plot.
struct Setting {
    std::string name;    ///< "8 bits"
    std::string label;   ///< short, beside the mark: "8"
    std::string failure; ///< why it could not be measured, or what it gave that is no number
    std::string note;    ///< what is timed, where that is not quite the others' work
    std::vector<ErrorValue> errors; ///< one for each of the job's measures, unless it failed
    std::vector<bool> on_front;     ///< for each measure: nothing is both faster and nearer
    bool never_errs = false;        ///< its error is 0 on any scene, not only on this one
    std::optional<Work> work;       ///< none where the method's numbers cannot be counted
    /// Of a method that snaps vertices: how many pixels differ from exact arithmetic on the snapped
    /// ones. 0, or the method is wrong.
    std::optional<std::uint64_t> wrong_when_snapped;
    std::uint64_t units = 0; ///< how much work it was
    Timing timing;           ///< ns per unit
};

/// A method, with its knob from one end to the other: a line on the plot.
struct Curve {
    std::string method; ///< "x accumulated, float"
    std::string knob;   ///< "reseeded every so many rows"
    std::vector<Setting> settings;
    /// It does something else than the others and is compared with that: no front and no advice has it.
    bool is_apart = false;
};

/// One job on one scene.
struct JobReport {
    ReportJob job = ReportJob::edge;
    std::string nothing; ///< why there is nothing to measure; then there are no curves
    std::string unit;    ///< what time is measured for: "row"
    std::uint64_t units = 0;
    std::string reference; ///< what is exact here, in words
    std::vector<ErrorMeasure> measures;
    std::vector<Curve> curves;
    std::vector<std::string> advice; ///< what to choose, a sentence or more for each measure
};

/// What writing the trace costs, apart from all the rest. Times are ns for the whole scene.
struct TraceCost {
    std::uint64_t steps = 0;
    std::uint64_t bytes = 0;
    Timing drawing; ///< without a sink
    Timing writing; ///< drawing and writing; nothing is stored
};

/// All jobs on one scene.
struct SceneReport {
    std::string title;
    std::vector<JobReport> jobs;
    TraceCost trace; ///< no steps if the scene cannot be drawn with its own scalar

    /// True if there was something to measure.
    bool has_measured() const {
        for (const JobReport& job : jobs)
            if (job.nothing.empty())
                return true;
        return false;
    }
};

struct ReportOptions {
    std::vector<ReportJob> jobs = report_jobs();
    TimingRules timing;
    std::function<void(std::string_view)> progress; ///< told what is being done
};

/// Measures a scene.
SceneReport report_of(const Scene& scene, const ReportOptions& options);

/// Median times that differ by less than this part of them are the same: runs of one and the same
/// loop differ by as much.
inline constexpr double timing_noise = 0.02;

/// Finds out for each measure which settings are on the Pareto front: no other has a smaller error in
/// a time that is no longer, or the same error in a shorter time. Failures are not on it.
void mark_fronts(JobReport& job);

/// What to choose when price matters, from errors and median times: the fastest whose error is no more than
/// the measure's `unseen`, or what never errs if that takes no longer than price_of_safety times as long; where
/// nothing is that near, the least error. Says what it costs never to err, and what the fastest of all does.
std::string advice_for(const JobReport& job, std::size_t measure);

/// "x accumulated, float: every 16 rows".
std::string name_of(const Curve& curve, const Setting& setting);

} // namespace rastertrace
