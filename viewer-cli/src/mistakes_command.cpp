// SPDX-License-Identifier: MIT
// rastertrace mistakes: the known mistakes that a scene can be drawn with.

#include "command.h"
#include "load.h"
#include "option_values.h"

#include <rastertrace/core/draw/model/mistakes.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <memory>
#include <string>
#include <string_view>

namespace rastertrace {

namespace {

/// `factor-2-dropped`, and what is known of it.
std::string as_text(const Mistake& mistake) {
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

std::string as_json() {
    std::string text = "{\"mistakes\":[";
    std::string_view separator = "\n";
    for (const Mistake& mistake : mistakes()) {
        text += fmt::format(
            R"({}{{"name":"{}","says":{},"should":{},"step":"{}","symptom":{},"source":{},"setting":"{}"}})",
            separator, mistake.name, json_quoted(mistake.says), json_quoted(mistake.should),
            mistake.step, json_quoted(mistake.symptom), json_quoted(mistake.source),
            mistake.setting);
        separator = ",\n";
    }
    return text + "\n]}\n";
}

class MistakesCommandLine final : public Command {
public:
    CommandAbout about() const override {
        return {"mistakes", "List the known mistakes of rasterizers; --mistake draws with one",
                "rastertrace mistakes factor-2-dropped"};
    }

    void add_to(OptionList& options) override {
        options.option("name", name_, "Only this one", "NAME");
        options.flag("--json", json_, "Print JSON");
    }

    void read() override {
        std::vector<std::string_view> names;
        for (const Mistake& mistake : mistakes())
            names.push_back(mistake.name);
        if (!name_.empty() && find_mistake(name_) == nullptr)
            refuse_value("mistakes", "a name that `rastertrace mistakes` lists", name_,
                         did_you_mean(name_, names));
    }

    int run() override {
        if (!name_.empty()) {
            print(as_text(*find_mistake(name_)));
        } else if (json_) {
            print(as_json());
        } else {
            std::string text;
            for (const Mistake& mistake : mistakes())
                text += fmt::format("{:<30} {}\n", mistake.name, mistake.symptom);
            print(text);
        }
        return exit_fine;
    }

private:
    std::string name_;
    bool json_ = false;
};

} // namespace

std::unique_ptr<Command> mistakes_command() {
    return std::make_unique<MistakesCommandLine>();
}

} // namespace rastertrace
