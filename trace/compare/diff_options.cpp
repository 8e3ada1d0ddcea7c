// SPDX-License-Identifier: MIT
#include "diff_options.h"

#include <rastertrace/trace/record/step_kind.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

namespace rastertrace {

namespace {

constexpr std::string_view header_name = "header";
constexpr std::string_view end_name = "end";

/// True if some step of the traces is as `is_meant` says.
template <typename IsMeant>
bool have_step(const Trace& a, const Trace& b, const IsMeant& is_meant) {
    for (const Trace* const trace : {&a, &b})
        for (std::size_t n = 1; n <= trace->size(); ++n)
            if (is_meant(trace->step(n)))
                return true;
    return false;
}

bool have_kind(const Trace& a, const Trace& b, std::string_view kind) {
    return have_step(a, b, [kind](const StepView& step) { return step.kind_name() == kind; });
}
bool have_field(const Trace& a, const Trace& b, std::string_view field) {
    return have_step(a, b, [field](const StepView& step) { return step.field(field).has_value(); });
}

/// What is wrong with a field of a kind that we know, for an option: it is a key, which steps are found by, or no
/// number; "" if nothing is. (Primitives are found by their places, too.)
std::string_view fault_of_field(std::string_view option, StepKind kind, std::string_view name) {
    for (const StepField& field : fields_of(kind)) {
        if (field.name != name)
            continue;
        if (field.role == FieldRole::key && kind != StepKind::primitive)
            return "steps are found by it";
        if (option == "--tolerance" && field.element != FieldType::whole &&
            field.element != FieldType::quantity)
            return "it is no number";
    }
    return "";
}

/// One name of an option, `scanline` or `scanline.left`.
void check_name(std::string_view option, std::string_view kind, std::string_view field,
                const Trace& a, const Trace& b) {
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
        for (const StepField& one : fields_of(*known))
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

void add_step_key(DiffOptions& options, const std::string& text) {
    const std::size_t equals = text.find('=');
    const std::string kind = text.substr(0, equals);
    std::vector<std::string> fields;
    if (equals != std::string::npos)
        fields = split_at(text.substr(equals + 1), ',');
    if (kind.empty() || fields.empty() ||
        std::find(fields.begin(), fields.end(), "") != fields.end())
        throw problem_of(
            "", fmt::format("--key: expected KIND=FIELD,..., like tile=tx,ty, found \"{}\"",
                            printable(text)));
    if (step_kind_named(kind))
        throw problem_of("", fmt::format("--key: expected a kind of step of your own, found {}, "
                                         "whose steps are found by fields of their own",
                                         kind));
    options.keys[kind] = std::move(fields);
}

void check_names(const DiffOptions& options, const Trace& a, const Trace& b) {
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
