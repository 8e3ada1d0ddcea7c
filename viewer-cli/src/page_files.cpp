// SPDX-License-Identifier: MIT
#include "page_files.h"

#include <rastertrace/trace/problem.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>
#include <system_error>

namespace rastertrace {

namespace {

/// The word that has the name of the output, and where in it: -o FILE, -oFILE, --output FILE, --output=FILE.
struct OutputWord {
    std::size_t word;
    std::size_t begin;
};
std::optional<OutputWord> output_in(const std::vector<std::string>& words) {
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string& word = words[i];
        if ((word == "-o" || word == "--output") && i + 1 < words.size())
            return OutputWord{i + 1, 0};
        for (const std::string_view begin : {std::string_view("--output="), std::string_view("-o")})
            if (word.starts_with(begin) && word.size() > begin.size())
                return OutputWord{i, begin.size()};
    }
    return std::nullopt;
}

std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

bool writes_file(const std::vector<std::string>& words) {
    if (words.empty() || (words.front() != "figure" && words.front() != "trace"))
        return false;
    const auto output = output_in(words);
    if (!output)
        return false;
    const std::string_view path = std::string_view(words[output->word]).substr(output->begin);
    return path != "-" && !path.starts_with("/dev/");
}

OutputElsewhere::OutputElsewhere(std::vector<std::string> words) : words_(std::move(words)) {
    std::error_code error;
    const std::filesystem::path temporary = std::filesystem::temp_directory_path(error);
    std::string pattern = (temporary / "rastertrace-page-XXXXXX").string();
    if (error || ::mkdtemp(pattern.data()) == nullptr) {
        Problem problem =
            problem_of(error ? "TMPDIR" : pattern,
                       error ? error.message() : std::generic_category().message(errno));
        problem.cause = Problem::Cause::system;
        throw problem;
    }
    folder_ = pattern;
    const auto output = output_in(words_);
    std::string& word = words_[output->word];
    const std::filesystem::path path(word.substr(output->begin));
    final_folder_ = path.parent_path();
    word.replace(output->begin, std::string::npos, (folder_ / path.filename()).string());
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
