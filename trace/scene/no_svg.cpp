// SPDX-License-Identifier: MIT
// In place of svg_text.cpp, where there is no expat: in the module for pages.
#include "svg_text.h"

namespace rastertrace {

Result<Source> scene_of_svg(const Source& source) {
    return problem_of(source.name, "expected a scene in JSON, found SVG",
                      "rastertrace scene FILE makes a scene of it");
}

} // namespace rastertrace
