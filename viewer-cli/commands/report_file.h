// SPDX-License-Identifier: MIT
#pragma once

// The report of error against run time, as text for a terminal, JSON, CSV, SVG and HTML.
//
//     print(report_text(measured));

#include <rastertrace/numerics/report.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
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

/// What was counted: operations, pixels, fallbacks.
struct WorkColumn {
    std::string_view key;  ///< "adds"
    std::string_view name; ///< "additions"
    std::uint64_t Work::*count;
    bool is_operation = true;
    bool is_per_unit = true; ///< in tables for people
};
inline constexpr std::array work_columns{
    WorkColumn{"adds", "additions", &Work::adds},
    WorkColumn{"multiplies", "multiplications", &Work::multiplies},
    WorkColumn{"divides", "divisions", &Work::divides},
    WorkColumn{"comparisons", "comparisons", &Work::comparisons},
    WorkColumn{"pixels_tested", "pixels tested", &Work::pixels_tested, false},
    WorkColumn{"exact_fallbacks", "exact fallbacks, in all", &Work::exact_fallbacks, false, false}};

/// How much of it there was, if it was counted.
inline std::optional<std::uint64_t> count_in(const WorkColumn& column,
                                             const std::optional<Work>& work) {
    if (!work || (column.is_operation && !work->has_operations))
        return std::nullopt;
    return (*work).*column.count;
}

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
