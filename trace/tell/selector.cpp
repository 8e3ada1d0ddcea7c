// SPDX-License-Identifier: MIT
#include "selector.h"

#include <rastertrace/trace/record/traced_steps.h>

#include "verdict_words.h"
#include <rastertrace/trace/record/field_type.h>

#include <rastertrace/trace/text/json_scanner.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <span>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <variant>

namespace rastertrace {

namespace {

constexpr std::string_view blanks = " \t";

/// The field that every step has besides its own: the name of its primitive.
constexpr std::string_view primitive_field = "in";

/// How many values or steps a message names.
constexpr std::size_t most_named = 5;

std::optional<Number> field_as_number(std::string_view text) {
    auto parsed = parse_number(text, NumberSize::any);
    if (auto* number = std::get_if<Number>(&parsed))
        return std::move(*number);
    return std::nullopt;
}

/// A value as it is compared: plain text, and a list without blanks and quotes, [A,B].
std::string compared_text(std::string_view json) {
    std::string text = plain_text(json);
    if (text.starts_with('['))
        std::erase_if(text, [](char c) { return c == '"' || c == ' '; });
    return text;
}

bool is_of_kind(const Trace& trace, std::size_t n, std::string_view kind) {
    const auto known = trace.kind_of(n);
    return known ? name_of(*known) == kind : trace.step(n).kind_name() == kind;
}

/// The number of the first step that `is_meant`, or 0.
template <typename IsMeant> std::size_t first_step(const Trace& trace, IsMeant&& is_meant) {
    for (std::size_t n = 1; n <= trace.size(); ++n)
        if (is_meant(n))
            return n;
    return 0;
}

/// The names of the kinds of step in a trace, each once.
std::vector<std::string> kinds_in(const Trace& trace) {
    std::vector<std::string> kinds;
    std::unordered_set<std::string> seen;
    for (std::size_t n = 1; n <= trace.size(); ++n)
        if (const auto [kind, is_new] = seen.insert(trace.step(n).kind_name()); is_new)
            kinds.push_back(*kind);
    return kinds;
}

/// A problem at a place of a selector's text, which is one line and needs no number.
Problem problem_in(const Source& source, std::size_t offset, std::string message,
                   std::string hint = {}) {
    Problem problem = problem_at(source, offset, std::move(message), std::move(hint));
    problem.line = 0;
    return problem;
}

/// Reads one selector, word by word; the first fault is thrown as a Problem.
class SelectorReader {
public:
    SelectorReader(Source source, const Trace& trace) : trace_(trace) {
        selector_.source = std::move(source);
    }

    Selector read() {
        const std::string_view word = next_word();
        if (word.empty())
            fail("expected a step (N, first, last, or KIND field=value ...), found nothing");
        if (word == "first" || word == "last" || word.front() == '-' ||
            number_text::is_digit(word.front())) {
            selector_.number = number_of(word);
            if (!next_word().empty())
                fail(fmt::format("expected nothing behind {}, found more", word));
            return std::move(selector_);
        }
        read_kind(word);
        for (auto next = next_word(); !next.empty(); next = next_word())
            read_condition(next);
        return std::move(selector_);
    }

private:
    [[noreturn]] void fail(std::string message, std::string hint = {}) const {
        fail_at(begin_, std::move(message), std::move(hint));
    }
    [[noreturn]] void fail_at(std::size_t offset, std::string message,
                              std::string hint = {}) const {
        throw problem_in(selector_.source, offset, std::move(message), std::move(hint));
    }

    /// Goes to the next word, which may have blanks between double quotes. "" behind the last.
    std::string_view next_word() {
        const std::string_view text = selector_.source.text;
        begin_ = std::min(text.find_first_not_of(blanks, end_), text.size());
        end_ = begin_;
        bool is_quoted = false;
        for (; end_ < text.size(); ++end_) {
            if (is_quoted && text[end_] == '\\')
                ++end_;
            else if (text[end_] == '"')
                is_quoted = !is_quoted;
            else if (!is_quoted && blanks.find(text[end_]) != std::string_view::npos)
                break;
        }
        end_ = std::min(end_, text.size());
        if (is_quoted)
            fail_at(text.find('"', begin_), "expected a closing quote, found none");
        return text.substr(begin_, end_ - begin_);
    }

    std::size_t number_of(std::string_view word) const {
        if (word == "first")
            return std::min<std::size_t>(1, trace_.size());
        if (word == "last")
            return trace_.size();
        std::size_t number = 0;
        const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
        if (read.ec != std::errc{} || read.ptr != word.data() + word.size() ||
            number > trace_.size())
            fail(fmt::format("expected a step from 0 to {}, found {}", trace_.size(), word));
        return number;
    }

    void read_kind(std::string_view word) {
        if (first_step(trace_, [&](std::size_t n) { return is_of_kind(trace_, n, word); }) == 0) {
            const std::vector<std::string> kinds = kinds_in(trace_);
            fail(fmt::format("expected a kind of step that the trace has ({}), found {}",
                             joined(kinds, ", "), word),
                 did_you_mean(word, {kinds.begin(), kinds.end()}));
        }
        selector_.kind = word;
        if (const auto kind = step_kind_named(word))
            fields_ = fields_of(*kind);
    }

    /// field=value, a word for the value of a boolean, or a value alone.
    void read_condition(std::string_view word) {
        const std::size_t equals = word.find('=');
        if (equals == std::string_view::npos)
            return read_word(word);
        const std::string_view field = word.substr(0, equals);
        const std::string_view value = word.substr(equals + 1);
        const std::optional<FieldType> type = type_of(field);
        if (value.empty())
            fail(fmt::format("expected {}=VALUE, found no value", field));
        add(field, value, type);
    }

    /// What was decided; a pixel, as X,Y; or a value of the field that steps of the kind are told apart by.
    void read_word(std::string_view word) {
        std::vector<std::string_view> known;
        for (const VerdictWord& verdict : verdict_words)
            for (const StepField& field : fields_)
                if (field.name == verdict.field && field.type == FieldType::boolean) {
                    if (verdict.word == word)
                        return add(verdict.field, verdict.value, FieldType::boolean);
                    known.push_back(verdict.word);
                }
        const auto is_key = [](const StepField& field) { return field.role == FieldRole::key; };
        const auto key = std::find_if(fields_.begin(), fields_.end(), is_key);
        const bool has_pixel = key != fields_.end() && key->name == "x";
        const std::size_t comma = word.find(',');
        if (has_pixel && comma != std::string_view::npos) {
            add("x", word.substr(0, comma), FieldType::whole);
            return add("y", word.substr(comma + 1), FieldType::whole);
        }
        const std::string hint = did_you_mean(word, known);
        if (!has_pixel && key != fields_.end() && hint.empty())
            return add(key->name, word, key->type);
        std::string expected = has_pixel ? "field=value or X,Y" : "field=value";
        for (const std::string_view other : known)
            expected += fmt::format(" or {}", other);
        fail(fmt::format("expected {}, found {}", expected, word), hint);
    }

    /// An edge is called by either name: BA, if the trace has no AB but that.
    void take_known_name(FieldCondition& edge) const {
        const std::string& name = edge.value;
        const std::size_t hyphen = name.find('-');
        const std::size_t first = std::min(hyphen, first_code_point(name).length);
        const std::string back = hyphen != std::string::npos
                                     ? name.substr(hyphen + 1) + "-" + name.substr(0, hyphen)
                                     : name.substr(first) + name.substr(0, first);
        const auto has = [&](const std::string& value) {
            return first_step(trace_, [&](std::size_t n) {
                       const auto json = is_of_kind(trace_, n, selector_.kind)
                                             ? trace_.step(n).field(edge.field)
                                             : std::nullopt;
                       return json && compared_text(*json) == value;
                   }) != 0;
        };
        if (!has(name) && has(back))
            edge.value = back;
    }

    /// Adds a condition. Fields that a foreign rasterizer has put in may be of any type.
    void add(std::string_view field, std::string_view value, std::optional<FieldType> type) {
        FieldCondition condition{.field = std::string(field),
                                 .value = compared_text(value),
                                 .number = {},
                                 .offset = begin_};
        if (field.ends_with("edge"))
            take_known_name(condition);
        if (!type || type == FieldType::whole || type == FieldType::quantity)
            condition.number = field_as_number(condition.value);
        if (type && !can_be(condition, *type))
            fail(fmt::format("expected {} for {}, found {}", in_words(*type), field, value));
        selector_.conditions.push_back(std::move(condition));
    }

    static bool can_be(const FieldCondition& condition, FieldType type) {
        const std::string_view value = condition.value;
        switch (type) {
        case FieldType::whole:
            return condition.number && condition.number->exact().get_den() == 1;
        case FieldType::quantity:
            return condition.number || value == "null" ||
                   is_not_finite(fmt::format("\"{}\"", value));
        case FieldType::boolean:
            return value == "true" || value == "false";
        case FieldType::list:
            return value.starts_with('[') && value.ends_with(']');
        case FieldType::string:
            break;
        }
        return true;
    }

    static std::string_view in_words(FieldType type) {
        switch (type) {
        case FieldType::whole:
            return "a whole number";
        case FieldType::quantity:
            return "a number, like 3.125 or 25/8,";
        case FieldType::boolean:
            return "true or false";
        case FieldType::list:
            return "a list, like [1,2],";
        case FieldType::string:
            break;
        }
        return "text";
    }

    /// What the steps of this kind have under that name; fails if they have nothing.
    std::optional<FieldType> type_of(std::string_view name) const {
        if (name == primitive_field)
            return FieldType::string;
        for (const StepField& field : fields_)
            if (field.name == name)
                return field.type;
        const std::size_t foreign = first_step(trace_, [&](std::size_t n) {
            return is_of_kind(trace_, n, selector_.kind) && trace_.step(n).field(name);
        });
        if (foreign != 0)
            return std::nullopt;
        std::vector<std::string_view> known;
        for (const StepField& field : fields_)
            known.push_back(field.name);
        known.push_back(primitive_field);
        fail(fmt::format("expected a field of {} ({}), found {}", selector_.kind,
                         joined(known, ", "), name),
             did_you_mean(name, known));
    }

    const Trace& trace_;
    Selector selector_;
    std::span<const StepField> fields_; ///< of the kind; none of a kind that we do not know
    std::size_t begin_ = 0;             ///< of the current word
    std::size_t end_ = 0;
};

/// What a step has to compare with a condition.
std::optional<std::string> value_for(const FieldCondition& condition, const Trace& trace,
                                     std::size_t n, std::size_t primitive) {
    if (condition.field == primitive_field)
        return primitive == 0 ? std::nullopt : std::optional(name_in(trace.step(primitive)).text());
    const auto json = trace.step(n).field(condition.field);
    return json ? std::optional(compared_text(*json)) : std::nullopt;
}

bool holds(const FieldCondition& condition, const std::optional<std::string>& value) {
    if (!value || *value == condition.value)
        return value.has_value();
    if (condition.field == primitive_field)
        return value->starts_with(condition.value + "/");
    const auto number = condition.number ? field_as_number(*value) : std::nullopt;
    return number && number->exact() == condition.number->exact();
}

/// Calls `take` with every step that is meant, and its primitive.
template <typename Take>
void for_each_match(const Selector& selector, const Trace& trace, Take&& take) {
    std::size_t primitive = 0;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        if (trace.kind_of(n) == StepKind::primitive)
            primitive = n;
        if (matches(selector, trace, n, primitive))
            take(n, primitive);
    }
}

std::vector<std::size_t> all_matches(const Selector& selector, const Trace& trace) {
    std::vector<std::size_t> steps;
    if (selector.number)
        steps.push_back(*selector.number);
    else
        for_each_match(selector, trace, [&](std::size_t n, std::size_t) { steps.push_back(n); });
    return steps;
}

/// "5, 4, 3, ...": the first few of a list.
std::string some_of(const std::vector<std::string>& list) {
    const std::span all(list);
    return joined(all.first(std::min(all.size(), most_named)), ", ") +
           (all.size() > most_named ? ", ..." : "");
}

/// The values that a field has in the steps that `selector` means, nearest to the condition first.
std::vector<std::string> values_near(const FieldCondition& condition, const Selector& selector,
                                     const Trace& trace) {
    std::vector<std::string> values;
    std::unordered_set<std::string> seen;
    for_each_match(selector, trace, [&](std::size_t n, std::size_t primitive) {
        if (const auto value = value_for(condition, trace, n, primitive))
            if (seen.insert(*value).second)
                values.push_back(*value);
    });
    if (!condition.number) {
        const auto nearest = nearest_word(condition.value, {values.begin(), values.end()});
        const auto place = std::find(values.begin(), values.end(), nearest);
        if (place != values.end())
            std::rotate(values.begin(), place, place + 1);
        return values;
    }

    std::vector<std::pair<mpq_class, std::string>> by_distance;
    for (std::string& value : values)
        if (const auto number = field_as_number(value))
            by_distance.emplace_back(abs(number->exact() - condition.number->exact()),
                                     std::move(value));
    std::stable_sort(by_distance.begin(), by_distance.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    values.clear();
    for (auto& [distance, value] : by_distance)
        values.push_back(std::move(value));
    return values;
}

/// Why there is no step that meets all conditions: the first of them that leaves none.
Problem nothing_matches(const Selector& selector, const Trace& trace) {
    Selector met = selector;
    met.conditions.clear();
    for (const FieldCondition& condition : selector.conditions) {
        Selector next = met;
        next.conditions.push_back(condition);
        if (!all_matches(next, trace).empty()) {
            met = std::move(next);
            continue;
        }
        const std::string_view before =
            std::string_view(selector.source.text).substr(0, condition.offset);
        const std::string_view subject = before.substr(0, before.find_last_not_of(blanks) + 1);
        const std::vector<std::string> near = values_near(condition, met, trace);
        std::string hint =
            near.empty() ? fmt::format("no {} has {}", subject, condition.field)
                         : fmt::format("{} has {}: {}", subject, condition.field, some_of(near));
        return problem_in(selector.source, condition.offset,
                          fmt::format("expected a step of the trace, found none with {}={}",
                                      condition.field, condition.value),
                          std::move(hint));
    }
    return problem_in(selector.source, 0, "expected a step of the trace, found none");
}

} // namespace

Result<Selector> parse_selector(Source source, const Trace& trace) {
    try {
        return SelectorReader(std::move(source), trace).read();
    } catch (const Problem& problem) {
        return problem;
    }
}

bool matches(const Selector& selector, const Trace& trace, std::size_t n, std::size_t primitive) {
    if (selector.number)
        return n == *selector.number;
    return is_of_kind(trace, n, selector.kind) &&
           std::all_of(selector.conditions.begin(), selector.conditions.end(),
                       [&](const FieldCondition& condition) {
                           return holds(condition, value_for(condition, trace, n, primitive));
                       });
}

Result<std::vector<std::size_t>> matching_steps(const Selector& selector, const Trace& trace) {
    std::vector<std::size_t> steps = all_matches(selector, trace);
    if (steps.empty())
        return nothing_matches(selector, trace);
    return steps;
}

Result<std::size_t> matching_step(const Selector& selector, const Trace& trace, std::string hint) {
    const auto steps = matching_steps(selector, trace);
    if (!steps)
        return steps.problem();
    if (const std::size_t count = steps.value().size(); count > 1) {
        // By the names of their primitives too, if they are not all of one.
        std::vector<std::string> numbers;
        std::vector<std::string> named;
        std::unordered_set<std::string> names;
        for_each_match(selector, trace, [&](std::size_t n, std::size_t primitive) {
            if (named.size() > most_named)
                return;
            const std::string name = primitive == 0 ? "" : name_in(trace.step(primitive)).text();
            names.insert(name);
            numbers.push_back(std::to_string(n));
            named.push_back(name.empty() ? numbers.back() : fmt::format("{} of {}", n, name));
        });
        return problem_in(selector.source, 0,
                          fmt::format("expected one step, found {}: {}", count,
                                      some_of(names.size() > 1 ? named : numbers)),
                          std::move(hint));
    }
    return steps.value().front();
}

} // namespace rastertrace
