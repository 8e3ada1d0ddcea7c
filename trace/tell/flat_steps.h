// SPDX-License-Identifier: MIT
#pragma once

// The steps of a trace as lines for databases and data frames: each step as the trace has it, behind its number and the
// name of the primitive, or part, that it belongs to, if one has begun. No header, no end record.
//
//     FlatSteps flat(output);  // {"n":2,"in":"ABC","step":"scanline","y":3,...}
//     write_trace(scene, {.layout = TraceLayout::jsonl}, flat);
//     flat.finish();

#include <rastertrace/trace/text/output.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace rastertrace {

/// Takes a trace in JSON Lines, and writes its steps to another output.
class FlatSteps final : public Output {
public:
    explicit FlatSteps(Output& to) : to_(to) {}

    /// Takes the next bytes of the trace, which need not end with a line.
    void write(std::string_view bytes) override;

    /// Writes what is left: to be called behind the last byte.
    void finish();

private:
    void take_line(std::string_view line);

    Output& to_;
    std::string line_; ///< the beginning of a line whose end is not there yet
    std::string text_; ///< that is not written yet
    std::string in_;   ///< the name of the primitive that has begun, as JSON; "": none yet
    std::size_t steps_ = 0;
    bool is_behind_header_ = false;
};

} // namespace rastertrace
