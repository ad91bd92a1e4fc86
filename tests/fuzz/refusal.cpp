#include "tests/fuzz/refusal.hpp"

#include <cstdio>
#include <cstdlib>

namespace edgeshade::test {

ReadingLimits smallLimits() {
    ReadingLimits limits;
    limits.fileBytes = 1 << 20;
    limits.memoryBytes = 64 << 20;
    limits.triangles = 100'000;
    limits.nodes = 1'000;
    limits.nodeDepth = 50;
    return limits;
}

void requireSentence(const std::string& message) {
    const bool isSentence = message.find("fuzz.glb") != std::string::npos &&
                            message.size() < 2000 && message.ends_with('.') &&
                            !message.ends_with("..");
    if (isSentence) return;
    std::fprintf(stderr, "not a sentence that names the file: %s\n", message.c_str());
    std::abort();
}

} // namespace edgeshade::test
