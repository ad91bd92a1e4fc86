#pragma once

#include "preprocess/base/error.hpp"
#include "preprocess/base/limits.hpp"

#include <string>

namespace edgeshade::test {

/// Path of fuzzed assets: no file can exist in this folder, so that external files are refused.
inline constexpr const char* fuzzedPath = "/proc/self/nothing/fuzz.glb";

/// Limits that only let inputs through which need little memory and time.
ReadingLimits smallLimits();

/// Ends the process (abort), with the message on stderr, unless it is one sentence that names the
/// file.
void requireSentence(const std::string& message);

/// Runs a part of the program; returns whether it accepted the input. Refusals must be one
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
