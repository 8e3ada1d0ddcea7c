#!/bin/sh
# SPDX-License-Identifier: MIT
# The tests of damaged and large traces (tests/viewer-cli/big_trace_test.cpp) with many more cases: 10,000 damaged traces
# and 10,000 of random lines, all examples, a line of a gigabyte, ten million names. Takes about an hour, 12 GB of memory
# and 4 GB of the disk of temporary files.
#
#     scripts/check-big-traces.sh [build/test/tests/test-viewer-cli]
set -eu
cd "$(dirname "$0")/.."
RASTERTRACE_LONG=1 exec "${1:-build/test/tests/test-viewer-cli}" --gtest_filter='BigTrace.*:BigTraceMemory.*'
