#include "preprocess/buffer_view.hpp"

namespace edgeshade {

void alignTo4(Bytes& bytes) {
    bytes.resize((bytes.size() + 3) / 4 * 4, 0);
}

std::size_t appendView(nlohmann::ordered_json& json, Bytes& binary,
                       std::span<const std::uint8_t> bytes) {
    alignTo4(binary);
    auto& views = json["bufferViews"];
    views.push_back({{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}});
    binary.insert(binary.end(), bytes.begin(), bytes.end());
    return views.size() - 1;
}

} // namespace edgeshade
