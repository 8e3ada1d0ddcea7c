// SPDX-License-Identifier: MIT
#include <rastertrace/numerics/report.h>

#include "job_builder.h"

#include <rastertrace/numerics/drawing.h>
#include <rastertrace/trace/output.h>
#include <rastertrace/trace/write_trace.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

namespace rastertrace {

namespace {

struct NamedJob {
    ReportJob job;
    std::string_view name;
    JobReport (*measure)(const Scene&, const ReportOptions&);
};
constexpr std::array jobs{NamedJob{ReportJob::edge, "edge", measure_edges},
                          NamedJob{ReportJob::coverage, "coverage", measure_coverage},
                          NamedJob{ReportJob::depth, "depth", measure_depth},
                          NamedJob{ReportJob::color, "color", measure_color}};

const NamedJob& entry_of(ReportJob job) {
    return *std::find_if(jobs.begin(), jobs.end(),
                         [job](const NamedJob& one) { return one.job == job; });
}

/// Counts bytes and drops them.
class NullOutput final : public Output {
public:
    void write(std::string_view bytes) override { bytes_ += bytes.size(); }
    std::uint64_t bytes() const { return bytes_; }

private:
    std::uint64_t bytes_ = 0;
};

/// Draws the scene as it is, and writes its trace to nowhere.
TraceCost trace_cost_of(const Scene& scene, const ReportOptions& options) {
    NullOutput nowhere;
    TraceCost cost;
    cost.steps = write_trace(scene, {}, nowhere);
    cost.bytes = nowhere.bytes();
    std::vector<TimedRun> runs(2);
    runs[0].run = [&scene] { keep(drawn(scene, plan_for(scene))); };
    runs[1].run = [&scene] {
        NullOutput output;
        keep(write_trace(scene, {}, output));
    };
    time_in_turn(runs, options.timing);
    cost.drawing = runs[0].timing;
    cost.writing = runs[1].timing;
    return cost;
}

/// A setting of a job, with the error that is looked at.
struct Candidate {
    const Curve* curve;
    const Setting* setting;
    double error;
    double time() const { return setting->timing.median; }
    std::string name() const { return name_of(*curve, *setting); }
};

bool is_faster(const Candidate& a, const Candidate& b) {
    return a.time() < b.time();
}
bool is_more_exact(const Candidate& a, const Candidate& b) {
    return a.error != b.error ? a.error < b.error : is_faster(a, b);
}

/// The most exact of those that take at most `factor` times the least time.
Candidate most_exact_within(std::vector<Candidate> all, double factor) {
    const double least = std::min_element(all.begin(), all.end(), is_faster)->time();
    std::erase_if(all, [&](const Candidate& one) { return one.time() > factor * least; });
    return *std::min_element(all.begin(), all.end(), is_more_exact);
}

/// Of those that are right on any scene.
std::optional<Candidate> fastest_that_never_errs(std::vector<Candidate> all) {
    std::erase_if(all,
                  [](const Candidate& one) { return !one.setting->never_errs || one.error != 0; });
    if (all.empty())
        return std::nullopt;
    return *std::min_element(all.begin(), all.end(), is_faster);
}

std::vector<Candidate> candidates(const JobReport& job, std::size_t measure) {
    std::vector<Candidate> result;
    for (const Curve& curve : job.curves)
        for (const Setting& setting : curve.settings)
            if (setting.failure.empty() && setting.errors[measure].value)
                result.push_back({&curve, &setting, *setting.errors[measure].value});
    return result;
}

/// "is off by 0.024 px", "has 12 wrong for 300 rows", "is off by 1.2e-07".
std::string error_in_words(const ErrorMeasure& measure, const ErrorValue& error) {
    if (error.count)
        return fmt::format("has {} wrong for {} {}", *error.count, error.of, measure.against);
    return fmt::format("is off by {:.3g}{}{}", *error.value, measure.unit.empty() ? "" : " ",
                       measure.unit);
}

/// True if a time is as good as another, but for the noise of the clock.
bool is_as_fast(double time, double other) {
    return time <= other * (1 + timing_noise);
}

} // namespace

const std::vector<ReportJob>& report_jobs() {
    static const std::vector<ReportJob> all = [] {
        std::vector<ReportJob> result;
        for (const NamedJob& one : jobs)
            result.push_back(one.job);
        return result;
    }();
    return all;
}

std::string_view name_of(ReportJob job) {
    return entry_of(job).name;
}

std::optional<ReportJob> report_job_named(std::string_view name) {
    for (const NamedJob& one : jobs)
        if (one.name == name)
            return one.job;
    return std::nullopt;
}

std::string name_of(const Curve& curve, const Setting& setting) {
    return fmt::format("{}: {}", curve.method, setting.name);
}

SceneReport report_of(const Scene& scene, const ReportOptions& options) {
    SceneReport report;
    report.title = scene.title;
    for (const ReportJob job : options.jobs) {
        if (options.progress)
            options.progress(fmt::format("{}: errors", name_of(job)));
        report.jobs.push_back(entry_of(job).measure(scene, options));
    }
    if (report.has_measured() && !find_unfit(scene))
        report.trace = trace_cost_of(scene, options);
    return report;
}

void mark_fronts(JobReport& job) {
    for (Curve& curve : job.curves)
        for (Setting& setting : curve.settings)
            setting.on_front.assign(job.measures.size(), false);
    for (std::size_t measure = 0; measure < job.measures.size(); ++measure) {
        const auto all = candidates(job, measure);
        for (Curve& curve : job.curves)
            for (Setting& setting : curve.settings) {
                if (!setting.failure.empty() || !setting.errors[measure].value)
                    continue;
                const double error = *setting.errors[measure].value;
                const double time = setting.timing.median;
                setting.on_front[measure] =
                    std::none_of(all.begin(), all.end(), [&](const Candidate& other) {
                        return other.error < error
                                   ? is_as_fast(other.time(), time)
                                   : other.error == error && !is_as_fast(time, other.time());
                    });
            }
    }
}

Advice advice_for(const JobReport& job, std::size_t measure) {
    const auto all = candidates(job, measure);
    if (all.empty())
        return {"Nothing could be measured."};
    const auto error = [&](const Candidate& one) {
        return error_in_words(job.measures[measure], one.setting->errors[measure]);
    };
    const auto cost = [&](const Candidate& one) {
        return fmt::format("{:.3g} ns per {}", one.time(), job.unit);
    };

    // The most exact of all, of the fastest, and of those that are almost as fast.
    constexpr double almost = 2;
    const Candidate best = *std::min_element(all.begin(), all.end(), is_more_exact);
    const Candidate fastest = most_exact_within(all, 1 + timing_noise);
    const Candidate near = most_exact_within(all, almost);

    // No error on this scene need not mean none on another: name what cannot have any.
    const bool may_err_elsewhere = best.error == 0 && !best.setting->never_errs;
    const std::string of_best = best.error > 0      ? error(best)
                                : may_err_elsewhere ? "has no error here"
                                                    : "has no error";
    std::string instead;
    if (const auto safest = fastest_that_never_errs(all); may_err_elsewhere && safest)
        instead = fmt::format("; {} never has any ({})", safest->name(), cost(*safest));

    if (fastest.error == best.error)
        return {fmt::format("Choose {}: it {}, and nothing is faster ({}){}.", fastest.name(),
                            of_best, cost(fastest), instead)};
    const std::string choice =
        fmt::format("Choose {}: it {}{} ({}){}", best.name(), of_best,
                    best.error == 0 ? "" : ", the least of all", cost(best), instead);
    const std::string speed =
        fmt::format("the fastest, {} ({}), {}", fastest.name(), cost(fastest), error(fastest));
    if (near.error == best.error || near.error == fastest.error)
        return {fmt::format("{}; {}.", choice, speed)};
    return {fmt::format("{}; {}; within twice that time {} {} ({}).", choice, speed, near.name(),
                        error(near), cost(near))};
}

} // namespace rastertrace
