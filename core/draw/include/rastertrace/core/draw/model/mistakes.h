// SPDX-License-Identifier: MIT
#pragma once

// The known mistakes of rasterizers, one table: those of the texts that the project grew from, and those
// that were met in the field. Each can be put into the model; one that draws just what a setting draws
// is that setting.
//
//     ModelRules rules(scene);
//     find_mistake("dx-dy-inverted")->put_in(rules);
//     draw_by(rules);

#include <rastertrace/core/draw/model/model.h>

#include <span>
#include <string_view>
#include <vector>

namespace rastertrace {

struct Mistake {
    std::string_view name;    ///< "dx-dy-inverted"
    std::string_view says;    ///< the formula with the mistake in it
    std::string_view should;  ///< the right one; "" if the mistake is a rule that is as good
    std::string_view step;    ///< the kind of step that it changes
    std::string_view symptom; ///< what is seen of it in the picture
    std::string_view source;
    bool (*concerns)(const Scene& scene); ///< false of scenes that it never changes
    void (*put_in)(ModelRules& rules);
    std::string_view setting = {}; ///< "rounding=truncate": draws the same, without the model

    /// True if it is a rule of another program, and no mistake.
    bool is_rule() const { return should.empty(); }
};

/// All of them.
std::span<const Mistake> mistakes();

/// The mistake of that name, or nullptr.
const Mistake* find_mistake(std::string_view name);

/// Those of a scene's method that the model makes in it: no setting, and none in what the scene does not have.
std::vector<const Mistake*> modelled_mistakes(const Scene& scene);

} // namespace rastertrace
