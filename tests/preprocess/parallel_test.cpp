#include "preprocess/base/parallel.hpp"

#include "preprocess/base/radix_sort.hpp"
#include "tests/support/hard_lights.hpp"

#include <algorithm>
#include <atomic>
#include <gtest/gtest.h>
#include <stdexcept>

namespace edgeshade::test {

TEST(Parallel, EveryItemIsWorkedOnOnce) {
    for (const std::size_t threads : {1, 2, 5})
        for (const std::size_t count : {0, 1, 2, 7, 1000}) {
            std::vector<std::atomic<int>> times(count);
            inParallel(count, {threads}, [&](std::size_t i) { ++times[i]; });
            EXPECT_TRUE(std::all_of(times.begin(), times.end(),
                                    [](const std::atomic<int>& of) { return of == 1; }));
        }
}

TEST(Parallel, PartsCoverAllItemsInOrder) {
    for (const std::size_t count : {0, 1, 99, 100, 1000}) {
        std::size_t end = 0;
        const auto parts = partsOf(count, 50, {7});
        for (const ItemRange& part : parts) {
            EXPECT_EQ(part.first, end);
            EXPECT_TRUE(part.size() >= 50 || parts.size() == 1);
            end = part.end;
        }
        EXPECT_EQ(end, count);
    }
}

TEST(Parallel, WhatOneThrowsIsThrown) {
    for (const std::size_t threads : {1, 4})
        EXPECT_THROW(inParallel(100, {threads},
                                [](std::size_t i) {
                                    if (i == 42) throw std::runtime_error("no");
                                }),
                     std::runtime_error);
}

TEST(RadixSort, AsComparingDoes) {
    Random random(4);
    for (const std::size_t count : {0, 1, 2, 256, 257, 5000, 140'000})
        for (const int different : {1, 3, 2000, 1 << 30}) { // numbers of different values of a word
            std::vector<Keyed<3>> items(count);
            for (std::size_t i = 0; i < count; ++i) {
                for (std::uint32_t& word : items[i].key)
                    word = 3u * static_cast<std::uint32_t>(random.below(different));
                items[i].number = static_cast<std::uint32_t>(i);
            }
            std::vector<Keyed<3>> expected = items;
            std::stable_sort(expected.begin(), expected.end(),
                             [](const Keyed<3>& a, const Keyed<3>& b) { return a.key < b.key; });
            for (const std::size_t threads : {1, 2, 5}) {
                std::vector<Keyed<3>> sorted = items;
                radixSort(sorted, {threads});
                EXPECT_TRUE(std::equal(sorted.begin(), sorted.end(), expected.begin(),
                                       [](const Keyed<3>& a, const Keyed<3>& b) {
                                           return a.key == b.key && a.number == b.number;
                                       }))
                    << count << " items, " << different << " values, threads " << threads;
            }
        }
}

} // namespace edgeshade::test
