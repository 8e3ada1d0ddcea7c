// SPDX-License-Identifier: MIT
#include "trace_lines.h"

#include "field_type.h"
#include "header_check.h"
#include "replay.h"
#include "step_decoder.h"
#include "steps.h"
#include "trace_keys.h"
#include "traced_steps.h"
#include "write_trace.h"

#include <rastertrace/trace/text/byte_order_mark.h>
#include <rastertrace/trace/text/canvas_json.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/conventions.h>
#include <rastertrace/trace/text/input.h>
#include <rastertrace/trace/text/json_document.h>
#include <rastertrace/trace/text/json_scanner.h>
#include <rastertrace/trace/text/mapped_file.h>
#include <rastertrace/trace/text/process_files.h>
#include <rastertrace/trace/text/text.h>
#include <rastertrace/trace/text/trace_layout.h>
#include <rastertrace/trace/text/zero_byte.h>

#include <fmt/core.h>

#include <algorithm>
#include <span>
#include <utility>

namespace rastertrace {

namespace {

/// JSON without the blanks between its tokens.
std::string compact(std::string_view json) {
    std::string text;
    bool is_in_string = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (!is_in_string && (c == ' ' || c == '\t' || c == '\r' || c == '\n'))
            continue;
        text += c;
        if (is_in_string && c == '\\')
            text += json[++i];
        else if (c == '"')
            is_in_string = !is_in_string;
    }
    return text;
}

/// What the picture that comes of all steps has otherwise than the end record says.
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

} // namespace

/// Reads one trace. What makes the rest useless is thrown as a Problem; what does not is damage.
class TraceReader {
public:
    /// How closely a trace is looked at.
    enum class Care {
        none,    ///< its steps are elsewhere
        to_use,  ///< a step that cannot be used ends the reading
        to_tell, ///< such a step is damage, and the rest is read
    };

    TraceReader(Source source, Care care, std::size_t most_steps) : care_(care) {
        trace_.steps_ = std::make_shared<Steps>(std::move(source));
        if (most_steps != any_number)
            steps().bound(most_steps);
    }

    /// Reads what may be a trace.
    static Result<Trace> read_with(Source source, Care care, std::size_t most_steps = any_number);

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
        return std::move(trace_);
    }

    const Source& source() const { return trace_.source(); }

private:
    std::string_view text() const { return source().view(); }
    Steps& steps() { return *trace_.steps_; }

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
        for (const auto& [key, value] : root.members())
            if (key.text != "steps" && key.text != "end")
                trace_.header_json.append(trace_.header_json.empty() ? "{" : ",")
                    .append(compact(text().substr(key.begin, value.end() - key.begin)));
        trace_.header_json += "}";
        const auto list = root.find("steps");
        if (!list || list->kind != JsonValue::Kind::array)
            fail(root.begin, R"(expected the key "steps" with an array, found none)");
        for (const JsonValue& step : list->elements())
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
        trace_.header_json = alone.text;
        trace_.has_lines_ = true;

        const std::size_t last_byte = text().find_last_not_of(" \t\r\n");
        std::size_t offset = text().find('\n');
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
        if (trace_.cut_short)
            return;
        trace_.cut_short = problem_at(
            source(), offset,
            fmt::format("expected the rest of the trace, found the end of the file: the trace is "
                        "truncated after {} whole steps",
                        trace_.size()));
        trace_.damage.push_back(*trace_.cut_short);
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
                trace_.method.words.emplace_back(key.text, value.text);
        add_convention();
        trace_.method = told_method(std::move(trace_.method.words));
        if (const auto stages = header.find("stages"))
            for (const JsonValue& stage : stages->elements())
                read_stage(stage);
        read_left_out(header);
        note_wrong_forms(header, header_keys);
    }

    /// A named set stands for all that it sets, as in a scene. What the header says itself wins; the numbers
    /// that a foreign trace was drawn with, nothing else tells.
    void add_convention() {
        const std::string name = trace_.method.word_of("convention");
        for (const ConventionRow& row : convention_rows())
            if (row.name == name)
                for (const auto& [key, value] : row.method)
                    if (key != "scalar" && trace_.method.word_of(key).empty())
                        trace_.method.words.emplace_back(key, value);
    }

    /// What nobody reads because it is not as the format says.
    void note_wrong_forms(const JsonValue& object, std::span<const HeaderKey> keys,
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

    /// Takes the lines from `offset` on that hold steps as this program writes them; tells where the first other line
    /// begins.
    std::size_t take_plain_lines(std::size_t offset, bool is_document) {
        constexpr std::size_t most_remembered = 16U << 20U; // bytes
        std::size_t remembered = offset;
        while (const std::size_t size = take_plain_line(offset, is_document)) {
            if (const auto* const pixel = std::get_if<PixelStep>(&step_); pixel != nullptr)
                check_pixel(offset, pixel->x, pixel->y);
            steps().take(step_);
            offset += size;
            if (offset - remembered < most_remembered)
                continue;
            if (source().mapped)
                source().mapped->forget();
            remembered = offset;
            tell_bytes_done(offset);
        }
        tell_bytes_done(offset);
        return offset;
    }

    /// Takes the step in the line at `offset`. Returns how many bytes the line has with its newline; 0 if it is written
    /// otherwise.
    std::size_t take_plain_line(std::size_t offset, bool is_document) {
        std::string_view rest = text().substr(offset);
        if (!take_step(rest, step_))
            return 0;
        if (is_document && rest.starts_with(','))
            rest.remove_prefix(1);
        return rest.starts_with('\n') ? text().size() - rest.size() + 1 - offset : 0;
    }

    /// Throws a Problem that points at the first zero byte of a part of the text.
    void refuse_zero_bytes(std::size_t from, std::size_t size = std::string_view::npos) const {
        if (text().substr(from, size).find('\0') != std::string_view::npos)
            throw *zero_byte_in(source());
    }

    void add_step(std::size_t begin, std::size_t size) {
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
        const auto kind = checked_kind(source(), begin, size);
        add_place(begin, size, kind);
        if (kind == StepKind::pixel) {
            const auto pixel = trace_.step(trace_.size()).as<PixelStep>();
            check_pixel(begin, pixel.x, pixel.y);
        }
        if (kind)
            note_not_finite(trace_.not_finite, source(), begin, json, *kind);
    }

    void add_place(std::size_t begin, std::size_t size, std::optional<StepKind> kind) {
        steps().take_text(kind, text().substr(begin, size));
        constexpr std::size_t seldom = 4096;
        if (trace_.size() % seldom == 0)
            tell_bytes_done(begin);
    }

    void tell_bytes_done(std::size_t end) {
        add_bytes_done({.read = end - std::exchange(counted_, end)});
    }

    /// The first pixel that is off the canvas is told.
    void check_pixel(std::size_t begin, Index x, Index y) {
        if (has_stray_pixel_ || trace_.canvas.contains(x, y))
            return;
        has_stray_pixel_ = true;
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
            if (!trace_.cut_short)
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
                if (const std::uint64_t found = steps().count(name); found != told)
                    disagree(fmt::format("{}", told), name + " steps", found);
            }
        }
        compare_picture_with_end();
    }

    /// The picture that the steps draw against the end record. A pixel off the canvas has been told already.
    void compare_picture_with_end() {
        if (has_stray_pixel_ || !(trace_.end->pixels || !trace_.end->frame.empty()))
            return;
        const Image image = frame_after(trace_, trace_.size()).image;
        if (auto message = disagreement_of_picture(trace_, *trace_.end, image))
            trace_.damage.push_back(problem_at(source(), end_offset_, *std::move(message)));
    }

    Trace trace_;
    Care care_;
    std::size_t counted_ = 0;      ///< of the bytes, see add_bytes_done
    bool has_stray_pixel_ = false; ///< one that the canvas has not; the first is told
    std::size_t end_offset_ = 0;
    std::size_t useless_steps_ = 0; ///< that are damage
    std::vector<WrongForm> wrong_forms_;
    AnyStep step_; ///< that was looked at last
};

Trace trace_around_steps(Source source) {
    return TraceReader(std::move(source), TraceReader::Care::none, any_number).read();
}

Result<Trace> TraceReader::read_with(Source source, Care care, std::size_t most_steps) {
    // The mark that some editors put in front of UTF-8 says nothing.
    const std::size_t mark = size_of_mark(source.text);
    source.text.replace(0, mark, mark, ' ');
    TraceReader reader(std::move(source), care, most_steps);
    try {
        return reader.read();
    } catch (const Problem& problem) {
        // A zero byte is told first, wherever it is.
        if (auto zero = zero_byte_in(reader.source()))
            return *std::move(zero);
        std::vector<Problem> all =
            care == Care::to_tell ? std::move(reader.trace_.damage) : std::vector<Problem>();
        all.push_back(problem);
        return first_of(std::move(all));
    }
}

Result<Trace> read_trace(Source source, std::size_t most_steps) {
    return TraceReader::read_with(std::move(source), TraceReader::Care::to_use, most_steps);
}

Result<Trace> read_trace_to_tell(Source source, std::size_t most_steps) {
    return TraceReader::read_with(std::move(source), TraceReader::Care::to_tell, most_steps);
}

} // namespace rastertrace
