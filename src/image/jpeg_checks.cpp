#include "src/image/jpeg_checks.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace edgeshade {
namespace {

constexpr int mostCodes = 256;
constexpr std::uint8_t startOfImage = 0xD8, endOfImage = 0xD9, startOfScan = 0xDA,
                       huffmanTables = 0xC4;

/// The number of codes of the first oversized table in the segment at `at`, where its length is
/// stored.
std::optional<int> oversizedIn(std::span<const std::uint8_t> bytes, std::size_t at) {
    if (at + 2 > bytes.size()) return std::nullopt;
    const std::size_t length = bytes[at] << 8 | bytes[at + 1];
    std::span<const std::uint8_t> rest = bytes.subspan(at + 2);
    for (std::size_t used = 2; used < length && !rest.empty();) {
        // Decoders read zeros beyond the end.
        const auto counts = rest.subspan(1, std::min<std::size_t>(16, rest.size() - 1));
        const int codes = std::accumulate(counts.begin(), counts.end(), 0);
        if (codes > mostCodes) return codes;
        const std::size_t size = 17 + static_cast<std::size_t>(codes);
        if (size > rest.size()) break;
        rest = rest.subspan(size);
        used += size;
    }
    return std::nullopt;
}

} // namespace

std::optional<int> oversizedHuffmanTable(std::span<const std::uint8_t> bytes) {
    // Goes from marker to marker as stb_image does.
    bool started = false, scanning = false;
    for (std::size_t at = 0; at + 1 < bytes.size();) {
        const std::uint8_t marker = bytes[at + 1];
        const bool isRestart = marker >= 0xD0 && marker <= 0xD7;
        if (bytes[at] != 0xFF || marker == 0xFF || (scanning && (marker == 0 || isRestart))) {
            ++at;
            continue;
        }
        at += 2;
        scanning = marker == startOfScan;
        if (!started && marker != startOfImage) return std::nullopt;
        if (!std::exchange(started, true)) continue;
        if (marker == endOfImage || at + 2 > bytes.size()) return std::nullopt;
        if (marker == huffmanTables)
            if (const auto codes = oversizedIn(bytes, at)) return codes;
        at += std::size_t{bytes[at]} << 8 | bytes[at + 1];
    }
    return std::nullopt;
}

} // namespace edgeshade
