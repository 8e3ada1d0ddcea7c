// SPDX-License-Identifier: MIT
// Exercises of each kind, for some seeds: compiled by two compilers, they must be the same.

#include "exercise_scenes.h"

#include <rastertrace/trace/check/exercise.h>

#include <cstdio>
#include <string>

int main() {
    using namespace rastertrace;
    for (const ExerciseScene& like : exercise_scenes) {
        const ExerciseMaker exercise =
            exercises_like({std::string(like.name) + ".json", std::string(like.text)});
        for (int seed = 1; seed <= 2; ++seed)
            std::fputs(exercise("1:" + std::to_string(seed)).text.c_str(), stdout);
    }
    return 0;
}
