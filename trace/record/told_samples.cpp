// SPDX-License-Identifier: MIT
#include "told_samples.h"

#include <rastertrace/trace/text/method_names.h>

namespace rastertrace {

const SampleOffset<Rational>& ToldSamples::of(const TracedWord<PrimitiveKind>& kind) const {
    if (kind == PrimitiveKind::line || kind == PrimitiveKind::outline)
        return lines;
    const bool is_other = kind == PrimitiveKind::polygon || kind == PrimitiveKind::circle ||
                          kind == PrimitiveKind::point;
    return is_other ? others : triangles;
}

ToldSamples told_samples(const Trace& trace) {
    const ToldMethod told = told_method(trace.method);
    const Sample of_triangles = told.triangles.sample.value_or(Sample::integer);
    const Sample of_others = told.others.sample.value_or(Sample::integer);
    const bool has_diamonds =
        told.keys.contains("line") && traits_of(told.others.line).rule == LineRule::diamonds;
    const auto samples_at = [](Sample sample) {
        const Rational offset = offset_of(sample).exact();
        return SampleOffset<Rational>(offset, offset);
    };
    const auto others = samples_at(of_others);
    const auto triangles = samples_at(of_triangles);
    return {triangles, has_diamonds ? triangles : others, others};
}

bool pixels_begin_at_integers(const Trace& trace) {
    return told_method(trace.method).triangles.sample.value_or(Sample::integer) != Sample::integer;
}

} // namespace rastertrace
