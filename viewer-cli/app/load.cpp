// SPDX-License-Identifier: MIT
#include "app/load.h"

#include "app/progress.h"

#include <rastertrace/trace/audit/redo.h>
#include <rastertrace/trace/picture/picture_trace.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/input_file.h>
#include <rastertrace/trace/text/process_files.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <fmt/core.h>

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <utility>

namespace rastertrace {

namespace {

[[noreturn]] void refuse_trace(const Source& source) {
    throw problem_of(source.name, "expected a scene, found a trace",
                     "a trace is drawn already; `show` and `stats` read it");
}

Trace drawn(const PlannedScene& planned, const std::string& name, const InputLimits& limits) {
    return drawn_trace(planned.scene, planned.plan, name, limits.steps);
}

Trace titled(Trace trace, const std::string& path) {
    trace.title = shown_title(trace.title, path);
    return trace;
}

} // namespace

void refuse_scene_options(const Source& source, const SceneOptions& options) {
    std::string option;
    if (!options.method.empty())
        option = fmt::format("{} {}", options.method.front().first, options.method.front().second);
    else if (!options.frames.vary.empty())
        option = "vary";
    else if (options.frames.frame)
        option = fmt::format("frame {}", *options.frames.frame);
    if (!option.empty())
        throw problem_of(source.name,
                         fmt::format("expected a scene to draw with --{}, found a trace, which is "
                                     "drawn already",
                                     option));
}

InputFrames::InputFrames(const std::string& path, const SceneOptions& options)
    : InputFrames(path, load_input(path, options.limits), options) {}

InputFrames::InputFrames(const std::string& path, Source source, const SceneOptions& options)
    : path_(path), options_(options), source_(std::move(source)) {
    if (is_trace(source_)) {
        refuse_scene_options(source_, options);
        return;
    }
    scenes_.emplace(source_, options.method, options.limits, options.frames.vary);
    first_ = options.frames.frame.value_or(1);
    last_ = options.frames.frame.value_or(scenes_->count());
}

PlannedScene InputFrames::scene(std::size_t frame) {
    if (!scenes_)
        refuse_trace(source_);
    PlannedScene scene = scenes_->frame(frame);
    if (frame == first_ && !options_.is_quiet)
        for (const Problem& remark : scene.remarks)
            print_error(remark);
    return scene;
}

Trace InputFrames::trace(std::size_t frame) {
    if (!scenes_) {
        const bool is_marked =
            options_.tells_steps && source_.view().size() <= largest_marked_trace;
        Trace trace = value_or_throw(read_trace(std::move(source_), options_.limits.steps));
        if (is_marked)
            mark_wrong_steps(trace);
        return titled(std::move(trace), path_);
    }
    Trace trace = drawn(scene(frame), source_.name, options_.limits);
    if (options_.tells_steps && !trace.method.triangles.mistakes.empty())
        mark_wrong_steps(trace);
    return titled(std::move(trace), path_);
}

Trace InputFrames::trace_by(std::size_t frame, const MethodOverrides& method) const {
    if (!scenes_)
        refuse_scene_options(source_, {.method = method});
    SceneSequence scenes(source_, method, options_.limits, options_.frames.vary);
    return titled(drawn(scenes.frame(frame), source_.name, options_.limits), path_);
}

bool is_file(const std::filesystem::directory_entry& entry) {
    std::error_code error;
    const bool is_regular = entry.is_regular_file(error);
    if (error)
        print_error(problem_of(
            entry.path().string(),
            fmt::format("expected a file that can be read, found: {}", error.message())));
    return is_regular;
}

void check_region(const Region& region, const Canvas& canvas) {
    if (canvas.contains(region.x0, region.y0) && canvas.contains(region.x1, region.y1))
        return;
    throw problem_of(
        "", fmt::format("--region: expected pixels of the canvas (x {} to {}, y {} to {}), "
                        "found {},{},{},{}",
                        canvas.left(), canvas.right(), std::min(canvas.top(), canvas.bottom()),
                        std::max(canvas.top(), canvas.bottom()), region.x0, region.y0, region.x1,
                        region.y1));
}

namespace {

/// The beginning of a file.
std::string front_of(const std::string& path) {
    constexpr std::size_t enough_to_tell = 1 << 16;
    InputFile file = value_or_throw(InputFile::open(path));
    std::string front;
    try {
        while (front.size() < enough_to_tell && file.read_into(front)) {
        }
    } catch (const Problem&) {
        return front; // who reads on will tell
    }
    return front;
}

} // namespace

std::optional<Picture> picture_in_file(const std::string& path, const InputLimits& limits) {
    std::error_code error;
    if (path == "-" || !std::filesystem::is_regular_file(path, error))
        return std::nullopt;
    if (!picture_format({path, front_of(path), {}}))
        return std::nullopt;
    return value_or_throw(read_picture(value_or_throw(read_bytes(path, limits))));
}

Source load_input(const std::string& path, const InputLimits& limits) {
    if (const auto picture = picture_in_file(path, limits))
        return {path, picture_trace(*picture)};
    return value_or_throw(read_source(path, limits));
}

Trace trace_to_compare(Source source, const std::string& path, const SceneOptions& options) {
    if (is_trace(source))
        return value_or_throw(read_trace(std::move(source), options.limits.steps));
    const std::string name = source.name;
    InputFrames input(path, std::move(source), options);
    return drawn(input.scene(input.first()), name, options.limits);
}

PlannedScene load_scene(const std::string& path, const SceneOptions& options) {
    InputFrames input(path, options);
    return input.scene(input.first());
}

Source load_scene_source(const std::string& path, const InputLimits& limits) {
    Source source = load_input(path, limits);
    if (is_trace(source))
        refuse_trace(source);
    return source;
}

std::string shown_title(const std::string& title, const std::string& path) {
    if (!title.empty())
        return title;
    return path == "-" ? "standard input" : path.substr(path.find_last_of('/') + 1);
}

Trace load_trace(const std::string& path, const SceneOptions& options) {
    InputFrames input(path, options);
    return input.trace(input.first());
}

Source load_scene_trace_or_claims(const std::string& path, const InputLimits& limits) {
    const auto picture = picture_in_file(path, limits);
    if (!picture)
        return value_or_throw(read_source_or_claims(path, limits));
    std::string claim = "picture:\n";
    for (const std::string& row : picture_rows(*picture))
        claim += row + "\n";
    return {path, std::move(claim), {}};
}

Truth truth_in(Source source, const SceneOptions& options) {
    if (is_trace(source)) {
        refuse_scene_options(source, options);
        return Truth(value_or_throw(read_trace(std::move(source), options.limits.steps)));
    }
    return Truth(std::move(source), options.method, options.limits, options.frames);
}

std::string path_of_scene(const Claims& claims) {
    if (claims.scene.empty())
        throw problem_of(claims.source.name,
                         "expected a scene before the claims, or its name in them, found none",
                         "check SCENE CLAIMS, or a line `scene: FILE`");
    return (std::filesystem::path(claims.source.name).parent_path() / claims.scene).string();
}

Source load_scene_of_claims(const Claims& claims, const InputLimits& limits) {
    const std::string path = path_of_scene(claims);
    auto source = read_named_file(path, limits);
    if (source && !is_claims(source.value()))
        return std::move(source.value());
    if (!source && source.problem().cause == Problem::Cause::system)
        throw source.problem();
    const Problem found =
        source ? problem_of("", "expected a scene or a trace, found claims") : source.problem();
    throw problem_at(claims.source, claims.scene_offset,
                     fmt::format("{} ({})", found.message, path), found.hint);
}

Source load_page(const std::string& path) {
    const ReadToReplace to_be_renewed;
    Source page = value_or_throw(read_named_file(path, {}));
    standard_output(); // before it is replaced
    return page;
}

ExitStatus report_damage(const Trace& trace) {
    for (const Problem& problem : trace.damage)
        print_error(problem);
    if (const auto remark = trace.not_finite.remark())
        print_error(*remark);
    return trace.damage.empty() ? exit_fine : exit_bad_input;
}

DescriptorOutput standard_output() {
    constexpr const char* name = "standard output";
    struct stat status {};
    if (::fstat(STDOUT_FILENO, &status) == 0)
        refuse_opened({.device = status.st_dev, .inode = status.st_ino}, name);
    return {STDOUT_FILENO, name};
}

void print(std::string_view text) {
    standard_output().write(text);
}

void print_error(const Problem& problem) {
    print_error(fmt::format("rastertrace: {}\n", to_text(problem)));
}

void print_error(std::string_view text) noexcept {
    // A pipe that nobody reads must not end the program by its signal.
    struct sigaction ignored {};
    struct sigaction before {};
    ignored.sa_handler = SIG_IGN;
    ::sigaction(SIGPIPE, &ignored, &before);
    clear_progress_line();
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
