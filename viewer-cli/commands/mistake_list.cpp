// SPDX-License-Identifier: MIT
#include "commands/mistake_list.h"

#include <rastertrace/core/draw/model/mistakes.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <string>

namespace rastertrace {

std::string mistakes_text() {
    std::string text;
    for (const Mistake& mistake : mistakes())
        text += fmt::format("{:<30} {}\n", mistake.name, mistake.symptom);
    return text;
}

std::string mistake_text(const Mistake& mistake) {
    std::string text = fmt::format("{}{}\n  it says   {}\n", mistake.name,
                                   mistake.is_rule() ? ", a rule of others" : "", mistake.says);
    if (!mistake.is_rule())
        text += fmt::format("  should    {}\n", mistake.should);
    text += fmt::format("  changes   {}\n  symptom   {}\n  source    {}\n", mistake.step,
                        mistake.symptom, mistake.source);
    if (!mistake.setting.empty())
        text += fmt::format("  the same  {}\n", mistake.setting);
    return text;
}

JsonText mistakes_json() {
    return {{"mistakes", JsonText::lines(mistakes(), [](const Mistake& mistake) {
                 return JsonText{{"name", mistake.name},       {"says", mistake.says},
                                 {"should", mistake.should},   {"step", mistake.step},
                                 {"symptom", mistake.symptom}, {"source", mistake.source},
                                 {"setting", mistake.setting}};
             })}};
}

} // namespace rastertrace
