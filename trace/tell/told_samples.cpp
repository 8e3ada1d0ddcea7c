// SPDX-License-Identifier: MIT
#include "told_samples.h"

namespace rastertrace {

const SampleOffset<Rational>& ToldSamples::of(const TracedWord<PrimitiveKind>& kind) const {
    const auto traits = traits_of(kind);
    const SampledBy whose = traits ? traits->samples : SampledBy::fill;
    return whose == SampledBy::line ? lines : whose == SampledBy::itself ? others : triangles;
}

ToldSamples told_samples(const Trace& trace) {
    const auto samples_by = [](const Method& method) {
        const Rational offset = offset_of(sample_of_others(method)).exact();
        return SampleOffset<Rational>(offset, offset);
    };
    const auto others = samples_by(trace.method.others);
    const auto triangles = samples_by(trace.method.triangles);
    const bool has_diamonds = traits_of(trace.method.others.line).rule == LineRule::diamonds;
    return {triangles, has_diamonds ? triangles : others, others};
}

bool pixels_begin_at_integers(const Trace& trace) {
    return trace.method.triangles.sample == Sample::center;
}

} // namespace rastertrace
