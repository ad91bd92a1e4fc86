#pragma once

#include "tests/support/child_process.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>

namespace edgeshade::test {

/// What the program says about its failure: its standard error without warnings, the bar that shows
/// progress, and the last line's end.
inline std::string messageOf(const ProcessResult& result) {
    std::string message;
    for (std::size_t start = 0; start < result.err.size();) {
        const std::size_t end = std::min(result.err.find('\n', start), result.err.size());
        const std::string line = result.err.substr(start, end - start);
        if (!line.starts_with("warning: ") && !line.starts_with('\r'))
            message += (message.empty() ? "" : "\n") + line;
        start = end + 1;
    }
    return message;
}

/// Expects one line that is a sentence and does not blame the program.
inline void expectOneSentence(const ProcessResult& result) {
    const std::string message = messageOf(result);
    EXPECT_TRUE(message.starts_with("edgeshade: ")) << message;
    EXPECT_TRUE(message.ends_with(".")) << message;
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 0) << message;
    EXPECT_EQ(message.find("fault of the program"), std::string::npos) << message;
    EXPECT_FALSE(message.ends_with("..")) << message;
}

} // namespace edgeshade::test
