// Images that are broken, missing or of an unsupported format.
#include "tests/cli/left_out.hpp"
#include "tests/support/webp_encoding.hpp"

namespace edgeshade::test {
namespace {

const std::vector<std::string> drawing = {"render", "info"}, all = {"render", "info", "pack"};

LeftOut changed(const std::string& name, const std::function<void(GltfBuilder&)>& change,
                const std::vector<std::string>& words) {
    return {name,
            [change](const TempFolder& folder) {
                GltfBuilder gltf = soundScene();
                change(gltf);
                return folder.write("bad.glb", gltf.glb());
            },
            words, drawing};
}

LeftOut withImage(const std::string& name, const Json& image,
                  const std::vector<std::string>& words) {
    return changed(
        name, [image](GltfBuilder& gltf) { gltf.json["images"][0] = image; }, words);
}

/// An image that `pack` would also put into the file.
LeftOut withUri(const std::string& name, const std::string& uri,
                const std::vector<std::string>& words) {
    LeftOut row = withImage(name, {{"uri", uri}}, words);
    row.verbs = all;
    return row;
}

LeftOut embedded(const std::string& name, const Bytes& bytes,
                 const std::vector<std::string>& words) {
    return changed(
        name,
        [bytes](GltfBuilder& gltf) {
            gltf.json["images"][0] = {{"bufferView", gltf.addView(bytes)},
                                      {"mimeType", "image/png"}};
        },
        [&words] {
            std::vector<std::string> more = words;
            more.push_back("images[0]");
            return more;
        }());
}

/// An image in a file beside the scene.
LeftOut inFile(const std::string& name, const std::string& uri, const Bytes& bytes,
               const std::vector<std::string>& words) {
    return {name,
            [=](const TempFolder& folder) {
                folder.write(uri, bytes);
                GltfBuilder gltf = soundScene();
                gltf.json["images"][0] = {{"uri", uri}};
                return folder.write("bad.glb", gltf.glb());
            },
            words, all};
}

Bytes cutOff(Bytes image, std::size_t size) {
    image.resize(size);
    return image;
}

/// A PNG whose header claims this many pixels per side: bits 16 to 23, and 8 to 15.
Bytes pngOfSize(std::uint8_t high, std::uint8_t low = 0) {
    Bytes png = smallPng();
    png[17] = png[21] = high;
    png[18] = png[22] = low;
    return png;
}

/// A PNG of 2x2 pixels whose header claims this many times 16 MiB of data.
Bytes pngOfClaimedData(std::uint8_t high) {
    Bytes png = smallPng();
    png[33] = high; // bits 24 to 31 of the length of IDAT
    return png;
}

/// A JPEG that ends after `segments` and a table of 300 codes.
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

/// The signature of KTX2 files.
Bytes ktx2() {
    return {0xAB, 'K', 'T', 'X', ' ', '2', '0', 0xBB, '\r', '\n', 0x1A, '\n', 0, 0, 0, 0};
}

const std::vector<std::string> ktx2Words = {"images[0] is KTX2",
                                            "'gltf-transform ktxdecompress IN.glb OUT.glb'"};

/// A texture whose image only `extension` names.
LeftOut byExtension(const std::string& name, const std::string& extension, const Bytes& bytes,
                    const std::vector<std::string>& words) {
    return changed(
        name,
        [=](GltfBuilder& gltf) {
            gltf.useExtension(extension);
            gltf.json["images"][0] = {{"bufferView", gltf.addView(bytes)},
                                      {"mimeType", "image/png"}};
            gltf.json["textures"][0] = {{"extensions", {{extension, {{"source", 0}}}}}};
        },
        words);
}

LeftOut linkOutOfTheFolder() {
    return {"ImageBehindALinkOutOfTheFolder",
            [](const TempFolder& folder) {
                const auto outside = folder.write("outside.png", smallPng());
                GltfBuilder gltf = soundScene();
                gltf.json["images"][0] = {{"uri", "link.png"}};
                const auto scene = folder.write("scene/bad.glb", gltf.glb());
                std::filesystem::create_symlink(outside, scene.parent_path() / "link.png");
                return scene;
            },
            {"images[0].uri", "link.png", "link out of"},
            all};
}

} // namespace

std::vector<LeftOut> leftOutImages() {
    return {
        embedded("ImageOfGarbage", Bytes(100, 0x5A), {"neither PNG, JPEG nor WebP"}),
        embedded("ImageWithoutBytes", Bytes(), {"neither PNG, JPEG nor WebP"}),
        embedded("ImageCutOff", cutOff(smallPng(), 50), {"can't be decoded"}),
        embedded("ImageTooLarge", pngOfSize(1), {}),
        embedded("ImageFarTooLarge", pngOfSize(0x7F), {}),
        embedded("ImageOfMorePixelsThanItsBytesHold", pngOfSize(0, 0x3F), {"16130x16130 pixels"}),
        embedded("PngOfMoreDataThanItsBytes", pngOfClaimedData(0x30), {"can't be decoded"}),
        embedded("JpegOfTooManyHuffmanCodes", crowdedJpeg(), {"300 codes"}),
        embedded("JpegCutOffInACrowdedTable", cutOff(crowdedJpeg(), 16), {"300 codes"}),
        embedded("JpegOfTooManyHuffmanCodesLater", crowdedJpeg({0xFF, 0xFE, 0, 4, 0xFF, 0xD9}),
                 {"300 codes"}),
        embedded("WebpCutOff", cutOff(smallWebp(), 25), {"WebP"}),
        embedded("WebpOfAHeaderAlone", cutOff(smallWebp(), 16), {"WebP"}),
        embedded("WebpAnimated", animatedWebp(), {"animated WebP"}),
        embedded("Ktx2", ktx2(), ktx2Words),
        withUri("ImageMissing", "gone.png", {"images[0].uri", "'", "gone.png' does not exist"}),
        withUri("ImageInTheFolderAbove", "../image.png", {"images[0].uri", "../image.png"}),
        withUri("ImageOfAnAbsolutePath", "/etc/passwd", {"images[0].uri", "/etc/passwd"}),
        withUri("ImageOfAnotherScheme", "https://example.com/a.png",
                {"images[0].uri", "https://example.com/a.png"}),
        withUri("ImageThatIsAFolder", ".", {"images[0].uri", "folder"}),
        withUri("ImageOfBadBase64", "data:image/png;base64,@@@", {"images[0].uri", "data URI"}),
        inFile("ImageOfUnknownFormat", "image.gif", {'G', 'I', 'F', '8', '9', 'a'},
               {"images[0]", "neither PNG, JPEG"}),
        linkOutOfTheFolder(),
        withImage("ImageFromNowhere", {{"name", "nothing"}},
                  {"images[0] has neither a bufferView nor a uri"}),
        withImage("ImageOfNoView", {{"bufferView", 99}, {"mimeType", "image/png"}},
                  {"images[0].bufferView is 99"}),
        withImage("ImageOfAViewThatIsText", {{"bufferView", "first"}},
                  {"images[0].bufferView is \"first\""}),
        withImage("ImageOfANumber", {{"uri", 5}}, {"images[0].uri is 5"}),
        changed("TextureOfNoImage",
                [](GltfBuilder& gltf) { gltf.json["textures"][0]["source"] = 99; },
                {"textures[0].source is 99", "1 images"}),
        changed("TextureOfANegativeImage",
                [](GltfBuilder& gltf) { gltf.json["textures"][0]["source"] = -1; },
                {"textures[0].source is -1"}),
        changed("TextureWithoutSource",
                [](GltfBuilder& gltf) { gltf.json["textures"][0].erase("source"); },
                {"textures[0] has no source"}),
        changed("TextureOfABrokenExtension",
                [](GltfBuilder& gltf) {
                    gltf.json["textures"][0] = {
                        {"extensions", {{"EXT_texture_webp", {{"source", 7}}}}}};
                },
                {"textures[0].extensions.EXT_texture_webp.source is 7"}),
        changed("TextureOutOfRange",
                [](GltfBuilder& gltf) {
                    gltf.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] =
                        99;
                },
                {"materials[0]", "99"}),
        byExtension("Ktx2OfARequiredExtension", "KHR_texture_basisu", ktx2(), ktx2Words),
        byExtension("WebpOfARequiredExtensionCutOff", "EXT_texture_webp", cutOff(smallWebp(), 25),
                    {"images[0]", "WebP"}),
    };
}

} // namespace edgeshade::test
