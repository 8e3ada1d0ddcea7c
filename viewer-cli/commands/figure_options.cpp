// SPDX-License-Identifier: MIT
// The options of `rastertrace figure`.

#include "app/option_values.h"
#include "commands/figure_command.h"

#include <rastertrace/figures/figure.h>
#include <rastertrace/trace/record/traced_values.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

/// A number above 0, at most `most`.
std::optional<double> size_in(std::string_view option, const std::string& text, double most) {
    if (text.empty())
        return std::nullopt;
    const auto value = TracedNumber(text).nearest_double();
    if (!value || !(*value > 0) || *value > most)
        refuse_value(option, fmt::format("a number above 0, at most {:g}", most), text);
    return value;
}

std::vector<std::string_view> part_names() {
    std::vector<std::string_view> names;
    for (const FigurePartRow& row : figure_parts())
        names.push_back(row.name);
    return names;
}

/// The views of pixels that have colors: coverage tells numbers.
std::optional<View> cell_view_named(std::string_view name) {
    const auto view = view_named(name);
    return view == View::coverage ? std::nullopt : view;
}
std::vector<std::string_view> view_words() {
    std::vector<std::string_view> names = view_names();
    std::erase_if(names, [](std::string_view name) { return !cell_view_named(name); });
    names.push_back("space");
    return names;
}

/// So many numbers with commas between, none beyond a million; else none at all.
std::vector<double> numbers_in(std::string_view list, std::size_t count) {
    constexpr double most = 1e6;
    std::vector<double> numbers;
    for (const std::string& text : split_at(list, ','))
        if (const auto number = TracedNumber(text).nearest_double();
            number && std::abs(*number) <= most)
            numbers.push_back(*number);
        else
            return {};
    return numbers.size() == count ? numbers : std::vector<double>();
}

/// "3,2: the tie goes up"
FigureNote note_in(const std::string& text) {
    const std::size_t colon = std::min(text.find(':'), text.size());
    const auto place = numbers_in(std::string_view(text).substr(0, colon), 2);
    const std::string words{
        without_blanks(std::string_view(text).substr(std::min(colon + 1, text.size())))};
    if (place.empty() || words.empty())
        refuse_value("--note", "a place and words, like \"3,2: the tie goes up\"", text);
    return {place[0], place[1], words};
}

SpaceEye eye_in(const std::string& text) {
    if (const auto eye = space_eye_named(text))
        return *eye;
    const auto numbers = numbers_in(text, 3);
    if (numbers.empty() || numbers == std::vector<double>(3))
        refuse_value("--eye",
                     fmt::format("{}, or a direction x,y,z other than 0,0,0",
                                 joined(space_eye_names(), ", ")),
                     text);
    return {.direction = {numbers[0], numbers[1], numbers[2]}, .is_named = false};
}

} // namespace

CommandAbout FigureCommand::about() const {
    std::vector<ExplainedWord> parts;
    for (const FigurePartRow& row : figure_parts())
        parts.push_back({std::string(row.name), std::string(row.shows)});
    return {"figure", "Draw frames as figures for a page, a book or a talk",
            "rastertrace figure examples/t0-fill/first-triangle.json --step \"scanline y=2\" -o "
            "row.svg\n\n"
            "An .html is a page to click through, forward and back, with all steps.",
            "What a figure can show (PART), for --with and --without", std::move(parts)};
}

void FigureCommand::add_to(OptionList& options) {
    options.option("trace", trace, trace_input, "TRACE").required();
    options
        .option("-o,--output", output,
                fmt::format("The file; its name ends in one of {}; - for standard output",
                            joined(endings_in<FigureFormat>(figure_endings), ", ")),
                "FILE")
        .required();
    options.option("--format", format_, "How to write it, whatever the file's name", "NAME")
        .values(figure_format_names());
    OptionList chosen = options.one_of(
        "Which frames", "One of these; if none is given, the last one, and of a .gif or "
                        "--animate each row, pixel of a line and vertex");
    chosen.option("--step", step_,
                  "After this step, together with the pixels that belong to it; of an .html, the "
                  "step that it begins at",
                  "STEP");
    chosen.option("--until", until_, "Before this step, which is not told: an exercise", "STEP");
    chosen.option("--every", every_,
                  "After every such step: a file for each, but for --sheet, --animate and .gif",
                  "STEP");
    options.option("--sheet", sheet_,
                   fmt::format("Frames side by side, like 3x4: 3 columns, 4 rows; or those of a "
                               "step in space: {}",
                               joined(space_frames_names(), ", ")),
                   "CxR|NAME");
    options.flag(
        "--animate", is_animated,
        "All frames in one .svg, which moves, or in one .tex: the overlays of a beamer frame");
    options.option("--seconds", seconds_,
                   "How long each frame is seen; by default all of them take 20, and one at "
                   "most 1",
                   "N");
    options.option("--with", with_, "Show these parts too", "PART,...")
        .values_told_below(part_names());
    options.option("--without", without_, "Leave these parts out", "PART,...")
        .values_told_below(part_names());
    options.option("--title", figure.title, "This title instead of the scene's", "TEXT");
    options.option("--caption", figure.caption,
                   "This text instead of the step's sentence; none for no text", "TEXT");
    options
        .option("--note", notes_,
                "These words, with an arrow to a place of the screen; may be given again",
                "x,y: TEXT")
        .repeatable();
    options
        .option("--view", view_,
                "What the color of a pixel means; if none is given, what the scene is about. "
                "With space, "
                "the scene in space is in the place of the pixels",
                "NAME")
        .values(view_words());
    options
        .option("--eye", eye_, "From where the picture in space is seen, also a direction x,y,z",
                "NAME|x,y,z")
        .values(space_eye_names());
    options.option("--against", against,
                   "Compare the pixels with those of another trace or scene, or of the same "
                   "scene by another METHOD (key=value,...)",
                   "TRACE|METHOD");
    options.option("--region", region_, "Show only these pixels", "x0,y0,x1,y1");
    options.option("--theme", theme_, "auto is, in an .svg, as the reader has set it", "NAME")
        .values(theme_names());
    options.option("--cell", cell_, "The side of a pixel, in units; by default by the canvas",
                   "PX");
    options.option("--scale", scale_, "Of a .png or .gif: pixels of a unit; 2 and 1 if not given",
                   "N");
    options.option("--width", width_,
                   "As wide as that: pixels; of a .tex, millimeters; 120 at most if not given",
                   "N");
    options.option("--height", height_, "As high as that; with --width, it fits into both", "N");
    options.flag("--bare", is_bare,
                 "Only the pixels in their own colors, one unit each if --cell is not given");
    options.language();
    drawing_.add_to(options, Holds::steps, "all if not given");
}

void FigureCommand::read() {
    if (!step_.empty())
        which = Which::step;
    if (!until_.empty())
        which = Which::until;
    if (!every_.empty())
        which = Which::every;
    selector = step_ + until_ + every_; // one of them, at most

    FigureOptions& options = figure;
    options.with = values_of("--with", "parts", with_, part_names(), figure_part_named);
    options.without = values_of("--without", "parts", without_, part_names(), figure_part_named);
    for (const FigurePart part : options.with)
        if (std::find(options.without.begin(), options.without.end(), part) !=
            options.without.end())
            refuse_value("--without", "parts that are not in --with", without_);
    if (options.caption == "none") {
        options.caption.reset();
        options.without.push_back(FigurePart::caption);
    }
    options.is_in_space = view_ == "space";
    if (!options.is_in_space) {
        options.view = value_of("--view", view_, view_words(), cell_view_named);
    }
    if (!eye_.empty())
        options.eye = eye_in(eye_);
    for (const std::string& note : notes_)
        options.notes.push_back(note_in(note));
    options.region = region_of(region_);
    constexpr double largest_cell = 1000;
    options.cell = size_in("--cell", cell_, largest_cell);

    style.theme =
        value_of("--theme", theme_, theme_names(), theme_named).value_or(Theme::automatic);
    constexpr double largest_scale = 100;
    style.scale = size_in("--scale", scale_, largest_scale);
    constexpr double largest_size = 5000;
    style.width = size_in("--width", width_, largest_size);
    style.height = size_in("--height", height_, largest_size);
    constexpr double longest = 600;
    style.seconds = size_in("--seconds", seconds_, longest);
    constexpr double shortest = 0.02; // of a GIF, as browsers play it
    if (style.seconds && *style.seconds < shortest)
        refuse_value("--seconds", fmt::format("at least {:g}", shortest), seconds_);

    if (is_bare) {
        for (const FigurePartRow& row : figure_parts())
            if (row.part != FigurePart::pixels)
                options.without.push_back(row.part);
        options.view = options.view.value_or(View::shade);
        options.cell = options.cell.value_or(1);
        if (!style.width && !style.height)
            style.scale = style.scale.value_or(1);
    }
    format = value_of("--format", format_, figure_format_names(), figure_format_named);
    frames_in_space = space_frames_named(sheet_);
    if (!sheet_.empty() && !frames_in_space) {
        const auto [columns, rows] = size_in_option(
            "--sheet", "columns and rows, like 3x4, each from 1 to 100, or spaces or ears", sheet_,
            100);
        sheet = {columns, rows};
    }
    scenes = drawing_.scene_options();
    scenes.tells_steps = true;
}

std::unique_ptr<Command> figure_command() {
    return std::make_unique<FigureCommand>();
}

} // namespace rastertrace
