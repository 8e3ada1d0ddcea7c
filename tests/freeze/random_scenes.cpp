// SPDX-License-Identifier: MIT
// Writes random scenes for scripts/freeze.sh.
//
//     random_scenes 3000 folder   # folder/00000.json ...

#include "random_scene.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

int main(int count, char** arguments) {
    if (count != 3) {
        std::cerr << "usage: random_scenes COUNT FOLDER\n";
        return 2;
    }
    const int scenes = std::atoi(arguments[1]);
    const std::filesystem::path folder = arguments[2];
    for (int i = 0; i < scenes; ++i) {
        std::ostringstream name;
        name << std::setfill('0') << std::setw(5) << i << ".json";
        std::ofstream(folder / name.str())
            << rastertrace::RandomScene(static_cast<std::uint64_t>(i) + 1).text();
    }
}
