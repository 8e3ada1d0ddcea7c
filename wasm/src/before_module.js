// SPDX-License-Identifier: MIT
// Emscripten puts this before its own code. The module holds its WebAssembly as text, and fetches nothing: without
// this, it would fetch that text as a data: address, which counts as a request.

var fetch;
