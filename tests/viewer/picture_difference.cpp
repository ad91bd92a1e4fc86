// picture_difference A.png B.png: prints how many pixels per thousand differ, or "sizes" if the
// pictures' sizes differ.

#include "preprocess/base/file_io.hpp"
#include "src/image/decode.hpp"

#include <algorithm>
#include <iostream>

int main(int argc, char** argv) {
    if (argc != 3) return 1;
    const auto read = [](const char* path) {
        return edgeshade::decodeImage(edgeshade::readFile(path), path);
    };
    const edgeshade::Image a = read(argv[1]), b = read(argv[2]);
    if (a.width != b.width || a.height != b.height) {
        std::cout << "sizes" << std::endl;
        return 0;
    }
    std::size_t differing = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4)
        differing += !std::equal(&a.rgba[i], &a.rgba[i] + 4, &b.rgba[i]);
    std::cout << 1000.0 * 4.0 * static_cast<double>(differing) / static_cast<double>(a.rgba.size())
              << std::endl;
}
