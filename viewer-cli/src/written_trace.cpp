// SPDX-License-Identifier: MIT
#include "written_trace.h"

#include <rastertrace/trace/record/excerpt.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/trace_text.h>

#include <unistd.h>

#include <utility>

namespace rastertrace {

void write_part_of(const Source& given, const std::vector<std::string>& kinds, TraceLayout layout,
                   Output& output) {
    const TraceText text(given);
    const Trace trace = value_or_throw(read_trace(given));
    write_excerpt(trace, text.header_json(), kinds, layout, output);
    report_damage(trace);
}

TraceProgress::TraceProgress(std::string doing, const std::string& path) {
    if (!is_standard_output(path) || ::isatty(STDOUT_FILENO) == 0)
        progress_.emplace(LongWork{.doing = std::move(doing),
                                   .unit = "MB written",
                                   .done = [] { return bytes_done().written; },
                                   .one_unit = bytes_in_a_megabyte});
}

} // namespace rastertrace
