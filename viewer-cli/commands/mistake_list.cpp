// SPDX-License-Identifier: MIT
#include "commands/mistake_list.h"

#include <rastertrace/core/draw/model/mistakes.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <string>
#include <string_view>

namespace rastertrace {

std::string mistakes_text() {
    std::string text;
    for (const Mistake& mistake : mistakes())
        text += fmt::format("{:<30} {}\n", mistake.name, mistake.symptom);
    return text;
}

std::string mistake_text(const Mistake& mistake) {
    std::string text =
        fmt::format("{}{}\n  it says   {}\n", mistake.name,
                    mistake.is_rule() ? ", a rule of others" : "", mistake.says);
    if (!mistake.is_rule())
        text += fmt::format("  should    {}\n", mistake.should);
    text += fmt::format("  changes   {}\n  symptom   {}\n  source    {}\n", mistake.step,
                        mistake.symptom, mistake.source);
    if (!mistake.setting.empty())
        text += fmt::format("  the same  {}\n", mistake.setting);
    return text;
}

std::string mistakes_json() {
    std::string text = "{\"mistakes\":[";
    std::string_view separator = "\n";
    for (const Mistake& mistake : mistakes()) {
        text += fmt::format(
            R"({}{{"name":"{}","says":{},"should":{},"step":"{}","symptom":{},"source":{},"setting":"{}"}})",
            separator, mistake.name, json_quoted(mistake.says),
            json_quoted(mistake.should), mistake.step, json_quoted(mistake.symptom),
            json_quoted(mistake.source), mistake.setting);
        separator = ",\n";
    }
    return text + "\n]}\n";
}

} // namespace rastertrace
