// SPDX-License-Identifier: MIT
#include <shortest_text.h>

#include <charconv>
#include <string>

namespace std { // NOLINT

to_chars_result to_chars(char* first, char*, double value) {
    return {rastertrace::write_shortest(first, value), errc{}};
}

to_chars_result to_chars(char* first, char*, float value) {
    return {rastertrace::write_shortest(first, value), errc{}};
}

from_chars_result from_chars(const char* first, const char* last, double& value) {
    // strtod wants a zero at the end, and reads more than decimals: what is asked of here is one.
    const string text(first, last);
    char* end = nullptr;
    value = strtod(text.c_str(), &end);
    return {first + (end - text.c_str()), errc{}};
}

} // namespace std
