// pack_one IN OUT
#include <edgeshade/packing.hpp>

#include <fstream>
#include <iostream>

int main(int, char** words) {
    try {
        const edgeshade::PackedScene packed = edgeshade::packScene(words[1]);
        std::ofstream(words[2], std::ios::binary)
            .write(reinterpret_cast<const char*>(packed.glb.data()),
                   static_cast<std::streamsize>(packed.glb.size()));
        std::cout << packed.triangles << " " << packed.edges << "\n";
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 2;
    }
}
