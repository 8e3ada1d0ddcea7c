// SPDX-License-Identifier: MIT
#include <rastertrace/figures/gif.h>

#include "fewer_colors.h"
#include "palette.h"

#include <fmt/core.h>

#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

constexpr double hundredths = 100;
constexpr double least_seconds = 0.02;
constexpr double most_seconds = 655.35;

/// Pixels of a bitmap that are written as one picture.
struct Window {
    std::size_t left;
    std::size_t top;
    std::size_t width;
    std::size_t height;
};

/// All that differs between two bitmaps of a size; one pixel if nothing does, because each frame has its picture.
Window changed(const Bitmap& before, const Bitmap& after) {
    std::size_t left = after.width;
    std::size_t right = 0;
    std::size_t top = after.height;
    std::size_t bottom = 0;
    const auto width = static_cast<std::ptrdiff_t>(after.width);
    for (std::size_t y = 0; y < after.height; ++y) {
        const auto old_row = before.colors.begin() + static_cast<std::ptrdiff_t>(y) * width;
        const auto new_row = after.colors.begin() + static_cast<std::ptrdiff_t>(y) * width;
        const auto first = std::mismatch(new_row, new_row + width, old_row).first - new_row;
        if (first == width)
            continue;
        auto last = width - 1;
        while (new_row[last] == old_row[last])
            --last;
        left = std::min(left, static_cast<std::size_t>(first));
        right = std::max(right, static_cast<std::size_t>(last));
        top = std::min(top, y);
        bottom = y;
    }
    if (top == after.height)
        return {0, 0, 1, 1};
    return {left, top, right - left + 1, bottom - top + 1};
}

std::vector<Color> pixels_in(const Bitmap& bitmap, const Window& window) {
    std::vector<Color> pixels;
    pixels.reserve(window.width * window.height);
    for (std::size_t y = window.top; y < window.top + window.height; ++y) {
        const auto row =
            bitmap.colors.begin() + static_cast<std::ptrdiff_t>(y * bitmap.width + window.left);
        pixels.insert(pixels.end(), row, row + static_cast<std::ptrdiff_t>(window.width));
    }
    return pixels;
}

struct ColorMapDeleter {
    void operator()(ColorMapObject* map) const { GifFreeMapObject(map); }
};
using ColorMap = std::unique_ptr<ColorMapObject, ColorMapDeleter>;

/// A table of 2, 4, 8, ... colors, the last ones black where there are fewer.
ColorMap color_map_of(const Palette& palette) {
    std::vector<GifColorType> colors;
    for (const Color color : palette.colors())
        colors.push_back({color.red(), color.green(), color.blue()});
    std::size_t count = 2;
    while (count < colors.size())
        count *= 2;
    colors.resize(count);
    return ColorMap(GifMakeMapObject(static_cast<int>(count), colors.data()));
}

/// Writes bytes into the string behind a file of giflib.
int append(GifFileType* gif, const GifByteType* bytes, int count) {
    static_cast<std::string*>(gif->UserData)
        ->append(reinterpret_cast<const char*>(bytes), // NOLINT: giflib has unsigned bytes
                 static_cast<std::size_t>(count));
    return count;
}

/// A file that giflib writes. All that is asked of it fails once something has failed.
class GifWriter {
public:
    explicit GifWriter(std::string& bytes) : gif_(EGifOpen(&bytes, append, &error_)) {
        if (gif_ != nullptr)
            EGifSetGifVersion(gif_, true);
    }
    GifWriter(const GifWriter&) = delete;
    GifWriter& operator=(const GifWriter&) = delete;
    ~GifWriter() {
        if (gif_ != nullptr)
            EGifCloseFile(gif_, &error_);
    }

    void begin(const Bitmap& bitmap, const Palette& palette) {
        const ColorMap map = color_map_of(palette);
        // Netscape's extension: how often, 0 for ever.
        constexpr std::array<unsigned char, 3> times{1, 0, 0};
        keep(gif_ != nullptr && map != nullptr &&
             EGifPutScreenDesc(gif_, static_cast<int>(bitmap.width),
                               static_cast<int>(bitmap.height), 8, 0, map.get()) == GIF_OK &&
             EGifPutExtensionLeader(gif_, APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
             EGifPutExtensionBlock(gif_, 11, "NETSCAPE2.0") == GIF_OK &&
             EGifPutExtensionBlock(gif_, static_cast<int>(times.size()), times.data()) == GIF_OK &&
             EGifPutExtensionTrailer(gif_) == GIF_OK);
    }

    /// A picture over what is there. `local` are its colors, if they are not the file's.
    void add(const Window& window, const std::vector<GifByteType>& indices, int delay,
             const Palette* local) {
        const GraphicsControlBlock control{.DisposalMode = DISPOSE_DO_NOT,
                                           .UserInputFlag = false,
                                           .DelayTime = delay,
                                           .TransparentColor = NO_TRANSPARENT_COLOR};
        std::array<GifByteType, 4> block{};
        EGifGCBToExtension(&control, block.data());
        const ColorMap map = local == nullptr ? nullptr : color_map_of(*local);
        if (is_well_ && map == nullptr) {
            // giflib forgets to free the table of the frame before when this one has none.
            GifFreeMapObject(gif_->Image.ColorMap);
            gif_->Image.ColorMap = nullptr;
        }
        keep(is_well_ && (local == nullptr || map != nullptr) &&
             EGifPutExtension(gif_, GRAPHICS_EXT_FUNC_CODE, static_cast<int>(block.size()),
                              block.data()) == GIF_OK &&
             EGifPutImageDesc(gif_, static_cast<int>(window.left), static_cast<int>(window.top),
                              static_cast<int>(window.width), static_cast<int>(window.height),
                              false, map.get()) == GIF_OK);
        std::vector<GifByteType> row;
        for (std::size_t y = 0; is_well_ && y < window.height; ++y) {
            const auto begin = indices.begin() + static_cast<std::ptrdiff_t>(y * window.width);
            row.assign(begin, begin + static_cast<std::ptrdiff_t>(window.width));
            keep(EGifPutLine(gif_, row.data(), static_cast<int>(window.width)) == GIF_OK);
        }
    }

    /// Writes the end. What went wrong, if anything did.
    std::optional<Problem> finish() {
        if (is_well_ && EGifCloseFile(std::exchange(gif_, nullptr), &error_) == GIF_OK)
            return std::nullopt;
        const char* message = GifErrorString(gif_ != nullptr ? gif_->Error : error_);
        Problem problem =
            problem_of("", fmt::format("the GIF could not be made: {}",
                                       message != nullptr ? message : "giflib does not say why"));
        problem.cause = Problem::Cause::system;
        return problem;
    }

private:
    void keep(bool is_well) { is_well_ = is_well_ && is_well; }

    int error_ = 0;
    GifFileType* gif_;
    bool is_well_ = true;
};

std::optional<std::vector<GifByteType>> indices_in(const std::vector<Color>& pixels,
                                                   const Palette& palette) {
    std::vector<GifByteType> indices;
    indices.reserve(pixels.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (i > 0 && pixels[i] == pixels[i - 1]) {
            indices.push_back(indices.back());
            continue;
        }
        const auto index = palette.index_of(pixels[i]);
        if (!index)
            return std::nullopt;
        indices.push_back(*index);
    }
    return indices;
}

std::optional<Problem> problem_with(std::size_t count, const GifOptions& options) {
    if (count == 0)
        return problem_of("", "expected a frame for the GIF, found none");
    if (count > most_gif_frames)
        return problem_of(
            "",
            fmt::format("expected at most {} frames in a GIF, found {}", most_gif_frames, count),
            "--every takes fewer of the steps");
    if (!(least_seconds <= options.seconds && options.seconds <= most_seconds))
        return problem_of("",
                          fmt::format("expected {} to {} seconds for a frame of a GIF, found {}",
                                      least_seconds, most_seconds, options.seconds));
    return std::nullopt;
}

std::optional<Problem> problem_with(const Bitmap& first, const Bitmap& frame) {
    if (auto problem = problem_of_sides(frame, most_gif_side, "GIF"))
        return problem;
    if (frame.width != first.width || frame.height != first.height)
        return problem_of("", fmt::format("expected frames of one size in a GIF, found {} x {} "
                                          "after {} x {}",
                                          frame.width, frame.height, first.width, first.height));
    return std::nullopt;
}

} // namespace

Result<std::string> gif_of(std::size_t count,
                           const std::function<Bitmap(std::size_t index)>& frame_at,
                           const GifOptions& options) {
    if (auto problem = problem_with(count, options))
        return *std::move(problem);
    std::string bytes;
    GifWriter writer(bytes);
    Palette palette; // of the first frame, and of those that have no other colors
    Bitmap before;
    // While a frame is compressed, the next one is drawn.
    std::future<Bitmap> next = std::async(frame_at, std::size_t{0});
    for (std::size_t i = 0; i < count; ++i) {
        Bitmap frame = next.get();
        if (auto problem = problem_with(i == 0 ? frame : before, frame))
            return *std::move(problem);
        if (i + 1 < count)
            next = std::async(frame_at, i + 1);
        const Window window =
            i == 0 ? Window{0, 0, frame.width, frame.height} : changed(before, frame);
        std::vector<Color> pixels = pixels_in(frame, window);

        // Colors that the file's table does not have are in a table of the frame.
        auto indices = indices_in(pixels, palette);
        Palette local;
        const Palette* of_frame = nullptr;
        if (i == 0 || !indices) {
            if (!local.add(pixels)) {
                reduce_colors(pixels);
                local = {};
                local.add(pixels);
            }
            indices = indices_in(pixels, local);
            if (i == 0) {
                palette = local;
                writer.begin(frame, palette);
            } else {
                of_frame = &local;
            }
        }

        // All frames together take as long as they should, though each takes whole hundredths.
        const auto time_at = [&options](std::size_t frames) {
            return static_cast<int>(
                std::floor(static_cast<double>(frames) * options.seconds * hundredths + 0.5));
        };
        writer.add(window, *indices, std::min(time_at(i + 1) - time_at(i), 65535), of_frame);
        before = std::move(frame);
    }
    if (auto problem = writer.finish())
        return *std::move(problem);
    return bytes;
}

} // namespace rastertrace
