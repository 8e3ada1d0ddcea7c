// SPDX-License-Identifier: MIT
#pragma once

// What a claim is about where its line alone does not tell: what has the name does. AB: 3/4 is the slope of an edge, or
// Bresenham's d of a line; A = (2, 5) is a vertex.

#include "claim_subject.h"
#include "claims.h"

namespace rastertrace {

/// The claim with the step and the fields that it is meant to have. Throws a Problem that points at a vertex which is in
/// several spaces.
Claim as_meant(Claim claim, const Claims& claims, const TruthIndex& truth);

/// Where a vertex is snapped, whole numbers are its pixel. The subject's fields are those of the claim.
void name_snapped_place(Claim& claim, const Subject& subject);

} // namespace rastertrace
