// Writes a generated mesh as glTF, for scenes of millions of triangles.
//
//     write_generated_mesh grid|boxes|tangle TRIANGLES FILE.glb
#include "tests/support/generated_meshes.hpp"
#include "tests/support/gltf_builder.hpp"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

int main(int count, char** words) {
    using namespace edgeshade;
    const long triangles = count == 4 ? std::atol(words[2]) : 0;
    if (triangles < 1) {
        std::fputs("write_generated_mesh grid|boxes|tangle TRIANGLES FILE.glb\n", stderr);
        return 1;
    }
    try {
        test::Soup soup = test::generatedMesh(words[1], static_cast<std::size_t>(triangles));
        test::GltfBuilder gltf;
        gltf.addShapeNode({std::move(soup.positions), {}, {}, std::move(soup.indices)});
        writeFile(words[3], gltf.glb());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
