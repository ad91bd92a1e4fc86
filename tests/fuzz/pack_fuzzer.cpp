// Packing a glTF: sections come and go, any value of the JSON and any byte of a view changes, and
// packed files are read back and checked.
#include "tests/fuzz/glb_mutation.hpp"
#include "tests/fuzz/pack_and_check.hpp"

using namespace edgeshade::test;

MutationScope edgeshade::test::mutationScope() {
    return {.json = [](Json& json) { return std::vector<Json*>{&json}; },
            .ranges = bufferViewsOf,
            .sections = true,
            .run = packAndCheck};
}
