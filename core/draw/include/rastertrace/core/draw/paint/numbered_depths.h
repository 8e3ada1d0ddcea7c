// SPDX-License-Identifier: MIT
#pragma once

// The depth tests of a picture whose pieces are drawn in doubles or in fractions. A cell has a double
// and the number of its piece, and of each piece it is known how far its doubles may be off. Where two
// depths differ by less than that, the exact depths of both pieces are compared.
//
//     depths.begin(7);       // the depths that follow are of piece 7
//     depths.try_out(true);  // they are intervals, and none is kept: how far may doubles be off?
//     depths.draw();         // they are doubles or fractions

#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/draw/paint/depth_tests.h>
#include <rastertrace/core/numbers/interval.h>

#include <functional>
#include <limits>
#include <utility>

namespace rastertrace {

/// The exact turned depth of a piece in a pixel, by the scene's method; of a line, that of the side
/// that begins at a corner.
Rational exact_depth(const Scene& scene, const Piece<Rational>& piece, std::size_t corner,
                     Pixel pixel);

class NumberedDepths : public DepthTests<double> {
public:
    /// Returns that of a piece by its number, at this x and row.
    using ExactDepth = std::function<Rational(std::uint32_t, std::size_t corner, int x, int row)>;

    NumberedDepths(const DepthRegion& region, const DepthRule<Rational>& rule, ExactDepth exact)
        : DepthTests(region, {rule.larger_passes, {}}, true), region_(region),
          exact_depth_(std::move(exact)) {
        if (rule.cleared)
            cleared_ = turned(*rule.cleared);
        const auto known = Conversion<Interval>::of(cleared_.value_or(0));
        clear_ = {known.middle(), known.width(), no_owner};
    }

    void begin(std::uint32_t piece) {
        owner_ = piece * sides;
        errors_.resize(piece);
        errors_.push_back(0);
    }
    void begin_side(std::size_t corner) {
        owner_ = piece_of(owner_) * sides + static_cast<std::uint32_t>(corner);
    }
    static std::uint32_t piece_of(std::uint32_t owner) { return owner / sides; }

    /// A test that intervals leave open throws Undecided. Without `throws` it passes, and every face
    /// does: then a trial only finds out how far its doubles may be off.
    void try_out(bool throws) {
        is_trial_ = true;
        throws_ = throws;
        tried_ = {};
    }
    void draw() { is_trial_ = false; }

    /// The number of tests that took exact depths.
    std::uint64_t exact_tests() const { return exact_tests_; }

    // As DepthTests has them.
    template <typename Depth> Depth turned(const Depth& depth) const {
        return rastertrace::turned(depth, larger_passes());
    }
    template <typename Depth> bool is_nearer(const double& cell, const Depth& depth) {
        const Held held = held_by(depth);
        return !has_depth(cell) || is_less(held, in(cell), cell);
    }
    template <typename Depth> bool hides(const double& cell, const Depth& depth) {
        const Held own = held_by(depth); // first: it may enlarge the error of the piece in the cell
        return is_less(in(cell), own, cell);
    }
    template <typename Depth> bool keep_if_nearer(double& cell, const Depth& depth) {
        if (is_trial_ && !throws_) {
            held_by(depth); // keeps the error
            return true;
        }
        if (!is_nearer(cell, depth))
            return false;
        if (!is_trial_) {
            cell = to_double(depth);
            owners_[buffer_.index_of(cell)] = owner_;
        }
        return !is_behind_thin(cell, depth, Thickness::face);
    }
    template <typename Depth>
    bool is_behind_thin(const double& cell, const Depth& depth, Thickness thickness) {
        const Thin* const thin = thin_at(cell);
        if (thin == nullptr)
            return false;
        const Held own = held_by(depth);
        const Held other = held_by(*thin);
        return thickness < thin->thickness ? is_less(other, own, cell) : !is_less(own, other, cell);
    }
    std::optional<std::uint32_t> thin_owner_of(const double& cell) const {
        return thin_at(cell) ? std::optional(thin_at(cell)->owner) : std::nullopt;
    }
    template <typename Depth>
    void keep_thin(const double& cell, const Depth& depth, Thickness thickness) {
        ThinDepths<double>& kept = is_trial_ ? tried_ : thin_;
        kept.keep(buffer_.index_of(cell), {to_double(depth), thickness, owner_});
    }
    template <typename Depth> std::optional<Depth> stored_face(const double& cell) const {
        return has_depth(cell) ? std::optional(told<Depth>(in(cell), cell)) : std::nullopt;
    }
    template <typename Depth> std::optional<Depth> stored_thin(const double& cell) const {
        const Thin* const thin = thin_at(cell);
        return thin ? std::optional(told<Depth>(held_by(*thin), cell)) : std::nullopt;
    }
    bool hides_thin(const double& cell) {
        return owner_of(cell) && is_less(in(cell), held_by(*thin_at(cell)), cell);
    }

private:
    using Thin = ThinDepths<double>::Thin;
    static constexpr std::uint32_t sides = 4; ///< of a piece, at most; each is an owner

    /// A turned depth, and how far it may be off.
    struct Held {
        double near;
        double error;
        std::uint32_t owner;
    };
    Held held_by(const Thin& thin) const {
        return {thin.depth, errors_[piece_of(thin.owner)], thin.owner};
    }
    Held held_by(const double& depth) { return {depth, errors_.back(), owner_}; }
    [[gnu::always_inline]] Held held_by(const Interval& depth) {
        if (is_trial_ && throws_)
            require_finite(depth);          // it is told
        const double error = depth.width(); // of any double in it
        if (!(error <= errors_.back()))
            errors_.back() = error;
        return {depth.middle(), error, owner_};
    }
    Held held_by(const Rational& depth) { return held_by(Conversion<Interval>::of(depth)); }
    Held in(const double& cell) const {
        const auto owner = owner_of(cell);
        return owner ? Held{cell, errors_[piece_of(*owner)], *owner} : clear_;
    }
    bool has_depth(const double& cell) const { return cleared_ || owner_of(cell); }
    const Thin* thin_at(const double& cell) const {
        const Thin* const tried = is_trial_ ? tried_.find(buffer_.index_of(cell)) : nullptr;
        return tried ? tried : thin_.find(buffer_.index_of(cell));
    }

    [[gnu::always_inline]] bool is_less(const Held& a, const Held& b, const double& cell) {
        // Both are rounded. The difference has the right sign; the error is enlarged by more than that.
        const double difference = b.near - a.near;
        const double error = (a.error + b.error) * (1 + 4 * std::numeric_limits<double>::epsilon());
        return difference > error || (!(difference <= -error) && is_less_exactly(a, b, cell));
    }
    [[gnu::noinline]] bool is_less_exactly(const Held& a, const Held& b, const double& cell) {
        if (is_trial_ && throws_)
            throw Undecided{a.near - b.near, a.error + b.error};
        exact_tests_ += is_trial_ ? 0 : 1;
        return is_trial_ || exact(a, cell) < exact(b, cell);
    }
    Rational exact(const Held& held, const double& cell) const {
        const auto index = static_cast<int>(buffer_.index_of(cell));
        const int x = region_.left + index % region_.width;
        const int row = region_.top_row + index / region_.width;
        return held.owner == no_owner
                   ? *cleared_
                   : exact_depth_(piece_of(held.owner), held.owner % sides, x, row);
    }
    template <typename Depth> Depth told(const Held& held, const double& cell) const {
        if constexpr (std::same_as<Depth, Rational>)
            return turned(exact(held, cell));
        else
            return turned(Depth(held.near));
    }

    DepthRegion region_;
    std::optional<Rational> cleared_; ///< turned
    Held clear_;
    ExactDepth exact_depth_;
    std::vector<double> errors_; ///< of the doubles of each piece, at most
    ThinDepths<double> tried_;   ///< of the piece that is tried
    std::uint64_t exact_tests_ = 0;
    bool is_trial_ = false;
    bool throws_ = false;
};

} // namespace rastertrace
