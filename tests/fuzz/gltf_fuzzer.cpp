// GLB and glTF through all stages of reading: mutates any value of the JSON, any byte of a view,
// and sometimes the container.
#include "tests/fuzz/glb_mutation.hpp"

using namespace edgeshade::test;

MutationScope edgeshade::test::mutationScope() {
    return {[](Json& json) { return std::vector<Json*>{&json}; }, bufferViewsOf, true};
}
