// SPDX-License-Identifier: MIT
#include "unknown_names.h"

#include <rastertrace/trace/record/traced_steps.h>

#include <rastertrace/trace/text/json_scanner.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace rastertrace {

namespace {

/// `kinds of step that ...: wobble (2), wave (1)`; nothing if there are none.
void tell(const std::map<std::string, std::uint64_t>& counts, std::string_view what,
          std::vector<std::string>& remarks) {
    constexpr std::size_t most_listed = 8;
    std::vector<std::string> listed;
    for (const auto& [name, count] : counts)
        if (listed.size() < most_listed)
            listed.push_back(fmt::format("{} ({})", shortened(printable(name), 40), count));
    if (counts.size() > most_listed)
        listed.emplace_back("...");
    if (!listed.empty())
        remarks.push_back(fmt::format("{}: {}", what, joined(listed, ", ")));
}

} // namespace

bool is_foreign(const StepView& step) {
    const auto kind = step.field("step");
    return kind && kind->starts_with('"') && !step_kind_named(step.kind_name());
}

void UnknownNames::add(const StepView& step, std::optional<StepKind> kind) {
    if (!kind) {
        if (is_foreign(step))
            ++kinds_[step.kind_name()];
        return;
    }
    const auto known = fields_of(*kind);
    JsonScanner fields(step.own_text());
    while (fields.next_field()) {
        const auto is_field = [&fields](const StepField& field) {
            return field.name == fields.key();
        };
        if (fields.key() != "step" && fields.key() != key_of_code &&
            std::none_of(known.begin(), known.end(), is_field))
            ++fields_[fmt::format("{}.{}", name_of(*kind), fields.key())];
    }
}

std::vector<std::string> UnknownNames::remarks() const {
    std::vector<std::string> remarks;
    tell(kinds_, "kinds of step that this program does not know", remarks);
    tell(fields_, "fields that steps of these kinds do not have", remarks);
    return remarks;
}

} // namespace rastertrace
