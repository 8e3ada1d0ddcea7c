// SPDX-License-Identifier: MIT
#include "claims_template.h"

#include "claim_line.h"
#include "claims.h"
#include "claims_table.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// More lines than anyone fills in.
constexpr std::size_t most_lines = 500;

/// The largest picture that is drawn by hand, in pixels along a side.
constexpr int largest_picture = 40;

/// `?, ?, ?`
std::string open_values(std::size_t count, std::string_view separator) {
    return joined(std::vector<std::string>(count, std::string(open_value)), separator);
}

template <typename Value> std::string open_list(const TracedList<Value>& list) {
    return open_values(list.values().size(), ", ");
}

/// Writes the lines of a trace step by step.
class TemplateWriter {
public:
    explicit TemplateWriter(const Trace& trace) : trace_(trace) {
        for (std::size_t n = 1; n <= trace.size(); ++n) {
            const auto kind = trace.kind_of(n);
            primitives_ += kind == StepKind::primitive ? 1 : 0;
            if (kind != StepKind::depth)
                continue;
            const auto test = trace.step(n).as<DepthStep>();
            ++tests_[{test.x, test.y}];
        }
    }

    std::string write() {
        for (std::size_t n = 1; n <= trace_.size(); ++n)
            if (const auto kind = trace_.kind_of(n))
                add(*kind, trace_.step(n));
        end_line_of_d();
        if (left_out_ > 0)
            text_ += fmt::format("# and {} more lines\n", left_out_);
        add_picture();
        return std::move(text_);
    }

private:
    void add(StepKind kind, const StepView& step) {
        if (kind != StepKind::decide && kind != StepKind::pixel && kind != StepKind::depth)
            end_line_of_d();
        switch (kind) {
        case StepKind::vertex:
            return add_vertex(step.as<VertexStep>());
        case StepKind::order:
            return add_line(kind, "order: " + open_list(step.as<OrderStep>().names));
        case StepKind::primitive: {
            const auto primitive = step.as<PrimitiveStep>();
            primitive_ = primitive.name.text();
            has_d_ =
                primitive.kind == PrimitiveKind::line || primitive.kind == PrimitiveKind::circle;
            is_polygon_ = primitive.kind == PrimitiveKind::polygon;
            has_spans_ = false;
            return;
        }
        case StepKind::face:
            return add_face(name_in_table(name_in(step).text()));
        case StepKind::light:
            return add_line(kind,
                            fmt::format("intensity {}: ?", name_in_table(name_in(step).text())));
        case StepKind::edge: {
            const auto edge = step.as<EdgeStep>();
            if (edge.dx_dy.has_number())
                add_line(kind, fmt::format("{}edge {}: {}", of_primitive(),
                                           name_in_table(edge.edge.text()),
                                           is_polygon_ ? "ymin ?, ymax ?, x ?, 1/m ?" : "?"));
            return;
        }
        case StepKind::crossings:
            return add_crossings(step.as<CrossingsStep>());
        case StepKind::scanline:
            return add_row(step.as<ScanlineStep>());
        case StepKind::decide:
            decisions_ += has_d_ ? 1 : 0;
            return;
        case StepKind::depth:
            return add_depth(step.as<DepthStep>());
        default:
            return;
        }
    }

    /// What the scene's author typed needs no working out.
    void add_vertex(const VertexStep& vertex) {
        if (vertex.space != Space::object)
            add_line(StepKind::vertex,
                     fmt::format("{} {}: {}{}", name_in_table(vertex.name.text()),
                                 vertex.space.text(), open_list(vertex.at),
                                 vertex.snapped ? " -> " + open_list(vertex.snapped) : ""));
    }

    void add_face(const std::string& name) {
        for (const std::string_view what : {"normal", "centroid", "view"})
            add_line(StepKind::face, fmt::format("{} {}: ?, ?, ?", what, name));
        add_line(StepKind::face, fmt::format("dot {}: ? ?", name));
    }

    /// The ends of all spans of a row, if there is more than one.
    void add_crossings(const CrossingsStep& row) {
        const std::size_t count = row.x.values().size();
        has_spans_ = count > 2;
        if (has_spans_)
            add_line(StepKind::crossings,
                     fmt::format("{}y={}: {}", of_primitive(), row.y, open_values(count, ", ")));
    }

    void add_row(const ScanlineStep& row) {
        if (has_spans_)
            return;
        const std::string name = fmt::format("{}y={}", of_primitive(), row.y);
        add_line(StepKind::scanline, name + ": ?, ? -> ?..?");
        if (row.left_depth)
            add_line(StepKind::scanline, name + " depth: ?, ?");
    }

    void add_depth(const DepthStep& test) {
        if (tests_[{test.x, test.y}] > 1)
            add_line(
                StepKind::scanline, // it stands below its row
                fmt::format("depth {} ({},{}): ? ?", name_in_table(primitive_), test.x, test.y));
    }

    /// Bresenham's d, all of a line at once.
    void end_line_of_d() {
        if (decisions_ > 0)
            add_line(StepKind::decide, fmt::format("{}: {}", name_in_table(primitive_),
                                                   open_values(decisions_, " ")));
        decisions_ = 0;
    }

    void add_picture() {
        const Canvas& canvas = trace_.canvas;
        if (canvas.width > largest_picture || canvas.height > largest_picture)
            return;
        text_ += text_.empty() ? "picture:\n" : "\npicture:\n";
        for (int row = 0; row < canvas.height; ++row)
            text_ += std::string(static_cast<std::size_t>(canvas.width), '?') + "\n";
    }

    /// `ABC `, where there is more than one primitive.
    std::string of_primitive() const {
        return primitives_ > 1 ? name_in_table(primitive_) + " " : "";
    }

    /// Adds a line once, with a blank line before it if it begins another group.
    void add_line(StepKind group, const std::string& line) {
        if (!lines_.insert(line).second)
            return;
        if (lines_.size() > most_lines) {
            ++left_out_;
            return;
        }
        if (!text_.empty() && group != last_group_)
            text_ += '\n';
        last_group_ = group;
        text_ += line + "\n";
    }

    const Trace& trace_;
    std::size_t primitives_ = 0;
    std::map<std::pair<Index, Index>, std::size_t> tests_; ///< depth tests of each pixel
    std::string primitive_;                                ///< the name of the current one
    bool has_d_ = false;                                   ///< it is a line or a circle
    bool is_polygon_ = false;
    bool has_spans_ = false;    ///< the row has more than one, which are claimed by its ends
    std::size_t decisions_ = 0; ///< of the current line
    std::string text_;
    std::set<std::string> lines_;
    std::size_t left_out_ = 0;
    StepKind last_group_ = StepKind::triangulate;
};

/// A cell of a table: in quotes where a comma or a quote is in it, as in JSON what nobody sees.
std::string cell(const std::string& text) {
    if (printable(text) != text)
        return json_quoted(text);
    if (text.find_first_of(",\"") == std::string::npos)
        return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

/// Tables with empty cells: one of each kind for each primitive, in the order in which the trace comes to them.
class TableWriter {
public:
    explicit TableWriter(const Trace& trace) : trace_(trace) {}

    std::string write() {
        std::string primitive;
        for (std::size_t n = 1; n <= trace_.size(); ++n) {
            const StepView step = trace_.step(n);
            if (const auto kind = step.kind()) {
                if (*kind == StepKind::primitive)
                    primitive = name_in(step).text();
                add(*kind, step, primitive);
            }
        }
        std::string text;
        for (const Table& table : tables_) {
            text += text.empty() ? "" : "\n";
            text += (table.title.empty() ? "" : table.title + "\n") + table.head + "\n";
            for (const std::string& row : table.rows)
                text += row + "\n";
        }
        return text;
    }

private:
    struct Table {
        std::string title;
        std::string head;
        std::vector<std::string> rows;
    };

    void add(StepKind kind, const StepView& step, const std::string& primitive) {
        switch (kind) {
        case StepKind::vertex: {
            const auto vertex = step.as<VertexStep>();
            const std::size_t count = vertex.at.values().size();
            if (vertex.space != Space::object)
                add_row(std::string(vertex.space.text()),
                        std::string("vertex,x,y,z,w")
                            .substr(0, std::string("vertex").size() + 2 * count),
                        vertex.name.text(), count);
            return;
        }
        case StepKind::face:
            return add_row("", "face,normal,view,dot,culled", name_in(step).text(), 4);
        case StepKind::edge:
            return add_row(primitive, "edge,dx/dy", step.as<EdgeStep>().edge.text(), 1);
        case StepKind::scanline: {
            const auto row = step.as<ScanlineStep>();
            const bool has_depth = row.left_depth.has_number();
            return add_row(primitive,
                           has_depth ? "y,left,right,from,to,left depth,right depth"
                                     : "y,left,right,from,to",
                           std::to_string(row.y), has_depth ? 6 : 4);
        }
        case StepKind::decide:
            return add_row(primitive, "k,d", "", 1);
        default:
            return;
        }
    }

    void add_row(const std::string& title, const std::string& head, const std::string& key,
                 std::size_t empty_cells) {
        const auto place = std::find_if(tables_.begin(), tables_.end(), [&](const Table& table) {
            return table.title == cell(title) && table.head == head;
        });
        Table& table =
            place == tables_.end() ? tables_.emplace_back(Table{cell(title), head, {}}) : *place;
        // Bresenham's steps are counted from 0.
        const std::string first = key.empty() ? std::to_string(table.rows.size()) : cell(key);
        const std::string row = first + std::string(empty_cells, ',');
        if (table.rows.size() < most_lines &&
            std::find(table.rows.begin(), table.rows.end(), row) == table.rows.end())
            table.rows.push_back(row);
    }

    const Trace& trace_;
    std::vector<Table> tables_;
};

} // namespace

std::string claims_template_in_columns(const Trace& trace) {
    return TableWriter(trace).write();
}

std::string claims_template(const Trace& trace) {
    return TemplateWriter(trace).write();
}

std::string scene_line(std::string_view path) {
    // A name in quotes is read as in JSON; without quotes it goes from its first word to a comment.
    const bool is_plain = path.find('#') == std::string_view::npos &&
                          without_blanks(path).size() == path.size() &&
                          json_quoted(path).size() == path.size() + 2; // nothing escaped
    return fmt::format("# a relative name is looked for from the folder of this file\nscene: {}\n",
                       is_plain ? std::string(path) : json_quoted(path));
}

} // namespace rastertrace
