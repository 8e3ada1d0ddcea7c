// SPDX-License-Identifier: MIT
#pragma once

// A file for each frame of a sequence: they get their names when all of them are written.
//
//     FrameFiles files("turn.svg", 12);      // turn-01.svg, ...
//     files.open(1).write(svg);
//     files.commit();

#include <rastertrace/trace/text/output.h>

#include <cstddef>
#include <string>

namespace rastertrace {

/// The name of a frame's file: its number, with so many digits, stands in front of the ending.
std::string path_of_frame(const std::string& path, std::size_t frame, std::size_t digits);

class FrameFiles {
public:
    /// `count` is the number of the last file. Throws a Problem if `path` is a device or a folder, or that many files
    /// cannot be open at once.
    FrameFiles(std::string path, std::size_t count);

    /// The file of a frame, from 1, with as many digits as the last one has. Throws a Problem, as FileOutputs does, and
    /// if it has been read.
    FileOutput& open(std::size_t frame);

    /// Gives all of them their names.
    void commit() { files_.commit(); }

private:
    std::string path_;
    std::size_t count_;
    FileOutputs files_;
};

} // namespace rastertrace
