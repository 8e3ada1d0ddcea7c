// SPDX-License-Identifier: MIT
#pragma once

// A sink that writes each step as one line of JSON. docs/trace-format.md describes the lines.
//
//     std::string text;
//     StringOutput out(text);
//     StepWriter writer(out, TraceLayout::json, {});
//     draw(scene, plan, writer);
//
// A line is put together in a buffer from literals and numbers, and the buffer goes to the output
// when it is full: memory does not grow with the number of steps. A step that the filter leaves out
// is never formatted.

#include "step_kind.h"
#include "trace_options.h"

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
#include <vector>

namespace rastertrace {

/// How numbers are written that are known exactly.
enum class NumberStyle {
    exact,   ///< as fractions: "25/8"
    doubles, ///< as the nearest doubles, like all other numbers: 3.125
};

/// A method that draws some of its numbers exactly and others not writes all of them alike.
NumberStyle number_style_of(const Method& method);

/// A number that is written as it is: in the style of doubles as a string where no double is that
/// number.
template <typename Number> struct Exactly {
    const Number& number;
    bool however_long = false; ///< else a number with too many digits is rounded
};
template <typename Number> Exactly(const Number&) -> Exactly<Number>;
template <typename Number> Exactly(const Number&, bool) -> Exactly<Number>;

/// A number that is rounded to a pixel, or whose sign decides. In the style of doubles it is written as a
/// fraction where the nearest double is a whole number or a half, and not the number: there the double
/// could be rounded to another pixel.
template <typename Number> struct Deciding { const Number& number; };
template <typename Number> Deciding(const Number&) -> Deciding<Number>;

class StepWriter {
public:
    StepWriter(Output& output, TraceLayout layout, const StepFilter& filter,
               NumberStyle numbers = NumberStyle::exact);
    StepWriter(const StepWriter&) = delete;
    StepWriter& operator=(const StepWriter&) = delete;

    /// False for steps that the filter leaves out, whatever they say.
    template <typename Step> bool takes() const {
        if constexpr (requires(Step * step) { kind_of(step); })
            return wanted_[static_cast<std::size_t>(kind_of(static_cast<Step*>(nullptr)))];
        else
            return true;
    }

    /// Of a primitive that is not written, only the names count.
    bool reads_corners() const { return wanted_[static_cast<std::size_t>(StepKind::primitive)]; }

    void operator()(const MatrixSetUp<Quantity>& step) {
        if (!wants(StepKind::matrix))
            return;
        begin_line(StepKind::matrix);
        put(R"({"step":"matrix","name":")", step.name, "\"");
        if (!step.object.empty())
            put(R"(,"object":)", std::string_view(json_quoted(step.object)));
        put(R"(,"rows":[)");
        put_rows("", step.matrix);
        put("]");
        std::string_view before = R"(,"factors":[)";
        for (const auto& factor : step.factors) {
            put(before, "\"", factor.name, "\"");
            before = ",";
        }
        before = R"(],"factor_rows":[)";
        for (const auto& factor : step.factors) {
            put_rows(before, factor.matrix);
            before = ",";
        }
        if (!step.factors.empty())
            put("]");
        before = R"(,"camera":[)";
        for (const auto& vector : step.camera) {
            put(before, "[", vector.x, ",", vector.y, ",", vector.z, "]");
            before = ",";
        }
        put(step.camera.empty() ? std::string_view("}") : std::string_view("]}"));
    }

    void operator()(const VertexPlaced<Quantity>& step) {
        if (!wants(StepKind::vertex))
            return;
        begin_vertex_line(step.name, step.space);
        if (step.snapped.empty())
            put_numbers(R"(,"at":[)", step.at);
        else
            put(R"(,"at":[)", Deciding{step.at[0]}, ",", Deciding{step.at[1]}, "]");
        if (!step.snapped.empty())
            put_numbers(R"(,"snapped":[)", step.snapped);
        put("}");
    }

    void operator()(const PrimitiveBegan<Quantity>& step) {
        is_in_primitive_ = !primitive_ || is_part_of(step.name, *primitive_);
        color_ = step.color;
        name_ = step.name;
        vertex_count_ = step.vertices.size();
        std::copy(step.vertices.begin(), step.vertices.end(), vertices_.begin());
        has_labels_ = false;
        is_circle_ = step.kind == PrimitiveKind::circle;
        if (!wants(StepKind::primitive))
            return;
        begin_primitive_line(step.kind, step.name, step.vertices);
        // Who looks for pixels that are wrong has to know just where the corners are.
        std::string_view before = R"(,"at":[[)";
        double within = 0;
        for (const auto& position : step.positions) {
            put(before, Exactly{position.x}, ",", Exactly{position.y}, "]");
            before = ",[";
            within = std::max({within, rounded_off(position.x), rounded_off(position.y)});
        }
        if (!step.positions.empty())
            put("]");
        if (within > 0)
            put(R"(,"within":)", within);
        before = R"(,"depths":[)";
        for (const auto& depth : step.depths) {
            put(before, Exactly{depth});
            before = ",";
        }
        if (!step.depths.empty())
            put("]");
        end_primitive_line(step);
    }

    void operator()(const PrimitivesOrdered<Quantity>& step) {
        if (!wants(StepKind::order))
            return;
        begin_line(StepKind::order);
        put(R"({"step":"order","names":[)");
        std::string_view before = "";
        for (const std::string_view name : step.names) {
            put(before, std::string_view(json_quoted(name)));
            before = ",";
        }
        // Different ones that round to one double are told as they are: their order hangs on it.
        put(R"(],"distances":[)");
        before = "";
        const auto& distances = step.distances;
        for (std::size_t i = 0, end = 0; i < distances.size(); i = end) {
            const double near = to_double(distances[i]);
            bool differ = false;
            for (end = i + 1; end < distances.size() && to_double(distances[end]) == near; ++end)
                differ = differ || round_alike(distances[end - 1], distances[end]);
            for (std::size_t k = i; k < end; ++k) {
                if (differ)
                    put(before, Exactly{distances[k], true});
                else
                    put(before, distances[k]);
                before = ",";
            }
        }
        before = R"(],"listed":[)";
        for (const std::size_t index : step.indices) {
            put(before, static_cast<std::int64_t>(index + 1));
            before = ",";
        }
        put("]}");
    }

    void operator()(const FaceTested<Quantity>& step) {
        if (!wants(StepKind::face))
            return;
        begin_line(StepKind::face);
        put(R"({"step":"face","name":)", std::string_view(json_quoted(name_)), R"(,"normal":[)",
            step.normal.x, ",", step.normal.y, ",", step.normal.z, R"(],"view":[)", step.view.x,
            ",", step.view.y, ",", step.view.z, R"(],"dot":)", Deciding{step.dot});
        if (step.cosine)
            put(R"(,"cosine":)", *step.cosine);
        else
            put(R"(,"cosine":null)");
        put(std::string_view(step.is_by_light ? R"(,"by":"light")" : ""), R"(,"culled":)",
            word(step.is_culled), R"(,"opposite":)", word(step.is_culled_opposite), "}");
    }

    void operator()(const FaceLit<Quantity>& step) {
        if (!wants(StepKind::light))
            return;
        begin_line(StepKind::light);
        put(R"({"step":"light","name":)", std::string_view(json_quoted(name_)), R"(,"normal":[)",
            step.normal.x, ",", step.normal.y, ",", step.normal.z, R"(],"light":[)", step.light.x,
            ",", step.light.y, ",", step.light.z, R"(],"dot":)", Deciding{step.dot},
            R"(,"intensity":)", step.intensity, R"(,"color":")",
            std::string_view(to_text(step.color)), "\"}");
    }

    void operator()(const DepthTested<Quantity>& step) {
        if (!wants(StepKind::depth) || !is_in_region(step.pixel))
            return;
        begin_line(StepKind::depth);
        const bool hangs_on_digits = numbers_ == NumberStyle::doubles && step.stored &&
                                     round_alike(step.depth, *step.stored);
        put(R"({"step":"depth","x":)", step.pixel.x, R"(,"y":)", step.pixel.y, R"(,"depth":)",
            Exactly{step.depth, hangs_on_digits});
        if (step.stored)
            put(R"(,"stored":)", Exactly{*step.stored, hangs_on_digits}, R"(,"pass":)",
                word(step.passes));
        else
            put(R"(,"stored":null,"pass":)", word(step.passes));
        if (step.reason != DepthReason::stored)
            put(",\"", field_of(step.reason), "\":", std::string_view(json_quoted(step.other)));
        put("}");
    }

    void operator()(const EdgeSetUp<Quantity>& step) {
        if (!wants(StepKind::edge))
            return;
        begin_line(StepKind::edge);
        put(R"({"step":"edge","edge":)", label(step.edge), R"(,"dx_dy":)");
        if (step.is_horizontal)
            put("null}");
        else
            put(step.dx_dy, "}");
    }

    void operator()(const EdgeFunctionSetUp<Quantity>& step) {
        if (!wants(StepKind::edge))
            return;
        begin_line(StepKind::edge);
        put(R"({"step":"edge","edge":)", label(step.edge), R"(,"a":)", Exactly{step.a}, R"(,"b":)",
            Exactly{step.b}, R"(,"top_left":)", word(step.is_top_left), "}");
    }

    void operator()(const LineSampled<Quantity>& step) {
        if (!wants(StepKind::along) || !is_in_region(step))
            return;
        begin_line(StepKind::along);
        put(R"({"step":"along",")", std::string_view(step.is_x_major ? "x" : "y"), R"(":)", step.at,
            R"(,"value":)", Deciding{step.value}, R"(,"pixel":)", step.pixel, "}");
    }

    void operator()(const SampleTested<Quantity>& step) {
        if (!wants(StepKind::sample) || !is_in_region(step.pixel))
            return;
        begin_line(StepKind::sample);
        put(R"({"step":"sample","x":)", step.pixel.x, R"(,"y":)", step.pixel.y, R"(,"weights":[)",
            Deciding{step.weights[0]}, ",", Deciding{step.weights[1]}, ",",
            Deciding{step.weights[2]}, R"(],"inside":)", word(step.is_inside), "}");
    }

    void operator()(const ScanlineSpanned<Quantity>& step) {
        if (!wants(StepKind::scanline) || !is_in_region(step.y, step.from, step.to))
            return;
        begin_line(StepKind::scanline);
        put(R"({"step":"scanline","y":)", step.y, R"(,"left":)", Deciding{step.left},
            R"(,"right":)", Deciding{step.right}, R"(,"from":)", step.from, R"(,"to":)", step.to,
            R"(,"left_edge":)", label(step.left_edge), R"(,"right_edge":)", label(step.right_edge));
        if (step.left_depth && step.right_depth)
            put(R"(,"left_depth":)", *step.left_depth, R"(,"right_depth":)", *step.right_depth);
        put("}");
    }

    void operator()(const PixelPlotted& step) {
        if (!wants(StepKind::pixel) || !is_in_region(step.pixel))
            return;
        begin_line(StepKind::pixel);
        if (step.color == color_)
            put(R"({"step":"pixel","x":)", step.pixel.x, R"(,"y":)", step.pixel.y, "}");
        else
            put_colored_pixel(step);
    }

    void operator()(const FaceTriangulated<Quantity>& step);
    void operator()(const PrimitiveClipped& step);
    void operator()(const SideBegan& step);
    void operator()(const HalfBegan& step);
    void operator()(const RayBegan& step);
    void operator()(const LineDecided& step);
    void operator()(const PixelsRejected& step);
    void operator()(const RowsRejected& step);
    void operator()(const PrimitiveSkipped& step);
    void operator()(const BoundExceeded& step);

    /// Writes text as it is: for what stands before the first step and behind the last one.
    void put_text(std::string_view text) { put(text); }

    /// Starts a line for a step of this kind and counts it.
    void begin_line(StepKind kind) {
        ++counts_[static_cast<std::size_t>(kind)];
        put(separator_);
        separator_ = next_separator_;
    }

    /// Puts literals, strings and numbers one behind the other.
    template <typename... Pieces> void put(const Pieces&... pieces) {
        char* out = room((size_of(pieces) + ...));
        ((out = append(out, pieces)), ...);
        used_ = static_cast<std::size_t>(out - buffer_.data());
    }

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

    static std::string_view word(bool value) { return value ? "true" : "false"; }

    void write_labels();
    void put_names(std::string_view key, std::span<const std::string_view> names);
    void begin_primitive_line(PrimitiveKind kind, std::string_view name,
                              std::span<const std::string_view> vertices);
    void end_primitive_line(const PrimitiveBegan<Quantity>& step);
    static std::string_view field_of(DepthReason reason);
    void begin_vertex_line(std::string_view name, Space space);

    void put_numbers(std::string_view key, std::span<const Quantity> numbers) {
        std::string_view before = key;
        for (const Quantity& number : numbers) {
            put(before, number);
            before = ",";
        }
        put("]");
    }

    /// The rows of a matrix, without brackets around them all.
    void put_rows(std::string_view before, const Matrix<Quantity>& matrix) {
        for (const auto& row : matrix.rows) {
            put(before, "[", row[0], ",", row[1], ",", row[2], ",", row[3], "]");
            before = ",";
        }
    }

    /// True for two different fractions with one nearest double.
    static bool round_alike(const Quantity& a, const Quantity& b) {
        const Rational* const x = a.rational();
        const Rational* const y = b.rational();
        return x && y && to_double(a) == to_double(b) && *x != *y;
    }

    void put_colored_pixel(const PixelPlotted& step);

    /// The quoted name of an edge of the current primitive.
    std::string_view label(EdgeName edge) {
        if (!has_labels_)
            write_labels();
        return labels_[edge.from * most_vertices + edge.to];
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
    template <typename Number> static std::size_t size_of(const Number& number) {
        return room_for(number);
    }
    std::size_t size_of(const Quantity& number) const {
        constexpr std::size_t fits_all_but_rationals = room_for(Fraction128{});
        const Rational* const rational = number.rational();
        return rational ? size_of(*rational) : fits_all_but_rationals;
    }
    template <typename Number> std::size_t size_of(const Exactly<Number>& told) const {
        return size_of(told.number);
    }
    template <typename Number> std::size_t size_of(const Deciding<Number>& told) const {
        return size_of(told.number);
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
    template <typename Number> static char* append(char* out, const Number& number) {
        return format_number(out, number);
    }
    template <typename Integer> char* append(char* out, const Fraction<Integer>& number) const {
        return numbers_ == NumberStyle::doubles ? format_number(out, to_double(number))
                                                : format_number(out, number);
    }
    char* append(char* out, const Rational& number) const {
        return numbers_ == NumberStyle::doubles ? format_as_double(out, number)
                                                : format_number(out, number);
    }

    char* append(char* out, const Quantity& number) const {
        return number.visit([&](const auto& value) { return append(out, value); });
    }
    template <typename Number> char* append(char* out, const Exactly<Number>& told) const {
        return append(out, told.number);
    }
    char* append(char* out, const Exactly<Quantity>& told) const {
        return told.number.visit([&](const auto& value) {
            return append(out, Exactly{value, told.however_long});
        });
    }
    template <typename Integer>
    char* append(char* out, const Exactly<Fraction<Integer>>& told) const {
        return numbers_ == NumberStyle::doubles ? format_exactly(out, exact(told.number))
                                                : format_number(out, told.number);
    }
    char* append(char* out, const Exactly<Rational>& told) const {
        return numbers_ == NumberStyle::doubles
                   ? format_exactly(out, told.number, told.however_long)
                   : format_number(out, told.number);
    }

    char* append(char* out, const Deciding<Quantity>& told) const {
        return told.number.visit([&](const auto& value) { return append(out, Deciding{value}); });
    }
    template <typename Number> char* append(char* out, const Deciding<Number>& told) const {
        return append(out, told.number);
    }
    template <typename Integer>
    char* append(char* out, const Deciding<Fraction<Integer>>& told) const {
        return numbers_ == NumberStyle::doubles ? format_deciding(out, told.number)
                                                : format_number(out, told.number);
    }
    char* append(char* out, const Deciding<Rational>& told) const {
        return numbers_ == NumberStyle::doubles ? format_deciding(out, told.number)
                                                : format_number(out, told.number);
    }

    /// How far what is written by Exactly lies from the number at most.
    double rounded_off(const Quantity& number) const {
        const Rational* const rational = number.rational();
        return rational ? rounded_off(*rational) : 0;
    }
    double rounded_off(const Rational& number) const {
        if (numbers_ == NumberStyle::exact || is_short(number))
            return 0;
        const double near = nearest_double(number);
        return std::isfinite(near) && Rational(near) != number
                   ? std::max(std::abs(near) * std::numeric_limits<double>::epsilon(),
                              std::numeric_limits<double>::denorm_min())
                   : 0;
    }

    static constexpr std::size_t most_vertices = 3;

    Output& output_;
    std::vector<char> buffer_;
    std::size_t used_ = 0;
    std::string_view separator_ = "\n"; ///< before the next line
    std::string_view next_separator_;
    NumberStyle numbers_;
    std::array<bool, step_kinds> wanted_{};
    std::optional<Region> region_;
    std::optional<std::string> primitive_;
    bool is_in_primitive_;
    std::array<std::uint64_t, step_kinds> counts_{};
    Color color_;      ///< of the current primitive
    std::string name_; ///< of the same
    std::size_t vertex_count_ = 0;
    bool is_circle_ = false; ///< then each decision is about pixels in all eight octants
    std::array<std::string_view, most_vertices> vertices_;          ///< its vertices' names
    std::array<std::string, most_vertices * most_vertices> labels_; ///< its edges' quoted names,
    bool has_labels_ = false;                                       ///< once one was asked for
};

} // namespace rastertrace
