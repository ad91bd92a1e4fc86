// Files that are no GLB, or a broken GLB.
#include "tests/cli/bad_input.hpp"

#include <random>

namespace edgeshade::test {
namespace {

Bytes soundGlb() {
    return soundScene().glb();
}

/// The sound GLB cut off after `size` bytes.
BadInput cutOff(const std::string& name, std::size_t size, const std::vector<std::string>& words) {
    return badBytes(
        name,
        [size] {
            Bytes glb = soundGlb();
            glb.resize(size);
            return glb;
        },
        words);
}

/// The sound GLB with a 32-bit number of its header changed.
BadInput withNumber(const std::string& name, std::size_t offset, std::uint32_t value,
                    const std::vector<std::string>& words) {
    return badBytes(
        name,
        [=] {
            Bytes glb = soundGlb();
            std::memcpy(glb.data() + offset, &value, sizeof value);
            return glb;
        },
        words);
}

Bytes randomBytes() {
    std::mt19937 random(1);
    Bytes bytes(5000);
    for (auto& byte : bytes)
        byte = static_cast<std::uint8_t>(random());
    return bytes;
}

std::uint32_t jsonLength() {
    std::uint32_t length = 0;
    std::memcpy(&length, soundGlb().data() + 12, sizeof length);
    return length;
}

} // namespace

std::vector<BadInput> badContainers() {
    const std::size_t binary = 20 + jsonLength(); // start of the second chunk
    return {
        {"MissingFile",
         [](const TempFolder& folder) { return folder / "gone.glb"; },
         {"gone.glb", "does not exist"}},
        {"MissingFolder",
         [](const TempFolder& folder) { return folder / "gone/scene.glb"; },
         {"does not exist"}},
        {"Folder", [](const TempFolder& folder) { return folder.path(); }, {"is a folder"}},
        {"VeryLongName",
         [](const TempFolder& folder) { return folder / (std::string(5000, 'x') + ".glb"); },
         {}},
        badBytes("EmptyFile", [] { return Bytes(); }, {"is empty"}),
        badBytes("Garbage", randomBytes, {"neither GLB nor JSON"}),
        badBytes("Zeros", [] { return Bytes(1000, 0); }, {"neither GLB nor JSON"}),
        badBytes("AnotherKindOfFile", smallPng, {"neither GLB nor JSON"}),
        cutOff("CutOffInTheMagic", 3, {}),
        cutOff("CutOffAfterTheMagic", 4, {"cut off"}),
        cutOff("CutOffInTheHeader", 11, {"cut off"}),
        cutOff("CutOffAfterTheHeader", 12, {"cut off"}),
        cutOff("CutOffInAChunkHeader", 19, {"cut off"}),
        cutOff("CutOffBeforeTheJson", 20, {"cut off"}),
        cutOff("CutOffInTheJson", 100, {"cut off"}),
        cutOff("CutOffBeforeTheSecondChunk", binary, {"cut off"}),
        cutOff("CutOffInTheSecondChunkHeader", binary + 7, {"cut off"}),
        cutOff("CutOffInTheBinary", binary + 100, {"cut off"}),
        withNumber("GlbOfVersion1", 4, 1, {"version 1"}),
        withNumber("GlbOfVersion3", 4, 3, {"version 3"}),
        withNumber("LengthOfZero", 8, 0, {}),
        withNumber("LengthOfTheHeaderAlone", 8, 12, {}),
        withNumber("LengthPastTheEnd", 8, 0xFFFFFFFF, {"cut off", "4294967295"}),
        withNumber("JsonChunkPastTheEnd", 12, 0xFFFFFFFF, {"chunk", "4294967295"}),
        withNumber("JsonChunkWithoutContent", 12, 0, {}),
        withNumber("BinaryChunkPastTheEnd", binary, 0xFFFFFFF0, {"chunk"}),
        withNumber("NoJsonChunk", 16, 0x12345678, {"without a JSON chunk"}),
        withNumber("NoBinaryChunk", binary + 4, 0x12345678, {"buffers[0]"}),
    };
}

} // namespace edgeshade::test
