// SPDX-License-Identifier: MIT
// What giflib reads of our GIF files.

#include "colors.h"
#include "random_choice.h"

#include <rastertrace/figures/gif.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <gif_lib.h>

#include <cstring>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {
namespace {

using testing::ElementsAre;

Bitmap plain(std::size_t width, std::size_t height, Color color) {
    return {.width = width, .height = height, .colors = std::vector<Color>(width * height, color)};
}

Result<std::string> gif_of_all(const std::vector<Bitmap>& frames, const GifOptions& options = {}) {
    return gif_of(
        frames.size(), [&frames](std::size_t i) { return frames[i]; }, options);
}

struct ReadFrame {
    int delay; ///< hundredths of a second
    std::string window;
    bool has_own_colors;
    std::vector<Color> composed; ///< what is to be seen
};

struct ReadGif {
    std::vector<ReadFrame> frames;
    bool repeats = false;
};

ReadGif read_back(const std::string& file) {
    std::string_view rest = file;
    int error = 0;
    GifFileType* gif = DGifOpen(
        &rest,
        [](GifFileType* from, GifByteType* to, int count) {
            auto& left = *static_cast<std::string_view*>(from->UserData);
            const std::size_t taken = std::min(left.size(), static_cast<std::size_t>(count));
            std::memcpy(to, left.data(), taken);
            left.remove_prefix(taken);
            return static_cast<int>(taken);
        },
        &error);
    ReadGif read;
    if (gif == nullptr || DGifSlurp(gif) != GIF_OK) {
        ADD_FAILURE() << "giflib does not read it";
        return read;
    }
    std::vector<Color> screen(static_cast<std::size_t>(gif->SWidth * gif->SHeight));
    for (int i = 0; i < gif->ImageCount; ++i) {
        const SavedImage& image = gif->SavedImages[i];
        const GifImageDesc& place = image.ImageDesc;
        const ColorMapObject* map = place.ColorMap != nullptr ? place.ColorMap : gif->SColorMap;
        for (int y = 0; y < place.Height; ++y)
            for (int x = 0; x < place.Width; ++x) {
                const GifColorType color = map->Colors[image.RasterBits[y * place.Width + x]];
                screen[static_cast<std::size_t>((place.Top + y) * gif->SWidth + place.Left + x)] = {
                    color.Red, color.Green, color.Blue};
            }
        GraphicsControlBlock control{};
        DGifSavedExtensionToGCB(gif, i, &control);
        EXPECT_EQ(control.DisposalMode, DISPOSE_DO_NOT);
        read.frames.push_back({control.DelayTime,
                               std::to_string(place.Width) + "x" + std::to_string(place.Height) +
                                   "+" + std::to_string(place.Left) + "+" +
                                   std::to_string(place.Top),
                               place.ColorMap != nullptr, screen});
        for (int k = 0; k < image.ExtensionBlockCount; ++k) {
            const ExtensionBlock& block = image.ExtensionBlocks[k];
            read.repeats =
                read.repeats ||
                (block.Function == APPLICATION_EXT_FUNC_CODE &&
                 std::string_view(reinterpret_cast<const char*>(block.Bytes), // NOLINT
                                  static_cast<std::size_t>(block.ByteCount)) == "NETSCAPE2.0");
        }
    }
    DGifCloseFile(gif, &error);
    return read;
}

TEST(Gif, FramesAreReadBackAsTheBitmaps) {
    Random random(20);
    for (const int colors : {1, 2, 3, 200, 256}) {
        std::vector<Bitmap> frames{plain(30, 20, white)};
        for (int i = 0; i < 12; ++i) {
            Bitmap next = frames.back();
            for (int k = random.whole(0, 40); k > 0; --k) {
                const int n = random.whole(0, colors - 1);
                next.colors[static_cast<std::size_t>(random.whole(0, 599))] = {
                    static_cast<std::uint8_t>(n), static_cast<std::uint8_t>(3 * n), 9};
            }
            frames.push_back(next);
        }
        const auto gif = gif_of_all(frames);
        ASSERT_TRUE(gif);
        const ReadGif read = read_back(gif.value());
        ASSERT_EQ(read.frames.size(), frames.size());
        for (std::size_t i = 0; i < frames.size(); ++i)
            EXPECT_EQ(read.frames[i].composed, frames[i].colors) << colors << " colors, " << i;
        EXPECT_EQ(gif.value(), gif_of_all(frames).value());
    }
}

TEST(Gif, OnlyWhatChangedIsWritten) {
    Bitmap second = plain(10, 8, white);
    second.colors[23] = black; // column 3, row 2
    second.colors[65] = black; // column 5, row 6
    Bitmap fourth = second;
    fourth.colors[79] = {1, 2, 3};
    const ReadGif read =
        read_back(gif_of_all({plain(10, 8, white), second, second, fourth}).value());
    std::vector<std::string> windows;
    std::vector<bool> have_own_colors;
    for (const ReadFrame& frame : read.frames) {
        windows.push_back(frame.window);
        have_own_colors.push_back(frame.has_own_colors);
    }
    EXPECT_THAT(windows, ElementsAre("10x8+0+0", "3x5+3+2", "1x1+0+0", "1x1+9+7"));
    EXPECT_THAT(have_own_colors, ElementsAre(false, true, false, true));
}

TEST(Gif, TimesAddUp) {
    const std::vector<Bitmap> frames(8, plain(2, 2, white));
    std::vector<int> delays;
    for (const ReadFrame& frame : read_back(gif_of_all(frames, {.seconds = 0.125}).value()).frames)
        delays.push_back(frame.delay);
    EXPECT_THAT(delays, ElementsAre(13, 12, 13, 12, 13, 12, 13, 12));
}

TEST(Gif, RepeatsIfItShould) {
    const std::vector<Bitmap> frames(2, plain(2, 2, white));
    EXPECT_TRUE(read_back(gif_of_all(frames).value()).repeats);
}

TEST(Gif, OfTooManyColorsTheMostFrequentStay) {
    // All grays three times, and next to each one a color that is there once.
    Bitmap bitmap{.width = 4, .height = 256};
    for (unsigned i = 0; i < 256; ++i) {
        const auto gray = static_cast<std::uint8_t>(i);
        const auto near = static_cast<std::uint8_t>(i ^ 1);
        for (int k = 0; k < 3; ++k)
            bitmap.colors.push_back({gray, gray, gray});
        bitmap.colors.push_back({gray, near, gray});
    }
    const ReadGif read = read_back(gif_of_all({bitmap}).value());
    ASSERT_EQ(read.frames.size(), 1U);
    // Each group of colors that differ in the last bit has two grays, as frequent: the darker one stays.
    for (std::size_t i = 0; i < bitmap.colors.size(); ++i) {
        const auto gray = static_cast<std::uint8_t>(i / 4 & 0xFE);
        ASSERT_EQ(read.frames[0].composed[i], Color(gray, gray, gray)) << i;
    }
}

TEST(Gif, OfFarTooManyColorsALargeAreaKeepsItsOwn) {
    Bitmap bitmap = plain(100, 100, {201, 33, 77});
    for (std::size_t i = 0; i < 4000; ++i)
        bitmap.colors[i] = {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i / 16),
                            static_cast<std::uint8_t>(i / 40)};
    const ReadGif read = read_back(gif_of_all({bitmap}).value());
    std::set<std::vector<int>> colors;
    for (const Color color : read.frames[0].composed)
        colors.insert({color.red(), color.green(), color.blue()});
    EXPECT_LE(colors.size(), 256U);
    EXPECT_GT(colors.size(), 64U);
    EXPECT_EQ(read.frames[0].composed.back(), Color(201, 33, 77));
}

TEST(Gif, AsksForFramesInTheirOrderAndOnce) {
    std::vector<std::size_t> asked;
    ASSERT_TRUE(gif_of(4,
                       [&asked](std::size_t i) {
                           asked.push_back(i);
                           return plain(1, 1, white);
                       },
                       {}));
    EXPECT_THAT(asked, ElementsAre(0, 1, 2, 3));
}

TEST(Gif, PassesOnWhatAFrameThrows) {
    const auto frame_at = [](std::size_t i) {
        if (i == 2)
            throw std::runtime_error("the third");
        return plain(1, 1, white);
    };
    EXPECT_THROW((void)gif_of(4, frame_at, {}), std::runtime_error);
}

std::string message_of(const Result<std::string>& result) {
    return result ? "none" : to_text(result.problem());
}

TEST(Gif, SaysWhatItCannotHold) {
    const Bitmap one = plain(1, 1, white);
    EXPECT_EQ(message_of(gif_of_all({})), "expected a frame for the GIF, found none");
    EXPECT_EQ(message_of(gif_of(10'001, [&one](std::size_t) { return one; }, {})),
              "expected at most 10000 frames in a GIF, found 10001\n"
              "hint: --every takes fewer of the steps");
    EXPECT_EQ(message_of(gif_of(10'000, [&one](std::size_t) { return one; }, {})), "none");
    EXPECT_EQ(message_of(gif_of_all({plain(65'536, 1, white)})),
              "expected 1 to 65535 pixels a side in a GIF, found 65536 x 1\n"
              "hint: a smaller --scale makes it smaller");
    EXPECT_EQ(message_of(gif_of_all({plain(1, 65'535, white)})), "none");
    EXPECT_EQ(message_of(gif_of_all({one, plain(1, 2, white)})),
              "expected frames of one size in a GIF, found 1 x 2 after 1 x 1");
    EXPECT_EQ(message_of(gif_of_all({one}, {.seconds = 0.01})),
              "expected 0.02 to 655.35 seconds for a frame of a GIF, found 0.01");
    EXPECT_EQ(message_of(gif_of_all({one}, {.seconds = 656})),
              "expected 0.02 to 655.35 seconds for a frame of a GIF, found 656");
    EXPECT_EQ(message_of(gif_of_all({one}, {.seconds = 655.35})), "none");
}

} // namespace
} // namespace rastertrace
