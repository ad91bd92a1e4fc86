#include "src/image/image.hpp"

namespace edgeshade {

std::string sizeText(int width, int height) {
    return std::to_string(width) + "x" + std::to_string(height) + " pixels";
}

void countPixels(int width, int height, const std::string& name, MemoryBudget& memory) {
    constexpr std::uint64_t bytesPerPixel = 12; // decoded, as RGBA, and the returned copy
    memory.take(std::uint64_t(width) * static_cast<std::uint64_t>(height), bytesPerPixel,
                name + " has " + sizeText(width, height) + ", which");
}

} // namespace edgeshade
