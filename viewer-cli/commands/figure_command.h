// SPDX-License-Identifier: MIT
#pragma once

// What `rastertrace figure` is asked.

#include "app/command.h"
#include "app/load.h"
#include "app/shared_options.h"
#include "commands/figure_file.h"

#include <rastertrace/figures/figure.h>
#include <rastertrace/figures/space_frames.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace rastertrace {

class FigureCommand final : public Command {
public:
    enum class Which {
        last,
        step,
        until,
        every,
        film, ///< see film_of
    };

    /// Frames in rows and columns on one sheet.
    struct Sheet {
        std::size_t columns;
        std::size_t rows;
    };

    CommandAbout about() const override;
    void add_to(OptionList& options) override;
    void read() override;
    int run() override;

    std::string trace;
    std::string output;
    std::optional<FigureFormat> format; ///< none: by the name of the output
    Which which = Which::last;
    std::string selector; ///< for all but Which::last
    FigureOptions figure;
    FigureStyle style;
    std::optional<Sheet> sheet;
    std::optional<SpaceFrames> frames_in_space; ///< in the place of all other pictures
    bool is_animated = false;                   ///< all frames in one .svg
    bool is_bare = false;                       ///< only the pixels
    std::string against;                        ///< METHOD, or a file: see FigureOptions
    SceneOptions scenes;

private:
    std::string step_;
    std::string until_;
    std::string every_;
    std::string format_;
    std::string with_;
    std::string without_;
    std::string view_;
    std::string eye_;
    std::vector<std::string> notes_;
    std::string region_;
    std::string theme_;
    std::string sheet_;
    std::string cell_;
    std::string scale_;
    std::string width_;
    std::string height_;
    std::string seconds_;
    DrawingOptions drawing_;
};

} // namespace rastertrace
