// What libFuzzer calls, for fuzzers of GLBs: each says its mutationScope().
#include "tests/fuzz/glb_mutation.hpp"
#include "tests/fuzz/read_everything.hpp"

using namespace edgeshade::test;

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t mostSize, unsigned seed) {
    static const MutationScope scope = mutationScope();
    return mutateGlb(data, size, mostSize, seed, scope);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    readEverything({data, size});
    return 0;
}
