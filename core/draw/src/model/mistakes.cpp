// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/model/mistakes.h>

#include "model/mistake_tables.h"

namespace rastertrace {

std::span<const Mistake> mistakes() {
    static const std::vector<Mistake> all = [] {
        std::vector<Mistake> rows;
        for (const auto& part :
             {mistakes_of_rows(), mistakes_of_samples(), mistakes_of_lines(), mistakes_of_space()})
            rows.insert(rows.end(), part.begin(), part.end());
        return rows;
    }();
    return all;
}

const Mistake* find_mistake(std::string_view name) {
    for (const Mistake& mistake : mistakes())
        if (mistake.name == name)
            return &mistake;
    return nullptr;
}

} // namespace rastertrace
