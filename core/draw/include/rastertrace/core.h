// SPDX-License-Identifier: MIT
#pragma once

#if __cplusplus < 202002L
#error "rastertrace needs C++20: -std=c++20"
#endif

// All that it takes to draw a scene and to listen. Who wants one algorithm, inlined and without a
// plan, includes its own header and a painter: core/raster/fill_scanline.h and
// core/raster/flat_painter.h.

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/draw/tell/listener.h>
#include <rastertrace/core/numbers/quantity.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/steps.h>
