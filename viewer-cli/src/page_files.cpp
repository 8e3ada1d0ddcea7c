// SPDX-License-Identifier: MIT
#include "page_files.h"

#include <rastertrace/trace/problem.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>

namespace rastertrace {

namespace {

constexpr std::array<std::string_view, 2> output_options{"-o", "--output"};

/// The word behind -o, if there is one.
auto find_output(auto& words) {
    const auto option = std::find_first_of(words.begin(), words.end(), output_options.begin(),
                                           output_options.end());
    return option == words.end() ? option : std::next(option);
}

std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

bool writes_file(const std::vector<std::string>& words) {
    if (words.empty() || (words.front() != "figure" && words.front() != "trace"))
        return false;
    const auto output = find_output(words);
    return output != words.end() && *output != "-" && !output->starts_with("/dev/");
}

OutputElsewhere::OutputElsewhere(std::vector<std::string> words) : words_(std::move(words)) {
    std::string pattern =
        (std::filesystem::temp_directory_path() / "rastertrace-page-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) {
        Problem problem = problem_of(pattern, std::generic_category().message(errno));
        problem.cause = Problem::Cause::system;
        throw problem;
    }
    folder_ = pattern;
    const auto output = find_output(words_);
    const std::filesystem::path path(*output);
    final_folder_ = path.parent_path();
    *output = (folder_ / path.filename()).string();
}

OutputElsewhere::~OutputElsewhere() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

std::vector<std::string> OutputElsewhere::stale_files() const {
    std::vector<std::string> stale;
    for (const auto& written : std::filesystem::directory_iterator(folder_)) {
        const std::filesystem::path there = final_folder_ / written.path().filename();
        std::error_code error;
        if (!std::filesystem::is_regular_file(there, error) ||
            bytes_of(there) != bytes_of(written.path()))
            stale.push_back(there.string());
    }
    std::sort(stale.begin(), stale.end());
    return stale;
}

} // namespace rastertrace
