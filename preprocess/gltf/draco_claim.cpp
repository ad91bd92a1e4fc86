#include "preprocess/gltf/draco_claim.hpp"

#include <draco/compression/config/compression_shared.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>

namespace edgeshade {
namespace {

using draco::DecoderBuffer;

/// Reads a 32-bit number, which older streams store without varint encoding, and adds it to
/// `number`.
bool readNumber(DecoderBuffer& buffer, bool shortened, std::uint64_t& number) {
    std::uint32_t value = 0;
    if (shortened ? !draco::DecodeVarint(&value, &buffer) : !buffer.Decode(&value)) return false;
    number += value;
    return true;
}

/// Reads the face count and the point count.
bool readSequential(DecoderBuffer& buffer, std::uint16_t version, DracoClaim& claim) {
    const bool shortened = version >= DRACO_BITSTREAM_VERSION(2, 2);
    return readNumber(buffer, shortened, claim.faces) &&
           readNumber(buffer, shortened, claim.points);
}

/// Reads the fields that the edgebreaker decoder reads first.
bool readEdgebreaker(DecoderBuffer& buffer, std::uint16_t version, DracoClaim& claim) {
    const bool shortened = version >= DRACO_BITSTREAM_VERSION(2, 0);
    std::uint8_t traversal = 0, attributeParts = 0;
    std::uint64_t newVertices = 0, symbols = 0;
    if (!buffer.Decode(&traversal)) return false;
    if (version < DRACO_BITSTREAM_VERSION(2, 2) && !readNumber(buffer, shortened, newVertices))
        return false;
    if (!readNumber(buffer, shortened, claim.points) ||
        !readNumber(buffer, shortened, claim.faces) || !buffer.Decode(&attributeParts) ||
        !readNumber(buffer, shortened, symbols) ||
        !readNumber(buffer, shortened, claim.points)) // splits
        return false;
    claim.points += newVertices;
    claim.attributeParts = attributeParts;
    return true;
}

} // namespace

std::uint64_t DracoClaim::memoryBytes() const {
    constexpr std::uint64_t bytesPerFace = 160, bytesPerFaceOfPart = 40, bytesPerPoint = 160;
    return faces * (bytesPerFace + bytesPerFaceOfPart * attributeParts) + points * bytesPerPoint;
}

std::optional<DracoClaim> dracoClaim(std::span<const std::uint8_t> bytes) {
    DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    draco::DracoHeader header;
    if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok() ||
        header.encoder_type != draco::TRIANGULAR_MESH)
        return std::nullopt;
    const auto version = static_cast<std::uint16_t>(
        DRACO_BITSTREAM_VERSION(header.version_major, header.version_minor));
    buffer.set_bitstream_version(version);
    if ((header.flags & METADATA_FLAG_MASK) != 0) {
        draco::GeometryMetadata skipped;
        if (!draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &skipped))
            return std::nullopt;
    }
    DracoClaim claim;
    const bool isEdgebreaker = header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING;
    if (!(isEdgebreaker ? readEdgebreaker(buffer, version, claim)
                        : readSequential(buffer, version, claim)))
        return std::nullopt;
    return claim;
}

} // namespace edgeshade
