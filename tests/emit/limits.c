// SPDX-License-Identifier: MIT
// Tells so many pixels, and says what went wrong.
//
//     limits FILE STEPS

#include <rastertrace/emit.h>

#include <stdlib.h>

int main(int count, char** arguments) {
    static struct rt_trace trace;
    if (count < 3)
        return 2;
    const long steps = atol(arguments[2]);
    rt_open(&trace, arguments[1]);
    rt_header(&trace, 1000, 1000, "top-left");
    for (long i = 0; i < steps; ++i)
        rt_pixel(&trace, i % 1000, i / 1000 % 1000);
    const int status = rt_end(&trace);
    printf("%s\n", rt_error(&trace));
    return status;
}
