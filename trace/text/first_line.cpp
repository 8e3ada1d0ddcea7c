// SPDX-License-Identifier: MIT
#include "first_line.h"

#include "text.h"

#include <cstddef>
#include <string_view>
#include <utility>

namespace rastertrace {

LineLayout read_first_line(InputFile& file, Source& source, InputCheck& fault_of) {
    std::size_t block = source.text.size();
    bool is_told = false;
    while (file.read_into(source.text)) {
        if (auto fault = fault_of(source, block))
            throw *std::move(fault);
        block = source.text.size();
        const std::size_t newline = is_told ? std::string::npos : source.text.find('\n');
        if (newline == std::string::npos)
            continue;
        is_told = true;
        const LineLayout layout =
            layout_of(without_blanks(std::string_view(source.text).substr(0, newline)));
        if (layout != LineLayout::other)
            return layout;
    }
    return LineLayout::other;
}

FirstLine open_first_line(const std::string& path, InputCheck::Kind kind,
                          const InputLimits& limits) {
    auto opened = InputFile::open(path);
    if (!opened)
        throw opened.problem();
    InputFile& file = opened.value();
    Source source{.name = file.name(), .text = {}, .file = file.id()};
    InputCheck fault_of(kind, limits);
    const LineLayout layout = read_first_line(file, source, fault_of);
    return {std::move(file), std::move(source), layout};
}

} // namespace rastertrace
