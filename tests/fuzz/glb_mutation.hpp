#pragma once

#include "tests/fuzz/read_everything.hpp"
#include "tests/support/gltf_builder.hpp"

#include <cstdint>
#include <functional>
#include <random>
#include <vector>

namespace edgeshade::test {

/// The parts of a GLB that a fuzzer changes, and the function that it runs. The first two functions
/// get JSON of any shape and may find nothing in it.
struct MutationScope {
    /// Values under which JSON is changed.
    std::function<std::vector<Json*>(Json&)> json;
    /// Ranges of the binary chunk that may be changed: objects with byteOffset and byteLength, in
    /// buffer 0.
    std::function<std::vector<Json*>(Json&)> ranges;
    /// Whether any byte of the file, including its container, is sometimes changed.
    bool container = false;
    /// Whether sections and other members of the root are sometimes removed, emptied, given twice
    /// or moved.
    bool sections = false;
    /// The code under test.
    bool (*run)(std::span<const std::uint8_t>) = readEverything;
};

/// The scope of the current fuzzer; each fuzzer defines it.
MutationScope mutationScope();

/// libFuzzer's LLVMFuzzerCustomMutator() for GLBs: changes one value of the JSON, or the bytes of
/// one range, or a section, and reassembles the file with correct lengths and offsets. Input that
/// is no GLB is changed byte by byte.
std::size_t mutateGlb(std::uint8_t* data, std::size_t size, std::size_t mostSize, unsigned seed,
                      const MutationScope& scope);

/// All buffer views of the JSON that have a range.
std::vector<Json*> bufferViewsOf(Json& json);

} // namespace edgeshade::test
