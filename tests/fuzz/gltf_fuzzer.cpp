// GLB and glTF through all of reading: any value of the JSON, any byte that a view names, and now
// and then the container.
#include "tests/fuzz/glb_mutation.hpp"

using namespace edgeshade::test;

MutationScope edgeshade::test::mutationScope() {
    return {[](Json& json) { return std::vector<Json*>{&json}; }, bufferViewsOf, true};
}
