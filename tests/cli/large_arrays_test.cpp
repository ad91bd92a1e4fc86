// Large arrays start at huge pages, small ones needn't; failed allocations are reported.
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <new>
#include <vector>

namespace edgeshade {
namespace {

constexpr std::size_t hugePage = std::size_t{2} << 20;

bool isAligned(const void* memory) {
    return reinterpret_cast<std::uintptr_t>(memory) % hugePage == 0;
}

TEST(LargeArrays, BeginAtHugePagesAndHoldWhatIsWritten) {
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
    for (const std::size_t size : {2 * hugePage, 2 * hugePage + 1, 5 * hugePage - 3})
        EXPECT_TRUE(isAligned(std::vector<char>(size).data())) << size;
#endif
    std::vector<std::vector<std::uint8_t>> kept;
    for (std::uint8_t i = 0; i < 8; ++i) // freed and allocated again in between
        for (const std::size_t size : {std::size_t{100}, 2 * hugePage + i}) {
            std::vector<std::uint8_t>(size, 0xEE);
            kept.emplace_back(size, i);
        }
    for (const std::vector<std::uint8_t>& array : kept)
        EXPECT_TRUE(array.front() == array.back() && array.front() == array[array.size() / 2]);
}

TEST(LargeArrays, MoreThanThereIsIsToldAsEver) {
    volatile std::size_t most = std::numeric_limits<std::size_t>::max(); // hidden from the compiler
    for (const std::size_t less : {std::size_t{0}, hugePage, most / 2})
        EXPECT_THROW(::operator delete(::operator new(most - less)), std::bad_alloc) << less;
}

} // namespace
} // namespace edgeshade
