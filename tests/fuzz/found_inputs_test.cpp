// Reads the fuzzers' seeds and their findings in the ordinary build.
#include "preprocess/base/file_io.hpp"
#include "tests/fuzz/gltf_structure.hpp"
#include "tests/fuzz/pack_and_check.hpp"
#include "tests/fuzz/read_everything.hpp"
#include "tests/fuzz/seeds.hpp"

#include <filesystem>
#include <gtest/gtest.h>

namespace edgeshade::test {

TEST(FoundInputs, NoneOfThemDoesHarm) {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(EDGESHADE_FOUND_INPUTS)) {
        SCOPED_TRACE(entry.path().filename());
        const Bytes bytes = readFile(entry.path());
        if (entry.path().extension() == ".glb" || entry.path().extension() == ".gltf")
            readEverything(bytes), packAndCheck(bytes);
        else
            EXPECT_FALSE(readImage(bytes));
        ++count;
    }
    EXPECT_GT(count, 0u);
}

TEST(Seeds, ScenesAreAccepted) {
    for (const auto& seeds : {gltfSeeds(), compressionSeeds(), shadowSeeds(), packSeeds()})
        for (const auto& [name, bytes] : seeds)
            EXPECT_TRUE(readEverything(bytes)) << name;
}

TEST(Seeds, ScenesArePacked) {
    for (const auto& seeds : {gltfSeeds(), compressionSeeds(), shadowSeeds(), packSeeds()})
        for (const auto& [name, bytes] : seeds)
            EXPECT_TRUE(packAndCheck(bytes)) << name;
}

TEST(Seeds, ImagesAreAccepted) {
    for (const auto& [name, bytes] : imageSeeds())
        EXPECT_EQ(readImage(bytes), name != "animated.webp") << name; // none of its pictures is the
                                                                      // image
}

} // namespace edgeshade::test
