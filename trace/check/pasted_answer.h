// SPDX-License-Identifier: MIT
#pragma once

// An answer of `show` that stands among claims: its sentences are claims (claim_sentences.h), its pictures and workings
// are not.
//
//     First triangle                       step 14 of 62
//     scanline y=2   left AB: x = 2 + 3/4 (2 - 5) = -1/4 ...
//
//          -2-1 0 1 2 3

#include <cstddef>
#include <string_view>

namespace rastertrace {

/// Goes with the lines of a file, from the first to the last.
class PastedAnswer {
public:
    /// True of a line that holds no claim: a heading or a title, a picture and what its marks mean, a working.
    bool leaves_out(std::string_view text, std::size_t begin, std::size_t end);

    /// Where the sentence of the line that ends at `end` ends: below a heading it may go on in the next lines, which are
    /// then left out.
    std::size_t end_of_sentence(std::string_view text, std::size_t end);

    /// True where the marks of a picture may be explained: a line that is no claim is left out there.
    bool is_behind_picture() const { return frame_ == FramePart::legend; }

    void leave_out() { ++not_judged_; }

    /// Goes behind a claim.
    void end_frame() {
        if (frame_ == FramePart::legend)
            frame_ = FramePart::none;
    }

    /// How many lines of pictures and workings have been left out.
    std::size_t not_judged() const { return not_judged_; }

private:
    bool is_in_frame(std::string_view line);
    bool is_working(std::string_view line);

    /// The part of a frame that the last line belonged to.
    enum class FramePart { none, sentence, picture, legend };
    FramePart frame_ = FramePart::none;
    std::size_t read_to_ = 0;
    bool is_below_sentence_ = false;
    std::size_t not_judged_ = 0;
};

} // namespace rastertrace
