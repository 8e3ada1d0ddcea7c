// SPDX-License-Identifier: MIT
#pragma once

// The report of error against run time, as text for a terminal, JSON, CSV, SVG and HTML.
//
//     print(report_text(measured));

#include <rastertrace/numerics/report.h>

#include <string>
#include <vector>

namespace rastertrace {

/// Where and how times were measured: they mean nothing without it.
struct Machine {
    std::string cpu; ///< "" where the system does not tell
    std::string compiler;
    std::string flags;
    std::string version; ///< of the program
};
Machine this_machine();

/// What is written down.
struct MeasuredReport {
    Machine machine;
    TimingRules timing;
    std::vector<SceneReport> scenes;
};

enum class ReportFormat { text, json, csv, svg, html };

/// Lines of at most 100 characters.
std::string report_text(const MeasuredReport& report);
std::string report_json(const MeasuredReport& report);
/// A line for each setting and measure, RFC 4180.
std::string report_csv(const MeasuredReport& report);
/// Every plot, scene by scene and job by job.
std::string report_svg(const MeasuredReport& report);
/// The same with the tables; one file, no scripts.
std::string report_html(const MeasuredReport& report);

std::string report_in(ReportFormat format, const MeasuredReport& report);

} // namespace rastertrace
