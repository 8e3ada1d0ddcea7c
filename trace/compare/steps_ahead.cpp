// SPDX-License-Identifier: MIT
#include "steps_ahead.h"

#include <rastertrace/trace/record/field_type.h>
#include <rastertrace/trace/text/json_scanner.h>

#include <string_view>

namespace rastertrace {

namespace {

/// A field of a key: a whole number as such, anything else as what it says.
void add_key(std::string& key, std::string_view name, std::string_view json) {
    const auto number = whole_in(json);
    key.append(" ").append(name).append("=");
    key += number ? std::to_string(*number) : plain_text(json);
}

std::string key_of(const KeyedStep& keyed, const StepKeys& keys) {
    std::string key = keyed.kind_name;
    const StepView step = keyed.view();
    if (keyed.kind) {
        for (const StepField& field : fields_of(*keyed.kind))
            if (field.role == FieldRole::key)
                if (const auto json = step.field(field.name))
                    add_key(key, field.name, *json);
        return key;
    }
    // Of a kind that we do not know: what it was said to have, or what other kinds have.
    static const std::vector<std::string> usual{"name", "x", "y"};
    const auto own = keys.find(keyed.kind_name);
    for (const std::string& name : own == keys.end() ? usual : own->second)
        if (const auto json = step.field(name))
            add_key(key, name, *json);
    return key;
}

} // namespace

const KeyedStep* StepsAhead::at(std::size_t i) {
    while (ahead_.size() <= i && next_ + ahead_.size() <= last_) {
        const std::size_t n = next_ + ahead_.size();
        KeyedStep step{.trace = &trace_, .number = n, .kind = trace_.kind_of(n)};
        step.kind_name = step.kind ? std::string(name_of(*step.kind)) : trace_.step(n).kind_name();
        step.key = key_of(step, keys_);
        ahead_.push_back(std::move(step));
    }
    return i < ahead_.size() ? &ahead_[i] : nullptr;
}

} // namespace rastertrace
