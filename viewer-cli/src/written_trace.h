// SPDX-License-Identifier: MIT
#pragma once

// How a command writes a trace: to standard output or a file, packed or not, as it is or as flat steps.
//
//     write_whole(command.output, [&](Output& output) { write_trace(scene, plan, options, output); });

#include "load.h"
#include "progress.h"

#include <rastertrace/trace/record/flat_steps.h>
#include <rastertrace/trace/record/trace_options.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/packed.h>
#include <rastertrace/trace/text/process_files.h>

#include <optional>
#include <string>
#include <vector>

namespace rastertrace {

/// True if that is no file.
inline bool is_standard_output(const std::string& path) {
    return path.empty() || path == "-";
}

/// Lets somebody write to an output, packed if the name of its file says so.
template <typename Write>
void write_packed(const std::string& path, Output& output, const Write& write) {
    PackedOutput packed(output, packing_named(path));
    write(packed);
    packed.finish();
}

/// Lets somebody write to standard output, or to a file that gets its name when all is there.
template <typename Write> void write_whole(const std::string& path, const Write& write) {
    if (is_standard_output(path)) {
        DescriptorOutput output = standard_output();
        write(output);
        return;
    }
    FileOutput output(path, opened_files());
    write_packed(path, output, write);
    output.commit();
}

/// Lets somebody write a trace in JSON Lines, of which the flat steps go to the output; without a form, the trace.
template <typename Write>
void write_flat(std::optional<FlatForm> form, Output& output, const Write& write) {
    if (!form)
        return write(output);
    FlatSteps flat(output, *form);
    write(flat);
    flat.finish();
}

/// Writes the steps of these kinds, or all if none is named, of a trace that was read whole; tells what may be wrong
/// with it. Throws a Problem, as write_excerpt does.
void write_part_of(const Source& given, const std::vector<std::string>& kinds, TraceLayout layout,
                   Output& output);

/// The progress of a command that writes such an output: none beside rows on a terminal.
class TraceProgress {
public:
    TraceProgress(std::string doing, const std::string& path);

private:
    std::optional<Progress> progress_;
};

} // namespace rastertrace
