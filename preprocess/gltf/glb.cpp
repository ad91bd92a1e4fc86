#include "preprocess/gltf/glb.hpp"

#include "preprocess/base/error.hpp"

#include <limits>

namespace edgeshade {
namespace {

constexpr std::uint32_t magic = 0x46546C67;       // "glTF"
constexpr std::uint32_t jsonChunk = 0x4E4F534A;   // "JSON"
constexpr std::uint32_t binaryChunk = 0x004E4942; // "BIN\0"
constexpr std::size_t headerSize = 12;
constexpr std::size_t chunkHeaderSize = 8;

std::uint32_t readU32(std::span<const std::uint8_t> bytes, std::size_t offset) {
    return static_cast<std::uint32_t>(bytes[offset]) | bytes[offset + 1] << 8 |
           bytes[offset + 2] << 16 | static_cast<std::uint32_t>(bytes[offset + 3]) << 24;
}

void appendU32(Bytes& bytes, std::size_t value) {
    for (int shift = 0; shift < 32; shift += 8)
        bytes.push_back(static_cast<std::uint8_t>(value >> shift & 0xFF));
}

} // namespace

bool isGlb(std::span<const std::uint8_t> bytes) {
    return bytes.size() >= 4 && readU32(bytes, 0) == magic;
}

GlbChunks splitGlb(std::span<const std::uint8_t> bytes, const std::filesystem::path& path) {
    const std::string name = "'" + path.string() + "'";
    if (bytes.size() < headerSize + chunkHeaderSize)
        throw InputError(name + " is cut off: " + std::to_string(bytes.size()) +
                         " bytes are too few for a GLB.");
    if (const auto version = readU32(bytes, 4); version != 2)
        throw InputError(name + " is a GLB of version " + std::to_string(version) +
                         "; only version 2 is read.");
    if (const auto length = readU32(bytes, 8); length > bytes.size())
        throw InputError(name + " is cut off: its header says " + std::to_string(length) +
                         " bytes, but there are " + std::to_string(bytes.size()) + ".");

    GlbChunks chunks;
    bool haveJson = false;
    const std::size_t end = readU32(bytes, 8);
    for (std::size_t at = headerSize; at + chunkHeaderSize <= end;) {
        const std::size_t length = readU32(bytes, at);
        const std::uint32_t type = readU32(bytes, at + 4);
        at += chunkHeaderSize;
        if (length > end - at)
            throw InputError(name + " has a chunk of " + std::to_string(length) +
                             " bytes that runs past its end.");
        const auto content = bytes.subspan(at, length);
        if (type == jsonChunk && !haveJson) {
            chunks.json.assign(content.begin(), content.end());
            haveJson = true;
        } else if (type == binaryChunk && !chunks.binary) {
            chunks.binary.emplace(content.begin(), content.end());
        }
        at += length;
    }
    if (!haveJson) throw InputError(name + " is a GLB without a JSON chunk.");
    return chunks;
}

Bytes joinGlb(std::string json, Bytes binary) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4, 0);
    const std::size_t total = headerSize + chunkHeaderSize + json.size() +
                              (binary.empty() ? 0 : chunkHeaderSize + binary.size());
    if (total > std::numeric_limits<std::uint32_t>::max())
        throw Error(ExitStatus::output, "The packed file would have " + std::to_string(total) +
                                            " bytes; a GLB holds at most 4294967295.");
    Bytes glb;
    glb.reserve(total);
    appendU32(glb, magic);
    appendU32(glb, 2);
    appendU32(glb, total);
    appendU32(glb, json.size());
    appendU32(glb, jsonChunk);
    glb.insert(glb.end(), json.begin(), json.end());
    if (!binary.empty()) {
        appendU32(glb, binary.size());
        appendU32(glb, binaryChunk);
        glb.insert(glb.end(), binary.begin(), binary.end());
    }
    return glb;
}

} // namespace edgeshade
