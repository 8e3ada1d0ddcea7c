// SPDX-License-Identifier: MIT
#include "exercise_options.h"

#include "load.h"
#include "option_values.h"

#include <rastertrace/trace/exercise/exercise_kinds.h>

namespace rastertrace {

namespace {

std::vector<std::string> kinds() {
    std::vector<std::string> names;
    for (const ExerciseKind& kind : exercise_kinds)
        names.emplace_back(kind.name);
    return names;
}

auto find_kind(const std::string& name) {
    return std::ranges::find(exercise_kinds, name, &ExerciseKind::name);
}

} // namespace

void ExerciseOptions::add_to(OptionList& options, bool is_required) {
    OptionList model = options.one_of("What exercises are like", "One of these", is_required);
    model.option("--like", like_, "A scene", "SCENE");
    model.option("--kind", kind_, "A scene of ours", "NAME").values(kinds());
}

void ExerciseOptions::read() const {
    if (!kind_.empty() && find_kind(kind_) == exercise_kinds.end())
        refuse_value("--kind", "one out of " + joined(kinds(), ", "), kind_);
}

Source ExerciseOptions::scene() const {
    return kind_.empty() ? load_scene_source(like_)
                         : Source{kind_ + ".json", std::string(find_kind(kind_)->scene)};
}

} // namespace rastertrace
