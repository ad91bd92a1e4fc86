#include "preprocess/gltf/data_uri.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/gltf/percent_encoding.hpp"

#include <algorithm>
#include <cstdint>

namespace edgeshade {
namespace {

constexpr std::string_view scheme = "data:";
constexpr std::string_view whiteSpace = " \t\r\n\f";

char lowerCase(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool equalsInAnyCase(std::string_view text, std::string_view lower) {
    return std::equal(text.begin(), text.end(), lower.begin(), lower.end(),
                      [](char a, char b) { return lowerCase(a) == b; });
}

/// Whether the part before the comma ends with ";base64".
bool saysBase64(std::string_view header) {
    const std::size_t semicolon = header.rfind(';');
    if (semicolon == std::string_view::npos) return false;
    header.remove_prefix(semicolon + 1);
    header.remove_prefix(std::min(header.find_first_not_of(whiteSpace), header.size()));
    header = header.substr(0, header.find_last_not_of(whiteSpace) + 1);
    return equalsInAnyCase(header, "base64");
}

/// The six bits of a character (RFC 4648, section 4), or -1 if it isn't one of base64's.
int sextetOf(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// `fail` is called with a description of the error and does not return.
template <class Fail>
Bytes decodedBase64(std::string_view text, Fail fail) {
    Bytes bytes;
    bytes.reserve(text.size() / 4 * 3);
    std::uint32_t bits = 0;
    std::size_t sextets = 0, padding = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (whiteSpace.find(text[i]) != std::string_view::npos) continue;
        if (text[i] == '=') {
            ++padding;
            continue;
        }
        const int sextet = sextetOf(text[i]);
        if (sextet < 0 || padding > 0)
            fail("character " + std::to_string(i) + " after the comma is not base64");
        bits = bits << 6 | static_cast<std::uint32_t>(sextet);
        if (++sextets % 4 == 0)
            for (const int shift : {16, 8, 0})
                bytes.push_back(static_cast<std::uint8_t>(bits >> shift & 0xFF));
    }
    const std::size_t rest = sextets % 4;
    if (rest == 1 || (padding != 0 && padding != (4 - rest) % 4))
        fail("its base64 ends within a group of four characters");
    if (rest >= 2) bytes.push_back(static_cast<std::uint8_t>(bits >> (6 * rest - 8) & 0xFF));
    if (rest == 3) bytes.push_back(static_cast<std::uint8_t>(bits >> 2 & 0xFF));
    return bytes;
}

} // namespace

bool isDataUri(std::string_view uri) {
    return equalsInAnyCase(uri.substr(0, scheme.size()), scheme);
}

Bytes dataOfUri(std::string_view uri, const std::string& where) {
    const auto fail = [&](const std::string& what) {
        throw InputError(where + " is a data URI that can't be decoded: " + what + ".");
    };
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos) fail("it has no comma");
    const std::string data = percentDecoded(uri.substr(comma + 1));
    if (saysBase64(uri.substr(scheme.size(), comma - scheme.size())))
        return decodedBase64(data, fail);
    return Bytes(data.begin(), data.end());
}

} // namespace edgeshade
