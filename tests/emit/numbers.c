// SPDX-License-Identifier: MIT
// Numbers read back to the same bits, whatever the locale's decimal point and the compiler's options are.
//
//     numbers

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char* point = ".";

/// snprintf in a locale that has this point.
static int print_with_point(char* out, size_t size, const char* format, ...) {
    char text[100];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    const size_t front = strcspn(text, ".");
    return text[front] == '.'
               ? snprintf(out, size, "%.*s%s%s", (int)front, text, point, text + front + 1)
               : snprintf(out, size, "%s", text);
}

#define snprintf print_with_point
#include <rastertrace/emit.h>

static int failures = 0;

static void expect_text(double value, const char* expected) {
    static struct rt_trace t;
    rt_append_number_(&t, value);
    t.buffer[t.used] = '\0';
    t.used = 0;
    if (strcmp(t.buffer, expected) != 0) {
        printf("expected %s, found %s\n", expected, t.buffer);
        ++failures;
    }
}

static double from_bits(unsigned long long bits) {
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/// Not finite, or zero: told by their bits, also with -ffast-math.
static void special(void) {
    expect_text(from_bits(0x7ff0000000000000ULL), "\"inf\"");
    expect_text(from_bits(0xfff0000000000000ULL), "\"-inf\"");
    expect_text(from_bits(0x7ff8000000000000ULL), "\"NaN\"");
    expect_text(from_bits(0xfff8000000000000ULL), "\"NaN\"");
    expect_text(from_bits(0x7ff0000000000001ULL), "\"NaN\"");
    expect_text(from_bits(0x8000000000000000ULL), "0");
    expect_text(0, "0");
    expect_text(RT_NONE, "null");
}

static void told_in_full(void) {
    expect_text(1, "1");
    expect_text(-100000, "-100000");
    expect_text(4503599627370497.0, "4503599627370497");
    expect_text(9007199254740991.0, "9007199254740991");
    expect_text(0.5, "0.5");
    expect_text(-1.0 / 1024, "-0.0009765625");
    expect_text(8589934591.0009765625, "8589934591.0009765625");
    expect_text(4503599627370495.5, "4503599627370495.5");
}

static void told_in_17_digits(void) {
    expect_text(0.1, "0.10000000000000001");
    expect_text(1.0 / 3, "0.33333333333333331");
    expect_text(-2.0 / 3, "-0.66666666666666663");
    expect_text(0.3, "0.29999999999999999");
    expect_text(0.0039062499999999996, "0.0039062499999999996");
    expect_text(1.9999999999999998, "1.9999999999999998");
    expect_text(99999999999999.98, "99999999999999.984");
    expect_text(0.99999999999999989, "0.99999999999999989");
}

static void told_by_the_library(void) {
    expect_text(1e-9, "1.0000000000000001e-09");
    expect_text(-1e300, "-1.0000000000000001e+300");
    expect_text(18446744073709551616.0, "1.8446744073709552e+19");
    expect_text(from_bits(1), "4.9406564584124654e-324");
}

static void reads_back(void) {
    unsigned long long state = 88172645463325252ULL;
    for (int i = 0; i < 300000; ++i) {
        char text[80];
        state ^= state << 13, state ^= state >> 7, state ^= state << 17;
        // Any double; one of the size of a picture; a float.
        const double any = from_bits(state);
        const double near = (double)(long long)(state >> 11) / (double)(1ULL << (state % 63));
        const double values[] = {any, near, (double)(float)near};
        for (int k = 0; k < 3; ++k) {
            unsigned long long bits, read;
            memcpy(&bits, &values[k], sizeof bits);
            if ((bits >> 52 & 0x7ff) == 0x7ff || bits << 1 == 0)
                continue;
            *rt_put_finite_(text, values[k], bits) = '\0';
            const double again = strtod(text, NULL);
            memcpy(&read, &again, sizeof read);
            if (read != bits) {
                printf("%s is not %a\n", text, values[k]);
                ++failures;
            }
        }
    }
}

int main(void) {
    special();
    told_in_full();
    told_in_17_digits();
    told_by_the_library();
    reads_back();
    point = ","; // de_DE
    told_by_the_library();
    point = "\xd9\xab"; // ps_AF
    told_by_the_library();
    return failures > 0;
}
