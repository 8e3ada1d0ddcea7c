// SPDX-License-Identifier: MIT
#include "diff_picture.h"

#include <rastertrace/trace/record/traced_steps.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <unordered_map>
#include <utility>

namespace rastertrace {

namespace {

/// The largest part of the pictures that is shown, and how far around a difference it reaches.
constexpr int widest = 60;
constexpr int highest = 30;
constexpr int margin = 2;

/// Both canvases: every pixel that one of them has.
struct BothCanvases {
    int left;
    int right;
    int low;
    int high;
    int down;

    BothCanvases(const Canvas& a, const Canvas& b)
        : left(std::min(a.left(), b.left())), right(std::max(a.right(), b.right())),
          low(std::min({a.top(), a.bottom(), b.top(), b.bottom()})),
          high(std::max({a.top(), a.bottom(), b.top(), b.bottom()})), down(a.down()) {}

    int top() const { return down < 0 ? high : low; }
    int height() const { return high - low + 1; }
    int y_of(int row) const { return top() + down * row; }
    int row_of(int y) const { return (y - top()) * down; }
};

/// The primitives that own pixels, each looked up once.
class KnownOwners {
public:
    explicit KnownOwners(const std::function<OwnerOfPixels(std::uint32_t)>& look_up)
        : look_up_(look_up) {}

    const OwnerOfPixels& of(std::uint32_t owner) {
        const auto [known, is_new] = known_.try_emplace(owner);
        if (is_new)
            known->second = look_up_(owner);
        return known->second;
    }

private:
    const std::function<OwnerOfPixels(std::uint32_t)>& look_up_;
    std::unordered_map<std::uint32_t, OwnerOfPixels> known_;
};

enum class PixelVerdict : std::uint8_t { none, alike, only_a, only_b, color, owner };

/// What is counted of each verdict, and its mark; in their order.
struct VerdictRow {
    char mark;
    std::uint64_t PictureDifference::*count = nullptr;
    std::vector<Pixel> Consequences::*led_to = nullptr;
};
constexpr std::array verdict_rows{
    VerdictRow{'.'},
    VerdictRow{'#'},
    VerdictRow{'!', &PictureDifference::only_a, &Consequences::only_a},
    VerdictRow{'?', &PictureDifference::only_b, &Consequences::only_b},
    VerdictRow{'~', &PictureDifference::colors, &Consequences::colors},
    VerdictRow{'~', &PictureDifference::owners, &Consequences::owners},
};

constexpr const VerdictRow& row_of(PixelVerdict verdict) {
    return verdict_rows[static_cast<std::size_t>(verdict)];
}

class PictureComparison {
public:
    PictureComparison(const OwnedPicture& a, const OwnedPicture& b, const PictureOwners& owners,
                      const PictureScope& scope)
        : a_(a), b_(b), owners_(owners), known_a_(owners.in_a), known_b_(owners.in_b),
          scope_(scope), both_(a.canvas(), b.canvas()) {}

    std::pair<PictureDifference, Consequences> compare() {
        for (int row = 0; row < both_.height(); ++row)
            for (int x = both_.left; x <= both_.right; ++x)
                count({x, both_.y_of(row)}, row);
        found_.down = both_.down;
        if (has_any_)
            show();
        return {std::move(found_), std::move(led_to_)};
    }

private:
    PixelVerdict verdict(Pixel pixel) const {
        if (scope_.region &&
            !(scope_.region->has_row(pixel.y) && scope_.region->meets(pixel.x, pixel.x)))
            return PixelVerdict::none;
        const bool in_a = a_.is_drawn(pixel);
        const bool in_b = b_.is_drawn(pixel);
        if (!in_a || !in_b)
            return in_a ? PixelVerdict::only_a : in_b ? PixelVerdict::only_b : PixelVerdict::none;
        if (scope_.has_colors &&
            !are_near(a_.color(pixel), b_.color(pixel), scope_.color_tolerance))
            return PixelVerdict::color;
        return !scope_.has_owners || has_one_owner(pixel) ? PixelVerdict::alike
                                                          : PixelVerdict::owner;
    }

    /// True if the same primitive has drawn a pixel in both.
    bool has_one_owner(Pixel pixel) const {
        return owners_.b_of_a(a_.owner(pixel)) == b_.owner(pixel);
    }

    void count(Pixel pixel, int row) {
        const PixelVerdict here = verdict(pixel);
        const VerdictRow& verdict_row = row_of(here);
        if (verdict_row.count == nullptr)
            return;
        ++(found_.*verdict_row.count);
        note_reached(pixel, led_to_.*verdict_row.led_to);
        const bool is_in_both = here == PixelVerdict::color || here == PixelVerdict::owner;
        has_other_owner_ =
            has_other_owner_ || (is_in_both && scope_.has_owners && !has_one_owner(pixel));
        if (!has_any_)
            left_ = right_ = pixel.x, first_row_ = row;
        has_any_ = true;
        left_ = std::min(left_, pixel.x);
        right_ = std::max(right_, pixel.x);
        last_row_ = row;
        if (found_.pixels.size() < most_pixels_told)
            found_.pixels.push_back({.pixel = pixel,
                                     .a = drawn_in(a_, pixel, known_a_),
                                     .b = drawn_in(b_, pixel, known_b_)});
    }

    /// Notes a pixel that differs because of the first difference.
    void note_reached(Pixel pixel, std::vector<Pixel>& list) {
        const auto reaches = [&](const OwnedPicture& picture, KnownOwners& known) {
            return picture.is_drawn(pixel) &&
                   scope_.reach->has(pixel, known.of(picture.owner(pixel)));
        };
        if (!scope_.reach || (!reaches(a_, known_a_) && !reaches(b_, known_b_)))
            return;
        ++led_to_.count;
        if (list.size() < most_pixels_told)
            list.push_back(pixel);
    }

    static std::optional<PixelOwner> drawn_in(const OwnedPicture& picture, Pixel pixel,
                                              KnownOwners& known) {
        if (!picture.is_drawn(pixel))
            return std::nullopt;
        return PixelOwner{.primitive = known.of(picture.owner(pixel)).name,
                          .color = picture.color(pixel)};
    }

    /// Rows of a part that holds the differences, or as many as find room behind the first.
    void show() {
        const int last_row = both_.height() - 1;
        const bool has_room =
            both_.right - both_.left < widest && both_.height() <= highest && !scope_.region;
        int left = has_room ? both_.left : std::max(both_.left, left_ - margin);
        int right = has_room ? both_.right : std::min(both_.right, right_ + margin);
        const int first = has_room ? 0 : std::max(0, first_row_ - margin);
        int last = has_room ? last_row : std::min(last_row, last_row_ + margin);
        if (right - left >= widest) {
            left = std::max(both_.left, found_.pixels.front().pixel.x - widest / 2);
            right = std::min(both_.right, left + widest - 1);
        }
        last = std::min(last, first + highest - 1);
        found_.left = left;
        found_.top = both_.y_of(first);
        found_.is_cut = left > both_.left || right < both_.right || first > 0 || last < last_row;

        std::unordered_map<std::string, char> letter_of;
        for (int row = first; row <= last; ++row) {
            std::string marks, faces_a, faces_b;
            for (int x = left; x <= right; ++x) {
                const Pixel pixel{x, both_.y_of(row)};
                marks += row_of(verdict(pixel)).mark;
                faces_a += letter(letter_of, a_.owner(pixel), known_a_);
                faces_b += letter(letter_of, b_.owner(pixel), known_b_);
            }
            found_.rows.push_back(std::move(marks));
            found_.faces_a.push_back(std::move(faces_a));
            found_.faces_b.push_back(std::move(faces_b));
        }
        const bool tells_one = scope_.tells_owners && found_.names.size() > 1;
        if (!has_other_owner_ && !tells_one)
            found_.names.clear();
        for (std::vector<std::string>* const faces : {&found_.faces_a, &found_.faces_b})
            if (found_.names.empty() || (tells_one && !has_letters(*faces)))
                faces->clear();
    }

    static bool has_letters(const std::vector<std::string>& rows) {
        return std::any_of(rows.begin(), rows.end(), [](const std::string& row) {
            return row.find_first_not_of('.') != std::string::npos;
        });
    }

    char letter(std::unordered_map<std::string, char>& letter_of, std::uint32_t owner,
                KnownOwners& known) {
        if (owner == 0)
            return '.';
        const std::string& text = known.of(owner).name;
        const auto found = letter_of.find(text);
        if (found != letter_of.end())
            return found->second;
        if (found_.names.size() == primitive_letters.size())
            return '#';
        const char next = primitive_letters[found_.names.size()];
        found_.names.push_back(text);
        letter_of.emplace(text, next);
        return next;
    }

    const OwnedPicture& a_;
    const OwnedPicture& b_;
    const PictureOwners& owners_;
    KnownOwners known_a_;
    KnownOwners known_b_;
    const PictureScope& scope_;
    BothCanvases both_;
    PictureDifference found_;
    Consequences led_to_;
    bool has_any_ = false;
    bool has_other_owner_ = false; ///< some pixel of both is of different primitives
    int left_ = 0;                 ///< of all pixels that differ
    int right_ = 0;
    int first_row_ = 0;
    int last_row_ = 0;
};

} // namespace

bool are_near(Color a, Color b, int tolerance) {
    const auto near = [tolerance](std::uint8_t one, std::uint8_t other) {
        return std::abs(int{one} - int{other}) <= tolerance;
    };
    return a == b || (near(a.red(), b.red()) && near(a.green(), b.green()) &&
                      near(a.blue(), b.blue()) && near(a.alpha(), b.alpha()));
}

SeenStep seen_in(const Trace& trace, std::size_t n) {
    const auto kind = trace.kind_of(n);
    if (kind == StepKind::pixel) {
        const auto pixel = trace.step(n).as<PixelStep>();
        return {.what = SeenStep::What::pixel,
                .x = pixel.x,
                .y = pixel.y,
                .color = pixel.color.color()};
    }
    if (kind == StepKind::primitive)
        return {.what = SeenStep::What::primitive,
                .color = trace.step(n).as<PrimitiveStep>().color.color()};
    return {};
}

std::pair<PictureDifference, Consequences> difference_between(const OwnedPicture& a,
                                                              const OwnedPicture& b,
                                                              const PictureOwners& owners,
                                                              const PictureScope& scope) {
    return PictureComparison(a, b, owners, scope).compare();
}

} // namespace rastertrace
