#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace edgeshade {

/// What a file may ask for at most. What asks for more is refused before it is read, decoded or
/// repeated. Large models of today are far below the defaults.
struct ReadingLimits {
    /// Bytes of the asset's file, and of each file that it names.
    std::uint64_t fileBytes = std::uint64_t{4} << 30;
    /// Bytes that reading makes of them: files in memory, JSON, what is decompressed, attributes
    /// as floats, vertices once for every node that uses them, pictures. Counted when they are
    /// made, also where they are let go again, so that it bounds the time too.
    std::uint64_t memoryBytes = std::uint64_t{sizeof(void*) == 8 ? 16u : 2u} << 30;
    /// Triangles of the scene, a mesh that n nodes use counting n times.
    std::uint64_t triangles = 50'000'000;
    std::uint64_t nodes = 2'000'000;
    std::uint64_t nodeDepth = 1'000; ///< levels of nodes; a root is the first
};

/// Counts the bytes that reading one document makes.
class MemoryBudget {
  public:
    MemoryBudget() = default;
    explicit MemoryBudget(const ReadingLimits& limits) : limits_(limits) {}

    const ReadingLimits& limits() const { return limits_; }
    std::uint64_t taken() const { return taken_; }

    /// Counts `count` things of `size` bytes. `where` names the file and what in it wants them.
    /// Throws LimitError, before they are made, if that passes the limit.
    void take(std::uint64_t count, std::uint64_t size, const std::string& where);

  private:
    ReadingLimits limits_;
    std::uint64_t taken_ = 0;
};

} // namespace edgeshade
