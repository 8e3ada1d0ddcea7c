// SPDX-License-Identifier: MIT
#include "diff_fields.h"

#include "json_scanner.h"
#include "step_text.h"

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/trace/color_text.h>
#include <rastertrace/trace/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <variant>

namespace rastertrace {

namespace {

constexpr std::string_view header_name = "header";
constexpr std::string_view end_name = "end";

/// The distance from a number to the next larger one that its type has.
template <typename Float> Rational ulp_of(const Rational& number) {
    const auto value = static_cast<Float>(std::abs(nearest_double(number)));
    const Float next = std::nextafter(value, std::numeric_limits<Float>::infinity());
    return std::isfinite(next) ? Rational(static_cast<double>(next) - static_cast<double>(value))
                               : Rational(0);
}

/// What two values have to be compared by.
struct Comparison {
    std::optional<FieldType> type; ///< none: a field that we do not know
    bool is_color = false;
    const DiffTolerance* tolerance = nullptr;
    bool has_floats = false;
};

bool is_color(std::string_view name) {
    return name == "color" || name == "colors" || name == "background";
}

/// How two values differ; nothing if they are alike.
struct ValueDifference {
    std::optional<double> distance{};
};
using Differs = std::optional<ValueDifference>;

/// The number that a decimal stands for: the nearest one of its type, if that has one. A fraction in quotes is that
/// number.
Rational as_stored(const Rational& number, std::string_view json, bool is_float) {
    const double nearest = nearest_double(number);
    const double stored = is_float ? static_cast<double>(static_cast<float>(nearest)) : nearest;
    return json.starts_with('"') || !std::isfinite(stored) ? number : Rational(stored);
}

bool is_within(const DiffTolerance& tolerance, const Rational& a, const Rational& b) {
    return abs(a - b) <= tolerance.amount.exact();
}

/// True if two numbers are at most so many ulps apart, as the scalar has them.
bool is_within_ulps(const DiffTolerance& tolerance, const Rational& a, const Rational& b,
                    bool is_float) {
    const Rational larger = std::max<Rational>(abs(a), abs(b));
    const Rational ulp = is_float ? ulp_of<float>(larger) : ulp_of<double>(larger);
    return abs(a - b) <= tolerance.amount.exact() * ulp;
}

Differs differ_as_numbers(std::string_view json_a, const Rational& a, std::string_view json_b,
                          const Rational& b, const Comparison& by) {
    if (a == b)
        return std::nullopt;
    if (by.tolerance != nullptr && by.tolerance->is_ulps &&
        is_within_ulps(*by.tolerance, as_stored(a, json_a, by.has_floats),
                       as_stored(b, json_b, by.has_floats), by.has_floats))
        return std::nullopt;
    if (by.tolerance != nullptr && !by.tolerance->is_ulps && is_within(*by.tolerance, a, b))
        return std::nullopt;
    const double distance = nearest_double(Rational(abs(a - b)));
    return std::isfinite(distance) ? ValueDifference{distance} : ValueDifference{};
}

Differs differ(std::string_view a, std::string_view b, const Comparison& by);

Differs differ_as_lists(std::string_view a, std::string_view b, const Comparison& by) {
    JsonScanner in_a(a);
    JsonScanner in_b(b);
    Differs found;
    for (;;) {
        const bool has_a = in_a.next_element();
        const bool has_b = in_b.next_element();
        if (has_a != has_b)
            return ValueDifference{};
        if (!has_a)
            return found;
        const Differs here = differ(in_a.value(), in_b.value(), by);
        if (!here)
            continue;
        if (!found)
            found = here;
        else if (!here->distance || !found->distance)
            found->distance.reset();
        else
            found->distance = std::max(*found->distance, *here->distance);
    }
}

Differs differ(std::string_view a, std::string_view b, const Comparison& by) {
    if (a == b)
        return std::nullopt;
    if (a.starts_with('[') && b.starts_with('['))
        return differ_as_lists(a, b, by);
    const bool is_number = by.type ? by.type == FieldType::whole || by.type == FieldType::quantity
                                   : !a.starts_with('"') && !b.starts_with('"');
    const std::string text_a = plain_text(a);
    const std::string text_b = plain_text(b);
    if (is_number) {
        const auto number_a = number_in(text_a);
        const auto number_b = number_in(text_b);
        if (number_a && number_b)
            return differ_as_numbers(a, *number_a, b, *number_b, by);
    }
    const auto color_a = by.is_color ? parse_color(text_a) : std::nullopt;
    const auto color_b = by.is_color ? parse_color(text_b) : std::nullopt;
    const bool are_alike = (text_a == text_b && a.starts_with('"') == b.starts_with('"')) ||
                           (color_a && color_a == color_b);
    return are_alike ? std::nullopt : Differs(ValueDifference{});
}

using Field = std::pair<std::string, std::string_view>;

std::vector<Field> fields_in(std::string_view json) {
    std::vector<Field> fields;
    JsonScanner scanner(json);
    while (scanner.next_field())
        if (scanner.key() != "step")
            fields.emplace_back(plain_text(fmt::format("\"{}\"", scanner.key())), scanner.value());
    return fields;
}

std::optional<std::string_view> value_in(const std::vector<Field>& fields, std::string_view name) {
    for (const auto& [key, value] : fields)
        if (key == name)
            return value;
    return std::nullopt;
}

/// The type of a field; of a list, that of its elements.
std::optional<FieldType> type_of(std::optional<StepKind> kind, std::string_view name) {
    if (!kind)
        return std::nullopt;
    for (const StepField& field : row_of(*kind).fields)
        if (field.name == name)
            return field.type == FieldType::list ? element_type_of(field) : field.type;
    return std::nullopt;
}

/// The last tolerance that is about a field.
const DiffTolerance* tolerance_for(const std::vector<DiffTolerance>& tolerances,
                                   std::string_view kind, std::string_view field) {
    const DiffTolerance* last = nullptr;
    for (const DiffTolerance& one : tolerances)
        if ((one.kind.empty() || one.kind == kind) && (one.field.empty() || one.field == field))
            last = &one;
    return last;
}

/// The keys of a header: those of objects in it with a dot, those of stages by their names.
void flatten(std::map<std::string, std::string>& keys, std::vector<std::string>& order,
             const std::string& name, std::string_view value) {
    if (value.starts_with('{')) {
        JsonScanner fields(value);
        while (fields.next_field())
            flatten(keys, order, name + "." + std::string(fields.key()), fields.value());
        return;
    }
    if (name == "stages" && value.starts_with('[')) {
        JsonScanner stages(value);
        while (stages.next_element()) {
            const StepView stage(stages.value());
            const std::string plane = stage.text("plane");
            const std::string key =
                name + "." + stage.text("stage") + (plane.empty() ? "" : "." + plane);
            if (keys.emplace(key, stages.value()).second)
                order.push_back(key);
        }
        return;
    }
    if (keys.emplace(name, value).second)
        order.push_back(name);
}

struct FlatHeader {
    std::map<std::string, std::string> values;
    std::vector<std::string> order;

    explicit FlatHeader(std::string_view json) {
        JsonScanner fields(json);
        while (fields.next_field()) {
            const std::string_view key = fields.key();
            if (key != "steps" && key != "only" && key != "region" && key != "primitive")
                flatten(values, order, std::string(key), fields.value());
        }
    }

    std::string value(const std::string& key) const {
        const auto found = values.find(key);
        return found == values.end() ? std::string() : found->second;
    }
};

/// True if a trace has a text somewhere behind its header.
bool mentions(const TraceText& text, const std::string& wanted) {
    std::string block;
    std::size_t offset = text.begin();
    constexpr std::size_t size = 1 << 20;
    for (;;) {
        // It may begin in one block and end in the next.
        const std::size_t kept = std::min(block.size(), wanted.size());
        block.erase(0, block.size() - kept);
        block.resize(kept + size);
        const std::size_t count = text.read(offset, std::span(block).subspan(kept));
        block.resize(kept + count);
        if (block.find(wanted) != std::string::npos)
            return true;
        if (count == 0)
            return false;
        offset += count;
    }
}

/// True if a step of one of the traces is of this kind, or has this field.
bool have_kind(const TraceText& a, const TraceText& b, std::string_view kind) {
    for (const TraceText* const text : {&a, &b})
        for (const std::string_view blank : {"", " "})
            if (mentions(*text, fmt::format(R"("step":{}"{}")", blank, kind)))
                return true;
    return false;
}
bool have_field(const TraceText& a, const TraceText& b, std::string_view field) {
    const std::string key = fmt::format(R"("{}":)", field);
    return mentions(a, key) || mentions(b, key);
}

/// What is wrong with a field of a kind that we know, for an option: it is a key, which steps are found by, or no
/// number; "" if nothing is.
std::string_view fault_of_field(std::string_view option, StepKind kind, std::string_view name) {
    for (const StepField& field : row_of(kind).fields) {
        if (field.name != name)
            continue;
        const FieldType type = field.type == FieldType::list ? element_type_of(field) : field.type;
        if (field.role == FieldRole::key)
            return "steps are found by it";
        if (option == "--tolerance" && type != FieldType::whole && type != FieldType::quantity)
            return "it is no number";
    }
    return "";
}

/// One name of an option, `scanline` or `scanline.left`.
void check_name(std::string_view option, std::string_view kind, std::string_view field,
                const TraceText& a, const TraceText& b) {
    const auto known = step_kind_named(kind);
    if (!known && !have_kind(a, b, kind)) {
        std::vector<std::string_view> names = step_kind_names();
        if (option == "--ignore") {
            names.push_back(header_name);
            names.push_back(end_name);
        }
        throw problem_of("",
                         fmt::format("{}: expected a kind of step ({}), or one that a trace has, "
                                     "found {}",
                                     option, joined(names, ", "), printable(kind)),
                         did_you_mean(kind, names));
    }
    if (field.empty())
        return;
    std::vector<std::string_view> names;
    if (known)
        for (const StepField& one : row_of(*known).fields)
            names.push_back(one.name);
    const bool is_known = std::find(names.begin(), names.end(), field) != names.end();
    if (!is_known && !have_field(a, b, field))
        throw problem_of("",
                         fmt::format("{}: expected a field of {}{}, found {}", option, kind,
                                     names.empty() ? "" : " (" + joined(names, ", ") + ")",
                                     printable(field)),
                         did_you_mean(field, names));
    const std::string_view fault = known ? fault_of_field(option, *known, field) : "";
    if (!fault.empty())
        throw problem_of("", fmt::format("{}: expected another field than {} of {}: {}", option,
                                         field, kind, fault));
}

std::pair<std::string, std::string> kind_and_field(const std::string& name) {
    const std::size_t dot = name.find('.');
    return dot == std::string::npos ? std::pair(name, std::string())
                                    : std::pair(name.substr(0, dot), name.substr(dot + 1));
}

} // namespace

std::vector<FieldDifference> FieldComparison::differing(const StepLine& a,
                                                        const StepLine& b) const {
    std::vector<FieldDifference> differences;
    if (a.json == b.json)
        return differences;
    const std::vector<Field> of_a = fields_in(a.json);
    const std::vector<Field> of_b = fields_in(b.json);
    const auto is_compared = [&](std::string_view name) {
        return !is_ignored(fmt::format("{}.{}", a.kind_name, name));
    };
    for (const auto& [name, value] : of_a) {
        const auto other = value_in(of_b, name);
        if (!is_compared(name))
            continue;
        if (!other) {
            differences.push_back({.name = std::string(name), .a = std::string(value)});
            continue;
        }
        const Comparison by{.type = type_of(a.kind, name),
                            .is_color = is_color(name),
                            .tolerance = tolerance_for(options_.tolerances, a.kind_name, name),
                            .has_floats = has_floats_};
        if (const Differs here = differ(value, *other, by))
            differences.push_back({.name = std::string(name),
                                   .a = std::string(value),
                                   .b = std::string(*other),
                                   .distance = here->distance});
    }
    for (const auto& [name, value] : of_b)
        if (!value_in(of_a, name) && is_compared(name))
            differences.push_back({.name = std::string(name), .b = std::string(value)});
    return differences;
}

bool FieldComparison::is_ignored(std::string_view name) const {
    return std::find(options_.ignored.begin(), options_.ignored.end(), name) !=
           options_.ignored.end();
}

std::vector<FieldDifference> differing_keys(std::string_view header_a, std::string_view header_b) {
    const FlatHeader a(header_a);
    const FlatHeader b(header_b);
    const auto are_alike = [&](const std::string& key) {
        const std::string in_a = a.value(key);
        const std::string in_b = b.value(key);
        if (in_a.empty() || in_b.empty())
            return in_a == in_b;
        if (!in_a.starts_with('{') || !in_b.starts_with('{'))
            return !differ(in_a, in_b, {.type = {}, .is_color = is_color(key)});
        const StepView stage_a(in_a);
        const StepView stage_b(in_b);
        return stage_a.text("kept") == stage_b.text("kept") &&
               stage_a.text("why") == stage_b.text("why");
    };
    std::vector<FieldDifference> differences;
    for (const std::string& key : a.order)
        if (!are_alike(key))
            differences.push_back({.name = key, .a = a.value(key), .b = b.value(key)});
    for (const std::string& key : b.order)
        if (a.value(key).empty())
            differences.push_back({.name = key, .b = b.value(key)});
    return differences;
}

DiffTolerance parse_tolerance(const std::string& text) {
    constexpr std::string_view unit = "ulp";
    const std::size_t equals = text.find('=');
    DiffTolerance tolerance;
    if (equals != std::string::npos)
        std::tie(tolerance.kind, tolerance.field) = kind_and_field(text.substr(0, equals));
    std::string amount = equals == std::string::npos ? text : text.substr(equals + 1);
    tolerance.is_ulps = amount.ends_with(unit);
    if (tolerance.is_ulps)
        amount.resize(amount.size() - unit.size());
    auto parsed = parse_number(amount);
    auto* const number = std::get_if<Number>(&parsed);
    const bool has_names =
        equals == std::string::npos || (!tolerance.kind.empty() && text[equals - 1] != '.');
    if (number == nullptr || number->exact() < 0 || !has_names)
        throw problem_of(
            "", fmt::format("--tolerance: expected KIND.FIELD=NUMBER, KIND=NUMBER or NUMBER, like "
                            "scanline.left=1e-9 or 4ulp, found \"{}\"",
                            printable(text)));
    tolerance.amount = std::move(*number);
    return tolerance;
}

void check_names(const DiffOptions& options, const TraceText& a, const TraceText& b) {
    for (const DiffTolerance& one : options.tolerances)
        if (!one.kind.empty())
            check_name("--tolerance", one.kind, one.field, a, b);
    for (const std::string& name : options.ignored) {
        const auto [kind, field] = kind_and_field(name);
        if (name != header_name && name != end_name)
            check_name("--ignore", kind, field, a, b);
    }
    for (const std::string& kind : options.only)
        check_name("--only", kind, "", a, b);
}

} // namespace rastertrace
