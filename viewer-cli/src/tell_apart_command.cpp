// SPDX-License-Identifier: MIT
// rastertrace tell-apart: a small scene that two rules draw differently.

#include "command.h"
#include "load.h"
#include "option_values.h"
#include "shared_options.h"

#include <rastertrace/trace/diagnose/tell_apart.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <memory>
#include <string>

namespace rastertrace {

namespace {

Rule rule_in(const std::string& name) {
    if (name == "asked")
        return {};
    if (auto rule = rule_named(name))
        return *std::move(rule);
    refuse_value("tell-apart",
                 "a mistake, a convention, settings like rounding=truncate, or `asked`", name);
}

class TellApartCommandLine final : public Command {
public:
    CommandAbout about() const override {
        return {"tell-apart", "Print a small scene that two rules draw differently",
                "rastertrace tell-apart tie-refused-by-both asked --fill top-left\n\n"
                "A rule is a mistake, a convention, or settings; `asked` is the method as the "
                "options have it."};
    }

    void add_to(OptionList& options) override {
        options.option("a", a_, "A rule", "RULE").required();
        options.option("b", b_, "Another one", "RULE").required();
        method_.add_to(options);
    }

    void read() override {
        rule_a_ = rule_in(a_);
        rule_b_ = rule_in(b_);
    }

    int run() override {
        const auto scene = scene_apart(rule_a_, rule_b_, method_.overrides());
        if (!scene) {
            print_error(fmt::format(
                "rastertrace: no scene found that {} and {} draw differently, in {} random ones\n",
                printable(a_), printable(b_), most_seeds));
            return exit_difference;
        }
        print(scene->text);
        return exit_fine;
    }

private:
    std::string a_;
    std::string b_;
    Rule rule_a_;
    Rule rule_b_;
    MethodOptions method_;
};

} // namespace

std::unique_ptr<Command> tell_apart_command() {
    return std::make_unique<TellApartCommandLine>();
}

} // namespace rastertrace
