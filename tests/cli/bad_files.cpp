// Buffers: lengths, URIs and views.
#include "tests/cli/bad_input.hpp"

#include <sys/stat.h>

namespace edgeshade::test {
namespace {

/// The sound scene as .gltf, with this uri of its buffer.
BadInput withUri(const std::string& name, const std::string& uri,
                 const std::vector<std::string>& words) {
    return {name,
            [uri](const TempFolder& folder) {
                folder.write("scene.bin", soundScene().binary);
                return folder.write("below/bad.gltf", std::string_view(soundScene().gltf(uri)));
            },
            words};
}

/// The sound scene as .gltf, with this uri of its buffer, whose first part is a link to `target`.
/// The folder above contains a good buffer.
BadInput withLink(const std::string& name, const std::string& uri, const std::string& target,
                  const std::vector<std::string>& words) {
    BadInput row = withUri(name, uri, words);
    row.make = [make = row.make, uri, target](const TempFolder& folder) {
        const auto path = make(folder);
        std::filesystem::create_symlink(target, path.parent_path() / uri.substr(0, uri.find('/')));
        return path;
    };
    return row;
}

/// The sound scene with one key of the positions' view changed.
BadInput withView(const std::string& name, const std::string& key, const Json& value,
                  const std::vector<std::string>& words) {
    return badScene(
        name, [=](GltfBuilder& gltf) { gltf.json["bufferViews"][0][key] = value; }, words);
}

} // namespace

std::vector<BadInput> badFiles() {
    return {
        badScene("BufferLongerThanItsBytes",
                 [](GltfBuilder& gltf) {
                     gltf.json["buffers"] = {{{"byteLength", gltf.binary.size() + 1000}}};
                 },
                 {"buffers[0].byteLength"}),
        badScene("BufferOfNegativeLength",
                 [](GltfBuilder& gltf) {
                     gltf.json["buffers"] = {{{"byteLength", -5}}};
                 },
                 {"buffers[0].byteLength"}),
        badScene("BufferLengthIsText",
                 [](GltfBuilder& gltf) {
                     gltf.json["buffers"] = {{{"byteLength", "all"}}};
                 },
                 {"byteLength"}),
        badScene("BufferWithoutUri",
                 [](GltfBuilder& gltf) {
                     gltf.json["buffers"] = {Json::object(), {{"byteLength", 100}}};
                 },
                 {"buffers[1].uri"}),
        withUri("AbsoluteUri", "/etc/hostname", {"buffers[0].uri", "/etc/hostname"}),
        withUri("FileUri", "file:///etc/hostname", {"buffers[0].uri", "file:"}),
        withUri("UriOfTheFolderAbove", "../scene.bin", {"buffers[0].uri", "../scene.bin"}),
        withUri("EncodedUriOfTheFolderAbove", "%2e%2e%2fscene.bin", {"buffers[0].uri"}),
        withUri("UriWithAWayOutInTheMiddle", "a/../../scene.bin", {"buffers[0].uri"}),
        withUri("HttpUri", "http://example.com/scene.bin", {"buffers[0].uri", "http:"}),
        withUri("UriOfADrive", "C:\\scene.bin", {"buffers[0].uri"}),
        withUri("UriWithAZero", "a%00b.bin", {"buffers[0].uri", "zero byte"}),
        withUri("UriWithAColon", "folder/a:b.bin", {"buffers[0].uri", "colon"}),
        withUri("UriOfAnotherHostWithBackslashes", "\\\\host\\scene.bin",
                {"buffers[0].uri", "own folder"}),
        withUri("UriWithAWayOutPastBackslashes", "a\\..\\..\\scene.bin",
                {"buffers[0].uri", "own folder"}),
        withUri("MissingFileBehindABackslash", "data\\gone.bin",
                {"buffers[0].uri", "data/gone.bin", "does not exist"}),
        withUri("EncodedAbsoluteUri", "%2Fetc%2Fhostname", {"buffers[0].uri", "%2Fetc"}),
        withUri("UriOfTheFolderAboveWithBackslashes", "..\\scene.bin", {"buffers[0].uri"}),
        withUri("EncodedBackslashes", "..%5Cscene.bin", {"buffers[0].uri", "%5C"}),
        withUri("EncodedUriOfADrive", "C%3Ascene.bin", {"buffers[0].uri", "%3A"}),
        withUri("UriOfAnotherHost", "//example.com/scene.bin", {"buffers[0].uri"}),
        withUri("UriWithoutText", "?", {"?"}),
        withLink("LinkOutOfTheFolder", "link.bin", "../scene.bin", {"link.bin", "link out"}),
        withLink("LinkToAnAbsolutePlace", "link.bin", "/etc/hostname", {"link.bin", "link out"}),
        withLink("FolderThatIsALinkOut", "folder/scene.bin", "..",
                 {"folder/scene.bin", "link out"}),
        {"PipeInPlaceOfAFile",
         [](const TempFolder& folder) {
             ::mkfifo((folder / "pipe.bin").c_str(), S_IRUSR | S_IWUSR);
             return folder.write("bad.gltf", std::string_view(soundScene().gltf("pipe.bin")));
         },
         {"buffers[0].uri", "pipe.bin", "not a regular file"}},
        withUri("UriOfTheFolder", ".", {}),
        withUri("MissingBinaryFile", "gone.bin", {"gone.bin"}),
        withUri("BadBase64", "data:application/octet-stream;base64,@@@@====@@@@", {"buffers[0]"}),
        withUri("Base64TooShort", "data:application/octet-stream;base64,AAAA", {"buffers[0]"}),
        withUri("DataUriWithoutData", "data:", {"buffers[0]"}),
        badText("UriIsANumber",
                R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4,"uri":7}]})", {"uri"}),
        {"BinaryFileTooShort",
         [](const TempFolder& folder) {
             folder.write("short.bin", Bytes(10));
             return folder.write("bad.gltf", std::string_view(soundScene().gltf("short.bin")));
         },
         {"buffers[0].byteLength"}},
        withView("ViewOfNoBuffer", "buffer", 7, {"bufferViews[0].buffer is 7"}),
        withView("ViewOfANegativeBuffer", "buffer", -1, {"bufferViews[0].buffer is -1"}),
        withView("ViewBufferIsText", "buffer", "0", {"buffer"}),
        withView("ViewPastItsBuffer", "byteLength", 1000000, {"bufferViews[0]"}),
        withView("ViewOffsetPastItsBuffer", "byteOffset", 1000000, {"bufferViews[0]"}),
        withView("ViewOfNegativeOffset", "byteOffset", -4, {"bufferViews[0]"}),
        withView("ViewOfNegativeLength", "byteLength", -4, {"bufferViews[0]"}),
        withView("ViewOffsetIsText", "byteOffset", "0", {"byteOffset"}),
        withView("ViewLengthIsMissing", "byteLength", nullptr, {"byteLength"}),
        withView("StrideBelowTheElement", "byteStride", 4, {"bufferViews[0]"}),
        withView("StrideNoMultipleOf4", "byteStride", 13, {"byteStride"}),
        withView("StrideTooLarge", "byteStride", 1024, {"byteStride"}),
        badScene("UnusedViewOfNoBuffer",
                 [](GltfBuilder& gltf) {
                     gltf.json["bufferViews"].push_back({{"buffer", 7}, {"byteLength", 4}});
                 },
                 {"buffer", "7"}),
    };
}

} // namespace edgeshade::test
