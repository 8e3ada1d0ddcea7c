// SPDX-License-Identifier: MIT
// `rastertrace explain`: why something is as it is.

#include "app/command.h"
#include "app/load.h"
#include "app/option_values.h"
#include "app/shared_options.h"
#include "commands/explain_text.h"

#include <rastertrace/trace/explain/explain.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

/// What the trace drawn by another method answers; that it has no answer is one too.
Explanation answer_there(const Trace& against, const Trace& trace, const Question& question) {
    const auto same = question_for(against, trace, question);
    if (!same)
        return {.answer = said("there is no such step")};
    auto answer = explain(against, *same);
    return answer ? std::move(answer.value())
                  : Explanation{.answer = said("no answer: {}", answer.problem().message)};
}

/// 4,2, or (4, 2) as it is printed.
std::optional<Pixel> pixel_in(std::string_view text) {
    text = without_blanks(text);
    if (text.starts_with('(') && text.ends_with(')'))
        text = text.substr(1, text.size() - 2);
    const auto words = split_at(text, ',');
    const auto x = whole_number<int>(without_blanks(words.front()));
    const auto y =
        words.size() == 2 ? whole_number<int>(without_blanks(words.back())) : std::nullopt;
    return x && y ? std::optional(Pixel{*x, *y}) : std::nullopt;
}

class ExplainCommand final : public Command {
public:
    CommandAbout about() const override {
        return {
            "explain", "Say why a pixel, a row, a face, ... is as it is",
            "rastertrace explain examples/t0-fill/first-triangle.json --pixel 4,2\n\n"
            "Of a pixel: who drew it, and what kept all others out, with the numbers. --against\n"
            "rounding=truncate asks the same under another method, and tells the first decision\n"
            "that differs."};
    }

    void add_to(OptionList& options) override {
        options.option("trace", trace_, trace_input, "TRACE").required();
        OptionList what = options.one_of("What is asked", "One of these", true);
        what.option("--pixel", pixel_, "Who drew it, and why others did not", "X,Y");
        what.option("--scanline", row_, "Both ends of the row", "Y");
        const auto add_text = [&](const char* name, const char* meaning, const char* type) {
            return what.option(name, texts_[name], meaning, type);
        };
        add_text("--face", "How it is turned, lit and clipped, and what is seen of it", "NAME")
            .names_of(NamesOf::faces);
        add_text("--vertex", "Where it is, from space to space", "NAME")
            .names_of(NamesOf::vertices);
        add_text("--edge", "How it is set up, and the rows that end at it", "NAME")
            .names_of(NamesOf::edges);
        add_text("--pair", "Who has each pixel along the edge of two triangles", "NAME,NAME")
            .names_of(NamesOf::triangles);
        add_text("--step", "One step: a number, or like \"scanline y=2\"", "STEP");
        options.option("--against", against_,
                       "Ask the same of the scene drawn by another method, like "
                       "rounding=truncate,sample=center",
                       "METHOD");
        options.option("--format", format_, "How to print", "NAME").values({"text", "json"});
        options.flag("--json", json_, "Short for --format json");
        options.language();
        drawing_.add_to(options, Holds::steps);
    }

    void read() override {
        json_ = is_json(format_, json_);
        question_ = explain_question();
        scenes_ = drawing_.scene_options();
        scenes_.tells_steps = true;
    }

    int run() override {
        if (against_.empty())
            return tell(load_trace(trace_, scenes_));
        InputFrames input(trace_, scenes_);
        const auto changes = value_or_throw(parse_method({"--against", against_}));
        MethodOverrides method = scenes_.method;
        method.insert(method.end(), changes.begin(), changes.end());
        const Trace against = input.trace_by(input.first(), method);
        return tell(input.trace(input.first()), &against);
    }

private:
    /// Answers the question, and once more with the trace drawn by another method, if there is one.
    ExitStatus tell(const Trace& trace, const Trace* against = nullptr) const {
        const Explanation explanation = value_or_throw(explain(trace, question_));
        std::optional<OtherAnswer> other;
        if (against != nullptr)
            other = {against_, answer_there(*against, trace, question_),
                     first_difference(trace, *against, question_)};
        if (json_) {
            print(explanation_json(explanation, other).line());
        } else {
            print(shortened(printable(trace.title), 79) + "\n");
            print(explanation_text(explanation));
            if (other)
                print(other_answer_text(*other));
        }
        return report_damage(trace);
    }

    /// What `explain` is asked.
    Question explain_question() const {
        if (!pixel_.empty()) {
            const auto pixel = pixel_in(pixel_);
            if (!pixel)
                refuse_value("--pixel", "a pixel as x,y, like 4,2", pixel_);
            return {.about = Topic::pixel, .pixel = *pixel};
        }
        if (!row_.empty()) {
            const auto y = whole_number<int>(row_);
            if (!y)
                refuse_value("--scanline", "the y of a row, like 2", row_);
            return {.about = Topic::scanline, .pixel = {0, *y}};
        }
        for (const Topic topic :
             {Topic::face, Topic::vertex, Topic::edge, Topic::pair, Topic::step}) {
            const auto text = texts_.find("--" + std::string(name_of(topic)));
            if (text != texts_.end() && !text->second.empty())
                return {.about = topic, .text = text->second};
        }
        return {};
    }

    std::string trace_;
    std::string pixel_;
    std::string row_;
    std::map<std::string, std::string> texts_; ///< --face, --vertex, ...
    Question question_;
    std::string against_; ///< METHOD: the same question under another one; empty: none
    std::string format_;
    bool json_ = false;
    DrawingOptions drawing_;
    SceneOptions scenes_;
};

} // namespace

std::unique_ptr<Command> explain_command() {
    return std::make_unique<ExplainCommand>();
}

} // namespace rastertrace
