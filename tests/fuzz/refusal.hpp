#pragma once

#include "preprocess/error.hpp"
#include "preprocess/limits.hpp"

#include <string>

namespace edgeshade::test {

/// What fuzzed assets are called: no file of this folder can be there, so that external ones are
/// refused.
inline constexpr const char* fuzzedPath = "/proc/self/nothing/fuzz.glb";

/// Little memory and time are enough for whatever these let through.
ReadingLimits smallLimits();

/// Ends the process (abort), with the message on stderr, unless it is one sentence that names the
/// file.
void requireSentence(const std::string& message);

/// Runs the part; returns whether it refused nothing. What is refused must be refused in one
/// sentence.
template <class Part>
bool accepted(Part part) {
    try {
        part();
        return true;
    } catch (const InputError& error) {
        requireSentence(error.what());
        return false;
    }
}

} // namespace edgeshade::test
