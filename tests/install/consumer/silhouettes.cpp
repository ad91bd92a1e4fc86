// The silhouette edges of a cube, seen from a corner and from a side.
#include <edgeshade/silhouettes.hpp>

#include <iostream>
#include <stdexcept>

int main() {
    const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0,
                               0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1};
    const std::uint32_t indices[] = {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                                     2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};
    const edgeshade::ShadowCasters cube(positions, indices);
    std::cout << cube.silhouettes({3, 3, 3, 1}).size() << " "
              << cube.silhouettes({0.5, 3, 0.5, 1}).size() << "\n";
    try {
        const std::uint32_t beyond[] = {0, 1, 8};
        edgeshade::ShadowCasters(positions, beyond);
    } catch (const std::runtime_error& error) {
        std::cout << error.what() << "\n";
    }
}
