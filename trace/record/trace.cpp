// SPDX-License-Identifier: MIT
#include "trace.h"

#include "field_type.h"
#include "frame.h"
#include "header_check.h"
#include "scanned_lines.h"
#include "step_counts.h"
#include "step_decoder.h"
#include "step_places.h"
#include "trace_index.h"
#include "trace_keys.h"
#include "trace_lines.h"
#include "traced_steps.h"
#include "write_trace.h"

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/trace/text/byte_order_mark.h>
#include <rastertrace/trace/text/canvas_json.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/conventions.h>
#include <rastertrace/trace/text/format_number.h>
#include <rastertrace/trace/text/in_threads.h>
#include <rastertrace/trace/text/input.h>
#include <rastertrace/trace/text/json_document.h>
#include <rastertrace/trace/text/json_scanner.h>
#include <rastertrace/trace/text/process_files.h>
#include <rastertrace/trace/text/text.h>
#include <rastertrace/trace/text/trace_layout.h>
#include <rastertrace/trace/text/zero_byte.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <functional>
#include <limits>
#include <span>
#include <utility>
#include <variant>

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

std::optional<StepKind> Trace::kind_of(std::size_t n) const {
    assert(n > 0 && n <= size());
    return steps_->kind(n, text());
}

std::size_t Trace::next_of(StepKindSet kinds, std::size_t n, std::size_t last) const {
    return steps_->next_of(kinds, n, last, text());
}

StepReader::StepReader(const Trace& trace)
    : trace_(trace), finder_(std::make_unique<StepFinder>(*trace.steps_)) {}
StepReader::~StepReader() = default;
StepReader::StepReader(StepReader&&) noexcept = default;

StepView StepReader::step(std::size_t n) const {
    return step_at(finder_->at(n, trace_.text()), trace_.text());
}

std::optional<StepKind> StepReader::kind_of(std::size_t n) const {
    return finder_->kind(n, trace_.text());
}

bool StepReader::is_plain(std::size_t n) const {
    return finder_->is_plain(n, trace_.text());
}

std::optional<ReplayState> Trace::state_ahead(std::size_t of, std::size_t n) const {
    if (index_)
        return index_->keyframe(n, of, canvas);
    const auto last = n == size() && n > of ? std::move(end_state_) : nullptr;
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

std::string truncation_after(std::size_t steps) {
    return fmt::format("expected the rest of the trace, found the end of the file: the trace is "
                       "truncated after {} whole steps",
                       steps);
}

std::string disagreement(std::string_view told, std::string_view what, std::string_view found) {
    return fmt::format("expected {} {} as the end record says, found {}", told, what, found);
}

namespace {

/// Throws a Problem if a step lacks a field that it cannot be understood without, or has a wrong one.
void check_fields(StepKind kind, const Source& source, std::size_t begin, std::string_view json) {
    const StepView step(json);
    for (const StepField& field : fields_of(kind)) {
        if (!field.is_required())
            continue;
        const auto value = step.field(field.name);
        if (!value)
            throw problem_at(source, begin,
                             fmt::format("expected a {} step with the key \"{}\", found none",
                                         name_of(kind), field.name));
        if (!has_type(*value, field.type))
            throw problem_at(source, begin + static_cast<std::size_t>(value->data() - json.data()),
                             fmt::format("expected {}, found {}", expected_for(field.type),
                                         shortened(*value, 40)));
    }
}

/// Throws a Problem if a step has something else where a color belongs.
void check_colors(StepKind kind, const Source& source, std::size_t begin, std::string_view json) {
    const StepView step(json);
    for (const StepField& field : fields_of(kind)) {
        const auto value = field.is_color ? step.field(field.name) : std::nullopt;
        if (value && !has_type_of(*value, field))
            throw problem_at(
                source, begin + static_cast<std::size_t>(value->data() - json.data()),
                fmt::format("expected {}, found {}", expected_for(field), shortened(*value, 40)),
                "or #rgb, #rrggbbaa, or a name of CSS 2.1");
    }
}

} // namespace

std::optional<StepKind> checked_kind(const Source& source, std::size_t begin, std::size_t size) {
    // Valid JSON, each key once. Where the quick look finds fault, the thorough one says which.
    const std::string_view json = source.view().substr(begin, size);
    constexpr std::size_t most_keys = 16;
    std::array<std::string_view, most_keys> keys;
    std::size_t key_count = 0;
    std::string_view kind_json;
    bool is_plain = true;
    bool has_color = false;
    JsonScanner fields(json);
    while (fields.next_field()) {
        if (fields.key() == "step")
            kind_json = fields.value();
        has_color = has_color || holds_color(fields.key());
        const auto seen = keys.begin() + static_cast<std::ptrdiff_t>(key_count);
        if (key_count == most_keys || std::find(keys.begin(), seen, fields.key()) != seen)
            is_plain = false;
        else
            keys[key_count++] = fields.key();
    }
    if (fields.failed() || fields.needs_full_check() || !is_plain) {
        const auto parsed = parse_json(source, begin, size);
        if (!parsed)
            throw parsed.problem();
        if (const JsonValue step = parsed.value().root(); step.kind != JsonValue::Kind::object)
            throw problem_at(source, begin,
                             fmt::format("expected a step, found {}", described(step)));
    }
    if (!kind_json.starts_with('"'))
        throw problem_at(source, begin,
                         R"(expected a step with the key "step" and its kind, found none)");
    const auto kind = step_kind_named(plain_text(kind_json));
    if (kind)
        check_fields(*kind, source, begin, json);
    if (kind && has_color)
        check_colors(*kind, source, begin, json);
    return kind;
}

void note_not_finite(NotFiniteSteps& noted, const Source& source, std::size_t begin,
                     std::string_view json, StepKind kind) {
    constexpr std::string_view nan = "NaN\"";
    constexpr std::string_view infinity = "inf\"";
    if (json.find(nan) == std::string_view::npos && json.find(infinity) == std::string_view::npos)
        return; // nearly always
    const StepView step(json);
    for (const StepField& field : fields_of(kind)) {
        const auto value =
            field.element == FieldType::quantity ? step.field(field.name) : std::nullopt;
        const auto found = value ? not_finite_in(*value) : std::nullopt;
        if (!found)
            continue;
        if (noted.count++ == 0)
            noted.first =
                problem_at(source, begin + static_cast<std::size_t>(found->data() - json.data()),
                           fmt::format("remark: expected a finite number for {}, found {}",
                                       field.name, *found));
        return;
    }
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

bool tells_picture(const EndRecord& end) {
    return end.pixels || !end.frame.empty();
}

std::optional<std::string> disagreement_of_picture(const Trace& header, const EndRecord& end,
                                                   const Image& image) {
    // The end record is about the whole picture, also where steps were left out: those that plot its pixels, or
    // those that color them.
    const bool has_every_pixel =
        !header.left_out.has_places_missing && !header.lacks(StepKind::pixel);
    const bool has_every_color = has_every_pixel && !header.lacks(StepKind::primitive);
    const std::uint64_t pixels = image.drawn();
    const std::string found = fmt::format("{}", pixels);
    if (end.pixels && has_every_pixel && *end.pixels != pixels)
        return disagreement(fmt::format("{}", *end.pixels), "pixels", found);
    if (end.pixels && *end.pixels < pixels)
        return disagreement(fmt::format("at most {}", *end.pixels), "pixels", found);
    if (!end.frame.empty() && has_every_color && end.frame != frame_name(image))
        return disagreement("the picture", end.frame, frame_name(image));
    return std::nullopt;
}

/// Reads one trace. What makes the rest useless is thrown as a Problem; what does not is damage.
class TraceReader {
public:
    /// How closely a trace is looked at.
    enum class Care {
        none,    ///< this program has written it
        to_use,  ///< a step that cannot be used ends the reading
        to_tell, ///< such a step is damage, and the rest is read
    };

    /// Of a block, what it adds is added to `sums`.
    TraceReader(Source source, Care care, const TraceReading& reading, BlockSums* sums)
        : care_(care), reading_(reading), is_block_(sums != nullptr),
          sums_(sums != nullptr ? *sums : own_sums_) {
        trace_.source_ = std::move(source);
        if (trace_.source_.mapped)
            trace_.text_of_file_ = trace_.source_.view();
        trace_.steps_->set_file(trace_.source_.mapped);
    }

    /// Reads what may be a trace, or a part of one.
    static Result<Trace> read_with(Source& source, Care care, const TraceReading& reading = {},
                                   BlockSums* sums = nullptr);

    Trace read() {
        const std::string_view first_line = line_at(0);
        refuse_zero_bytes(0, first_line.size());
        switch (layout_of(first_line)) {
        case LineLayout::document:
            read_line_by_line(first_line, "]}", ']');
            break;
        case LineLayout::lines:
            read_line_by_line(first_line, "", '\0');
            break;
        case LineLayout::other:
            read_document();
            break;
        }
        if (care_ != Care::none)
            compare_with_end();
        for (WrongForm& wrong : wrong_forms_)
            trace_.passed_over.push_back(
                problem_at(source(), wrong.offset, std::move(wrong.message)));
        if (own_sums_.state)
            trace_.end_state_ = std::make_unique<ReplayState>(*std::move(own_sums_.state));
        return std::move(trace_);
    }

    const Source& source() const { return trace_.source_; }

private:
    /// Bytes that are read at once, in parts of one size.
    static constexpr std::size_t part_size = 1 << 20;
    static constexpr std::size_t most_at_once = 8 * part_size;

    std::string_view text() const { return trace_.text(); }

    [[noreturn]] void fail(std::size_t offset, std::string message, std::string hint = {}) const {
        throw problem_at(source(), offset, std::move(message), std::move(hint));
    }

    /// The line that begins at `offset`, without what ends it.
    std::string_view line_at(std::size_t offset) const {
        std::string_view line = text().substr(offset);
        line = line.substr(0, line.find('\n'));
        line.remove_suffix(line.size() - (line.find_last_not_of(" \t\r") + 1));
        return line;
    }

    /// Any layout of a complete JSON document.
    void read_document() {
        refuse_zero_bytes(0);
        const auto document = parse_json(source());
        if (!document)
            throw document.problem();
        const JsonValue root = document.value().root();
        read_header(root);
        const auto steps = root.find("steps");
        if (!steps || steps->kind != JsonValue::Kind::array)
            fail(root.begin, R"(expected the key "steps" with an array, found none)");
        for (const JsonValue& step : steps->elements())
            add_step(step.begin, step.end() - step.begin);
        if (const auto end = root.find("end"))
            read_end(*end);
    }

    /// Our own layouts. The header becomes an object with `closing`; a line that begins with
    /// `end_mark` ends the steps of a document.
    void read_line_by_line(std::string_view header, std::string_view closing, char end_mark) {
        const Source alone{source().name, std::string(header) + std::string(closing)};
        const auto parsed = parse_json(alone);
        if (!parsed)
            throw parsed.problem();
        read_header(parsed.value().root());

        const std::size_t last_byte = text().find_last_not_of(" \t\r\n");
        std::size_t offset = text().find('\n');
        if (reading_.index)
            offset = take_indexed_steps() - 1;
        bool is_free_of_zeros = false;
        while (offset < text().size()) {
            offset = take_plain_lines(offset + 1, end_mark != '\0');
            if (!std::exchange(is_free_of_zeros, true))
                refuse_zero_bytes(offset);
            std::string_view line = line_at(offset);
            const std::size_t begin = offset + std::min(line.find_first_not_of(" \t"), line.size());
            const std::size_t next = text().find('\n', offset);
            line = line.substr(begin - offset);
            const bool is_last = next == std::string_view::npos || next > last_byte;
            if (line.empty()) {
                offset = next;
                continue;
            }
            if (end_mark != '\0' && line.front() == end_mark) {
                read_end_of_document(begin);
                return;
            }
            if (end_mark == '\0' && is_end_line(line)) {
                read_end_line(begin, line, is_last);
                return;
            }
            if (end_mark != '\0' && line.ends_with(','))
                line.remove_suffix(1);
            if (is_last && !is_valid_json(begin, line.size()))
                return cut_short(begin);
            add_step(begin, line.size());
            offset = next;
        }
        cut_short(text().size());
    }

    void read_end_line(std::size_t begin, std::string_view line, bool is_last) {
        if (!is_valid_json(begin, line.size()) && is_last)
            return cut_short(begin);
        const auto record = parse_json(source(), begin, line.size());
        if (!record)
            throw record.problem();
        if (!is_last)
            fail(text().find_first_not_of(" \t\r\n", begin + line.size()),
                 "expected nothing behind the end record, found more");
        read_end(*record.value().root().find("end"));
    }

    /// From the bracket that closes the steps: `],"end":{...}}`. Read as the object {"end":{...}}.
    void read_end_of_document(std::size_t bracket) {
        const std::size_t comma = text().find_first_not_of(" \t\r\n", bracket + 1);
        if (comma == std::string_view::npos)
            return cut_short(text().size());
        if (text()[comma] == '}') {
            // A document without an end record; compare_with_end says so.
            const std::size_t more = text().find_first_not_of(" \t\r\n", comma + 1);
            if (more != std::string_view::npos)
                fail(more, "expected the end of the file, found more");
            return;
        }
        if (text()[comma] != ',')
            fail(comma, "expected ',' or '}' behind the steps, found something else");

        // The lines in front of it are left out, and the comma is the object's bracket.
        const std::size_t line = text().rfind('\n', comma) + 1;
        Source end{source().name, std::string(text().substr(line)), {}};
        end.text[comma - line] = '{';
        if (const auto problem = read_end_in_object(end, comma - line)) {
            if (ends_at_end_of_file(comma))
                return cut_short(comma + 1);
            throw *problem;
        }
    }

    /// Reads the end record of the object that begins at `begin` and ends the file.
    std::optional<Problem> read_end_in_object(const Source& end, std::size_t begin) {
        const std::size_t before = text().size() - end.text.size();
        const auto object = parse_json(end, begin);
        if (!object)
            return problem_at(source(), before + offset_of(object.problem(), end.text),
                              object.problem().message, object.problem().hint);
        try {
            if (const auto record = object.value().root().find("end"))
                read_end(*record, before);
        } catch (const Problem& problem) {
            return problem;
        }
        return std::nullopt;
    }

    /// The place in a text that a problem points at.
    static std::size_t offset_of(const Problem& problem, std::string_view text) {
        std::size_t offset = 0;
        for (std::size_t line = 1; line < problem.line; ++line)
            offset = text.find('\n', offset) + 1;
        return offset + first_characters(text.substr(offset), problem.column - 1).size();
    }

    /// True if what follows `begin` lacks only its end: brackets are open, or a string is.
    bool ends_at_end_of_file(std::size_t begin) const {
        std::string_view rest = text().substr(begin + 1);
        const std::size_t last = rest.find_last_not_of(" \t\r\n");
        int depth = 1;
        bool in_string = false;
        for (std::size_t i = 0; last != std::string_view::npos && i <= last; ++i) {
            if (in_string && rest[i] == '\\')
                ++i;
            else if (rest[i] == '"')
                in_string = !in_string;
            else if (!in_string && (rest[i] == '{' || rest[i] == '['))
                ++depth;
            else if (!in_string && (rest[i] == '}' || rest[i] == ']'))
                --depth;
        }
        return depth > 0;
    }

    void cut_short(std::size_t offset) {
        if (!was_cut_short_)
            trace_.damage.push_back(problem_at(source(), offset, truncation_after(trace_.size())));
        was_cut_short_ = true;
    }

    void read_header(const JsonValue& header) {
        if (header.kind != JsonValue::Kind::object)
            fail(header.begin, fmt::format("expected a trace, found {}", described(header)));
        const auto version = header.find("rastertrace");
        if (!version)
            fail(header.begin, R"(expected a trace with the key "rastertrace", found none)");
        const auto number = whole_in(version->text);
        if (version->kind != JsonValue::Kind::number || !number || *number < 1)
            fail(version->begin,
                 fmt::format("expected the version of the trace, found {}", described(*version)));
        if (*number > trace_version)
            fail(version->begin,
                 fmt::format("expected a trace of version {}, found version {}", trace_version,
                             *number),
                 "a newer rastertrace has written it");

        const auto canvas = header.find("canvas");
        if (!canvas)
            fail(header.begin, R"(expected the key "canvas", found none)");
        const auto read = read_canvas_json(source(), *canvas);
        if (!read)
            throw read.problem();
        if (!read.value().has_width || !read.value().has_height)
            fail(canvas->begin, R"(expected a canvas with "width" and "height", found less)");
        trace_.version = *number;
        trace_.canvas = {read.value().width, read.value().height, read.value().origin};
        if (const auto fault = fault_of_size(trace_.canvas))
            fail(canvas->begin, *fault);

        if (const auto background = header.find("background")) {
            trace_.background = parse_color(background->text);
            if (!trace_.background)
                fail(background->begin, fmt::format(R"(expected a color like "#ff8000", found {})",
                                                    described(*background)));
        }
        if (const auto title = header.find("title"))
            trace_.title = title->text;
        if (const auto numbers = header.find("numbers"))
            trace_.numbers = numbers->text;
        if (const auto projection = header.find("projection"))
            trace_.projection = projection->text;
        if (const auto method = header.find("method"))
            for (const auto& [key, value] : method->members())
                trace_.method.emplace_back(key.text, value.text);
        add_convention();
        if (const auto stages = header.find("stages"))
            for (const JsonValue& stage : stages->elements())
                read_stage(stage);
        read_left_out(header);
        note_wrong_forms(header, header_keys);
        if (care_ != Care::none && !is_block_)
            sums_.state.emplace(trace_.canvas, FrameParts{.writes = true, .depths = true});
    }

    /// A named set stands for all that it sets, as in a scene. What the header says itself wins.
    void add_convention() {
        const std::string name = trace_.method_value("convention");
        for (const ConventionRow& row : convention_rows())
            if (row.name == name)
                for (const auto& [key, value] : row.method)
                    if (trace_.method_value(key).empty())
                        trace_.method.emplace_back(key, value);
    }

    /// What nobody reads because it is not as the format says.
    void note_wrong_forms(const JsonValue& object, std::span<const JsonKey> keys,
                          std::size_t before = 0) {
        if (care_ == Care::none)
            return;
        for (WrongForm& wrong : wrong_forms(object, keys)) {
            wrong.offset += before;
            wrong_forms_.push_back(std::move(wrong));
        }
    }

    /// Which steps were left out.
    void read_left_out(const JsonValue& header) {
        LeftOut& left_out = trace_.left_out;
        const auto region = header.find("region");
        const auto primitive = header.find("primitive");
        if (const auto only = header.find("only")) {
            left_out.only.emplace();
            for (const JsonValue& name : only->elements())
                left_out.only->push_back(name.text);
        }
        if (region && region->elements().size() == 4) {
            left_out.region.emplace();
            for (std::size_t i = 0; i < 4; ++i)
                (*left_out.region)[i] = whole_in(region->elements()[i].text).value_or(0);
        }
        if (primitive)
            left_out.primitive = primitive->text;
        left_out.has_places_missing = region || primitive;
        trace_.is_partial = left_out.only || left_out.has_places_missing;
    }

    /// A stage that ran. What is no such record is passed over.
    void read_stage(const JsonValue& stage) {
        const auto name = stage.find("stage");
        const auto is_kept = stage.find("kept");
        if (!name || !is_kept || is_kept->text != "true")
            return;
        if (trace_.stages.empty() || trace_.stages.back() != name->text)
            trace_.stages.push_back(name->text);
    }

    bool is_valid_json(std::size_t begin, std::size_t size) const {
        JsonScanner fields(text().substr(begin, size));
        while (fields.next_field()) {
        }
        return !fields.failed() &&
               (!fields.needs_full_check() || parse_json(source(), begin, size));
    }

    /// Takes all steps from the index, and tells where the line behind them begins. They are what the end record says, or
    /// there would be no index.
    std::size_t take_indexed_steps() {
        const TraceIndex& index = *reading_.index;
        trace_.index_ = reading_.index;
        trace_.steps_->add_indexed(index);
        sums_.counts = index.counts();
        sums_.state.reset();
        check_count();
        return index.end_of_steps();
    }

    /// Takes the lines from `offset` on that hold steps as this program writes them, several parts of the text at once;
    /// tells where the first other line begins.
    std::size_t take_plain_lines(std::size_t offset, bool is_document) {
        std::string_view rest = text().substr(offset);
        if (!take_step(rest, step_))
            return offset; // of a foreign trace, perhaps every line
        const LineScan scan{.canvas = trace_.canvas,
                            .is_document = is_document,
                            .has_changes = sums_.state.has_value()};
        const std::size_t jobs = reading_.jobs == 0 ? usual_jobs() : reading_.jobs;
        constexpr std::size_t most_remembered = 16U << 20U; // bytes
        for (std::size_t remembered = offset; offset < text().size();) {
            if (source().mapped && offset - remembered > most_remembered) {
                source().mapped->forget();
                remembered = offset;
            }
            for (const ScannedLines& part :
                 scan_parts(text(), offset, offset + sums_.bytes_at_once, part_size, jobs, scan)) {
                take(part);
                offset = part.measured.end;
                if (!part.is_whole) {
                    // No newline is behind the end record of a block.
                    if (text().find('\n', offset) != std::string_view::npos)
                        sums_.bytes_at_once = least_bytes_at_once;
                    return offset;
                }
            }
            sums_.bytes_at_once = std::min(2 * sums_.bytes_at_once, most_at_once);
        }
        return offset;
    }

    /// Takes lines of plain steps.
    void take(const ScannedLines& lines) {
        if (lines.measured.kinds.size() > reading_.most_steps - trace_.size())
            throw too_many_steps(source().name, reading_.most_steps);
        if (lines.stray && care_ != Care::none)
            check_pixel(lines.stray->offset, lines.stray->x, lines.stray->y);
        if (sums_.state)
            lines.play(*sums_.state);
        sums_.counts += lines.counts;
        trace_.steps_->add_lines(lines.measured);
        tell_bytes_done(lines.measured.end);
    }

    /// Throws a Problem that points at the first zero byte of a part of the text.
    void refuse_zero_bytes(std::size_t from, std::size_t size = std::string_view::npos) const {
        if (text().substr(from, size).find('\0') != std::string_view::npos)
            throw *zero_byte_in(source());
    }

    void check_count() const {
        if (trace_.size() >= reading_.most_steps)
            throw too_many_steps(source().name, reading_.most_steps);
    }

    void add_step(std::size_t begin, std::size_t size) {
        check_count();
        if (care_ != Care::to_tell || useless_steps_ == most_useless_steps)
            return add_usable_step(begin, size);
        try {
            add_usable_step(begin, size);
        } catch (Problem& problem) {
            ++useless_steps_;
            trace_.damage.push_back(std::move(problem));
            add_place(begin, size, std::nullopt);
        }
    }

    void add_usable_step(std::size_t begin, std::size_t size) {
        const std::string_view json = text().substr(begin, size);
        if (care_ == Care::none) {
            sums_.counts.add(kind_of_plain_step(json));
            trace_.steps_->add({.offset = begin,
                                .length = static_cast<std::uint32_t>(size),
                                .kind = kind_of_plain_step(json),
                                .is_plain = true});
            return;
        }

        if (size > std::numeric_limits<std::uint32_t>::max())
            fail(begin, "expected a step shorter than 4 GiB, found a longer one");
        const auto kind = checked_kind(source(), begin, size);
        if (kind == StepKind::pixel) {
            const auto pixel = StepView(json).as<PixelStep>();
            check_pixel(begin, pixel.x, pixel.y);
        }
        if (kind)
            note_not_finite(trace_.not_finite, source(), begin, json, *kind);
        if (!kind)
            sums_.counts.add(StepView(json), kind);
        add_place(begin, size, kind);
    }

    void add_place(std::size_t begin, std::size_t size, std::optional<StepKind> kind) {
        if (kind)
            sums_.counts.add(*kind);
        if (sums_.state)
            sums_.state->take(StepView(text().substr(begin, size)), kind);
        trace_.steps_->add(
            {.offset = begin, .length = static_cast<std::uint32_t>(size), .kind = kind});
        constexpr std::size_t seldom = 4096;
        if (trace_.size() % seldom == 0)
            tell_bytes_done(begin);
    }

    void tell_bytes_done(std::size_t end) {
        add_bytes_done({.read = end - std::exchange(counted_, end)});
    }

    /// The first pixel that is off the canvas is told.
    void check_pixel(std::size_t begin, Index x, Index y) {
        if (sums_.has_stray_pixel || trace_.canvas.contains(x, y))
            return;
        sums_.has_stray_pixel = true;
        trace_.damage.push_back(problem_at(
            source(), begin,
            fmt::format("expected pixels on the canvas (x {}..{}, y {}..{}), found ({}, {})",
                        trace_.canvas.left(), trace_.canvas.right(), trace_.canvas.top(),
                        trace_.canvas.bottom(), x, y),
            "such pixels are not drawn"));
    }

    /// `before`: so many bytes of the text stand in front of the source that the record was read from.
    void read_end(const JsonValue& value, std::size_t before = 0) {
        const auto count_in = [this, before](const JsonValue& number) {
            const auto count = whole_in(number.text);
            if (number.kind != JsonValue::Kind::number || !count || *count < 0)
                fail(before + number.begin,
                     fmt::format("expected a count, found {}", described(number)));
            return static_cast<std::uint64_t>(*count);
        };
        if (value.kind != JsonValue::Kind::object)
            fail(before + value.begin,
                 fmt::format("expected the end record, found {}", described(value)));
        EndRecord end;
        if (const auto steps = value.find("steps"))
            end.steps = count_in(*steps);
        if (const auto pixels = value.find("pixels"))
            end.pixels = count_in(*pixels);
        if (const auto frame = value.find("frame"))
            end.frame = frame->text;
        if (const auto count = value.find("count"))
            for (const auto& [kind, number] : count->members())
                end.count[kind.text] = count_in(number);
        trace_.end = std::move(end);
        end_offset_ = before + value.begin;
        note_wrong_forms(value, end_keys, before);
    }

    /// Says what is missing at the end, or does not agree with it.
    void compare_with_end() {
        if (!trace_.end) {
            if (!was_cut_short_)
                trace_.damage.push_back(
                    problem_at(source(), text().size(),
                               "expected an end record, found none: the trace may be truncated"));
            return;
        }
        // They all point at one place, which is looked up once.
        std::optional<Problem> at;
        const auto disagree = [&](std::string_view told, std::string_view what, const auto& found) {
            if (!at)
                at = problem_at(source(), end_offset_, "");
            trace_.damage.push_back(*at);
            trace_.damage.back().message = disagreement(told, what, fmt::format("{}", found));
        };
        if (trace_.end->steps && *trace_.end->steps != trace_.size())
            disagree(fmt::format("{}", *trace_.end->steps), "steps", trace_.size());
        if (useless_steps_ > 0)
            return; // nobody knows what they should have been
        if (!trace_.end->count.empty()) {
            for (const auto& [name, told] : trace_.end->count) {
                if (const std::uint64_t steps = sums_.counts.of(name); steps != told)
                    disagree(fmt::format("{}", told), name + " steps", steps);
            }
        }
        compare_picture_with_end();
    }

    /// The picture that the steps draw against the end record. A pixel off the canvas has been told already.
    void compare_picture_with_end() {
        if (!sums_.state || sums_.has_stray_pixel || !tells_picture(*trace_.end))
            return;
        if (auto message = disagreement_of_picture(trace_, *trace_.end, sums_.state->frame().image))
            trace_.damage.push_back(problem_at(source(), end_offset_, *std::move(message)));
    }

    Trace trace_;
    Care care_;
    TraceReading reading_;
    bool is_block_;
    bool was_cut_short_ = false;
    std::size_t counted_ = 0; ///< of the bytes, see add_bytes_done
    BlockSums own_sums_;
    BlockSums& sums_; ///< the picture of its state is that of the end record
    std::size_t end_offset_ = 0;
    std::size_t useless_steps_ = 0; ///< that are damage
    std::vector<WrongForm> wrong_forms_;
    AnyStep step_; ///< that was looked at last
};

Result<Trace> read_written_trace(Source source) {
    try {
        return TraceReader::read_with(source, TraceReader::Care::none);
    } catch (const Problem& problem) {
        return problem;
    }
}

Result<Trace> TraceReader::read_with(Source& source, Care care, const TraceReading& reading,
                                     BlockSums* sums) {
    // The mark that some editors put in front of UTF-8 says nothing.
    const std::size_t mark = size_of_mark(source.text);
    source.text.replace(0, mark, mark, ' ');
    TraceReader reader(std::move(source), care, reading, sums);
    try {
        return reader.read();
    } catch (const Problem& problem) {
        // A zero byte is told first, wherever it is.
        auto zero = zero_byte_in(reader.source());
        source = std::move(reader.trace_.source_);
        return zero ? *std::move(zero) : problem;
    }
}

Result<Trace> read_trace(Source source, const TraceReading& reading) {
    return TraceReader::read_with(source, TraceReader::Care::to_use, reading);
}

Result<Trace> read_block(Source& source, bool to_tell, std::size_t jobs, BlockSums& sums) {
    return TraceReader::read_with(source,
                                  to_tell ? TraceReader::Care::to_tell : TraceReader::Care::to_use,
                                  {.jobs = jobs}, &sums);
}

Result<Trace> read_trace_to_tell(Source source, const TraceReading& reading) {
    return TraceReader::read_with(source, TraceReader::Care::to_tell, reading);
}

} // namespace rastertrace
