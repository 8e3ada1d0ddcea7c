// SPDX-License-Identifier: MIT
#include "redo_exact.h"

#include "redo_steps.h"

namespace rastertrace {

Redone redo_in_rationals(const Trace& trace, bool knows_all_numbers, StepsToRedo steps) {
    return knows_all_numbers ? redo_steps::Redo<Rational, Rational, true>(trace, steps).run()
                             : redo_steps::Redo<Rational, Rational, false>(trace, steps).run();
}

Redone redo_with_double_depths(const Trace& trace) {
    return redo_steps::Redo<Rational, double, true>(trace).run();
}

} // namespace rastertrace
