#include "preprocess/image_type.hpp"

namespace edgeshade {

std::string_view imageTypeOf(std::span<const std::uint8_t> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.starts_with("\x89PNG\r\n\x1A\n")) return "image/png";
    if (text.starts_with("\xFF\xD8\xFF")) return "image/jpeg";
    if (text.starts_with("RIFF") && text.substr(4, 8).find("WEBP") == 4) return "image/webp";
    if (text.starts_with("\xABKTX 20\xBB\r\n\x1A\n")) return "image/ktx2";
    return {};
}

} // namespace edgeshade
