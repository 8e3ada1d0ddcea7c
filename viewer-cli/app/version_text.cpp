// SPDX-License-Identifier: MIT
#include "app/version_text.h"

#include "app/installed_files.h"
#include "commands/report_file.h"

#include <rastertrace/trace/text/problem.h>
#include <rastertrace/wasm/module.h>

#include <fmt/core.h>

#include <gmp.h>

namespace rastertrace {

namespace {

std::string place_of_examples() {
    try {
        return examples_folder().string();
    } catch (const Problem&) {
        return "none found";
    }
}

} // namespace

std::string version_text(bool is_verbose) {
    const std::string text = fmt::format("rastertrace {}\n", RASTERTRACE_VERSION);
    if (!is_verbose)
        return text;
    const Machine machine = this_machine();
    return text + fmt::format("  compiler  {}\n  flags     {}\n  packages  GMP {}, fmt {}.{}.{}\n"
                              "  pages     {}\n  examples  {}\n",
                              machine.compiler, machine.flags, gmp_version, FMT_VERSION / 10000,
                              FMT_VERSION / 100 % 100, FMT_VERSION % 100,
                              wasm_module().empty()
                                  ? "show what was drawn: built without RASTERTRACE_WASM"
                                  : "draw by themselves, with the arithmetic of this program",
                              place_of_examples());
}

} // namespace rastertrace
