// SPDX-License-Identifier: MIT
#include "gmpxx.h"

#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace {

constexpr std::uint64_t digit_base = std::uint64_t{1} << 32;

std::uint32_t low_digit(std::uint64_t value) {
    return static_cast<std::uint32_t>(value % digit_base);
}

} // namespace

// Digits without a sign.

std::strong_ordering mpz_class::order(const Digits& a, const Digits& b) {
    if (a.size() != b.size())
        return a.size() <=> b.size();
    for (std::size_t i = a.size(); i-- > 0;)
        if (a[i] != b[i])
            return a[i] <=> b[i];
    return std::strong_ordering::equal;
}

mpz_class::Digits mpz_class::sum(const Digits& a, const Digits& b) {
    const Digits& longer = a.size() < b.size() ? b : a;
    const Digits& shorter = a.size() < b.size() ? a : b;
    Digits result(longer.size() + 1);
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < longer.size(); ++i) {
        carry += std::uint64_t{longer[i]} + (i < shorter.size() ? shorter[i] : 0);
        result[i] = low_digit(carry);
        carry /= digit_base;
    }
    result[longer.size()] = low_digit(carry);
    result.keep(result.size());
    return result;
}

mpz_class::Digits mpz_class::difference(const Digits& a, const Digits& b) {
    Digits result(a.size());
    std::uint64_t borrowed = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const std::uint64_t taken = borrowed + (i < b.size() ? b[i] : 0);
        borrowed = a[i] < taken ? 1 : 0;
        result[i] = low_digit(borrowed * digit_base + a[i] - taken);
    }
    result.keep(result.size());
    return result;
}

mpz_class::Digits mpz_class::product(const Digits& a, const Digits& b) {
    Digits result(a.size() + b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::uint64_t carry = 0;
        for (std::size_t j = 0; j < b.size(); ++j) {
            carry += std::uint64_t{a[i]} * b[j] + result[i + j];
            result[i + j] = low_digit(carry);
            carry /= digit_base;
        }
        result[i + b.size()] = low_digit(carry);
    }
    result.keep(result.size());
    return result;
}

std::uint64_t mpz_class::low_64_bits(const Digits& digits) {
    const std::uint64_t low = digits.empty() ? 0 : digits[0];
    return digits.size() < 2 ? low : low + digits[1] * digit_base;
}

std::uint32_t mpz_class::divide_by_digit(Digits& above, std::uint32_t below) {
    std::uint64_t rest = 0;
    for (std::size_t i = above.size(); i-- > 0;) {
        rest = rest * digit_base + above[i];
        above[i] = low_digit(rest / below);
        rest %= below;
    }
    above.keep(above.size());
    return low_digit(rest);
}

/// Long division, Knuth's algorithm D.
std::pair<mpz_class::Digits, mpz_class::Digits> mpz_class::quotient_and_rest(Digits above,
                                                                             Digits below) {
    if (order(above, below) < 0)
        return {{}, std::move(above)};
    if (above.size() <= 2) {
        const std::uint64_t a = low_64_bits(above);
        const std::uint64_t b = low_64_bits(below);
        return {mpz_class(a / b).digits_, mpz_class(a % b).digits_};
    }
    if (below.size() == 1) {
        const std::uint32_t rest = divide_by_digit(above, below[0]);
        return {std::move(above), mpz_class(rest).digits_};
    }

    // Both are made larger until the first digit of the divisor is at least half of the base: then a digit
    // of the quotient, guessed from the first digits, is too large by 2 at most.
    const auto shift = static_cast<unsigned>(std::countl_zero(below.back()));
    const auto shifted = [shift](const Digits& digits) {
        Digits result(digits.size() + 1);
        std::uint64_t carry = 0;
        for (std::size_t i = 0; i < digits.size(); ++i) {
            carry |= std::uint64_t{digits[i]} << shift;
            result[i] = low_digit(carry);
            carry /= digit_base;
        }
        result[digits.size()] = low_digit(carry);
        return result;
    };
    const std::size_t size = below.size();
    above = shifted(above);
    below = shifted(below);
    const std::uint64_t first = below[size - 1];
    const std::uint64_t second = below[size - 2];

    Digits quotient(above.size() - size);
    for (std::size_t i = quotient.size(); i-- > 0;) {
        // The guess, corrected by the next digit of both: now it is too large by 1 at most.
        const std::uint64_t top = above[i + size] * digit_base + above[i + size - 1];
        std::uint64_t guess = top / first;
        std::uint64_t rest = top % first;
        while (guess >= digit_base || guess * second > rest * digit_base + above[i + size - 2]) {
            --guess;
            rest += first;
            if (rest >= digit_base)
                break;
        }

        // The guess times the divisor is taken away.
        std::uint64_t carry = 0;
        std::uint64_t borrowed = 0;
        for (std::size_t j = 0; j <= size; ++j) {
            carry += j < size ? guess * below[j] : 0;
            const std::uint64_t taken = carry % digit_base + borrowed;
            carry /= digit_base;
            borrowed = above[i + j] < taken ? 1 : 0;
            above[i + j] = low_digit(borrowed * digit_base + above[i + j] - taken);
        }

        // It was too large by 1: the divisor is added again.
        if (borrowed != 0) {
            --guess;
            carry = 0;
            for (std::size_t j = 0; j <= size; ++j) {
                carry += std::uint64_t{above[i + j]} + (j < size ? below[j] : 0);
                above[i + j] = low_digit(carry);
                carry /= digit_base;
            }
        }
        quotient[i] = low_digit(guess);
    }

    // The rest is made as small again.
    std::uint64_t carry = 0;
    for (std::size_t i = size; i-- > 0;) {
        carry = (carry << 32) | above[i];
        above[i] = low_digit(carry >> shift);
    }
    above.keep(size);
    quotient.keep(quotient.size());
    return {std::move(quotient), std::move(above)};
}

// Whole numbers.

mpz_class::mpz_class(std::string_view decimal, int) {
    const bool is_negative = decimal.starts_with('-');
    for (const char c : decimal.substr(is_negative ? 1 : 0))
        *this = *this * 10 + (c - '0');
    is_negative_ = is_negative && !digits_.empty();
}

mpz_class::mpz_class(double value) {
    int exponent = 0;
    const double significand = std::frexp(std::abs(std::trunc(value)), &exponent);
    const mpz_class whole = static_cast<std::uint64_t>(std::ldexp(significand, 64));
    *this = exponent >= 64 ? whole << static_cast<mp_bitcnt_t>(exponent - 64)
                           : whole >> static_cast<mp_bitcnt_t>(64 - exponent);
    is_negative_ = value < 0 && !digits_.empty();
}

mpz_class::mpz_class(const mpq_class& value) : mpz_class(value.get_num() / value.get_den()) {}

std::string mpz_class::get_str() const {
    if (digits_.empty())
        return "0";
    // Nine decimal digits at a time, from the last.
    std::string reversed;
    for (Digits rest = digits_; !rest.empty();) {
        std::uint32_t nine = divide_by_digit(rest, 1'000'000'000);
        for (int i = 0; i < 9; ++i, nine /= 10)
            reversed += static_cast<char>('0' + nine % 10);
    }
    reversed.erase(reversed.find_last_not_of('0') + 1);
    if (is_negative_)
        reversed += '-';
    return {reversed.rbegin(), reversed.rend()};
}

mp_bitcnt_t mpz_class::bits() const {
    if (digits_.empty())
        return 0;
    return 32 * mp_bitcnt_t{digits_.size()} -
           static_cast<mp_bitcnt_t>(std::countl_zero(digits_.back()));
}

double mpz_class::get_d() const {
    long exponent = 0;
    const double significand = mpz_get_d_2exp(&exponent, this);
    return std::scalbln(significand, exponent);
}

bool mpz_class::fits_slong_p() const {
    // Only the lowest negative number has 64 bits.
    constexpr auto lowest = std::numeric_limits<std::int64_t>::min();
    return bits() < 64 || (is_negative_ && bits() == 64 && *this == mpz_class(lowest));
}

std::int64_t mpz_class::get_si() const {
    const std::uint64_t bits = low_64_bits(digits_);
    return static_cast<std::int64_t>(is_negative_ ? 0 - bits : bits);
}

std::strong_ordering operator<=>(const mpz_class& a, const mpz_class& b) {
    if (a.is_negative_ != b.is_negative_)
        return b.is_negative_ <=> a.is_negative_;
    return a.is_negative_ ? mpz_class::order(b.digits_, a.digits_)
                          : mpz_class::order(a.digits_, b.digits_);
}

bool operator==(const mpz_class& a, double b) {
    return std::trunc(b) == b && a == mpz_class(b);
}

mpz_class operator+(const mpz_class& a, const mpz_class& b) {
    if (a.is_negative_ == b.is_negative_)
        return {a.is_negative_, mpz_class::sum(a.digits_, b.digits_)};
    if (mpz_class::order(a.digits_, b.digits_) < 0)
        return {b.is_negative_, mpz_class::difference(b.digits_, a.digits_)};
    return {a.is_negative_, mpz_class::difference(a.digits_, b.digits_)};
}

mpz_class operator-(const mpz_class& a, const mpz_class& b) {
    return a + -b;
}

mpz_class operator*(const mpz_class& a, const mpz_class& b) {
    return {a.is_negative_ != b.is_negative_, mpz_class::product(a.digits_, b.digits_)};
}

std::pair<mpz_class, mpz_class> mpz_class::divided(const mpz_class& above, const mpz_class& below) {
    if (below.digits_.empty())
        throw std::domain_error("division by zero");
    auto [quotient, rest] = quotient_and_rest(above.digits_, below.digits_);
    return {mpz_class(above.is_negative_ != below.is_negative_, std::move(quotient)),
            mpz_class(above.is_negative_, std::move(rest))};
}

mpz_class operator/(const mpz_class& a, const mpz_class& b) {
    return mpz_class::divided(a, b).first;
}

mpz_class operator%(const mpz_class& a, const mpz_class& b) {
    return mpz_class::divided(a, b).second;
}

mpz_class operator<<(const mpz_class& a, mp_bitcnt_t bits) {
    if (a.digits_.empty())
        return a;
    const auto zeros = static_cast<std::size_t>(bits / 32);
    mpz_class::Digits digits(zeros + a.digits_.size() + 1);
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < a.digits_.size(); ++i) {
        carry |= std::uint64_t{a.digits_[i]} << bits % 32;
        digits[zeros + i] = low_digit(carry);
        carry /= digit_base;
    }
    digits[zeros + a.digits_.size()] = low_digit(carry);
    digits.keep(digits.size());
    return {a.is_negative_, std::move(digits)};
}

mpz_class operator>>(const mpz_class& a, mp_bitcnt_t bits) {
    const auto whole = static_cast<std::size_t>(std::min<mp_bitcnt_t>(bits / 32, a.digits_.size()));
    mpz_class::Digits digits(a.digits_.size() - whole);
    std::uint64_t carry = 0;
    for (std::size_t i = digits.size(); i-- > 0;) {
        carry = carry << 32 | a.digits_[whole + i];
        digits[i] = low_digit(carry >> bits % 32);
    }
    digits.keep(digits.size());
    mpz_class result(a.is_negative_, std::move(digits));

    // Down, not toward 0: that differs if something negative has been cut off.
    if (a.is_negative_ && result << bits != a)
        result -= 1;
    return result;
}

mpz_class gcd(mpz_class a, mpz_class b) {
    // On 64 bits, as soon as both have place there, the machine divides.
    while (b.bits() > 63 || a.bits() > 63) {
        if (sgn(b) == 0)
            return abs(std::move(a));
        a = a % b;
        a.swap(b);
    }
    auto x = static_cast<std::uint64_t>(abs(std::move(a)).get_si());
    auto y = static_cast<std::uint64_t>(abs(std::move(b)).get_si());
    while (y != 0)
        x = std::exchange(y, x % y);
    return x;
}

mpz_class lcm(const mpz_class& a, const mpz_class& b) {
    const mpz_class divisor = gcd(a, b);
    return sgn(divisor) == 0 ? mpz_class(0) : abs(a / divisor * b);
}

mpz_class sqrt(const mpz_class& a) {
    if (sgn(a) == 0)
        return a;
    // Newton's method from above: it falls until it is there.
    mpz_class root = mpz_class(1) << (a.bits() + 1) / 2;
    for (;;) {
        mpz_class next = (root + a / root) >> 1;
        if (next >= root)
            return root;
        root = std::move(next);
    }
}

// Fractions.

mpq_class::mpq_class(double value) {
    if (!std::isfinite(value))
        throw std::domain_error("no fraction is infinite");
    // The significand is a whole number of 53 bits.
    int exponent = 0;
    const double significand = std::frexp(value, &exponent);
    above_ = static_cast<std::int64_t>(std::ldexp(significand, 53));
    exponent -= 53;
    if (exponent >= 0)
        above_ = above_ << static_cast<mp_bitcnt_t>(exponent);
    else
        below_ = below_ << static_cast<mp_bitcnt_t>(-exponent);
    canonicalize();
}

void mpq_class::canonicalize() {
    if (sgn(below_) == 0)
        throw std::domain_error("division by zero");
    const mpz_class divisor = gcd(above_, below_);
    if (divisor != 1) {
        above_ /= divisor;
        below_ /= divisor;
    }
    if (sgn(below_) < 0) {
        above_ = -std::move(above_);
        below_ = -std::move(below_);
    }
}

std::string mpq_class::get_str() const {
    return below_ == 1 ? above_.get_str() : above_.get_str() + "/" + below_.get_str();
}

double mpq_class::get_d() const {
    if (sgn(above_) == 0)
        return 0;
    // A quotient of 64 or 65 bits; what is cut off with the rest lies toward 0.
    const auto shift =
        static_cast<std::int64_t>(below_.bits()) - static_cast<std::int64_t>(above_.bits()) + 64;
    const mpz_class quotient = shift >= 0 ? (above_ << static_cast<mp_bitcnt_t>(shift)) / below_
                                          : above_ / (below_ << static_cast<mp_bitcnt_t>(-shift));
    long exponent = 0;
    double significand = mpz_get_d_2exp(&exponent, &quotient);
    exponent -= static_cast<long>(shift);
    // A double near to 0 has fewer bits: these are cut off too.
    constexpr long least = std::numeric_limits<double>::min_exponent;
    if (exponent < least) {
        const int bits = 53 - static_cast<int>(std::min(least - exponent, 53L));
        significand = std::ldexp(std::trunc(std::ldexp(significand, bits)), -bits);
    }
    return std::scalbln(significand, exponent);
}

std::strong_ordering operator<=>(const mpq_class& a, const mpq_class& b) {
    if (a.below_ == b.below_)
        return a.above_ <=> b.above_;
    return a.above_ * b.below_ <=> b.above_ * a.below_;
}

mpq_class operator+(const mpq_class& a, const mpq_class& b) {
    mpq_class result = a.below_ == b.below_ ? mpq_class(a.above_ + b.above_, a.below_)
                                            : mpq_class(a.above_ * b.below_ + b.above_ * a.below_,
                                                        a.below_ * b.below_);
    if (result.below_ != 1)
        result.canonicalize();
    return result;
}

mpq_class operator-(const mpq_class& a, const mpq_class& b) {
    return a + -b;
}

mpq_class operator*(const mpq_class& a, const mpq_class& b) {
    mpq_class result(a.above_ * b.above_, a.below_ * b.below_);
    if (result.below_ != 1)
        result.canonicalize();
    return result;
}

mpq_class operator/(const mpq_class& a, const mpq_class& b) {
    mpq_class result(a.above_ * b.below_, a.below_ * b.above_);
    result.canonicalize();
    return result;
}

// Functions of GMP's C interface.

void mpz_ui_pow_ui(mpz_class* result, std::uint64_t base, std::uint64_t exponent) {
    mpz_class power = 1;
    for (mpz_class square = base; exponent != 0; exponent /= 2, square *= square)
        if (exponent % 2 == 1)
            power *= square;
    *result = std::move(power);
}

void mpz_fdiv_q(mpz_class* quotient, const mpz_class* above, const mpz_class* below) {
    mpz_class toward_zero = *above / *below;
    const mpz_class rest = *above - toward_zero * *below;
    if (sgn(rest) * sgn(*below) < 0)
        toward_zero -= 1;
    *quotient = std::move(toward_zero);
}

void mpz_cdiv_q(mpz_class* quotient, const mpz_class* above, const mpz_class* below) {
    const mpz_class negative = -*above;
    mpz_class down;
    mpz_fdiv_q(&down, &negative, below);
    *quotient = -std::move(down);
}

std::uint64_t mpz_fdiv_ui(const mpz_class* above, std::uint64_t below) {
    const mpz_class divisor = below;
    mpz_class rest = *above % divisor;
    if (sgn(rest) < 0)
        rest += divisor;
    return static_cast<std::uint64_t>(rest.get_si());
}

mp_bitcnt_t mpz_remove(mpz_class* result, const mpz_class* from, const mpz_class* factor) {
    const mpz_class divisor = *factor;
    mpz_class rest = *from;
    mp_bitcnt_t count = 0;
    for (; sgn(rest) != 0 && sgn(rest % divisor) == 0; ++count)
        rest /= divisor;
    *result = std::move(rest);
    return count;
}

std::size_t mpz_sizeinbase(const mpz_class* number, int base) {
    const mp_bitcnt_t bits = std::max<mp_bitcnt_t>(number->bits(), 1);
    if (base == 2)
        return static_cast<std::size_t>(bits);
    // The logarithm of 2, as GMP has it: times 2^64, rounded down.
    const mpz_class logarithm_of_2 = std::uint64_t{0x4d104d427de7fbcc};
    return static_cast<std::size_t>(mpz_class((logarithm_of_2 * bits) >> 64).get_ui()) + 1;
}

bool mpz_perfect_square_p(const mpz_class* number) {
    if (sgn(*number) < 0)
        return false;
    const mpz_class root = sqrt(*number);
    return root * root == *number;
}

double mpz_get_d_2exp(long* exponent, const mpz_class* number) {
    // The highest 53 bits are a double.
    const mp_bitcnt_t bits = number->bits();
    const mpz_class size = abs(*number);
    const mpz_class highest = bits > 53 ? size >> (bits - 53) : size;
    int of_highest = 0;
    const double significand = std::frexp(static_cast<double>(highest.get_si()), &of_highest);
    *exponent = static_cast<long>(bits);
    return sgn(*number) < 0 ? -significand : significand;
}
