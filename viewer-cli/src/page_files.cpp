// SPDX-License-Identifier: MIT
#include "page_files.h"

#include "frame_files.h"

#include <rastertrace/trace/text/problem.h>

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

/// Of the numbers of a sequence: no system lets more files be open at once.
constexpr std::size_t most_digits = 6;

/// The current folder, without symbolic links.
std::filesystem::path here() {
    return std::filesystem::canonical(".");
}

std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

OutputsElsewhere::OutputsElsewhere() : temporary_("rastertrace-page") {}

std::vector<std::string> OutputsElsewhere::written_files() const {
    std::vector<std::string> written;
    for (const auto& file : std::filesystem::recursive_directory_iterator(temporary_.path()))
        if (file.is_regular_file())
            written.push_back(("/" / file.path().lexically_relative(temporary_.path()))
                                  .lexically_proximate(here()));
    std::sort(written.begin(), written.end());
    return written;
}

std::vector<std::string>
OutputsElsewhere::left_over_files(const std::vector<std::string>& words) const {
    const auto output = output_in(words);
    if (!output)
        return {};
    std::error_code error;
    const auto is_written = [&](const std::string& path) {
        const auto place = std::filesystem::weakly_canonical(here() / path, error);
        return std::filesystem::exists(temporary_.path() / place.relative_path(), error);
    };
    // A sequence may have the name of the scene that it is of.
    const auto is_input = [&](const std::string& path) {
        return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
            return &word != &words[output->word] && std::filesystem::equivalent(word, path, error);
        });
    };
    std::vector<std::string> found;
    const std::string single = words[output->word].substr(output->begin);
    if (std::filesystem::is_regular_file(single, error) && !is_written(single) && !is_input(single))
        found.push_back(single);
    // Sequences have as many digits as their last number.
    std::size_t first = 1; // of so many digits
    for (std::size_t digits = 1; digits <= most_digits; ++digits, first *= 10) {
        std::vector<std::string> old;
        std::size_t n = 1;
        for (; n < 10 * first; ++n) {
            std::string path = path_of_frame(single, n, digits);
            const bool is_new = is_written(path);
            if (!is_new && !std::filesystem::is_regular_file(path, error))
                break;
            if (!is_new)
                old.push_back(std::move(path));
        }
        if (n > first)
            found.insert(found.end(), old.begin(), old.end());
    }
    return found;
}

std::vector<std::string> OutputsElsewhere::stale_files() const {
    std::vector<std::string> stale;
    for (const std::string& path : written_files()) {
        const std::filesystem::path there = (here() / path).lexically_normal();
        std::error_code error;
        const auto status = std::filesystem::status(there, error);
        // A device or a pipe has no bytes to be compared.
        if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
            continue;
        if (bytes_of(there) != bytes_of(temporary_.path() / there.relative_path()) ||
            !std::filesystem::exists(status))
            stale.push_back(path);
    }
    return stale;
}

} // namespace rastertrace
