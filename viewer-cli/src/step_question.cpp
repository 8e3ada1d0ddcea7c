// SPDX-License-Identifier: MIT
#include "step_question.h"

#include "terminal_text.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/csv.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>

namespace rastertrace {

namespace {

/// The whole numbers in a text.
std::vector<std::string> numbers_in(std::string_view text) {
    std::vector<std::string> numbers;
    std::string number;
    for (const char c : std::string(text) + " ") {
        if (('0' <= c && c <= '9') || (c == '-' && number.empty())) {
            number += c;
        } else {
            if (!number.empty() && number != "-")
                numbers.push_back(number);
            number = c == '-' && number.empty() ? "-" : ""; // behind a digit it separates
        }
    }
    return numbers;
}

/// The sentence of a step without its verdict, which stands behind the last colon.
std::string numbers_of(const Replay& replay) {
    std::string sentence = describe_step(replay);
    const std::string mistake = "; " + replay.trace().method_value("mistake") + ":";
    for (const std::string& end :
         {std::string("   [!]"), mistake}) // what is said behind the verdict
        sentence.resize(std::min(sentence.find(end), sentence.size()));
    return sentence.substr(0, sentence.rfind(": "));
}

} // namespace

std::optional<StepQuestion> question_about(const Replay& replay) {
    const std::size_t n = replay.step();
    const Trace& trace = replay.trace();
    const auto kind = n == 0 ? std::nullopt : trace.kind_of(n);
    if (!kind)
        return std::nullopt;
    const StepView step = trace.step(n);
    const std::string who = replay.primitive() == 0
                                ? ""
                                : printable(name_in(trace.step(replay.primitive())).text()) + ", ";
    StepQuestion question{.step = n, .kind = std::string(name_of(*kind)), .words = {}, .right = {}};
    const auto choice = [&](const std::string& asked, bool is_first, const std::string& first,
                            const std::string& second) {
        question.words =
            said({"{}: {} {} or {}", "{}: {} {} ou {}"}, numbers_of(replay), asked, first, second);
        question.right = is_first ? first : second;
        return question;
    };
    switch (*kind) {
    case StepKind::scanline: {
        const auto row = step.as<ScanlineStep>();
        if (row.from > row.to)
            return std::nullopt;
        question.words = said({"{}row y={}: which pixels does it have? from x, to x",
                               "{}linha y={}: quais pixels ela tem? de x, a x"},
                              who, row.y);
        question.right = fmt::format("{} {}", row.from, row.to);
        return question;
    }
    case StepKind::pixel: {
        const auto pixel = step.as<PixelStep>();
        question.words = who + said({"which pixel is drawn next? x, y, or the cursor",
                                     "qual pixel é desenhado em seguida? x, y, ou o cursor"});
        question.right = fmt::format("{} {}", pixel.x, pixel.y);
        question.is_about_pixel = true;
        return question;
    }
    case StepKind::depth:
        return choice(said({"does it", "ela"}), step.as<DepthStep>().pass.is_true(),
                      said({"pass", "passa"}), said({"fail", "falha"}));
    case StepKind::sample:
        return choice(said({"is it", "está"}), step.as<SampleStep>().inside.is_true(),
                      said({"inside", "dentro"}), said({"outside", "fora"}));
    case StepKind::face:
        return choice(said({"is it", "é"}), step.as<FaceStep>().culled.is_true(),
                      said({"culled", "eliminada"}), said({"drawn", "desenhada"}));
    default:
        return std::nullopt;
    }
}

bool is_right(const StepQuestion& question, std::string_view answer) {
    const auto numbers = numbers_in(question.right);
    if (!numbers.empty())
        return numbers_in(answer) == numbers;
    const std::string word = in_lower_case(std::string(without_blanks(answer)));
    return !word.empty() && question.right.starts_with(word);
}

std::string csv_of(const std::vector<GivenAnswer>& answers) {
    std::string text;
    put_csv_line(text, {"step", "kind", "question", "answer", "right answer", "is right"});
    for (const GivenAnswer& given : answers)
        put_csv_line(text, {std::to_string(given.question.step), given.question.kind,
                            given.question.words, given.answer, given.question.right,
                            given.is_right ? "true" : "false"});
    return text;
}

} // namespace rastertrace
