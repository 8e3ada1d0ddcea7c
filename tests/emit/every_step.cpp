// SPDX-License-Identifier: MIT
#include "every_step.c"
