// stb's image libraries, compiled once. Reading allocates memory through an AllocationBound.
#include "src/image/allocation_bound.hpp"

#include <cstdlib>
#include <limits>

namespace {

constexpr std::size_t unbounded = std::numeric_limits<std::size_t>::max();
thread_local std::size_t largestPiece = unbounded; // stb_image offers no other way to pass it

/// Zeroed, as stb_image before 2.28 looks up codes in Huffman tables that a JPEG never defined.
void* boundedCalloc(std::size_t size) {
    return size > largestPiece ? nullptr : std::calloc(1, size);
}

void* boundedRealloc(void* memory, std::size_t size) {
    return size > largestPiece ? nullptr : std::realloc(memory, size);
}

} // namespace

edgeshade::AllocationBound::AllocationBound(std::size_t bytes) {
    largestPiece = bytes;
}

edgeshade::AllocationBound::~AllocationBound() {
    largestPiece = unbounded;
}

#define STBI_MALLOC(size) boundedCalloc(size)
#define STBI_REALLOC(memory, size) boundedRealloc(memory, size)
#define STBI_FREE(memory) std::free(memory)
#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_STDIO
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#include <stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>
#define STB_IMAGE_RESIZE_IMPLEMENTATION
#include <stb_image_resize.h>
