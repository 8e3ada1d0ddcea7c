// SPDX-License-Identifier: MIT
#include "app/output_ending.h"

#include "app/command_words.h"
#include "commands/figure_file.h"

namespace rastertrace {

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
