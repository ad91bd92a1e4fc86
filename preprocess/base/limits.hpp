#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace edgeshade {

/// Limits on a file's demands. Anything beyond them is refused before it is read, decoded or
/// repeated. Today's large models are far below the defaults.
struct ReadingLimits {
    /// Bytes of the asset's file, and of each file it refers to.
    std::uint64_t fileBytes = std::uint64_t{4} << 30;
    /// Bytes produced by reading them: files in memory, JSON, decompressed data, attributes as
    /// floats, vertices once for every node that uses them, images. They count when they are
    /// allocated and stay counted when freed, so that the limit bounds the time too.
    std::uint64_t memoryBytes = std::uint64_t{sizeof(void*) == 8 ? 16u : 2u} << 30;
    /// Triangles of the scene; a mesh that n nodes use counts n times.
    std::uint64_t triangles = 50'000'000;
    std::uint64_t nodes = 2'000'000;
    std::uint64_t nodeDepth = 1'000; ///< levels of nodes; a root is the first
};

/// Counts the bytes produced by reading one document.
class MemoryBudget {
  public:
    MemoryBudget() = default;
    explicit MemoryBudget(const ReadingLimits& limits) : limits_(limits) {}

    const ReadingLimits& limits() const { return limits_; }
    std::uint64_t taken() const { return taken_; }

    /// Counts `count` items of `size` bytes, before they are allocated. `where` names the file and
    /// the field that needs them. Throws LimitError beyond the limit.
    void take(std::uint64_t count, std::uint64_t size, const std::string& where);

  private:
    ReadingLimits limits_;
    std::uint64_t taken_ = 0;
};

} // namespace edgeshade
