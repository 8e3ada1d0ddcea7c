// SPDX-License-Identifier: MIT
// Writes random scenes for scripts/freeze.sh.
//
//     random_scenes 3000 folder                # folder/00000.json ...
//     random_scenes --with-faults 200 folder   # the same, each with one fault

#include "random_choice.h"
#include "random_scene.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// Where one of some characters stands in a text, picked at random.
std::size_t place_of_any(std::string_view characters, const std::string& text, Random& random) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < text.size(); ++i)
        if (characters.find(text[i]) != std::string_view::npos)
            places.push_back(i);
    return places[static_cast<std::size_t>(random.whole(0, static_cast<int>(places.size()) - 1))];
}

/// The text of a scene with one fault: cut short, an x before a quotation mark, `true` in place of a digit, or 1e999
/// before one.
std::string with_fault(std::string text, Random& random) {
    constexpr std::string_view digits = "0123456789";
    switch (random.whole(0, 3)) {
    case 0:
        text.resize(static_cast<std::size_t>(random.whole(0, static_cast<int>(text.size()) - 1)));
        break;
    case 1:
        text.insert(place_of_any("\"", text, random), "x");
        break;
    case 2:
        text.replace(place_of_any(digits, text, random), 1, "true");
        break;
    default:
        text.insert(place_of_any(digits, text, random), "1e999");
        break;
    }
    return text;
}

} // namespace rastertrace

int main(int count, char** arguments) {
    using namespace rastertrace;
    const bool has_faults = count == 4 && std::string_view(arguments[1]) == "--with-faults";
    if (count != (has_faults ? 4 : 3)) {
        std::cerr << "usage: random_scenes [--with-faults] COUNT FOLDER\n";
        return 2;
    }
    const int scenes = std::atoi(arguments[count - 2]);
    const std::filesystem::path folder = arguments[count - 1];
    for (int i = 0; i < scenes; ++i) {
        std::ostringstream name;
        name << std::setfill('0') << std::setw(5) << i << ".json";
        const auto seed = static_cast<std::uint64_t>(i) + 1;
        std::string text = RandomScene(seed).text();
        Random random(seed);
        std::ofstream(folder / name.str()) << (has_faults ? with_fault(text, random) : text);
    }
}
