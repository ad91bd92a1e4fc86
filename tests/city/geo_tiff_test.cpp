// GeoTIFFs of maps, and when they are BigTIFFs.

#include "src/city/geo_tiff.hpp"
#include "tests/support/temp_folder.hpp"

#include <array>
#include <gtest/gtest.h>

namespace edgeshade::city {
namespace {

CellRange square(std::int64_t side) {
    return {-side / 2, -side / 2, side - side / 2, side - side / 2};
}

TEST(GeoTiff, IsABigTiffWhereTheWorstCaseIsAbove4GiB) {
    // 2^16 tiles of 2^16 floats have 2^34 bytes; a quarter of them has just 2^32.
    EXPECT_TRUE(takesBigTiff(square(65536), 1));
    EXPECT_TRUE(takesBigTiff(square(32768), 1));
    EXPECT_FALSE(takesBigTiff(square(32768 - 256), 1));
    // A tile that holds one column of the map is a whole tile.
    EXPECT_TRUE(takesBigTiff(square(32768 - 255), 1));
    EXPECT_FALSE(takesBigTiff(square(9216), 12));
    EXPECT_TRUE(takesBigTiff(square(9216 + 256), 12));
    EXPECT_FALSE(takesBigTiff(square(1), 12));
    EXPECT_TRUE(takesBigTiff(square(std::int64_t{1} << 31), 12));
}

/// The version in the header of a file for a map whose rows were not written.
int versionOf(std::int64_t side) {
    const test::TempFolder folder;
    Plan plan;
    plan.region = square(side);
    const std::array<std::string, 1> bands = {"hours"};
    GeoTiffWriter writer(folder / "map.tif", plan, bands);
    writer.finish();
    const Bytes bytes = readFile(folder / "map.tif", std::uint64_t{1} << 30);
    return bytes[2];
}

TEST(GeoTiff, SaysInItsHeaderThatItIsABigTiff) {
    EXPECT_EQ(versionOf(300), 42);
    EXPECT_EQ(versionOf(40000), 43);
}

} // namespace
} // namespace edgeshade::city
