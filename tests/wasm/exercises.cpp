// SPDX-License-Identifier: MIT
// Exercises of each kind, for some seeds: compiled by two compilers, they must be the same.

#include <rastertrace/trace/exercise/exercise.h>
#include <rastertrace/trace/exercise/exercise_kinds.h>

#include <cstdio>
#include <string>

int main() {
    using namespace rastertrace;
    for (const ExerciseKind& kind : exercise_kinds) {
        ExerciseMaker like({std::string(kind.name) + ".json", std::string(kind.scene)});
        for (int seed = 1; seed <= 2; ++seed)
            std::fputs(like.exercise("1:" + std::to_string(seed)).scene.text.c_str(), stdout);
    }
    return 0;
}
