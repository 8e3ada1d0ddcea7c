// SPDX-License-Identifier: MIT
#include "trace.h"

#include "field_type.h"
#include "frame.h"
#include "step_places.h"
#include "traced_steps.h"

#include <rastertrace/trace/text/format_number.h>
#include <rastertrace/trace/text/json_scanner.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <functional>
#include <utility>

namespace rastertrace {

std::string_view StepView::pixel_json() const {
    char* end = buffer_.data();
    const auto add_text = [&end](std::string_view text) {
        end = std::copy(text.begin(), text.end(), end);
    };
    add_text(R"({"step":"pixel","x":)");
    end = format_number(end, pixel_.x);
    add_text(R"(,"y":)");
    end = format_number(end, pixel_.y);
    add_text("}");
    return {buffer_.data(), static_cast<std::size_t>(end - buffer_.data())};
}

std::optional<std::string_view> StepView::field(std::string_view name) const& {
    if (is_pixel_ && name != "x" && name != "y" && name != "step")
        return std::nullopt;
    JsonScanner fields(json());
    while (fields.next_field())
        if (fields.key() == name)
            return fields.value();
    return std::nullopt;
}

std::string StepView::kind_name() const {
    return is_pixel_ ? std::string(name_of(StepKind::pixel))
                     : plain_text(field("step").value_or(""));
}

std::optional<double> nearest_double_in(const std::string& number) {
    return TracedNumber(number).nearest_double();
}

Trace::Trace() : steps_(std::make_unique<StepPlaces>()) {}
Trace::Trace(Trace&&) noexcept = default;
Trace& Trace::operator=(Trace&&) noexcept = default;
Trace::~Trace() = default;

const StepPlace& Trace::place_of(std::size_t n) const {
    assert(n > 0 && n <= size());
    return steps_->at(n, text());
}

std::size_t Trace::size() const {
    return steps_->size();
}

namespace {

StepView step_at(const StepPlace& place, std::string_view text) {
    return place.pixel ? StepView(*place.pixel) : StepView(text.substr(place.offset, place.length));
}

} // namespace

StepView Trace::step(std::size_t n) const {
    return step_at(place_of(n), text());
}

std::size_t Trace::offset_of(std::size_t n) const {
    return place_of(n).offset;
}

std::size_t Trace::line_of(std::size_t n) const {
    if (!has_lines_ || !source_.is_read)
        return 0;
    const std::string_view before = text().substr(0, offset_of(n));
    return static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
}

std::optional<StepKind> Trace::kind_of(std::size_t n) const {
    assert(n > 0 && n <= size());
    return steps_->kind(n, text());
}

std::size_t Trace::next_of(StepKindSet kinds, std::size_t n, std::size_t last) const {
    return steps_->next_of(kinds, n, last, text());
}

std::optional<ReplayState> Trace::end_state_ahead(std::size_t of) const {
    const auto last = size() > of ? std::move(end_state_) : nullptr;
    return last ? std::optional(std::move(*last)) : std::nullopt;
}

bool Trace::is_plain(std::size_t n) const {
    assert(n > 0 && n <= size());
    return steps_->is_plain(n, text());
}

Trace Trace::without_steps() const {
    Trace excerpt;
    excerpt.version = version;
    excerpt.title = title;
    excerpt.canvas = canvas;
    excerpt.background = background;
    excerpt.method = method;
    excerpt.stages = stages;
    excerpt.is_partial = is_partial;
    excerpt.left_out = left_out;
    excerpt.end = end;
    excerpt.header_json = header_json;
    excerpt.numbers_give = numbers_give;
    if (text_of_file_.data() != nullptr) {
        excerpt.source_ = source_;
        excerpt.text_of_file_ = text_of_file_;
        excerpt.steps_->set_file(source_.mapped);
    }
    return excerpt;
}

bool Trace::is_in_file(std::string_view json) const {
    const std::less_equal<> is_not_behind; // also of pointers to different texts
    return text_of_file_.data() != nullptr && is_not_behind(text_of_file_.data(), json.data()) &&
           is_not_behind(json.data() + json.size(), text_of_file_.data() + text_of_file_.size());
}

void Trace::add_to_excerpt(const StepView& step, std::optional<StepKind> kind, std::size_t number) {
    const std::string_view json = step.json();
    const bool is_mapped = text_of_file_.data() != nullptr;
    assert(!is_mapped || is_in_file(json));
    steps_->add({.offset = is_mapped ? static_cast<std::size_t>(json.data() - text_of_file_.data())
                                     : source_.text.size(),
                 .length = static_cast<std::uint32_t>(json.size()),
                 .kind = kind});
    numbers_.push_back(number);
    if (!is_mapped)
        source_.text += json;
}

bool Trace::lacks(StepKind kind) const {
    const auto& only = left_out.only;
    return only && std::find(only->begin(), only->end(), name_of(kind)) == only->end();
}

std::string Trace::method_value(std::string_view key) const {
    for (const auto& [name, value] : method)
        if (name == key)
            return value;
    return {};
}

Problem Trace::problem_at_field(std::size_t n, std::string_view field, std::string message) const {
    const StepView view = step(n);
    const std::string_view json = view.json();
    const auto value = view.field(field);
    const std::size_t in_step = value ? static_cast<std::size_t>(value->data() - json.data()) : 0;
    return problem_at(source_, offset_of(n) + in_step, std::move(message));
}

std::vector<Problem> Trace::faults_in_step(std::size_t n) const {
    const auto kind = kind_of(n);
    if (!kind || is_plain(n))
        return {};
    const StepView view = step(n);
    const std::string_view json = view.json();
    const auto& known = fields_of(*kind);
    std::vector<Problem> faults;
    JsonScanner fields(json);
    while (fields.next_field()) {
        const auto field =
            std::find_if(known.begin(), known.end(),
                         [&fields](const StepField& one) { return one.name == fields.key(); });
        if (field == known.end() || has_type_of(fields.value(), *field))
            continue;
        const auto offset = static_cast<std::size_t>(fields.value().data() - json.data());
        faults.push_back(
            problem_at(source_, offset_of(n) + offset,
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
