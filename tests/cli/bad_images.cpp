// Samplers, and images beyond a limit. Images that are broken or missing are left out instead: see
// left_out_images.cpp.
#include "src/image/png.hpp"
#include "tests/cli/bad_input.hpp"

namespace edgeshade::test {
namespace {

BadInput withSampler(const std::string& name, const std::string& key, int value,
                     const std::vector<std::string>& words) {
    return badScene(
        name, [=](GltfBuilder& gltf) { gltf.json["samplers"][0][key] = value; }, words);
}

/// The sound scene with a plain picture of 512x512 pixels in a separate file.
std::filesystem::path withLargeImage(const TempFolder& folder) {
    GltfBuilder gltf = soundScene();
    gltf.json["images"][0] = {{"uri", "large.png"}};
    folder.write("large.png", encodePng(Bytes(4 * 512 * 512), 512, 512));
    return folder.write("bad.glb", gltf.glb());
}

} // namespace

std::vector<BadInput> badImages() {
    return {
        withSampler("SamplerOfUnknownEnlarging", "magFilter", 9987,
                    {"samplers[0].magFilter", "9987"}),
        withSampler("SamplerOfUnknownReduction", "minFilter", 9990,
                    {"samplers[0].minFilter", "9990"}),
        withSampler("SamplerOfUnknownWrapping", "wrapS", 12345, {"12345"}),
        badScene("TextureOfNoSampler",
                 [](GltfBuilder& gltf) { gltf.json["textures"][0]["sampler"] = 99; }, {"99"}),
        {"ImageBeyondTheLimitOfMemory",
         withLargeImage,
         {"images[0]", "512x512 pixels", "bytes of memory"},
         {"info", "render"},
         {"--max-memory", "2M"}},
        {"ImageBeyondTheLimitOfFiles",
         withLargeImage,
         {"images[0].uri", "large.png", "limit for a file is 3000"},
         {"info", "pack", "render"},
         {"--max-file", "3000"}},
    };
}

} // namespace edgeshade::test
