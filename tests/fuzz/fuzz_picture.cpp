// SPDX-License-Identifier: MIT
// Any bytes as a picture: what is wrong with them is said safely, and a picture that can be read is whole, and the
// same when it is written plainly and read again.

#include "check.h"

#include <rastertrace/trace/picture/picture.h>
#include <rastertrace/trace/picture/picture_trace.h>
#include <rastertrace/trace/text/text.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

namespace rastertrace::fuzz {

namespace {

std::string as_ppm(const Picture& picture) {
    std::string bytes =
        "P6 " + std::to_string(picture.width) + " " + std::to_string(picture.height) + " 255\n";
    for (const Color color : picture.pixels)
        bytes += {static_cast<char>(color.red()), static_cast<char>(color.green()),
                  static_cast<char>(color.blue())};
    return bytes;
}

void write_and_read_back(const Picture& picture) {
    const auto again = read_picture(
        {"again", picture.has_colors ? as_ppm(picture) : joined(picture_rows(picture), "\n")});
    check(static_cast<bool>(again), "a picture that was written cannot be read");
    check(again.value().has_colors == picture.has_colors, "a picture has lost its colors");
    check(std::equal(picture.pixels.begin(), picture.pixels.end(), again.value().pixels.begin(),
                     again.value().pixels.end(),
                     [&](Color before, Color after) {
                         return before == after ||
                                (picture.has_colors && before.alpha() != 255); // PPM has no alpha
                     }),
          "a picture that was written has other pixels");
}

void read(const Source& source) {
    const auto picture = read_picture(source);
    if (!picture) {
        check_message(picture.problem());
        return;
    }
    const auto width = static_cast<std::size_t>(picture.value().width);
    const auto height = static_cast<std::size_t>(picture.value().height);
    check(picture.value().pixels.size() == width * height, "a picture is not whole");
    constexpr std::size_t small = 10'000;
    if (width * height < small)
        write_and_read_back(picture.value());
}

} // namespace

} // namespace rastertrace::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace rastertrace;
    fuzz::read(fuzz::source_of("fuzz", data, size));
    fuzz::read(fuzz::source_of("fuzz.tga", data, size));
    return 0;
}
