// SPDX-License-Identifier: MIT
// What a page needs of a trace. Texts are written once, in "words", and told by their number there. A list of
// numbers holds a few for each step, or for each step of a kind, one step after the other:
//
//     title, notes      words
//     canvas            left, top: x and y of the upper left pixel; width, height; down: 1 if y points down, else -1;
//                       sample: 1/2 if pixels are tested at their centers; background: a word, or null
//     conventions       key, value, meaning: words, of each rule that is in force
//     view, views       the view to begin with, and those that say something
//     kinds             of each kind of step its name, and the pieces of its sentence between the placeholders
//     groups, heading   what faces are told apart as, words; what is said before them
//     primitives        step, name, kind, color, group (-1: none), corners, their names and coordinates
//     step_kinds        of each step its place in kinds; fills: of each step a word for each placeholder
//     at                of each step the pixel that it is about, counted from the upper left one; -1: none
//     areas             of each step that is about more than a pixel, or about none of its own: its number, columns and
//                       rows: from, to, from, to
//     about             of each step that is not about the primitive that began last: its number, and the step of its own
//                       primitive; 0: none
//     marks             of each step that tells something else than its numbers give: its number, and a word that says
//                       what they give; the key is left out if there is no such step
//     working           of each step a list of words; null: there are too many steps
//     pixels            of each pixel step its color
//     depths            of each depth step: 1 if it passes, and 2 if it is stored; how light its gray is; its number
//     samples           of each sample step 1 if it is inside
//     rows              of each scanline step: row, x of both ends, columns of both pixels; the ends as words
//     edges             of each edge step the places of its two corners in its primitive; -1: not known
//     space             the picture in space: its width and height, the elements of all steps, and of each step a word for
//                       what it adds; the key is left out if the scene is not one in space
//     write_grays       how light a pixel is that was written once, twice, ...
//     answers           of each pixel; null: the canvas is too large, or the page asks (page_answer). See answers_text.

#include <rastertrace/figures/page.h>

#include "grays.h"

#include <rastertrace/trace/explain/explain_pixels.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/corners.h>
#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/tell/face_groups.h>
#include <rastertrace/trace/tell/shown_steps.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/tell/told_samples.h>
#include <rastertrace/trace/tell/working.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/language.h>
#include <rastertrace/trace/text/method_names.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <utility>

namespace rastertrace {

namespace {

/// As many faces as there are colors for are told apart, and some more by their names.
constexpr std::size_t most_groups = 24;

/// Texts, each once.
class EachOnce {
public:
    std::size_t place_of(const std::string& word) {
        const auto [found, is_new] = places_.emplace(word, words_.size());
        if (is_new)
            words_.push_back(word);
        return found->second;
    }
    const std::vector<std::string>& all() const { return words_; }

private:
    std::unordered_map<std::string, std::size_t> places_;
    std::vector<std::string> words_;
};

/// A JSON array, written as it grows.
class JsonList {
public:
    template <typename Number> void add(Number number) { put(fmt::format("{}", number)); }
    void add(const JsonList& list) { put(list.text()); }
    void add_text(std::string_view text) { put(json_quoted(text)); }
    void add_json(std::string_view json) { put(json); }

    std::string text() const { return text_ + "]"; }

private:
    void put(std::string_view value) {
        if (text_.size() > 1)
            text_ += ',';
        text_ += value;
    }

    std::string text_ = "[";
};

/// A sentence whose numbers are taken out: "row y=2" is "row {}" and "y=2".
struct Numberless {
    std::vector<std::string> pieces{""};
    std::vector<std::string> fills;
};

Numberless without_numbers(const std::string& sentence) {
    Numberless result;
    bool is_first = true;
    for (const std::string& word : split_at(sentence, ' ')) {
        if (!std::exchange(is_first, false))
            result.pieces.back() += ' ';
        if (word.find_first_of("0123456789") == std::string::npos) {
            result.pieces.back() += word;
        } else {
            result.fills.push_back(word);
            result.pieces.emplace_back();
        }
    }
    return result;
}

/// The grays of all depths of a trace; nothing if it has no depth test.
std::optional<DepthGrays> depth_grays(const Trace& trace) {
    std::optional<DepthGrays> grays;
    for (const std::size_t n : trace.steps_of({StepKind::depth})) {
        if (!grays)
            grays.emplace();
        if (!grays->knows_which_is_nearer())
            if (const auto larger = larger_depth_passes(trace, n))
                grays->say_larger_is_nearer(*larger);
        if (const auto depth = trace.step(n).as<DepthStep>().depth.nearest_double())
            grays->include(*depth);
    }
    return grays;
}

/// The answer about a pixel, with the nearest of those that have not drawn it, and how many these were.
std::pair<Explanation, std::size_t> told_of_pixel(PixelExplainer& explainer, Pixel pixel) {
    Explanation told = explainer.explain(pixel);
    const std::size_t count = told.why_not.size();
    if (count > most_why_not_told) {
        std::stable_sort(told.why_not.begin(), told.why_not.end(), was_nearer_to_drawing);
        told.why_not.resize(most_why_not_told);
    }
    return {std::move(told), count};
}

/// Puts the data of a page together.
class PageData {
public:
    PageData(const Trace& trace, const PageDetail& detail, const StepsInSpace* in_space)
        : trace_(trace), grays_(depth_grays(trace)),
          replay_(trace, {.writes = false, .depths = true}), detail_(detail),
          has_working_(trace.size() <= detail.steps_with_working), in_space_(in_space) {}

    std::string text() {
        add_groups();
        for (std::size_t n = 1; n <= trace_.size(); ++n)
            add_step(n);
        const std::string answers = answers_text();
        const std::string head = header_text();
        std::string text = "{" + head;
        const auto put = [&text](std::string_view key, const std::string& value) {
            text += fmt::format(",\n\"{}\":{}", key, value);
        };
        put("groups", groups_.text());
        put("heading", json_quoted(printable(heading_)));
        put("primitives", primitives_.text());
        put("step_kinds", step_kinds_.text());
        put("fills", fills_.text());
        put("at", at_.text());
        put("working", has_working_ ? working_.text() : "null");
        if (!marks_.text().starts_with("[]"))
            put("marks", marks_.text());
        put("pixels", pixels_.text());
        put("depths", depths_.text());
        put("samples", samples_.text());
        put("rows", rows_.text());
        put("edges", edges_.text());
        put("areas", areas_.text());
        put("about", about_.text());
        put("answers", answers);
        if (in_space_ != nullptr)
            put("space", fmt::format("{{\"width\":{},\"height\":{},\"all\":{},\"steps\":{}}}",
                                     in_space_->width, in_space_->height,
                                     json_quoted(in_space_->of_all()), steps_in_space_.text()));
        JsonList write_grays;
        for (std::uint32_t count = 1; count <= most_writes_told; ++count)
            write_grays.add(int{gray(share_of_writes(count)).red()});
        put("write_grays", write_grays.text());
        JsonList words;
        for (const std::string& word : words_.all())
            words.add_text(word);
        put("words", words.text());
        return text + "}";
    }

private:
    std::size_t word(const std::string& text) { return words_.place_of(text); }
    std::size_t printable_word(const std::string& text) { return word(printable(text)); }

    // --- what holds for all steps

    std::string header_text() {
        const Canvas& canvas = trace_.canvas;
        JsonList notes;
        for (const Problem& problem : trace_.damage)
            notes.add(word(problem.line == 0
                               ? problem.message
                               : fmt::format("line {}: {}", problem.line, problem.message)));
        if (trace_.is_partial)
            notes.add(word("steps were left out of this trace"));
        JsonList views;
        for (const View view : views_of())
            views.add_text(name_of(view));
        return fmt::format(
            "\"format\":1,\n\"title\":{},\n\"notes\":{},\n\"canvas\":{{\"left\":{},\"top\":{},"
            "\"width\":{},\"height\":{},\"down\":{},\"sample\":{},\"tests_samples\":{},"
            "\"background\":{}}},\n\"conventions\":{},\n\"view\":\"{}\",\n\"views\":{},\n\"kinds\":"
            "{}",
            json_quoted(printable(trace_.title)), notes.text(), canvas.left(), canvas.top(),
            canvas.width, canvas.height, canvas.down(),
            pixels_begin_at_integers(trace_) ? "0.5" : "0", tests_samples(trace_),
            trace_.background ? json_quoted(to_text(*trace_.background)) : "null",
            conventions_text(), name_of(default_view(trace_)), views.text(), kinds_text());
    }

    std::vector<View> views_of() const {
        std::vector<View> views{View::plotted};
        if (group_count_ > 1)
            views.push_back(View::faces);
        views.push_back(View::shade);
        if (grays_)
            views.push_back(View::depth);
        views.push_back(View::writes);
        return views;
    }

    std::string conventions_text() {
        const Canvas& canvas = trace_.canvas;
        JsonList list;
        const auto add = [&](const std::string& key, const std::string& value,
                             const std::string& meaning) {
            for (const std::string& text : {key, value, meaning})
                list.add(printable_word(text));
        };
        add("y", canvas.down() > 0 ? "down" : "up", "which way y points");
        add("canvas",
            fmt::format("x {} to {}, y {} to {}", canvas.left(), canvas.right(),
                        std::min(canvas.top(), canvas.bottom()),
                        std::max(canvas.top(), canvas.bottom())),
            "the pixels that there are");
        for (const auto& [key, value] : trace_.method.words) {
            const MethodKey* const row = find_method_key(key);
            add(key, value, row == nullptr ? std::string() : std::string(row->meaning));
        }
        return list.text();
    }

    /// In the order of the step table; the last one is of steps that we do not know.
    static std::string kinds_text() {
        JsonList kinds;
        const auto add = [&kinds](std::string_view name, std::string_view sentence) {
            JsonList kind;
            kind.add_text(name);
            for (const std::string_view piece : pieces_of(sentence))
                kind.add_text(piece);
            kinds.add(kind);
        };
        for (std::size_t i = 0; i < step_kinds; ++i) {
            const StepRow& row = row_of(static_cast<StepKind>(i));
            add(name_of(row.kind), row.sentence.in(language_of_steps()));
        }
        add("unknown", "{step}");
        return kinds.text();
    }

    void add_groups() {
        FaceGroups groups = painted_face_groups(trace_, most_groups);
        group_count_ = groups.names.size();
        heading_ = groups.heading;
        for (const std::string& name : groups.names)
            groups_.add(printable_word(name));
        group_of_ = std::move(groups.group_of);
    }

    // --- step by step

    void add_step(std::size_t n) {
        replay_.go_to(n);
        const auto kind = trace_.kind_of(n);
        step_kinds_.add(kind ? static_cast<std::size_t>(*kind) : step_kinds);
        for (const std::string& fill : sentence_of_step(replay_).fills)
            fills_.add(word(fill));
        if (const std::string given = what_numbers_give(trace_, n); !given.empty()) {
            marks_.add(n);
            marks_.add(word(given));
        }
        if (has_working_) {
            JsonList lines;
            for (const std::string& line : working_of(replay_))
                lines.add(word(line));
            working_.add(lines);
        }
        const StepSubject subject = subject_of(replay_, n);
        if (const auto pixel = pixel_of(trace_, n))
            at_.add(trace_.canvas.offset_of(*pixel));
        else
            at_.add(-1);
        if (!pixel_of(trace_, n) && subject.pixels && kind != StepKind::scanline)
            add_area(n, *subject.pixels);
        if (subject.primitive != replay_.primitive()) {
            about_.add(n);
            about_.add(subject.primitive);
        }
        if (in_space_ != nullptr)
            add_space(kind);
        if (kind)
            add_what_is_drawn(trace_.step(n), *kind, subject);
    }

    /// In a long trace, pixels have what their primitive has: that is written once.
    void add_space(std::optional<StepKind> kind) {
        const bool is_of_primitive = trace_.size() > most_steps_with_sight && kind &&
                                     kind_of_pixel(*kind) && replay_.primitive() != 0;
        if (!is_of_primitive || replay_.primitive() != in_space_of_) {
            in_space_word_ = word(
                in_space_->of_step(is_of_primitive ? replay_at(replay_.primitive()) : replay_));
            in_space_of_ = is_of_primitive ? replay_.primitive() : 0;
        }
        steps_in_space_.add(in_space_word_);
    }

    /// True if steps of a kind are about single pixels.
    static bool kind_of_pixel(StepKind kind) {
        return kind == StepKind::pixel || kind == StepKind::depth || kind == StepKind::sample ||
               kind == StepKind::decide || kind == StepKind::along || kind == StepKind::reject;
    }

    const Replay& replay_at(std::size_t n) {
        if (!replay_of_primitive_)
            replay_of_primitive_.emplace(trace_);
        replay_of_primitive_->go_to(n);
        return *replay_of_primitive_;
    }

    void add_area(std::size_t n, const Region& area) {
        const Canvas& canvas = trace_.canvas;
        const auto [top, bottom] = std::minmax({canvas.row_of(area.y0), canvas.row_of(area.y1)});
        areas_.add(n);
        areas_.add(area.x0 - canvas.left());
        areas_.add(area.x1 - canvas.left());
        areas_.add(top);
        areas_.add(bottom);
    }

    void add_what_is_drawn(const StepView& step, StepKind kind, const StepSubject& subject) {
        switch (kind) {
        case StepKind::primitive:
            return add_primitive(step.as<PrimitiveStep>());
        case StepKind::pixel:
            pixels_.add(
                word(to_text(step.as<PixelStep>().color.color().value_or(replay_.color()))));
            return;
        case StepKind::depth: {
            const auto test = step.as<DepthStep>();
            depths_.add((test.pass.is_true() ? 1 : 0) + (stores_depth(test) ? 2 : 0));
            depths_.add(grays_->level_of(test.depth.nearest_double()));
            depths_.add(printable_word(short_number(test.depth.text())));
            return;
        }
        case StepKind::sample:
            samples_.add(step.as<SampleStep>().inside.is_true() ? 1 : 0);
            return;
        case StepKind::scanline:
            return add_row(step.as<ScanlineStep>());
        case StepKind::edge:
            for (const std::size_t i : {0U, 1U})
                if (subject.edge)
                    edges_.add((*subject.edge)[i]);
                else
                    edges_.add(-1);
            return;
        default:
            return;
        }
    }

    void add_primitive(const PrimitiveStep& step) {
        const auto vertices = step.vertices.texts();
        const auto places = corners_of(step);
        const auto group = group_of_.find(replay_.step());
        primitives_.add(replay_.step());
        primitives_.add(printable_word(step.name.text()));
        primitives_.add(printable_word(step.kind.text()));
        primitives_.add(word(to_text(replay_.color())));
        if (group == group_of_.end())
            primitives_.add(-1);
        else
            primitives_.add(group->second);
        JsonList corners;
        for (const Place& place : places) {
            corners.add(held(place.x));
            corners.add(held(place.y));
        }
        primitives_.add(corners);
        JsonList names;
        const auto at = text_rows(step.at);
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            names.add(printable_word(vertices[i]));
            names.add(i < at.size() && at[i].size() > 1
                          ? printable_word(fmt::format("({}, {})", short_number(at[i][0]),
                                                       short_number(at[i][1])))
                          : word(""));
        }
        primitives_.add(names);
    }

    void add_row(const ScanlineStep& row) {
        const Canvas& canvas = trace_.canvas;
        const bool is_on_canvas = canvas.contains(canvas.left(), row.y);
        rows_.add(is_on_canvas ? canvas.row_of(row.y) : -1);
        for (const TracedNumber& end : {row.left, row.right})
            rows_.add(held(end.nearest_double().value_or(farthest)));
        for (const Index pixel : {row.from, row.to})
            rows_.add(pixel - canvas.left());
        for (const TracedNumber& end : {row.left, row.right})
            rows_.add(printable_word(as_in_working(end.text())));
    }

    /// Beyond any canvas: there an end lies that is not finite, which a page does not draw.
    static constexpr double farthest = 1e9;

    /// A number that JSON readers have.
    static double held(double number) { return std::clamp(number, -farthest, farthest); }

    // --- pixel by pixel

    /// {"patterns": [pieces, ...], "pixels": [...]}; of each pixel the answer, how many reasons there are in all, how many
    /// are told, each of these as primitive, reason and sentence; how many lines say what cannot be told, and these. A
    /// sentence is its place in patterns, and a word for each of its fills.
    std::string answers_text() {
        const Canvas& canvas = trace_.canvas;
        const auto pixels = canvas.area();
        if (!has_answers(trace_, detail_))
            return "null";
        JsonList answers;
        PixelExplainer explainer(trace_);
        for (std::size_t i = 0; i < pixels; ++i) {
            const auto row = static_cast<int>(i / static_cast<std::size_t>(canvas.width));
            const auto column = static_cast<int>(i % static_cast<std::size_t>(canvas.width));
            const auto [told, count] =
                told_of_pixel(explainer, {canvas.left() + column, canvas.y_of(row)});
            add_sentence(told.answer, answers);
            answers.add(count);
            answers.add(told.why_not.size());
            for (const WhyNot& why : told.why_not) {
                answers.add(printable_word(why.primitive));
                answers.add(word(std::string(in_language_of_steps(why.reason))));
                add_sentence(why.sentence, answers);
            }
            answers.add(told.lacks.size());
            for (const std::string& line : told.lacks)
                answers.add(word(line));
        }
        return fmt::format("{{\"patterns\":{},\n\"pixels\":{}}}", patterns_.text(), answers.text());
    }

    void add_sentence(const std::string& sentence, JsonList& list) {
        const Numberless parts = without_numbers(sentence);
        const auto [found, is_new] =
            pattern_places_.emplace(joined(parts.pieces, "\n"), pattern_places_.size());
        if (is_new) {
            JsonList pieces;
            for (const std::string& piece : parts.pieces)
                pieces.add_text(piece);
            patterns_.add(pieces);
        }
        list.add(found->second);
        for (const std::string& fill : parts.fills)
            list.add(word(fill));
    }

    const Trace& trace_;
    std::optional<DepthGrays> grays_; ///< none: there are no depth tests
    Replay replay_;
    PageDetail detail_;
    bool has_working_;
    EachOnce words_;
    const StepsInSpace* in_space_;
    std::optional<Replay> replay_of_primitive_; ///< made when it is asked for
    JsonList steps_in_space_;
    std::size_t in_space_word_ = 0;
    std::size_t in_space_of_ = 0; ///< the primitive that the last word is of; 0: of another step
    std::size_t group_count_ = 0;
    std::string heading_;
    std::unordered_map<std::size_t, std::size_t> group_of_;
    std::unordered_map<std::string, std::size_t> pattern_places_;
    JsonList groups_, primitives_, step_kinds_, fills_, at_, marks_, working_, pixels_, depths_,
        samples_, rows_, edges_, areas_, about_, patterns_;
};

} // namespace

std::optional<Problem> too_large_for_page(const Trace& trace) {
    const auto pixels = trace.canvas.area();
    if (pixels > most_page_pixels)
        return problem_of("",
                          fmt::format("expected at most {} pixels for a page, found {} x {}",
                                      most_page_pixels, trace.canvas.width, trace.canvas.height),
                          "a .png or .svg shows it, or a page of the scene on a smaller canvas");
    if (trace.size() > most_page_steps)
        return problem_of("",
                          fmt::format("expected at most {} steps for a page, found {}",
                                      most_page_steps, trace.size()),
                          "a trace of fewer makes one: trace --only, --region or --primitive");
    return std::nullopt;
}

std::string page_data(const Trace& trace, const PageDetail& detail, const StepsInSpace* in_space) {
    return PageData(trace, detail, in_space).text();
}

bool has_answers(const Trace& trace, const PageDetail& detail) {
    const Canvas& canvas = trace.canvas;
    std::size_t primitives = 0;
    for ([[maybe_unused]] const std::size_t n : trace.steps_of({StepKind::primitive}))
        ++primitives;
    const auto pixels = canvas.area();
    return std::max(canvas.width, canvas.height) <= largest_side_with_why_not &&
           pixels * primitives <= detail.why_not_asked;
}

std::string page_answer(PixelExplainer& explainer, Pixel pixel) {
    const auto [told, count] = told_of_pixel(explainer, pixel);
    JsonList reasons, lacks;
    for (const WhyNot& why : told.why_not)
        reasons.add_json(fmt::format(R"({{"primitive":{},"reason":{},"sentence":{}}})",
                                     json_quoted(printable(why.primitive)),
                                     json_quoted(in_language_of_steps(why.reason)),
                                     json_quoted(why.sentence)));
    for (const std::string& line : told.lacks)
        lacks.add_text(line);
    return fmt::format(R"({{"answer":{},"count":{},"whyNot":{},"lacks":{}}})",
                       json_quoted(told.answer), count, reasons.text(), lacks.text());
}

} // namespace rastertrace
