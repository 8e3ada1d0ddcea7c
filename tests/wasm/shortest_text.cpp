// SPDX-License-Identifier: MIT
// The module's own text of a double or a float must be that of std::to_chars, for numbers of all kinds.

#include <shortest_text.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>

namespace {

class Comparison {
public:
    template <typename Floating> void compare(Floating value) {
        if (!std::isfinite(value))
            return;
        std::array<char, 64> own{};
        std::array<char, 64> standard{};
        const std::string found(own.data(), rastertrace::write_shortest(own.data(), value));
        const std::string expected(
            standard.data(),
            std::to_chars(standard.data(), standard.data() + standard.size(), value).ptr);
        ++count_;
        if (found == expected)
            return;
        ++differences_;
        if (differences_ <= 20)
            std::printf("expected %s, found %s\n", expected.c_str(), found.c_str());
    }

    int differences() const { return differences_; }
    int count() const { return count_; }

private:
    int count_ = 0;
    int differences_ = 0;
};

} // namespace

int main() {
    std::mt19937_64 random(20261123);
    Comparison comparison;
    for (int i = 0; i < 200'000; ++i) {
        // Any bits, whole numbers of any size, decimals, few bits far from the point, powers of ten.
        comparison.compare(std::bit_cast<double>(random()));
        comparison.compare(std::bit_cast<float>(static_cast<std::uint32_t>(random())));
        const std::uint64_t whole = random() >> random() % 64;
        comparison.compare(static_cast<double>(whole));
        comparison.compare(-static_cast<float>(whole));
        comparison.compare(static_cast<double>(random() % 1'000'000) / 1000);
        const double few = std::ldexp(static_cast<double>(random() % 4096),
                                      static_cast<int>(random() % 200) - 100);
        comparison.compare(few);
        comparison.compare(static_cast<float>(few));
        comparison.compare(std::pow(10.0, static_cast<int>(random() % 600) - 300) *
                           static_cast<double>(random() % 100));
    }
    std::printf("%d of %d texts differ\n", comparison.differences(), comparison.count());
    return comparison.differences() == 0 ? 0 : 1;
}
