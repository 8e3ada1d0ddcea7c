// SPDX-License-Identifier: MIT
#pragma once

// Where the samples of pixels lie, as the header of a trace says.
//
//     const ToldSamples samples = told_samples(trace);
//     samples.triangles.sample_of({3, 4});  // (7/2, 9/2)

#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/traced_steps.h>

#include <rastertrace/core/numbers/rational.h>
#include <rastertrace/core/raster/sample_offset.h>

namespace rastertrace {

/// From the integer point of a pixel to its sample.
struct ToldSamples {
    SampleOffset<Rational> triangles;
    SampleOffset<Rational> lines;  ///< and of the sides of outlines
    SampleOffset<Rational> others; ///< of primitives that are SampledBy::itself

    /// Those of a primitive; of a kind that is not ours, those of triangles.
    const SampleOffset<Rational>& of(const TracedWord<PrimitiveKind>& kind) const;
};

/// The samples of a trace. One that does not say where they are has them at the integer points.
ToldSamples told_samples(const Trace& trace);

/// True if a pixel is the square from its integer point to the next one, in x and in y; else that point is
/// in its middle.
bool pixels_begin_at_integers(const Trace& trace);

} // namespace rastertrace
