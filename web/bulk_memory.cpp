// Copies and fills memory by the instructions that WebAssembly has for it. The C library that -Oz
// links goes byte by byte, which took an eighth of the time in which a light's map is built. Every
// browser with WebAssembly's exceptions has them.

#include <cstddef>

extern "C" {

void* memcpy(void* to, const void* from, std::size_t bytes) {
    return __builtin_memcpy(to, from, bytes);
}

void* memmove(void* to, const void* from, std::size_t bytes) {
    return __builtin_memmove(to, from, bytes);
}

void* memset(void* to, int value, std::size_t bytes) {
    return __builtin_memset(to, value, bytes);
}
}
