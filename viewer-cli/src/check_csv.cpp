// SPDX-License-Identifier: MIT
#include "check_report.h"

#include <rastertrace/trace/text/csv.h>

#include <algorithm>

namespace rastertrace {

std::string check_csv(const std::vector<SheetMark>& marks, CheckTold told) {
    const bool has_exercises = std::any_of(
        marks.begin(), marks.end(), [](const SheetMark& mark) { return !mark.exercise.empty(); });
    std::string text;
    std::vector<std::string> head{"file", "right", "wrong", "follow", "open"};
    if (told == CheckTold::answers)
        head.emplace_back("likely_slip");
    if (has_exercises)
        head.emplace_back("exercise");
    put_csv_line(text, head);
    for (const SheetMark& mark : marks) {
        std::vector<std::string> line{mark.name};
        const Checked& counts = mark.counts;
        for (const std::size_t count : {counts.right, counts.wrong, counts.follow, counts.open})
            line.push_back(mark.problem ? "" : std::to_string(count));
        if (told == CheckTold::answers)
            line.push_back(mark.counts.slips.empty() ? "" : mark.counts.slips.front());
        if (has_exercises)
            line.push_back(mark.exercise);
        put_csv_line(text, line);
    }
    return text;
}

} // namespace rastertrace
