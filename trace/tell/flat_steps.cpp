// SPDX-License-Identifier: MIT
#include "flat_steps.h"

#include <rastertrace/trace/record/step_kind.h>

#include <rastertrace/trace/text/json_scanner.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <fmt/core.h>

#include <utility>

namespace rastertrace {

void FlatSteps::write(std::string_view bytes) {
    for (std::size_t end = 0; (end = bytes.find('\n')) != std::string_view::npos;) {
        line_ += bytes.substr(0, end);
        take_line(line_);
        line_.clear();
        bytes.remove_prefix(end + 1);
    }
    line_ += bytes;
}

void FlatSteps::take_line(std::string_view line) {
    constexpr std::size_t enough_to_write = 1 << 16; // bytes
    const bool is_header = !std::exchange(is_behind_header_, true);
    if (is_header || is_end_line(line))
        return;
    std::string_view kind;
    std::string_view name;
    JsonScanner fields(line);
    while (fields.next_field())
        if (fields.key() == "step")
            kind = fields.value();
        else if (fields.key() == "name")
            name = fields.value();
    if (plain_text(kind) == name_of(StepKind::primitive))
        in_ = name;
    text_ += fmt::format(R"({{"n":{},)", ++steps_);
    if (!in_.empty())
        text_.append(R"("in":)").append(in_) += ',';
    text_.append(line.substr(1)) += '\n';
    if (text_.size() > enough_to_write)
        finish();
}

void FlatSteps::finish() {
    to_.write(text_);
    text_.clear();
}

} // namespace rastertrace
