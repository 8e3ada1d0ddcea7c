// SPDX-License-Identifier: MIT
#include "diff_tally.h"

#include <algorithm>

namespace rastertrace {

namespace {

/// So many pixels that differ are remembered of one primitive.
constexpr std::size_t most_pixels_of_section = 1'000'000;

bool names_vertex(const std::string& primitive, const std::string& vertex) {
    const auto names = StepView(primitive).texts("vertices");
    return std::find(names.begin(), names.end(), vertex) != names.end();
}

} // namespace

KindDifference& DiffTally::of_kind(const StepLine& step) {
    KindDifference& kind = kinds_[step.kind_name];
    kind.kind = step.kind_name;
    return kind;
}

void DiffTally::add_changed(std::size_t place, const StepLine& a, const StepLine& b,
                            std::vector<FieldDifference> fields) {
    KindDifference& kind = of_kind(a);
    ++kind.changed;
    for (const FieldDifference& field : fields) {
        auto summary =
            std::find_if(kind.fields.begin(), kind.fields.end(),
                         [&field](const FieldSummary& one) { return one.name == field.name; });
        if (summary == kind.fields.end())
            summary = kind.fields.insert(kind.fields.end(), {.name = field.name});
        ++summary->count;
        if (field.distance)
            summary->largest = std::max(summary->largest.value_or(0), *field.distance);
    }
    if (a.kind == StepKind::pixel)
        note_pixel(a, PixelChange::color);
    note_first(place, &a, &b, std::move(fields), false);
}

void DiffTally::add_only_a(std::size_t place, const StepLine& a) {
    ++of_kind(a).only_a;
    note_pixel(a, PixelChange::only_a);
    note_first(place, &a, nullptr, {}, false);
}

void DiffTally::add_only_b(std::size_t place, const StepLine& b) {
    ++of_kind(b).only_b;
    note_pixel(b, PixelChange::only_b);
    note_first(place, nullptr, &b, {}, false);
}

void DiffTally::add_moved(std::size_t place, const StepLine& a, const StepLine& b) {
    ++of_kind(a).moved;
    note_first(place, &a, &b, {}, true);
}

void DiffTally::note_first(std::size_t place, const StepLine* a, const StepLine* b,
                           std::vector<FieldDifference> fields, bool is_moved) {
    if (first_ && first_->place < place)
        return;
    if (first_ && first_->place == place) {
        // One step in place of another: both are shown.
        const bool is_alone = first_->fields.empty() && !first_->is_moved && fields.empty();
        if (is_alone && !is_moved && !first_->a && a != nullptr)
            first_->a = *a;
        if (is_alone && !is_moved && !first_->b && b != nullptr)
            first_->b = *b;
        return;
    }
    first_ = FirstDifference{.place = place,
                             .a = a == nullptr ? std::nullopt : std::optional(*a),
                             .b = b == nullptr ? std::nullopt : std::optional(*b),
                             .fields = std::move(fields),
                             .is_moved = is_moved,
                             .section = section_};
}

void DiffTally::note_pixel(const StepLine& step, PixelChange change) {
    if (step.kind != StepKind::pixel || pixels_.size() == most_pixels_of_section)
        return;
    const StepView view(step.json);
    pixels_.push_back(
        {{static_cast<int>(*view.whole("x")), static_cast<int>(*view.whole("y"))}, change});
}

/// True of a pixel of this section that comes of the first difference: one of the same row, pixel or primitive; or
/// one of any primitive where such a pixel lies.
bool DiffTally::is_due_to_first(Pixel pixel) const {
    if (due_.count({pixel.x, pixel.y}) > 0)
        return true;
    const StepLine& step = first_->a ? *first_->a : *first_->b;
    const StepView view(step.json);
    const bool is_here = first_->section.id == section_.id;
    if (!step.kind)
        return is_here;
    switch (*step.kind) {
    case StepKind::matrix:
    case StepKind::order:
    case StepKind::triangulate:
        return true;
    case StepKind::vertex:
        return is_here || names_vertex(section_.json_a, view.text("name")) ||
               names_vertex(section_.json_b, view.text("name"));
    case StepKind::scanline:
        return is_here && (view.whole("y") == pixel.y ||
                           (first_->b && StepView(first_->b->json).whole("y") == pixel.y));
    case StepKind::sample:
    case StepKind::depth:
    case StepKind::pixel: {
        const auto is_at = [pixel](const std::optional<StepLine>& one) {
            return one && StepView(one->json).whole("x") == pixel.x &&
                   StepView(one->json).whole("y") == pixel.y;
        };
        return is_here && (is_at(first_->a) || is_at(first_->b));
    }
    default:
        return is_here;
    }
}

void DiffTally::end_section() {
    for (const PixelEvent& event : pixels_) {
        if (!is_due_to_first(event.pixel))
            continue;
        ++led_to_.count;
        due_.emplace(event.pixel.x, event.pixel.y);
        std::vector<Pixel>& list = event.change == PixelChange::only_a   ? led_to_.only_a
                                   : event.change == PixelChange::only_b ? led_to_.only_b
                                                                         : led_to_.colors;
        if (list.size() < most_pixels_told)
            list.push_back(event.pixel);
    }
    pixels_.clear();
}

std::vector<KindDifference> DiffTally::kinds() const {
    std::vector<KindDifference> sorted;
    for (const std::string_view name : step_kind_names())
        if (const auto found = kinds_.find(std::string(name)); found != kinds_.end())
            sorted.push_back(found->second);
    for (const auto& [name, kind] : kinds_)
        if (!step_kind_named(name))
            sorted.push_back(kind);
    return sorted;
}

} // namespace rastertrace
