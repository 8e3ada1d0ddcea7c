// SPDX-License-Identifier: MIT
#include <rastertrace/numerics/report.h>

#include "job_builder.h"

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/text/output.h>

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
    runs[0].run = [&scene] { keep(draw(scene, plan_for(scene))); };
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
bool is_nearer(const Candidate& a, const Candidate& b) {
    return a.error != b.error ? a.error < b.error : is_faster(a, b);
}

/// True if it is right on any scene.
bool never_errs(const Candidate& one) {
    return one.setting->never_errs && one.error == 0;
}

/// True if a time is as good as another, but for the noise of the clock.
bool is_as_fast(double time, double other) {
    return time <= other * (1 + timing_noise);
}

/// Those that `has` holds for.
template <typename Has> std::vector<Candidate> those(std::vector<Candidate> all, const Has& has) {
    std::erase_if(all, [&has](const Candidate& one) { return !has(one); });
    return all;
}

/// The fastest; of those that the clock can not tell apart, one that never errs, or the nearest.
Candidate fastest_of(const std::vector<Candidate>& all) {
    const double least = std::min_element(all.begin(), all.end(), is_faster)->time();
    const auto fast =
        those(all, [least](const Candidate& one) { return is_as_fast(one.time(), least); });
    const auto safe = those(fast, never_errs);
    const auto& among = safe.empty() ? fast : safe;
    return *std::min_element(among.begin(), among.end(), is_nearer);
}

std::vector<Candidate> candidates(const JobReport& job, std::size_t measure) {
    std::vector<Candidate> result;
    for (const Curve& curve : job.curves)
        for (const Setting& setting : curve.settings)
            if (!curve.is_apart && setting.failure.empty() && setting.errors[measure].value)
                result.push_back({&curve, &setting, *setting.errors[measure].value});
    return result;
}

/// "is off by 0.024 px", "has 12 wrong for 300 rows", "is off by 1.2e-07", "has no error here".
std::string error_in_words(const ErrorMeasure& measure, const Candidate& one,
                           const ErrorValue& error) {
    if (never_errs(one))
        return "never errs";
    if (one.error == 0)
        return "has no error here";
    if (error.count)
        return fmt::format("has {} wrong for {} {}", *error.count, error.of, measure.against);
    return fmt::format("is off by {:.3g}{}{}", *error.value, measure.unit.empty() ? "" : " ",
                       measure.unit);
}

/// "1.4 times as long", "207 times as long".
std::string times_as_long(const Candidate& one, const Candidate& other) {
    const double times = one.time() / other.time();
    return times < 10 ? fmt::format("{:.2g} times as long", times)
                      : fmt::format("{:.0f} times as long", times);
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
                if (curve.is_apart || !setting.failure.empty() || !setting.errors[measure].value)
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

std::string advice_for(const JobReport& job, std::size_t index) {
    const auto all = candidates(job, index);
    if (all.empty())
        return "Nothing could be measured.";
    const ErrorMeasure& measure = job.measures[index];
    const auto error = [&](const Candidate& one) {
        return error_in_words(measure, one, one.setting->errors[index]);
    };
    const auto cost = [&](const Candidate& one) {
        return fmt::format("{:.3g} ns per {}", one.time(), job.unit);
    };

    // The fastest that is enough, or the nearest if none is; then what never errs, if that is cheap.
    const auto enough =
        those(all, [&](const Candidate& one) { return one.error <= measure.unseen; });
    Candidate chosen =
        enough.empty() ? *std::min_element(all.begin(), all.end(), is_nearer) : fastest_of(enough);
    const auto safe = those(all, never_errs);
    if (!safe.empty() && fastest_of(safe).time() <= price_of_safety * chosen.time())
        chosen = fastest_of(safe);

    std::string sentence = fmt::format("Choose {}: it {}", chosen.name(), error(chosen));
    if (enough.empty())
        sentence += ", the least of all";
    else if (chosen.error > 0)
        sentence += fmt::format(", no more than {}", measure.unseen_as);
    const Candidate fastest = fastest_of(all);
    const bool is_fastest = is_as_fast(chosen.time(), fastest.time());
    sentence += fmt::format("{} ({}).", is_fastest ? ", and nothing is faster" : "", cost(chosen));

    // What it costs to be right on any scene, and what is had for the least.
    if (!never_errs(chosen) && !safe.empty()) {
        const Candidate safest = fastest_of(safe);
        sentence += fmt::format(" What never errs, {}, takes {} ({}).", safest.name(),
                                times_as_long(safest, chosen), cost(safest));
    }
    if (!is_fastest)
        sentence += fmt::format(" The fastest, {}, {} ({}).", fastest.name(), error(fastest),
                                cost(fastest));
    return sentence;
}

} // namespace rastertrace
