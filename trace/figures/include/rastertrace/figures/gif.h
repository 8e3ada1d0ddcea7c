// SPDX-License-Identifier: MIT
#pragma once

// Bitmaps one after the other, over and over, as an animated GIF. Each is asked for when it is its turn and only the rectangle
// that changed is written, so that a long animation takes the memory of three bitmaps and its file.
//
//     const auto gif = gif_of(
//         frames.size(), [&](std::size_t i) { return bitmap_of(frames[i], Theme::light, 1); },
//         {.seconds = 0.5});

#include <rastertrace/figures/bitmap.h>
#include <rastertrace/trace/text/problem.h>

#include <cstddef>
#include <functional>
#include <string>

namespace rastertrace {

/// The most frames: browsers keep all of them in memory, where 10,000 of 300 x 300 pixels take 3.6 gigabytes.
inline constexpr std::size_t most_gif_frames = 10'000;

/// The most pixels of a row or a column: the format has 16 bits for their number.
inline constexpr std::size_t most_gif_side = 65'535;

struct GifOptions {
    double seconds = 0.5; ///< for each frame, 0.02 (browsers take less for 0.1) to 655.35
};

/// The bytes of the file; or why there are none: no frame or too many, frames that are too large or differ in
/// size, or a time that GIF has not. `frame_at` is called once for each of 0 to `count` - 1, in this order, by one
/// thread at a time, which need not be the caller's; what it throws is passed on. What changes in more than 256
/// colors at once is written in fewer: of colors that are alike, the most frequent stays.
Result<std::string> gif_of(std::size_t count,
                           const std::function<Bitmap(std::size_t index)>& frame_at,
                           const GifOptions& options);

} // namespace rastertrace
