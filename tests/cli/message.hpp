#pragma once

#include "tests/support/child_process.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>

namespace edgeshade::test {

/// The lines of its standard error that are warnings, or those that aren't, without progress lines
/// and the last line's end.
inline std::string linesOf(const ProcessResult& result, bool warnings) {
    std::string lines;
    for (std::size_t start = 0; start < result.err.size();) {
        const std::size_t end = std::min(result.err.find('\n', start), result.err.size());
        const std::string line = result.err.substr(start, end - start);
        if (line.starts_with("warning: ") == warnings && !line.starts_with("progress: "))
            lines += (lines.empty() ? "" : "\n") + line;
        start = end + 1;
    }
    return lines;
}

/// The program's message about its failure.
inline std::string messageOf(const ProcessResult& result) {
    return linesOf(result, false);
}

/// The program's warnings.
inline std::string warningsOf(const ProcessResult& result) {
    return linesOf(result, true);
}

/// Expects one line that is a sentence and does not blame the program.
inline void expectOneSentence(const ProcessResult& result) {
    const std::string message = messageOf(result);
    EXPECT_TRUE(message.starts_with("edgeshade: ")) << message;
    EXPECT_TRUE(message.ends_with(".")) << message;
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 0) << message;
    EXPECT_EQ(message.find("Internal error"), std::string::npos) << message;
    EXPECT_FALSE(message.ends_with("..")) << message;
}

} // namespace edgeshade::test
