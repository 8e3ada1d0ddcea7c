// SPDX-License-Identifier: MIT
#pragma once

// All that it takes to draw a scene and to listen. Who wants one algorithm, inlined and without a plan,
// includes its own header and a painter: core/fill_top_left.h and core/flat_painter.h.

#include <rastertrace/core/draw.h>
#include <rastertrace/core/image.h>
#include <rastertrace/core/listener.h>
#include <rastertrace/core/plan.h>
#include <rastertrace/core/quantity.h>
#include <rastertrace/core/scene.h>
#include <rastertrace/core/steps.h>
