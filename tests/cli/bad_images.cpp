// Images and samplers. Those inside the file matter to drawing alone.
#include "tests/cli/bad_input.hpp"

namespace edgeshade::test {
namespace {

/// The sound scene with another image, for one verb alone if it is named.
BadInput withImage(const std::string& name, const std::function<Json(GltfBuilder&)>& image,
                   const std::vector<std::string>& words,
                   const std::vector<std::string>& verbs = {"render"}) {
    BadInput row = badScene(
        name, [image](GltfBuilder& gltf) { gltf.json["images"][0] = image(gltf); }, words);
    row.verbs = verbs;
    return row;
}

BadInput embedded(const std::string& name, const Bytes& bytes) {
    return withImage(
        name,
        [bytes](GltfBuilder& gltf) {
            return Json{{"bufferView", gltf.addView(bytes)}, {"mimeType", "image/png"}};
        },
        {"images[0]"});
}

Bytes cutOff(Bytes image, std::size_t size) {
    image.resize(size);
    return image;
}

/// A PNG whose header claims this many pixels a side: bits 16 to 23, and 8 to 15.
Bytes pngOfSize(std::uint8_t high, std::uint8_t low = 0) {
    Bytes png = smallPng();
    png[17] = png[21] = high;
    png[18] = png[22] = low;
    return png;
}

/// A PNG of 2x2 pixels whose data has this many times 16 MiB by its own account.
Bytes pngOfClaimedData(std::uint8_t high) {
    Bytes png = smallPng();
    png[33] = high; // bits 24 to 31 of the length of IDAT
    return png;
}

/// A JPEG that begins with `segments` and a table of 300 codes, and ends there.
Bytes crowdedJpeg(const Bytes& segments = {}) {
    Bytes jpeg = {0xFF, 0xD8};
    for (const std::uint8_t byte : segments)
        jpeg.push_back(byte);
    jpeg.insert(jpeg.end(), {0xFF, 0xC4, 319 >> 8, 319 & 0xFF, 0});
    for (int length = 1; length <= 16; ++length)
        jpeg.push_back(length == 8 || length == 9 ? 150 : 0);
    jpeg.resize(jpeg.size() + 300);
    return jpeg;
}

std::vector<std::string> packAndRender() {
    return {"pack", "render"};
}

} // namespace

std::vector<BadInput> badImages() {
    std::vector<BadInput> rows = {
        embedded("ImageOfGarbage", Bytes(100, 0x5A)),
        embedded("ImageWithoutBytes", Bytes()),
        embedded("ImageCutOff", cutOff(smallPng(), 50)),
        embedded("ImageTooLarge", pngOfSize(1)),
        embedded("ImageFarTooLarge", pngOfSize(0x7F)),
        embedded("ImageOfMorePixelsThanItsBytesHold", pngOfSize(0, 0x3F)),
        embedded("PngOfMoreDataThanItsBytes", pngOfClaimedData(0x30)),
        embedded("JpegOfTooManyHuffmanCodes", crowdedJpeg()),
        embedded("JpegCutOffInACrowdedTable", cutOff(crowdedJpeg(), 16)),
        embedded("JpegOfTooManyHuffmanCodesLater", crowdedJpeg({0xFF, 0xFE, 0, 4, 0xFF, 0xD9})),
        withImage(
            "ImageMissing",
            [](GltfBuilder&) {
                return Json{{"uri", "gone.png"}};
            },
            {"gone.png"}, packAndRender()),
        withImage(
            "ImageInTheFolderAbove",
            [](GltfBuilder&) {
                return Json{{"uri", "../image.png"}};
            },
            {"images[0].uri"}, packAndRender()),
        withImage(
            "ImageOfBadBase64",
            [](GltfBuilder&) {
                return Json{{"uri", "data:image/png;base64,@@@"}};
            },
            {"images[0]"}, packAndRender()),
        withImage("ImageFromNowhere",
                  [](GltfBuilder&) {
                      return Json{{"name", "nothing"}};
                  },
                  {"images[0]"}),
        withImage("ImageOfNoView",
                  [](GltfBuilder&) {
                      return Json{{"bufferView", 99}, {"mimeType", "image/png"}};
                  },
                  {"99"}),
        badScene("SamplerOfUnknownEnlarging",
                 [](GltfBuilder& gltf) { gltf.json["samplers"][0]["magFilter"] = 9987; },
                 {"samplers[0].magFilter", "9987"}),
        badScene("SamplerOfUnknownReduction",
                 [](GltfBuilder& gltf) { gltf.json["samplers"][0]["minFilter"] = 9990; },
                 {"samplers[0].minFilter", "9990"}),
        badScene("TextureOfNoImage",
                 [](GltfBuilder& gltf) { gltf.json["textures"][0]["source"] = 99; },
                 {"images[99]"}),
        badScene("TextureOfNoSampler",
                 [](GltfBuilder& gltf) { gltf.json["textures"][0]["sampler"] = 99; }, {"99"}),
        badScene("SamplerOfUnknownWrapping",
                 [](GltfBuilder& gltf) { gltf.json["samplers"][0]["wrapS"] = 12345; }, {"12345"}),
    };
    for (std::size_t last = rows.size() - 3; last < rows.size(); ++last)
        rows[last].verbs = {"render"};
    return rows;
}

} // namespace edgeshade::test
