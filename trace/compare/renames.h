// SPDX-License-Identifier: MIT
#pragma once

// What the names of one trace, of primitives, vertices and edges, are called in the other.
//
//     Renames renames;
//     renames.add(primitive_in_a, primitive_in_b);
//     renames.in_step(step_of_b);  // with the names that a has

#include <string>
#include <string_view>
#include <unordered_map>

namespace rastertrace {

class Renames {
public:
    /// The names of a primitive, from the steps that begin it in both traces. A name of b that stands for different
    /// ones of a is left as it is.
    void add(const std::string& step_a, const std::string& step_b);

    bool is_empty() const { return a_of_b_.empty(); }

    /// A step of b with the names of a; those that `fallback` alone knows with its own.
    std::string in_step(std::string_view step, const Renames& fallback) const;

private:
    void add_name(const std::string& in_a, const std::string& in_b);

    std::unordered_map<std::string, std::string> a_of_b_; ///< as they stand in JSON, with quotes
};

} // namespace rastertrace
