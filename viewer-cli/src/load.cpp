// SPDX-License-Identifier: MIT
#include "load.h"

#include <rastertrace/trace/output.h>
#include <rastertrace/trace/scene_file.h>

#include <fmt/core.h>

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <utility>

namespace rastertrace {

namespace {

/// What is printed must not go into a file that is read, as after `>>` it would.
void refuse_as_standard_output(const std::vector<FileId>& inputs) {
    struct stat status {};
    if (::fstat(STDOUT_FILENO, &status) != 0 || !S_ISREG(status.st_mode))
        return;
    const FileId output{.device = status.st_dev, .inode = status.st_ino};
    if (std::find(inputs.begin(), inputs.end(), output) != inputs.end())
        throw problem_of("standard output",
                         "expected another file than those that are read, found one of them");
}

/// What was read, unless standard output would go into it.
Source input_or_throw(Result<Source> read) {
    Source source = value_or_throw(std::move(read));
    if (source.file)
        refuse_as_standard_output({*source.file});
    return source;
}

/// Reads a file that is a scene or a trace.
Source read_input(const std::string& path, const InputLimits& limits) {
    return input_or_throw(read_source(path, limits));
}

PlannedScene planned(const Source& source, const MethodOverrides& method,
                     const InputLimits& limits) {
    PlannedScene scene = value_or_throw(read_scene(source, method, limits));
    refuse_as_standard_output(scene.files);
    for (const Problem& remark : scene.remarks)
        print_error(fmt::format("rastertrace: {}\n", to_text(remark)));
    return scene;
}

Trace titled(Trace trace, const std::string& path) {
    trace.title = shown_title(trace.title, path);
    return trace;
}

} // namespace

Source load_scene_source(const std::string& path, const InputLimits& limits) {
    Source source = read_input(path, limits);
    if (is_trace(source))
        throw problem_of(source.name, "expected a scene, found a trace",
                         "a trace is what this command makes; `show` and `stats` read it");
    return source;
}

PlannedScene load_scene(const std::string& path, const MethodOverrides& method,
                        const InputLimits& limits) {
    return planned(load_scene_source(path, limits), method, limits);
}

std::string shown_title(const std::string& title, const std::string& path) {
    if (!title.empty())
        return title;
    return path == "-" ? "standard input" : path.substr(path.find_last_of('/') + 1);
}

Trace load_trace(const std::string& path, const MethodOverrides& method,
                 const InputLimits& limits) {
    Source source = read_input(path, limits);
    if (is_trace(source)) {
        if (!method.empty())
            throw problem_of(source.name,
                             fmt::format("expected a scene to draw with --{} {}, found a trace, "
                                         "which is drawn already",
                                         method.front().first, method.front().second));
        return titled(value_or_throw(read_trace(std::move(source))), path);
    }
    const auto [scene, plan, files, remarks] = planned(source, method, limits);
    Source drawn{.name = source.name, .text = {}};
    StringOutput output(drawn.text);
    write_trace(scene, plan, {}, output);
    return titled(value_or_throw(read_trace(std::move(drawn))), path);
}

Source load_page(const std::string& path) {
    return input_or_throw(read_named_file(path, {}));
}

ExitStatus report_damage(const Trace& trace) {
    for (const Problem& problem : trace.damage)
        print_error(fmt::format("rastertrace: {}\n", to_text(problem)));
    return trace.damage.empty() ? exit_fine : exit_bad_input;
}

void print(std::string_view text) {
    DescriptorOutput(STDOUT_FILENO, "standard output").write(text);
}

void print_error(std::string_view text) noexcept {
    // A pipe that nobody reads must not end the program by its signal.
    struct sigaction ignored {};
    struct sigaction before {};
    ignored.sa_handler = SIG_IGN;
    ::sigaction(SIGPIPE, &ignored, &before);
    bool is_taken = true;
    while (is_taken && !text.empty()) {
        const ssize_t count = ::write(STDERR_FILENO, text.data(), text.size());
        if (count >= 0)
            text.remove_prefix(static_cast<std::size_t>(count));
        else if (errno == EAGAIN)
            wait_until_writable(STDERR_FILENO);
        else
            is_taken = errno == EINTR;
    }
    ::sigaction(SIGPIPE, &before, nullptr);
}

} // namespace rastertrace
