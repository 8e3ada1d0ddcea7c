// SPDX-License-Identifier: MIT
#pragma once

// Two headers, key by key.
//
//     differing_keys(a.header_json(), b.header_json());  // {{.name = "method.scalar", ...}}

#include "diff.h"

#include <rastertrace/trace/record/traced_steps.h>

#include <string_view>
#include <vector>

namespace rastertrace {

/// The keys of two headers that are not alike; an object's as `canvas.width`, a stage's as `stages.clip`. Which steps
/// were left out (`only`, `region`, `primitive`) is none of them.
std::vector<FieldDifference> differing_keys(std::string_view header_a, std::string_view header_b);

/// What a header says of a stage, by the key: `stage`, `plane`, `kept` or `why`. Valid as long as the stage's JSON.
TracedText value_of_stage(std::string_view stage, std::string_view key);

} // namespace rastertrace
