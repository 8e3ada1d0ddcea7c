// SPDX-License-Identifier: MIT
#include "digest.h"

#include "describe.h"
#include "step_text.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <string_view>

namespace rastertrace {

namespace {

using Cells = std::vector<std::string>;
using TextLines = std::vector<std::string>;

/// Rows of cells below one another. A column without any text has no width.
TextLines aligned(const std::vector<Cells>& rows) {
    std::vector<std::size_t> widths;
    for (const Cells& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i)
            widths[i] = std::max(widths[i], columns_in(row[i]));
    }
    TextLines lines;
    for (const Cells& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i)
            if (widths[i] > 0)
                line += row[i] + std::string(widths[i] - columns_in(row[i]) + 3, ' ');
        line.resize(line.find_last_not_of(' ') + 1);
        lines.push_back(std::move(line));
    }
    return lines;
}

/// A fraction as a formula has it, a decimal to six places.
std::string brief(const std::string& number) {
    constexpr double least = 1e-6, most = 1e9; // others are written with an exponent
    const auto value = number.find('.') == std::string::npos
                           ? std::nullopt
                           : TracedNumber(number).nearest_double();
    const bool has_places = value && least <= std::abs(*value) && std::abs(*value) < most;
    return has_places ? six_places(*value) : in_formula(number);
}

std::string pixels(Index count) {
    return count == 1 ? said("1 pixel") : said("{} pixels", count);
}

/// What became of a face.
struct Face {
    std::string name;
    std::string normal = {};               ///< "normal (0, 0, -4)"
    std::string verdict = {};              ///< ". to eye = 12: drawn", or how light it is
    TracedNumber least = {}, largest = {}; ///< of its depths
    std::size_t tests = 0, passed = 0;
    Index drawn = 0; ///< pixels

    void add(const DepthStep& test) {
        ++tests;
        passed += test.pass.is_true() ? 1 : 0;
        const auto depth = test.depth.nearest_double();
        if (depth &&
            depth < least.nearest_double().value_or(std::numeric_limits<double>::infinity()))
            least = test.depth;
        if (depth &&
            depth > largest.nearest_double().value_or(-std::numeric_limits<double>::infinity()))
            largest = test.depth;
    }

    Cells cells() const {
        const std::string from = brief(least.text()), to = brief(largest.text());
        const std::string depths = !least       ? ""
                                   : from == to ? said("depth {}", from)
                                                : said("depth {} to {}", from, to);
        const std::string result =
            tests == 0 ? pixels(drawn) : said("{} of {} depth tests pass", passed, tests);
        return {printable(name), normal, verdict, depths, tests > 0 || drawn > 0 ? result : ""};
    }
};

/// How a line decides, by the d that its steps tell: where it begins, and what is added after a step straight on and
/// after a diagonal one.
struct Decisions {
    std::optional<Rational> begin = {}, straight = {}, diagonal = {}, last = {};
    bool was_diagonal = false;

    void add(const DecideStep& step) {
        const auto d = step.d.exact();
        if (!begin)
            begin = d;
        if (auto& added = was_diagonal ? diagonal : straight; d && last && !added)
            added = Rational(*d - *last);
        last = d;
        was_diagonal = step.move.text().size() > 1; // NE, not E
    }

    std::string text() const {
        if (!begin)
            return {};
        std::string line = "d = " + rastertrace::text(*begin);
        if (straight && diagonal)
            line += said(", then {} or {}", plus(rastertrace::text(*straight)),
                         plus(rastertrace::text(*diagonal)));
        else if (straight || diagonal)
            line += said(", then {}", plus(rastertrace::text(straight ? *straight : *diagonal)));
        return line;
    }
};

/// Reads a trace once, and tells what it is about.
class Digest {
public:
    Digest(const Trace& trace, std::size_t most)
        : trace_(trace), most_(most), replay_(trace, {.writes = false, .depths = false}) {
        for (std::size_t n = 1; n <= trace.size(); ++n)
            if (const auto kind = trace.kind_of(n))
                read(n, *kind);
    }

    TextLines lines() {
        if (is_in_space_ && faces_.size() > 1)
            return of_faces();
        if (is_in_space_ && faces_.empty())
            return of_first_vertex();
        if (!rows_.empty())
            return of_rows();
        return of_primitives();
    }

private:
    // --- what is read

    void read(std::size_t n, StepKind kind) {
        const StepView step = trace_.step(n);
        switch (kind) {
        case StepKind::vertex:
            vertices_.push_back(n);
            is_in_space_ = is_in_space_ || !(step.as<VertexStep>().space == Space::screen);
            break;
        case StepKind::primitive: {
            const auto primitive = step.as<PrimitiveStep>();
            primitives_.push_back(n);
            face_ = is_filled(primitive.kind) ? &face_named(name_of_whole(primitive)) : nullptr;
            break;
        }
        case StepKind::face:
            read(step.as<FaceStep>());
            break;
        case StepKind::light:
            read(step.as<LightStep>());
            break;
        case StepKind::scanline:
            rows_.push_back({primitives_.empty() ? 0 : primitives_.back(), n});
            break;
        case StepKind::decide:
            if (!primitives_.empty() && primitives_.size() <= most_)
                decisions_[primitives_.back()].add(step.as<DecideStep>());
            break;
        case StepKind::depth:
            if (face_ != nullptr)
                face_->add(step.as<DepthStep>());
            break;
        case StepKind::pixel:
            if (face_ != nullptr)
                ++face_->drawn;
            break;
        default:
            break;
        }
    }

    void read(const FaceStep& test) {
        Face& face = face_named(test.name.text());
        face.normal = said("normal {}", in_point(test.normal));
        face.verdict =
            said(". {} = {}: {}", test.by == "light" ? said("to light") : said("to eye"),
                 brief(test.dot.text()), test.culled.is_true() ? said("culled") : said("drawn"));
    }

    void read(const LightStep& light) {
        Face& face = face_named(light.name.text());
        face.normal = said("normal {}", in_point(light.normal));
        face.verdict = said("intensity {}", brief(light.intensity.text()));
    }

    Face& face_named(const std::string& name) {
        const auto [place, is_new] = place_of_face_.emplace(name, faces_.size());
        if (is_new)
            faces_.push_back({.name = name});
        return faces_[place->second];
    }

    static std::string in_point(const TracedList<TracedNumber>& list) {
        std::vector<std::string> numbers = list.texts();
        for (std::string& number : numbers)
            number = brief(number);
        return point(std::move(numbers));
    }

    // --- what is told

    /// So many of the lines that it may have, and how many of the things that they tell are left out.
    TextLines limited(TextLines lines, std::size_t things, std::string_view kind) const {
        if (things > most_) {
            lines.resize(most_ - 1);
            lines.push_back(said("... and {} more: --every {}", things - lines.size(), kind));
        }
        return lines;
    }

    std::string sentence_of(std::size_t n) {
        replay_.go_to(n);
        return describe_step(replay_);
    }

    TextLines of_faces() const {
        std::vector<Cells> rows;
        for (std::size_t i = 0; i < std::min(faces_.size(), most_); ++i)
            rows.push_back(faces_[i].cells());
        return limited(aligned(rows), faces_.size(), "primitive");
    }

    /// In each of its spaces.
    TextLines of_first_vertex() {
        const auto name_of = [this](std::size_t n) { return name_in(trace_.step(n)).text(); };
        TextLines lines;
        for (const std::size_t n : vertices_)
            if (lines.size() < most_ - 1 && name_of(n) == name_of(vertices_.front()))
                lines.push_back(sentence_of(n));
        if (const std::size_t more = vertices_.size() - lines.size(); more > 0)
            lines.push_back(said("... and {} more: --every vertex", more));
        return lines;
    }

    /// Below the corners of their triangle.
    TextLines of_rows() {
        TextLines lines;
        std::vector<Cells> rows;
        std::size_t told = 0;
        const auto add_rows = [&] {
            for (const std::string& line : aligned(rows))
                lines.push_back("  " + line);
            told += rows.size();
            rows.clear();
        };
        std::size_t primitive = 0;
        for (const Row& row : rows_) {
            const bool is_other = row.primitive != primitive;
            const std::size_t taken = lines.size() + rows.size() + (is_other ? 1 : 0);
            if (taken + (&row == &rows_.back() ? 1 : 2) > most_)
                break;
            if (is_other) {
                add_rows();
                lines.push_back(sentence_of(row.primitive));
                primitive = row.primitive;
            }
            const auto step = trace_.step(row.step).as<ScanlineStep>();
            Cells cells{fmt::format("y={}", step.y)};
            for (const EndOfRow& end : ends_of(step))
                cells.push_back(fmt::format("{} x = {} -> {}", printable(end.edge.text()),
                                            brief(end.x.text()), end.pixel));
            cells.push_back(pixels(std::max<Index>(step.to - step.from + 1, 0)));
            rows.push_back(std::move(cells));
        }
        add_rows();
        if (told < rows_.size())
            lines.push_back(said("... and {} more: --every scanline", rows_.size() - told));
        return lines;
    }

    TextLines of_primitives() {
        std::vector<Cells> rows;
        for (std::size_t i = 0; i < std::min(primitives_.size(), most_); ++i)
            rows.push_back({sentence_of(primitives_[i]), slope_of_line()});
        return limited(aligned(rows), primitives_.size(), "primitive");
    }

    /// The slope of the line that the replay has reached, and how Bresenham decides; "" of any other primitive.
    std::string slope_of_line() const {
        const PrimitiveText primitive = primitive_of(replay_);
        const auto ends =
            primitive.kind == PrimitiveKind::line ? ends_of_line(replay_, primitive) : std::nullopt;
        if (!ends)
            return {};
        const bool is_x_major = abs(ends->to.x - ends->from.x) >= abs(ends->to.y - ends->from.y);
        const auto form = slope_form_of(*ends, is_x_major);
        if (!form)
            return {};
        const std::string slope = (is_x_major ? "m = " : "1/m = ") + text(form->m);
        const auto decisions = decisions_.find(replay_.step());
        return decisions == decisions_.end() ? slope : slope + "   " + decisions->second.text();
    }

    /// A scanline, and the primitive that it is of.
    struct Row {
        std::size_t primitive;
        std::size_t step;
    };

    const Trace& trace_;
    std::size_t most_;
    Replay replay_;
    std::vector<std::size_t> vertices_, primitives_; ///< their steps
    std::vector<Row> rows_;
    std::map<std::size_t, Decisions> decisions_; ///< of lines, by their steps
    std::deque<Face> faces_;                     ///< deque: face_ stays where it is
    std::map<std::string, std::size_t> place_of_face_;
    Face* face_ = nullptr; ///< the one that is drawn
    bool is_in_space_ = false;
};

} // namespace

std::vector<std::string> digest_of(const Trace& trace, std::size_t most_lines) {
    return Digest(trace, most_lines).lines();
}

} // namespace rastertrace
