// SPDX-License-Identifier: MIT
#pragma once

// A folder of its own, which is removed with all that is in it, whatever ends the program but SIGKILL.
//
//     const TemporaryFolder folder("rastertrace-fuzz");
//     write(folder.path() / "scene.json");

#include "app/run_program.h"

#include <rastertrace/trace/text/descriptor.h>

#include <filesystem>
#include <string>

namespace rastertrace {

class TemporaryFolder {
public:
    /// Throws a Problem if there can be no folder.
    explicit TemporaryFolder(const std::string& name);
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder();

    const std::filesystem::path& path() const { return path_; }

private:
    EndingHeldBack until_removed_;
    Descriptor parent_;
    std::filesystem::path path_;
};

} // namespace rastertrace
