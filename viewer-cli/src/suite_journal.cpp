// SPDX-License-Identifier: MIT
#include "suite_journal.h"

#include <rastertrace/trace/text/input_file.h>
#include <rastertrace/trace/text/json_reader.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <set>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

constexpr std::string_view journal_mark = "{\"rastertrace_suite_journal\":1}\n";

/// FNV-1a, 64 bit.
class Hash {
public:
    void add(std::string_view bytes) {
        for (const char c : bytes)
            value_ = (value_ ^ static_cast<unsigned char>(c)) * 1099511628211U;
    }
    std::string text() const { return fmt::format("{:016x}", value_); }

private:
    std::uint64_t value_ = 14695981039346656037U;
};

std::string hash_of_text(std::string_view text) {
    Hash hash;
    hash.add(text);
    return hash.text();
}

/// "" of a file that is not there, or cannot be read.
std::string hash_of_file(const std::string& path) {
    try {
        auto file = InputFile::open(path, InputFile::Kind::regular_file);
        if (!file)
            return "";
        Hash hash;
        for (std::string block; file.value().read_into(block); block.clear())
            hash.add(block);
        return hash.text();
    } catch (const Problem&) {
        return "";
    }
}

} // namespace

SuiteJournal::SuiteJournal(const std::string& path, const std::string& asked)
    : path_(path), asked_(hash_of_text(asked + "\n" + hash_of_file("/proc/self/exe"))),
      file_(::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666)) {
    struct stat status {};
    if (!file_.is_open() || ::fstat(file_.number(), &status) != 0)
        throw problem_of_system(path_, "could not be opened", errno);
    if (!S_ISREG(status.st_mode))
        throw problem_of(path_, "expected a file to keep a journal in, found a pipe or a device");
    if (::flock(file_.number(), LOCK_EX | LOCK_NB) != 0)
        throw problem_of(path_, "expected a journal that no other run writes, found one in use");
    Source source{path_, {}, {}};
    InputFile content(path_, Descriptor(::dup(file_.number())));
    while (content.read_into(source.text)) {
    }
    // A run may have been ended in the middle of a line.
    if (content.is_packed() ||
        !journal_mark.starts_with(source.text.substr(0, journal_mark.size())))
        throw problem_of(path_, "expected a journal of `suite`, found another file");
    size_ = source.text.rfind('\n') + 1;
    source.text.resize(size_);
    cut();
    if (size_ == 0)
        write(journal_mark);
    else
        read(source);
}

void SuiteJournal::read(const Source& source) {
    const JsonReader json{source};
    std::size_t next = 0;
    for (std::size_t begin = journal_mark.size(); begin < source.text.size(); begin = next) {
        next = source.text.find('\n', begin) + 1;
        const auto document = parse_json(source, begin, next - begin - 1);
        if (!document)
            throw document.problem();
        const JsonValue root = document.value().root();
        if (json.member(root, "asked").text != asked_)
            continue;
        Entry entry{.result = read_result(source, json.member(root, "case"))};
        for (const auto& [path, hash] : json.member(root, "files").members())
            entry.files.emplace(path.text, hash.text);
        entries_.insert_or_assign(entry.result.name, std::move(entry));
    }
}

std::optional<SuiteResult> SuiteJournal::find(const SuiteCase& one) const {
    const auto found = entries_.find(printable(one.name));
    if (found == entries_.end())
        return std::nullopt;
    const Entry& entry = found->second;
    for (const std::string& path : one.files)
        if (!entry.files.contains(path))
            return std::nullopt;
    for (const auto& [path, hash] : entry.files)
        if (hash_of_file(path) != hash)
            return std::nullopt;
    return entry.result;
}

void SuiteJournal::add(const SuiteCase& one, const std::vector<std::string>& read,
                       const SuiteResult& result) {
    std::set<std::string> paths(one.files.begin(), one.files.end());
    paths.insert(read.begin(), read.end());
    std::vector<std::string> files;
    for (const std::string& path : paths)
        files.push_back(json_quoted(path) + ":" + json_quoted(hash_of_file(path)));
    const std::string line = fmt::format("{{\"asked\":\"{}\",\"files\":{{{}}},\"case\":{}}}\n",
                                         asked_, joined(files, ","), result_json(result));
    const std::scoped_lock lock(mutex_);
    write(line);
}

void SuiteJournal::write(std::string_view line) {
    try {
        DescriptorOutput(file_.number(), path_).write(line);
        size_ += line.size();
    } catch (Problem& problem) {
        cut();
        problem.hint = "the cases before are kept there: the same command goes on from them";
        throw;
    }
}

void SuiteJournal::cut() const {
    if (::ftruncate(file_.number(), static_cast<off_t>(size_)) != 0)
        throw problem_of_system(path_, "could not be cut to whole lines", errno);
}

} // namespace rastertrace
