// SPDX-License-Identifier: MIT
#include "check_report.h"

#include "csv.h"

namespace rastertrace {

std::string check_csv(const std::vector<CheckedFile>& files, CheckTold told) {
    std::string text;
    std::vector<std::string> head{"file", "right", "wrong", "follow", "open"};
    if (told == CheckTold::answers)
        head.emplace_back("likely_slip");
    put_csv_line(text, head);
    for (const CheckedFile& file : files) {
        std::vector<std::string> line{file.name};
        if (file.problem) {
            line.resize(head.size());
        } else {
            for (const std::size_t count :
                 {file.checked.right, file.checked.wrong, file.checked.follow, file.checked.open})
                line.push_back(std::to_string(count));
            if (told == CheckTold::answers)
                line.push_back(most_likely_slip(file.checked));
        }
        put_csv_line(text, line);
    }
    return text;
}

} // namespace rastertrace
