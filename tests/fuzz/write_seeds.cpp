// write_seeds FOLDER: writes each fuzzer's seeds into FOLDER/gltf, /compression, /shadow, /pack and
// /image.
#include "tests/fuzz/seeds.hpp"

#include <filesystem>
#include <iostream>

int main(int argc, char** argv) {
    using namespace edgeshade::test;
    if (argc != 2) {
        std::cerr << "usage: write_seeds FOLDER\n";
        return 1;
    }
    const std::pair<const char*, Seeds> corpora[] = {{"gltf", gltfSeeds()},
                                                     {"compression", compressionSeeds()},
                                                     {"shadow", shadowSeeds()},
                                                     {"pack", packSeeds()},
                                                     {"image", imageSeeds()}};
    for (const auto& [name, seeds] : corpora) {
        const std::filesystem::path folder = std::filesystem::path(argv[1]) / name;
        std::filesystem::create_directories(folder);
        for (const auto& [seed, bytes] : seeds)
            edgeshade::writeFile(folder / seed, bytes);
    }
}
