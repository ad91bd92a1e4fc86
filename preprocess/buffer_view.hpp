#pragma once

#include "preprocess/file_io.hpp"

#include <nlohmann/json.hpp>
#include <span>

namespace edgeshade {

/// Zeros at the end, up to a multiple of four bytes.
void alignTo4(Bytes& bytes);

/// Appends `bytes` to `binary`, which is buffer 0, at a multiple of four, and a view of them to
/// glTF's `json`. Returns the view's index. The first view is a new member of `json`, which copies
/// all others elsewhere: no reference to what is in `json` outlives the call.
std::size_t appendView(nlohmann::ordered_json& json, Bytes& binary,
                       std::span<const std::uint8_t> bytes);

} // namespace edgeshade
