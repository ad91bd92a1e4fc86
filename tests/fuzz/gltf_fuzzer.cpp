// GLB and glTF through all of reading: any value of the JSON, any byte that a view names, and now
// and then the container.
#include "tests/fuzz/glb_mutation.hpp"
#include "tests/fuzz/read_everything.hpp"

using namespace edgeshade::test;

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t mostSize, unsigned seed) {
    static const MutationScope scope{
        [](Json& json) { return std::vector<Json*>{&json}; },
        bufferViewsOf,
        true,
    };
    return mutateGlb(data, size, mostSize, seed, scope);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    readEverything({data, size});
    return 0;
}
