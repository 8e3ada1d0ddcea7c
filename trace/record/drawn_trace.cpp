// SPDX-License-Identifier: MIT
#include "step_decoder.h"
#include "step_places.h"
#include "trace.h"
#include "write_trace.h"

#include <rastertrace/trace/text/input.h>
#include <rastertrace/trace/text/line_output.h>

#include <fmt/core.h>

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

/// Takes a number from the front of a text; false if there is none.
bool take_number(std::string_view& text, int& number) {
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return fault == std::errc();
}

/// Takes these characters from the front of a text; false if others stand there.
bool take(std::string_view& text, std::string_view front) {
    const bool is_there = text.starts_with(front);
    text.remove_prefix(is_there ? front.size() : 0);
    return is_there;
}

/// The pixel of a line that our writer has written of a `pixel` step without a color.
std::optional<Pixel> pixel_in(std::string_view line) {
    Pixel pixel;
    if (take(line, R"({"step":"pixel","x":)") && take_number(line, pixel.x) &&
        take(line, R"(,"y":)") && take_number(line, pixel.y) && line == "}")
        return pixel;
    return std::nullopt;
}

} // namespace

/// Takes the lines of a trace as they are written, and keeps what is held of them.
class DrawnSteps {
public:
    DrawnSteps(std::string name, std::size_t most) : name_(std::move(name)), most_(most) {
        // Doubled from here, the text has room for what may be held by default, and is not moved once more.
        held_.source_.text.reserve(std::size_t{1} << 16);
    }

    void take_line(std::string_view line) {
        if (header_.empty())
            header_ = line;
        else if (line.starts_with(R"({"end")"))
            end_ = line;
        else if (const auto pixel = pixel_in(line))
            add(*pixel);
        else
            add(line);
    }

    Trace trace() && {
        end_run();
        Source around{name_, header_ + "\n" + end_ + "\n", {}};
        auto read = read_written_trace(std::move(around));
        if (!read)
            throw read.problem();
        Trace trace = std::move(read.value());
        trace.source_.text = std::move(held_.source_.text);
        trace.steps_ = std::move(held_.steps_);
        return trace;
    }

private:
    void add(const Pixel& pixel) {
        const bool goes_on = pixels_in_run_ > 0 && pixel.y == run_.y &&
                             pixel.x - run_.x == static_cast<int>(pixels_in_run_);
        if (!goes_on) {
            end_run();
            count_line();
            run_ = pixel;
        }
        ++pixels_in_run_;
        if (++pixels_ > most_pixels_)
            throw too_much_to_hold(name_, most_pixels_, "pixels");
    }

    void add(std::string_view line) {
        end_run();
        count_line();
        std::string& text = held_.source_.text;
        held_.steps_->add({.offset = text.size(),
                           .length = static_cast<std::uint32_t>(line.size()),
                           .kind = kind_of_plain_step(line),
                           .is_plain = true});
        text.append(line) += '\n';
    }

    void end_run() {
        if (pixels_in_run_ == 0)
            return;
        held_.steps_->add_run(held_.source_.text, run_, pixels_in_run_);
        pixels_in_run_ = 0;
    }

    void count_line() {
        if (lines_++ >= most_)
            throw too_many_steps(name_, most_);
        if (held_.source_.text.size() > most_bytes_)
            throw too_much_to_hold(name_, most_bytes_, "bytes");
    }

    std::string name_;
    std::size_t most_;
    std::size_t most_bytes_ = most_held(most_, held_bytes_of_step);
    std::size_t most_pixels_ = most_held(most_, held_pixels_of_step); ///< without a color
    std::string header_;
    std::string end_;
    Trace held_;
    std::size_t lines_ = 0; ///< of its text
    Pixel run_;             ///< the first of the pixels that are not in it yet
    std::size_t pixels_in_run_ = 0;
    std::size_t pixels_ = 0; ///< without a color, so far
};

Trace drawn_trace(const Scene& scene, const Plan& plan, const std::string& name,
                  std::size_t most_steps) {
    DrawnSteps steps(name, most_steps);
    LineOutput lines([&steps](std::string_view line) { steps.take_line(line); });
    write_trace(scene, plan, {.layout = TraceLayout::jsonl, .filter = {}}, lines);
    return std::move(steps).trace();
}

} // namespace rastertrace
