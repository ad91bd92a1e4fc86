#pragma once

#include "tests/fuzz/read_everything.hpp"
#include "tests/support/gltf_builder.hpp"

#include <cstdint>
#include <functional>
#include <random>
#include <vector>

namespace edgeshade::test {

/// What of a GLB a fuzzer changes, and what it does with it. The first two functions get JSON of
/// any shape and may find nothing in it.
struct MutationScope {
    /// Values under which JSON is changed.
    std::function<std::vector<Json*>(Json&)> json;
    /// Ranges of the binary chunk that are changed: objects with byteOffset and byteLength, in
    /// buffer 0.
    std::function<std::vector<Json*>(Json&)> ranges;
    /// Whether now and then any byte of the file is changed, its container's too.
    bool container = false;
    /// Whether sections and other members of the root are now and then dropped, emptied, given
    /// twice or put elsewhere.
    bool sections = false;
    /// Whose faults the fuzzer looks for.
    bool (*run)(std::span<const std::uint8_t>) = readEverything;
};

/// What the fuzzer at hand changes; each of them defines it.
MutationScope mutationScope();

/// libFuzzer's LLVMFuzzerCustomMutator() for GLBs: changes one value of the JSON, or the bytes of
/// one range, or a section, and puts the file together again with all lengths and offsets right.
/// Whatever is no GLB is changed byte by byte.
std::size_t mutateGlb(std::uint8_t* data, std::size_t size, std::size_t mostSize, unsigned seed,
                      const MutationScope& scope);

/// All buffer views of the JSON that have a range.
std::vector<Json*> bufferViewsOf(Json& json);

} // namespace edgeshade::test
