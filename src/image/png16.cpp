#include "src/image/png16.hpp"

#include "src/image/zlib.hpp"

#include <array>
#include <string_view>

namespace edgeshade {
namespace {

void appendBigEndian(Bytes& bytes, std::uint32_t value) {
    for (const int shift : {24, 16, 8, 0})
        bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

/// CRC of PNG (third edition), annex D.
std::uint32_t crcOf(std::span<const std::uint8_t> bytes) {
    std::uint32_t crc = 0xFFFFFFFF;
    for (const std::uint8_t byte : bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit)
            crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320 : 0);
    }
    return ~crc;
}

void appendChunk(Bytes& png, std::string_view type, std::span<const std::uint8_t> data) {
    appendBigEndian(png, static_cast<std::uint32_t>(data.size()));
    const std::size_t start = png.size();
    png.insert(png.end(), type.begin(), type.end());
    png.insert(png.end(), data.begin(), data.end());
    appendBigEndian(png, crcOf(std::span(png).subspan(start)));
}

} // namespace

Bytes encodeGreyAlphaPng(std::span<const std::uint16_t> greyAlpha, int width, int height) {
    Bytes rows;
    rows.reserve(2 * greyAlpha.size() + static_cast<std::size_t>(height));
    const std::size_t rowLength = 2 * static_cast<std::size_t>(width);
    for (std::size_t i = 0; i < greyAlpha.size(); ++i) {
        if (i % rowLength == 0) rows.push_back(0); // no filter
        rows.push_back(static_cast<std::uint8_t>(greyAlpha[i] >> 8));
        rows.push_back(static_cast<std::uint8_t>(greyAlpha[i] & 0xFF));
    }
    Bytes header;
    appendBigEndian(header, static_cast<std::uint32_t>(width));
    appendBigEndian(header, static_cast<std::uint32_t>(height));
    constexpr std::array<std::uint8_t, 5> format = {16, 4, 0, 0, 0}; // bits, grey with alpha
    header.insert(header.end(), format.begin(), format.end());

    Bytes png = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    appendChunk(png, "IHDR", header);
    appendChunk(png, "IDAT", deflated(rows));
    appendChunk(png, "IEND", {});
    return png;
}

} // namespace edgeshade
