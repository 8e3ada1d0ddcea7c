// SPDX-License-Identifier: MIT
#pragma once

// A sink that writes each step as one line of JSON. docs/trace-format.md describes the lines.
//
//     std::string text;
//     StringOutput out(text);
//     StepWriter writer(out, TraceLayout::json, {});
//     draw(scene, plan, writer);
//
// A line is the table of its step (traced_steps.h), a value for each field. It is put together in a buffer that goes to the
// output when it is full: memory does not grow with the number of steps. A step that the filter leaves out is never
// formatted.

#include "double_texts.h"
#include "trace_options.h"
#include "traced_steps.h"

#include <rastertrace/core/draw/scene/method.h>
#include <rastertrace/core/numbers/quantity.h>
#include <rastertrace/core/raster/steps.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/format_number.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace rastertrace {

class StepWriter {
public:
    StepWriter(Output& output, TraceLayout layout, const StepFilter& filter);
    StepWriter(const StepWriter&) = delete;
    StepWriter& operator=(const StepWriter&) = delete;

    /// False for steps that the filter leaves out, whatever they say.
    template <typename Step> bool takes() const {
        if constexpr (requires(Step * step) { kind_of(step); })
            return wanted_[static_cast<std::size_t>(kind_of(static_cast<Step*>(nullptr)))];
        else
            return true;
    }

    void operator()(const PixelPlotted& step) {
        if (!wants(StepKind::pixel) || !is_in_region(step.pixel))
            return;
        if (step.color == color_)
            put_step<PixelStep>(step.pixel.x, step.pixel.y, Absent());
        else
            put_colored_pixel(step);
    }

    void operator()(const FaceTriangulated<Quantity>& step);
    void operator()(const MatrixSetUp<Quantity>& step);
    void operator()(const VertexPlaced<Quantity>& step);
    void operator()(const PrimitivesOrdered<Quantity>& step);
    void operator()(const PrimitiveBegan<Quantity>& step);
    void operator()(const FaceTested<Quantity>& step);
    void operator()(const FaceLit<Quantity>& step);
    void operator()(const PrimitiveClipped& step);
    void operator()(const EdgeSetUp<Quantity>& step);
    void operator()(const EdgeFunctionSetUp<Quantity>& step);
    void operator()(const SideBegan& step);
    void operator()(const HalfBegan& step);
    void operator()(const RayBegan& step);
    void operator()(const RowCrossed<Quantity>& step);
    void operator()(const ScanlineSpanned<Quantity>& step);
    void operator()(const LineSampled<Quantity>& step);
    void operator()(const LineDecided& step);
    void operator()(const SampleTested<Quantity>& step);
    void operator()(const DepthTested<Quantity>& step);
    void operator()(const PixelsRejected& step);
    void operator()(const RowsRejected& step);
    void operator()(const PrimitiveSkipped& step);
    void operator()(const BoundExceeded& step);

    /// Writes text as it is: for what stands before the first step and behind the last one.
    void put_text(std::string_view text) { put(text); }

    /// Hands everything written so far to the output.
    void flush();

    /// How many steps of a kind have been written.
    std::uint64_t count(StepKind kind) const { return counts_[static_cast<std::size_t>(kind)]; }

private:
    bool wants(StepKind kind) const {
        return wanted_[static_cast<std::size_t>(kind)] && is_in_primitive_;
    }

    // Steps that need not be put together if they are left out. PrimitiveBegan says whose the others are.
    static StepKind kind_of(const MatrixSetUp<Quantity>*) { return StepKind::matrix; }
    static StepKind kind_of(const VertexPlaced<Quantity>*) { return StepKind::vertex; }
    static StepKind kind_of(const FaceTested<Quantity>*) { return StepKind::face; }
    static StepKind kind_of(const FaceLit<Quantity>*) { return StepKind::light; }
    static StepKind kind_of(const EdgeSetUp<Quantity>*) { return StepKind::edge; }
    static StepKind kind_of(const EdgeFunctionSetUp<Quantity>*) { return StepKind::edge; }
    static StepKind kind_of(const RowCrossed<Quantity>*) { return StepKind::crossings; }
    static StepKind kind_of(const ScanlineSpanned<Quantity>*) { return StepKind::scanline; }
    static StepKind kind_of(const LineSampled<Quantity>*) { return StepKind::along; }
    static StepKind kind_of(const SampleTested<Quantity>*) { return StepKind::sample; }
    static StepKind kind_of(const DepthTested<Quantity>*) { return StepKind::depth; }
    static StepKind kind_of(const SideBegan*) { return StepKind::edge; }
    static StepKind kind_of(const HalfBegan*) { return StepKind::half; }
    static StepKind kind_of(const RayBegan*) { return StepKind::ray; }
    static StepKind kind_of(const LineDecided*) { return StepKind::decide; }
    static StepKind kind_of(const PixelPlotted*) { return StepKind::pixel; }
    static StepKind kind_of(const PixelsRejected*) { return StepKind::reject; }
    static StepKind kind_of(const RowsRejected*) { return StepKind::reject; }

    /// ABC/1 is a part of ABC.
    static bool is_part_of(std::string_view name, std::string_view whole) {
        return name.starts_with(whole) &&
               (name.size() == whole.size() || name[whole.size()] == '/');
    }

    bool is_in_region(Index y, Index from, Index to) const {
        return !region_ || (region_->has_row(y) && region_->meets(from, to));
    }
    bool is_in_region(Pixel pixel) const { return is_in_region(pixel.y, pixel.x, pixel.x); }
    bool is_in_region(const LineSampled<Quantity>& step) const {
        return step.is_x_major ? is_in_region(step.pixel, step.at, step.at)
                               : is_in_region(step.at, step.pixel, step.pixel);
    }

    void write_labels();
    void put_colored_pixel(const PixelPlotted& step);

    // A line is the table of its step (traced_steps.h) with a value for each field.

    /// The value of a field that a step does not have. A pointer that is null is another one.
    struct Absent {};

    /// A string.
    struct Quoted {
        std::string_view text;
    };
    static Quoted quoted(std::string_view text) { return {text}; }

    /// A string without a character that JSON escapes: a word of ours, or a color.
    struct Word {
        std::string_view text;
    };
    static constexpr Word off_canvas{"off-canvas"};
    struct ColorText : std::string {
        explicit ColorText(Color color) : std::string(to_text(color)) {}
    };

    /// A value, or null.
    template <typename Value> struct OrNull { const Value* value; };
    template <typename Value> OrNull(const Value*) -> OrNull<Value>;

    /// A list of so many values. Quantities are not copied.
    template <typename Value>
    using Held = std::conditional_t<std::is_same_v<Value, Quantity>, const Quantity&, Value>;
    template <typename... Values> struct Tuple { std::tuple<Held<Values>...> values; };
    template <typename... Values> static Tuple<Values...> tuple(const Values&... values) {
        return {{values...}};
    }

    /// A list as long as a range, each value as `value_of` makes it. It may be longer than the buffer.
    template <typename Range, typename Make> struct List {
        const Range& range;
        Make value_of;
    };
    template <typename Range, typename Make> List(const Range&, Make) -> List<Range, Make>;

    /// The same, but absent if it is empty.
    template <typename Range, typename Make> struct ListIfAny : List<Range, Make> {};
    template <typename Range, typename Make>
    ListIfAny(const Range&, Make) -> ListIfAny<Range, Make>;

    template <typename Value> static constexpr bool is_list = requires(Value list) {
        list.value_of;
    };

    /// A field with its key, or nothing if its value is absent.
    template <typename Row, typename Value> struct Field { const Value& value; };

    /// Writes a step: a value for each field of its kind, in the order of the table.
    template <typename Step, typename... Values> void put_step(const Values&... values) {
        ++counts_[static_cast<std::size_t>(Step::step_kind)];
        put_fields<Step>(typename Step::Fields{}, values...);
        separator_ = next_separator_;
    }

    template <typename Step, typename... Rows, typename... Values>
    void put_fields(FieldTable<Rows...> /*table*/, const Values&... values) {
        static_assert(sizeof...(Rows) == sizeof...(Values));
        constexpr std::string_view name = step_names[static_cast<std::size_t>(Step::step_kind)];
        if constexpr ((is_list<Values> || ...)) {
            put(separator_, front_of_step, name, "\"");
            (put_field<Rows>(values), ...);
            put("}");
        } else {
            put(separator_, front_of_step, name, "\"", Field<Rows, Values>{values}..., "}");
        }
    }

    template <typename Row, typename Value> void put_field(const Value& value) {
        put(Field<Row, Value>{value});
    }
    template <typename Row, typename Range, typename Make>
    void put_field(const List<Range, Make>& list) {
        put(Row::front);
        put_list(list);
    }
    template <typename Row, typename Range, typename Make>
    void put_field(const ListIfAny<Range, Make>& list) {
        if (!std::empty(list.range))
            put_field<Row>(static_cast<const List<Range, Make>&>(list));
    }

    template <typename Range, typename Make> void put_list(const List<Range, Make>& list) {
        std::string_view before = "[";
        for (const auto& one : list.range) {
            put(before, list.value_of(one));
            before = ",";
        }
        put(std::string_view(std::empty(list.range) ? "[]" : "]"));
    }

    /// Puts literals, strings and values one behind the other.
    template <typename... Pieces> void put(const Pieces&... pieces) {
        char* out = room((size_of(pieces) + ...));
        ((out = append(out, pieces)), ...);
        used_ = static_cast<std::size_t>(out - buffer_.data());
    }

    /// The quoted name of an edge of the current primitive.
    std::string_view label(EdgeName edge) {
        if (!has_labels_)
            write_labels();
        const std::size_t number = label_of(edge);
        return number < labels_.size() ? std::string_view(labels_[number]) : std::string_view("");
    }

    /// Where the label of an edge stands: from each vertex the way to the next one, and back to the one before.
    std::size_t label_of(EdgeName edge) const {
        const bool leads_on =
            edge.to == edge.from + 1 || (edge.to == 0 && edge.from + 1U == vertices_.size());
        return 2U * edge.from + (leads_on ? 0 : 1);
    }

    /// A place in the buffer with room for `size` bytes.
    char* room(std::size_t size) {
        if (buffer_.size() - used_ < size)
            make_room(size);
        return buffer_.data() + used_;
    }
    void make_room(std::size_t size);

    template <std::size_t size> static constexpr std::size_t size_of(const char (&)[size]) {
        return size - 1;
    }
    static std::size_t size_of(std::string_view text) { return text.size(); }
    static std::size_t size_of(bool /*value*/) { return longest_flag; }
    static std::size_t size_of(Word word) { return word.text.size() + 2; }
    static std::size_t size_of(const ColorText& color) { return color.size() + 2; }
    static std::size_t size_of(Quoted name) { return room_for_quoted(name.text); }
    template <typename Value> std::size_t size_of(const OrNull<Value>& told) const {
        return told.value ? size_of(*told.value) : null.size();
    }
    template <typename... Values> std::size_t size_of(const Tuple<Values...>& tuple) const {
        return std::apply(
            [this](const auto&... values) {
                return (this->size_of(values) + ... + 1) + sizeof...(values);
            },
            tuple.values);
    }
    template <typename Row, typename Value>
    std::size_t size_of(const Field<Row, Value>& field) const {
        if constexpr (std::is_same_v<Value, Absent>)
            return 0;
        else if constexpr (std::is_pointer_v<Value>)
            return field.value ? Row::front.size() + size_of(*field.value) : 0;
        else
            return Row::front.size() + size_of(field.value);
    }
    template <typename Number> static std::size_t size_of(const Number& number) {
        return room_for(number);
    }
    std::size_t size_of(const Quantity& number) const {
        constexpr std::size_t fits_all_but_rationals = room_for(Fraction64{});
        const Rational* const rational = number.rational();
        return rational ? size_of(*rational) : fits_all_but_rationals;
    }
    std::size_t size_of(const Rational& number) const { return room_for(number) + room_for(0.0); }

    template <std::size_t size> static char* append(char* out, const char (&literal)[size]) {
        std::memcpy(out, literal, size - 1);
        return out + (size - 1);
    }
    static char* append(char* out, std::string_view text) {
        std::memcpy(out, text.data(), text.size());
        return out + text.size();
    }
    static char* append(char* out, bool value) {
        return append(out, std::string_view(value ? "true" : "false"));
    }
    static char* append(char* out, Word word) {
        *out++ = '"';
        out = append(out, word.text);
        *out++ = '"';
        return out;
    }
    static char* append(char* out, const ColorText& color) {
        return append(out, Word{static_cast<const std::string&>(color)});
    }
    static char* append(char* out, Quoted name) { return write_quoted(out, name.text); }
    template <typename Value> char* append(char* out, const OrNull<Value>& told) const {
        return told.value ? append(out, *told.value) : append(out, null);
    }
    template <typename... Values> char* append(char* out, const Tuple<Values...>& tuple) const {
        char before = '[';
        const auto append_one = [&](const auto& value) {
            *out++ = std::exchange(before, ',');
            out = append(out, value);
        };
        std::apply([&](const auto&... values) { (append_one(values), ...); }, tuple.values);
        *out++ = ']';
        return out;
    }
    template <typename Row, typename Value>
    char* append(char* out, const Field<Row, Value>& field) const {
        if constexpr (std::is_same_v<Value, Absent>)
            return out;
        else if constexpr (std::is_pointer_v<Value>)
            return field.value ? append(append(out, Row::front), *field.value) : out;
        else
            return append(append(out, Row::front), field.value);
    }
    template <typename Number> static char* append(char* out, const Number& number) {
        return format_number(out, number);
    }
    char* append(char* out, double number) const { return texts_.append(out, number); }
    char* append(char* out, const Quantity& number) const {
        return number.visit([&](const auto& value) { return append(out, value); });
    }

    static constexpr std::string_view null = "null";
    static constexpr std::size_t longest_flag = 5; ///< false

    Output& output_;
    std::vector<char> buffer_;
    std::size_t used_ = 0;
    std::string_view separator_ = "\n"; ///< before the next line
    std::string_view next_separator_;
    std::array<bool, step_kinds> wanted_{};
    std::optional<Region> region_;
    std::optional<std::string> primitive_;
    bool is_in_primitive_;
    std::array<std::uint64_t, step_kinds> counts_{};
    Color color_;            ///< of the current primitive
    std::string name_;       ///< of the same
    bool is_circle_ = false; ///< then each decision is about pixels in all eight octants
    std::vector<std::string_view> vertices_; ///< its vertices' names
    std::vector<std::string> quoted_;        ///< the same in quotes,
    std::vector<std::string> labels_;        ///< and its edges' names in quotes,
    bool has_labels_ = false;                ///< once one was asked for
    mutable DoubleTexts texts_;
};

} // namespace rastertrace
