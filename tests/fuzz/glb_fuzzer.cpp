// Functions that libFuzzer calls, for fuzzers of GLBs: each defines its mutationScope().
#include "tests/fuzz/glb_mutation.hpp"

using namespace edgeshade::test;

namespace {

const MutationScope& scope() {
    static const MutationScope one = mutationScope();
    return one;
}

} // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t mostSize, unsigned seed) {
    return mutateGlb(data, size, mostSize, seed, scope());
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    scope().run({data, size});
    return 0;
}
