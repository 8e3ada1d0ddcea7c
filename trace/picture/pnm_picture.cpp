// SPDX-License-Identifier: MIT
// PNM, the formats of netpbm: bits, grays or colors, P1 to P3 as text, P4 to P6 as bytes.

#include "readers.h"

#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

constexpr bool is_blank(char c) {
    return c == ' ' || ('\t' <= c && c <= '\r');
}

class PnmReader {
public:
    explicit PnmReader(const Source& source) : source_(source), text_(source.view()) {}

    Picture read() {
        const char kind = text_[1];
        const bool is_bitmap = kind == '1' || kind == '4';
        const bool is_gray = kind == '2' || kind == '5';
        is_text_ = kind <= '3';
        const std::size_t width = number("a width", 1, largest_canvas_side);
        const std::size_t height = number("a height", 1, largest_canvas_side);
        if (!is_bitmap)
            most_ = number("a largest sample", 1, 65535);
        picture_ = blank_picture(source_, width, height);
        picture_.has_colors = !is_bitmap;
        for (std::uint32_t sample = 0; sample <= most_; ++sample)
            levels_.push_back(scaled_level(sample, most_));
        if (!is_text_)
            begin_bytes(is_bitmap ? (width + 7) / 8
                                  : width * (is_gray ? 1 : 3) * (most_ > 255 ? 2 : 1));

        auto pixel = picture_.pixels.begin();
        for (row_ = 0; row_ < height; ++row_)
            for (std::size_t x = 0; x < width; ++x)
                *pixel++ = is_bitmap ? next_bit(x) : is_gray ? next_gray() : next_color();
        return std::move(picture_);
    }

private:
    /// One blank stands before samples that are bytes; after it, all rows have to be there.
    void begin_bytes(std::size_t row_bytes) {
        if (at_ == text_.size())
            fail_expecting("a blank and samples");
        ++at_;
        check_rows(source_, picture_.height, (text_.size() - at_) / row_bytes);
    }

    Color next_color() {
        const std::uint8_t red = next_level();
        const std::uint8_t green = next_level();
        const std::uint8_t blue = next_level();
        return {red, green, blue};
    }

    Color next_gray() {
        const std::uint8_t gray = next_level();
        return {gray, gray, gray};
    }

    /// In text no blank has to stand between bits; in bytes, a row begins with the highest bit of one.
    Color next_bit(std::size_t x) {
        if (!is_text_) {
            bits_ = x % 8 == 0 ? next_byte() : bits_ << 1U;
            return (bits_ & 0x80U) != 0 ? Color() : no_color;
        }
        skip_blanks();
        if (text_[at_] != '0' && text_[at_] != '1')
            fail_expecting("0 or 1");
        return text_[at_++] == '1' ? Color() : no_color;
    }

    std::uint8_t next_level() {
        if (is_text_)
            return levels_[number("a sample", 0, most_)];
        std::uint32_t sample = next_byte();
        if (most_ > 255)
            sample = sample << 8U | next_byte();
        if (sample > most_)
            throw problem_of(source_.name,
                             fmt::format("expected samples from 0 to {}, found {} in row {}", most_,
                                         sample, row_ + 1));
        return levels_[sample];
    }

    std::uint32_t next_byte() { return static_cast<unsigned char>(text_[at_++]); }

    /// The next number of a text.
    std::uint32_t number(std::string_view what, std::uint32_t least, std::uint32_t most) {
        skip_blanks();
        std::size_t end = at_;
        std::uint32_t value = 0;
        for (; end < text_.size() && '0' <= text_[end] && text_[end] <= '9' && value <= most; ++end)
            value = 10 * value + static_cast<std::uint32_t>(text_[end] - '0');
        const bool is_whole = end == text_.size() || is_blank(text_[end]) || text_[end] == '#';
        if (end == at_ || !is_whole || value < least || value > most)
            fail_expecting(fmt::format("{} from {} to {}", what, least, most));
        at_ = end;
        return value;
    }

    /// Goes to the next character of a text that is no blank and in no comment.
    void skip_blanks() {
        while (at_ < text_.size() && (is_blank(text_[at_]) || text_[at_] == '#'))
            at_ = text_[at_] == '#' ? std::min(text_.find('\n', at_), text_.size()) : at_ + 1;
        if (at_ == text_.size())
            check_rows(source_, picture_.height, row_);
    }

    [[noreturn]] void fail_expecting(std::string_view expected) const {
        constexpr std::size_t shown = 40;
        const std::string_view rest = text_.substr(at_, 4 * shown);
        const auto end = std::find_if(rest.begin(), rest.end(), is_blank);
        const std::string word = shortened({rest.begin(), end}, shown);
        throw problem_at(source_, at_,
                         fmt::format("expected {}, found {}", expected,
                                     rest.empty() ? "the end" : '"' + word + '"'));
    }

    const Source& source_;
    std::string_view text_;
    std::size_t at_ = 2; ///< what is read next, behind P6
    bool is_text_ = false;
    std::uint32_t most_ = 1;           ///< the largest sample
    std::vector<std::uint8_t> levels_; ///< of each sample
    Picture picture_;
    std::size_t row_ = 0;    ///< whose samples are read
    std::uint32_t bits_ = 0; ///< the next one in front
};

} // namespace

Picture read_pnm(const Source& source) {
    return PnmReader(source).read();
}

} // namespace rastertrace
