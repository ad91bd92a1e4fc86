#pragma once

#include "preprocess/base/file_io.hpp"

#include <nlohmann/json.hpp>
#include <span>

namespace edgeshade {

/// Pads with zeros to a multiple of four bytes.
void alignTo4(Bytes& bytes);

/// Appends `bytes` to `binary`, which is buffer 0, at a multiple of four, and adds a view of them
/// to glTF's `json`. Returns the view's index. The first view adds a member to `json`, which moves
/// all others: references into `json` are invalid after the call.
std::size_t appendView(nlohmann::ordered_json& json, Bytes& binary,
                       std::span<const std::uint8_t> bytes);

} // namespace edgeshade
