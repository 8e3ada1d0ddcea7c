// SPDX-License-Identifier: MIT
#pragma once

#include <rastertrace/emit.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Tells, to a part, the pixels in one half of the canvas of `triangles` triangles, in which every third has none.
void draw_tile(struct rt_trace* part, int triangles, int is_right);

#ifdef __cplusplus
}
#endif
