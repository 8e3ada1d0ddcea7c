// SPDX-License-Identifier: MIT
#pragma once

// Hands on what is written, line by line.
//
//     LineOutput lines([](std::string_view line) { use(line); });
//     write_trace(scene, plan, {}, lines);

#include "output.h"

#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace rastertrace {

/// Calls `take` with each line, without its newline. What no newline follows is not handed on.
class LineOutput final : public Output {
public:
    explicit LineOutput(std::function<void(std::string_view line)> take) : take_(std::move(take)) {}

    void write(std::string_view bytes) override {
        for (std::size_t newline; (newline = bytes.find('\n')) != std::string_view::npos;) {
            const std::string_view line = bytes.substr(0, newline);
            if (begun_.empty())
                take_(line);
            else
                take_(std::exchange(begun_, {}).append(line));
            bytes.remove_prefix(newline + 1);
        }
        begun_ += bytes;
    }

private:
    std::function<void(std::string_view line)> take_;
    std::string begun_; ///< of a line whose end has not been written yet
};

} // namespace rastertrace
