// SPDX-License-Identifier: MIT
#include "app/option_values.h"

#include "app/command_words.h"
#include "commands/figure_file.h"

#include <rastertrace/trace/text/problem.h>

namespace rastertrace {

void refuse_value(std::string_view option, std::string_view expected, std::string_view found,
                  std::string hint) {
    throw problem_of("", fmt::format("{}: expected {}, found \"{}\"", option, expected, found),
                     std::move(hint));
}

std::pair<std::size_t, std::size_t> size_in_option(std::string_view option,
                                                   std::string_view expected, std::string_view text,
                                                   std::size_t most) {
    const std::size_t by = std::min(text.find('x'), text.size());
    const auto first = whole_number<std::size_t>(text.substr(0, by));
    const auto second = whole_number<std::size_t>(text.substr(std::min(by + 1, text.size())));
    for (const auto& number : {first, second})
        if (number.value_or(0) < 1 || *number > most)
            refuse_value(option, expected, text);
    return {*first, *second};
}

std::optional<Region> region_of(const std::string& text) {
    if (text.empty())
        return std::nullopt;
    std::vector<int> numbers;
    for (const std::string& word : split_at(text, ','))
        if (const auto number = whole_number<int>(word))
            numbers.push_back(*number);
    if (numbers.size() != 4 || split_at(text, ',').size() != 4)
        refuse_value("--region", "two corners as x0,y0,x1,y1, like -4,-3,2,5", text);
    if (numbers[0] > numbers[2] || numbers[1] > numbers[3])
        refuse_value("--region", "the smaller x and y first", text,
                     fmt::format("--region {},{},{},{}", std::min(numbers[0], numbers[2]),
                                 std::min(numbers[1], numbers[3]), std::max(numbers[0], numbers[2]),
                                 std::max(numbers[1], numbers[3])));
    return Region{numbers[0], numbers[1], numbers[2], numbers[3]};
}

ColorChoice color_choice_of(const std::string& text) {
    if (text == "always")
        return ColorChoice::always;
    if (text == "never")
        return ColorChoice::never;
    if (!text.empty() && text != "auto")
        refuse_value("--color", "auto, always or never", text);
    return ColorChoice::automatic;
}

bool is_json(const std::string& format, bool has_flag) {
    if (!format.empty() && format != "text" && format != "json")
        refuse_value("--format", "text or json", format);
    return has_flag || format == "json";
}

void refuse_ending(const std::string& path, const std::vector<std::string_view>& known) {
    const std::string ending = ending_of(path);
    const auto is_it = [&ending](const auto& one) { return one.text == ending; };
    const bool is_figure = std::any_of(figure_endings.begin(), figure_endings.end(), is_it);
    const std::vector<std::string_view> others(known.begin(), known.end() - 1);
    throw problem_of(
        path,
        fmt::format("expected a name that ends in {} or {}, found {}", joined(others, ", "),
                    known.back(), ending.empty() ? "none of them" : printable(ending)),
        is_figure ? fmt::format("rastertrace figure writes {}", ending)
        : ending == ".pdf"
            ? fmt::format(
                  "of an .svg: rsvg-convert -f pdf {} -o {}",
                  shell_word(std::filesystem::path(path).replace_extension(".svg").string()),
                  shell_word(path))
            : "--format says what to write");
}

} // namespace rastertrace
