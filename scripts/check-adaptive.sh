#!/bin/sh
# The long version of Adaptive.DecidesAsExact: 100,000 random scenes, or as many as are asked for.
#
#     scripts/check-adaptive.sh 20000
set -eu
cd "$(dirname "$0")/.."

cmake --preset test -G Ninja
cmake --build build/test --target test-core
RASTERTRACE_ADAPTIVE_SCENES="${1:-100000}" build/test/tests/test-core \
    --gtest_filter=Adaptive.DecidesAsExact
