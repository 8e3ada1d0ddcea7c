// SPDX-License-Identifier: MIT
// rastertrace report: error against run time, for every method and scalar.

#include "app/command.h"
#include "app/exit_status.h"
#include "app/load.h"
#include "app/option_values.h"
#include "app/progress.h"
#include "app/shared_options.h"
#include "commands/report_file.h"

#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// What a setting may take when there is no time: enough to see what is fast and what is slow.
constexpr TimingRules quick_timing{.runs = 20, .shortest_run = 2e-5, .most_time = 0.03};

constexpr std::array<Ending<ReportFormat>, 5> report_endings{{{".svg", ReportFormat::svg},
                                                              {".html", ReportFormat::html},
                                                              {".json", ReportFormat::json},
                                                              {".csv", ReportFormat::csv},
                                                              {".txt", ReportFormat::text}}};

/// The format of a file, by how its name ends.
ReportFormat format_of(const std::string& path) {
    if (const auto format = format_by_ending<ReportFormat>(path, report_endings))
        return *format;
    refuse_ending(path, endings_in<ReportFormat>(report_endings));
}

/// Why nothing of a scene could be measured.
std::string reasons_of(const SceneReport& scene) {
    std::string text;
    for (const JobReport& job : scene.jobs)
        text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", name_of(job.job), job.nothing);
    return text;
}

class ReportCommand final : public Command {
public:
    CommandAbout about() const override {
        return {"report", "Measure error against run time, for every method and scalar",
                "rastertrace report examples/numerics/friendly.json --quick --jobs edge"};
    }

    void add_to(OptionList& options) override {
        options.option("scene", scenes_, "Scenes; - for standard input", "SCENE...").required();
        options
            .option("-o,--output", outputs_,
                    "Write to this file instead of standard output: .svg, .html, .json, .csv "
                    "or .txt; may be given again",
                    "FILE")
            .repeatable();
        options
            .option("--format", format_name_, "How to write it, whatever the file's name", "NAME")
            .values({"text", "json", "csv", "svg", "html"});
        options.option("--jobs", names_of_jobs_, "Measure only these jobs", "JOB,...")
            .values(job_names());
        options.flag("--quick", quick_, "Take seconds, not minutes; times are rough");
        drawing_.add_to(options, Holds::no_steps);
    }

    void read() override {
        const std::vector<std::string_view> formats{"text", "json", "csv", "svg", "html"};
        format_ = value_of<ReportFormat>("--format", format_name_, formats);
        jobs_ = values_of("--jobs", "jobs", names_of_jobs_, job_names(), report_job_named);
        options_ = drawing_.scene_options();
    }

    int run() override {
        // Everything that can be refused is, before minutes of measuring: the scenes, and the files.
        std::vector<Scene> scenes;
        for (const std::string& path : scenes_) {
            PlannedScene planned = load_scene(path, options_);
            planned.scene.title = shown_title(planned.scene.title, path);
            scenes.push_back(std::move(planned.scene));
        }
        std::vector<ReportFormat> formats;
        for (const std::string& path : outputs_)
            formats.push_back(format_ ? *format_ : format_of(path));
        FileOutputs outputs;
        std::vector<FileOutput*> files;
        for (const std::string& path : outputs_)
            files.push_back(&outputs.open(path));

        MeasuredReport report{.machine = this_machine(), .timing = {}, .scenes = {}};
        if (quick_)
            report.timing = quick_timing;
        {
            Progress progress({.doing = "report"});
            for (std::size_t i = 0; i < scenes.size(); ++i) {
                const std::string title = shortened(printable(scenes[i].title), 40);
                ReportOptions options{.timing = report.timing,
                                      .progress = [&](std::string_view what) {
                                          progress.say(fmt::format("{}: {}", title, what));
                                      }};
                if (!jobs_.empty())
                    options.jobs = jobs_;
                SceneReport scene = report_of(scenes[i], options);
                if (!scene.has_measured())
                    throw problem_of(scenes_[i],
                                     fmt::format("expected something to measure, found none ({})",
                                                 reasons_of(scene)));
                report.scenes.push_back(std::move(scene));
            }
        }

        if (files.empty())
            print(report_in(format_.value_or(ReportFormat::text), report));
        for (std::size_t i = 0; i < files.size(); ++i)
            files[i]->write(report_in(formats[i], report));
        outputs.commit();
        return exit_fine;
    }

private:
    static std::vector<std::string_view> job_names() {
        std::vector<std::string_view> names;
        for (const ReportJob job : report_jobs())
            names.push_back(name_of(job));
        return names;
    }

    std::vector<std::string> scenes_;
    std::vector<std::string> outputs_; ///< none: standard output
    std::string format_name_;
    std::optional<ReportFormat> format_;
    std::string names_of_jobs_;
    std::vector<ReportJob> jobs_; ///< none: all of them
    bool quick_ = false;
    DrawingOptions drawing_;
    SceneOptions options_;
};

} // namespace

std::unique_ptr<Command> report_command() {
    return std::make_unique<ReportCommand>();
}

} // namespace rastertrace
