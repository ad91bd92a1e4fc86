// Places large arrays in huge pages, if the system has them. Providing 4 KB at a time can take the
// system longer than all other work on a mesh of millions of triangles.
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <sys/mman.h>

namespace {

constexpr std::size_t hugePage = std::size_t{2} << 20;

/// Null if there is no memory.
void* allocateHuge(std::size_t size) {
    if (size > SIZE_MAX - hugePage) return nullptr;
    const std::size_t whole = (size + hugePage - 1) / hugePage * hugePage;
    void* const array = std::aligned_alloc(hugePage, whole);
    if (array) madvise(array, whole, MADV_HUGEPAGE); // if refused, its pages are small
    return array;
}

} // namespace

void* operator new(std::size_t size) {
    void* const memory =
        size < 2 * hugePage ? std::malloc(size == 0 ? 1 : size) : allocateHuge(size);
    if (!memory) throw std::bad_alloc();
    return memory;
}

void operator delete(void* memory) noexcept {
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
#endif
