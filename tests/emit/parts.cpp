// SPDX-License-Identifier: MIT
// Two threads tell a part each, twenty times: the joined trace has the same bytes every time, and the order that the
// header promises. From two translation units: tile.c, and this one.
//
//     parts FOLDER

#include "tile.h"

#include <array>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <thread>

namespace {

constexpr int triangles = 3000; // a part has more bytes than the buffer

std::string joined(const std::string& path) {
    static rt_trace trace;
    static std::array<rt_trace, 2> parts;
    rt_open(&trace, path.c_str());
    rt_header(&trace, 200, 3000, "top-left");
    for (rt_trace& part : parts)
        rt_part(&part);
    std::thread left(draw_tile, &parts[0], triangles, 0);
    std::thread right(draw_tile, &parts[1], triangles, 1);
    left.join();
    right.join();
    rt_join(&trace, parts.data(), parts.size());
    rt_skip(&trace, "t", "the end");
    if (rt_end(&trace) != 0) {
        std::cout << rt_error(&trace) << '\n';
        std::exit(1);
    }
    std::ifstream file(path, std::ios::binary);
    return (std::ostringstream() << file.rdbuf()).str();
}

/// The trace that one thread would tell, primitive after primitive, without the places in the code.
std::string expected() {
    std::ostringstream out;
    int pixels = 0;
    int primitives = 0;
    int skips = 1;
    out << R"({"rastertrace":1,"canvas":{"width":200,"height":3000,"origin":"top-left"}})" << '\n';
    for (int number = 0; number < triangles; ++number) {
        if (number % 3 == 1) {
            for (const char* why : {"left", "right"})
                out << R"({"step":"skip","name":"t)" << number << R"(","why":")" << why << "\"}\n";
            skips += 2;
            continue;
        }
        out << R"({"step":"primitive","kind":"triangle","name":"t)" << number << "\"}\n";
        ++primitives;
        for (int tile = 0; tile < (number % 3 == 0 ? 1 : 2); ++tile)
            for (int x = 0; x < number % 50; ++x, ++pixels)
                out << R"({"step":"pixel","x":)" << 100 * tile + x << ",\"y\":" << number << "}\n";
    }
    const int steps = primitives + pixels + skips;
    out << R"({"step":"skip","name":"t","why":"the end"})" << '\n'
        << R"({"end":{"steps":)" << steps << R"(,"count":{"primitive":)" << primitives
        << R"(,"pixel":)" << pixels << R"(,"skip":)" << skips << "}}}\n";
    return out.str();
}

std::string without_code(const std::string& text) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t code = text.find(",\"code\":", at);
        result.append(text, at, code - at);
        at = code == std::string::npos ? code : text.find('}', code);
    }
    return result;
}

} // namespace

int main(int count, char** arguments) {
    if (count < 2)
        return 2;
    const std::string path = std::string(arguments[1]) + "/parts.jsonl";
    const std::string first = joined(path);
    if (without_code(first) != expected()) {
        std::cout << path << ": another order than by number, then by part\n";
        return 1;
    }
    for (int i = 1; i < 20; ++i)
        if (joined(path) != first) {
            std::cout << path << ": other bytes in run " << i << '\n';
            return 1;
        }
}
