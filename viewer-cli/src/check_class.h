// SPDX-License-Identifier: MIT
#pragma once

// The sheets of a class: one for each file, or folder, in a folder.

#include "check_report.h"

#include <rastertrace/figures/drawing.h>

#include <functional>
#include <string>
#include <vector>

namespace rastertrace {

class ClaimsChecker;

/// What has been found about a class.
struct ClassMarks {
    std::vector<SheetMark> sheets;       ///< by name
    std::vector<std::string> left_out;   ///< files that are no sheets
    std::vector<std::string> duplicates; ///< "2 sheets of anna: anna/a.txt, anna/b.txt"
};

/// Marks the sheets in a folder on all cores, each thread with a checker of its own. What cannot be checked is a problem
/// of its sheet. Throws a Problem if there are no sheets.
ClassMarks mark_class(const std::string& folder,
                      const std::function<ClaimsChecker()>& make_checker);

/// A line for each sheet, then the slips as bars.
std::string class_text(const ClassMarks& marks);

/// The slips as bars.
Drawing slip_chart(const std::vector<SheetMark>& sheets);

} // namespace rastertrace
