// SPDX-License-Identifier: MIT
#include "distinguish.h"

#include <map>
#include <set>
#include <utility>

namespace rastertrace {

namespace {

template <typename Answer>
std::size_t split_classes(std::vector<std::size_t>& classes, const std::vector<Answer>& answers) {
    std::map<std::pair<std::size_t, Answer>, std::size_t> numbers;
    for (std::size_t i = 0; i < classes.size(); ++i)
        classes[i] = numbers.try_emplace({classes[i], answers[i]}, numbers.size()).first->second;
    return numbers.size();
}

} // namespace

bool tells_all_apart(const Answers& answers) {
    std::set<std::string> known;
    for (const auto& answer : answers)
        if (!answer || !known.insert(*answer).second)
            return false;
    return true;
}

std::size_t Classes::split(const Answers& answers) {
    return split_classes(classes_, answers);
}

std::size_t Classes::split(const Classes& others) {
    return split_classes(classes_, others.classes_);
}

std::vector<std::vector<std::size_t>> Classes::members() const {
    std::vector<std::vector<std::size_t>> members;
    for (std::size_t i = 0; i < classes_.size(); ++i) {
        if (classes_[i] == members.size())
            members.emplace_back();
        members[classes_[i]].push_back(i);
    }
    return members;
}

} // namespace rastertrace
