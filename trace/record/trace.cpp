// SPDX-License-Identifier: MIT
#include "trace.h"

#include "field_type.h"
#include "step_json.h"
#include "steps.h"
#include "traced_steps.h"
#include "visit_step.h"

#include <rastertrace/trace/text/format_number.h>
#include <rastertrace/trace/text/json_scanner.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <utility>

namespace rastertrace {

std::string StepView::json() const {
    if (!text_.empty())
        return std::string(text_);
    std::string json;
    visit_step(*this, [&json](const auto& step) { json = step_json(step); });
    return json;
}

std::optional<std::string> StepView::field(std::string_view name) const {
    std::optional<std::string> found;
    if (text_.empty()) {
        visit_step(*this, [&](const auto& step) { found = field_of_step(step, name); });
        return found;
    }
    JsonScanner fields(text_);
    while (!found && fields.next_field())
        if (fields.key() == name)
            found = fields.value();
    return found;
}

std::vector<std::pair<std::string, std::string>> StepView::fields() const {
    const std::string json = this->json();
    std::vector<std::pair<std::string, std::string>> all;
    JsonScanner fields(json);
    while (fields.next_field())
        all.emplace_back(plain_text(fmt::format("\"{}\"", fields.key())), fields.value());
    return all;
}

std::string StepView::kind_name() const {
    return kind_ ? std::string(name_of(*kind_)) : plain_text(field("step").value_or(""));
}

Trace::Trace() : steps_(std::make_shared<Steps>()) {}

const Source& Trace::source() const {
    return steps_->source();
}

std::size_t Trace::size() const {
    return is_excerpt_ ? numbers_.size() : steps_->size();
}

StepView Trace::step(std::size_t n) const {
    assert(n > 0 && n <= size());
    return steps_->at(number_of(n));
}

std::size_t Trace::line_of(std::size_t n) const {
    if (!has_lines_ || !source().is_read)
        return 0;
    const std::string_view text = source().view();
    const std::string_view before =
        text.substr(0, static_cast<std::size_t>(text_of(n).data() - text.data()));
    return static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
}

std::optional<StepKind> Trace::kind_of(std::size_t n) const {
    assert(n > 0 && n <= size());
    return steps_->kind(number_of(n));
}

std::size_t Trace::next_of(StepKindSet kinds, std::size_t n, std::size_t last) const {
    for (; n <= last; ++n)
        if (const auto kind = kind_of(n); kind && kinds.has(*kind))
            return n;
    return last + 1;
}

std::vector<std::size_t> Trace::steps_of(StepKindSet kinds, std::size_t first,
                                         std::size_t last) const {
    last = std::min(last, size());
    std::vector<std::size_t> steps;
    while ((first = next_of(kinds, first, last)) <= last)
        steps.push_back(first++);
    return steps;
}

bool Trace::is_plain(std::size_t n) const {
    return steps_->text_of(number_of(n)).empty();
}

Trace Trace::without_steps() const {
    Trace excerpt = *this;
    excerpt.cut_short.reset();
    excerpt.damage.clear();
    excerpt.not_finite = {};
    excerpt.passed_over.clear();
    excerpt.numbers_.clear();
    excerpt.is_excerpt_ = true;
    return excerpt;
}

bool Trace::lacks(StepKind kind) const {
    const auto& only = left_out.only;
    return only && std::find(only->begin(), only->end(), name_of(kind)) == only->end();
}

/// The text that step n was read from. One that is written as this program writes it has the n-th line behind the header,
/// but for lines without anything.
std::string_view Trace::text_of(std::size_t n) const {
    if (const std::string_view own = steps_->text_of(number_of(n)); !own.empty())
        return own;
    std::string_view text = source().view();
    const auto next_line = [&text] {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        return line;
    };
    next_line();
    for (std::size_t left = number_of(n);;)
        if (const std::string_view line = next_line(); !without_blanks(line).empty() && --left == 0)
            return line.substr(0, line.rfind('}') + 1);
}

Problem Trace::problem_at_field(std::size_t n, std::string_view field, std::string message) const {
    const std::string_view text = text_of(n);
    const char* at = text.data();
    JsonScanner fields(text);
    while (fields.next_field())
        if (fields.key() == field)
            at = fields.value().data();
    return problem_at(source(), static_cast<std::size_t>(at - source().view().data()),
                      std::move(message));
}

std::vector<Problem> Trace::faults_in_step(std::size_t n) const {
    const auto kind = kind_of(n);
    if (!kind || is_plain(n))
        return {};
    const std::string_view json = text_of(n);
    const auto& known = fields_of(*kind);
    std::vector<Problem> faults;
    JsonScanner fields(json);
    while (fields.next_field()) {
        const auto field =
            std::find_if(known.begin(), known.end(),
                         [&fields](const StepField& one) { return one.name == fields.key(); });
        if (field == known.end() || has_type_of(fields.value(), *field))
            continue;
        const auto offset =
            static_cast<std::size_t>(fields.value().data() - source().view().data());
        faults.push_back(
            problem_at(source(), offset,
                       fmt::format("expected {} for {}, found {}", expected_for(*field),
                                   field->name, shortened(fields.value(), 40))));
    }
    return faults;
}

std::optional<Problem> NotFiniteSteps::remark() const {
    std::optional<Problem> remark = first;
    if (count > 1)
        remark->message += fmt::format("; {} more {} such a number", count - 1,
                                       count == 2 ? "step has" : "steps have");
    if (remark)
        remark->hint = "it is told as it stands; formulas, figures and counts leave it out";
    return remark;
}

} // namespace rastertrace
