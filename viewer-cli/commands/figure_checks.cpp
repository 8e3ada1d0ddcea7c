// SPDX-License-Identifier: MIT
#include "commands/figure_checks.h"

#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

/// Refuses an option that says nothing of a format.
void check_option(bool is_there, std::string_view option, FigureFormat format,
                  std::initializer_list<FigureFormat> formats) {
    if (!is_there || std::find(formats.begin(), formats.end(), format) != formats.end())
        return;
    std::vector<std::string> names;
    for (const FigureFormat one : formats)
        names.emplace_back(name_of(one));
    throw problem_of("", fmt::format("{}: expected one of {}, found {}", option,
                                     joined(names, ", "), name_of(format)));
}

/// Refuses what other formats have and a page does not: it has all steps, and its reader chooses what it shows.
void check_options_of_page(const FigureCommand& command) {
    const FigureOptions& options = command.figure;
    using enum FigureFormat;
    const auto refuse_if = [](bool is_there, std::string_view option) {
        check_option(is_there, option, html, {svg, png, tex, txt, gif});
    };
    refuse_if(command.is_bare, "--bare");
    refuse_if(command.sheet.has_value(), "--sheet");
    refuse_if(command.which == FigureCommand::Which::until, "--until");
    refuse_if(command.which == FigureCommand::Which::every, "--every");
    refuse_if(!options.with.empty(), "--with");
    refuse_if(!options.without.empty() || options.caption, "--without and --caption");
    refuse_if(options.region.has_value(), "--region");
}

/// Refuses what is about pixels where the picture in space is asked for.
void check_options_in_space(const FigureCommand& command, FigureFormat format) {
    using enum FigureFormat;
    if (format == html)
        throw problem_of("", "--view space: expected one of svg, png, tex, gif, found html",
                         "a page has the picture in space beside the pixels");
    check_option(true, "--view space", format, {svg, png, tex, gif});
    const FigureOptions& options = command.figure;
    const auto refuse_if = [](bool is_there, std::string_view option) {
        if (is_there)
            throw problem_of("", fmt::format("--view space: expected no {}, found one", option),
                             "--with space shows the picture in space beside the pixels");
    };
    refuse_if(options.region.has_value(), "--region");
    refuse_if(command.is_bare, "--bare");
    refuse_if(options.cell.has_value(), "--cell");
    refuse_if(!command.against.empty(), "--against");
    refuse_if(!options.notes.empty(), "--note");
}

} // namespace

void check_format(const FigureCommand& command, FigureFormat format) {
    const bool moves =
        format == FigureFormat::svg || format == FigureFormat::gif || format == FigureFormat::tex;
    if ((command.sheet || command.frames_in_space) && format == FigureFormat::txt)
        throw problem_of("",
                         fmt::format("--sheet: expected a format of drawings (svg, png, tex, gif), "
                                     "found {}",
                                     name_of(format)),
                         "without --sheet, --every writes a .txt for each frame");
    if (command.sheet && command.is_animated)
        throw problem_of("", "--animate: expected no --sheet, found both",
                         "--animate shows frames one after the other, --sheet side by side");
    if (command.is_animated && !moves)
        throw problem_of("", fmt::format("--animate: expected a format that moves (svg, gif, tex), "
                                         "found {}",
                                         name_of(format)));
    using enum FigureFormat;
    check_option(command.frames_in_space.has_value(), "--sheet", format, {svg, png, tex, gif});
    if (command.figure.is_in_space)
        check_options_in_space(command, format);
    if (format == html)
        check_options_of_page(command);
    check_option(command.style.scale.has_value() && !command.is_bare, "--scale", format,
                 {png, gif});
    const bool has_size = command.style.width || command.style.height;
    check_option(has_size, "--width and --height", format, {svg, png, tex, gif});
    if (has_size && command.style.scale)
        throw problem_of("", "--scale: expected no --width or --height, found one",
                         "--width says how wide the picture is, --scale how wide a unit");
    check_option(command.style.seconds.has_value(), "--seconds", format, {svg, gif});
    const auto is_drawn = [](FigurePart part) { return part != FigurePart::working; };
    const FigureOptions& options = command.figure;
    check_option(std::any_of(options.with.begin(), options.with.end(), is_drawn), "--with", format,
                 {svg, png, tex, gif});
    check_option(!command.against.empty(), "--against", format, {svg, png, tex, gif});
    check_option(options.title.has_value(), "--title", format, {svg, png, tex, gif, html});
    check_option(options.cell.has_value(), "--cell", format, {svg, png, tex, gif});
    check_option(!options.notes.empty(), "--note", format, {svg, png, tex, gif});
    check_option(command.style.theme != Theme::automatic, "--theme", format,
                 {svg, png, tex, gif, html});
}

} // namespace rastertrace
