// PNG, JPEG and WebP, byte by byte.
#include "tests/fuzz/read_everything.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    edgeshade::test::readImage({data, size});
    return 0;
}
