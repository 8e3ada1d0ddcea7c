// SPDX-License-Identifier: MIT
#pragma once

// Counts what the steps of a foreign rasterizer have that this program does not know. It is allowed; but a name may
// also be mistyped.
//
//     UnknownNames unknown;
//     unknown.add(step, kind);
//     unknown.remarks();  // {"kinds of step that this program does not know: wobble (3)"}

#include <rastertrace/trace/record/step_kind.h>
#include <rastertrace/trace/record/trace.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rastertrace {

/// True if a step names a kind that this program does not know.
bool is_foreign(const StepView& step);

class UnknownNames {
public:
    /// Takes a step, with its kind as the trace tells it.
    void add(const StepView& step, std::optional<StepKind> kind);

    /// What was found, a line for the kinds and a line for the fields; none if all are known.
    std::vector<std::string> remarks() const;

private:
    std::map<std::string, std::uint64_t> kinds_;
    std::map<std::string, std::uint64_t> fields_; ///< `scanline.lft`
};

} // namespace rastertrace
