// SPDX-License-Identifier: MIT
#include "other_goldens.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace rastertrace {

std::vector<std::string> other_goldens(const std::string& golden) {
    constexpr std::string_view mark_of_golden = ".golden";
    const std::filesystem::path path = golden;
    std::string front = path.stem().string();
    std::vector<std::string> others;
    if (!front.ends_with(mark_of_golden))
        return others;
    front.resize(front.size() - mark_of_golden.size() + 1); // to the point
    const std::string end = std::string(mark_of_golden) + path.extension().string();
    const std::filesystem::path folder = path.parent_path();
    std::error_code error;
    for (std::filesystem::directory_iterator file(folder.empty() ? "." : folder, error), behind;
         !error && file != behind; file.increment(error)) {
        const std::string other = file->path().filename().string();
        if (other.starts_with(front) && other.ends_with(end) &&
            other.size() > front.size() + end.size())
            others.push_back((folder / other).string());
    }
    std::sort(others.begin(), others.end());
    return others;
}

} // namespace rastertrace
