#pragma once

#include "preprocess/base/file_io.hpp"
#include "src/scene/primitive_map_job.hpp"

#include <span>

namespace edgeshade::web {

/// A task for the worker that builds primitive maps, and its result, as bytes for another instance
/// of this same program: see scene_transfer.hpp.
Bytes toTransfer(const PrimitiveMapTask& task);
PrimitiveMapTask taskFromTransfer(std::span<const std::uint8_t> bytes);

Bytes toTransfer(const BuiltPrimitiveMap& built);
BuiltPrimitiveMap builtFromTransfer(std::span<const std::uint8_t> bytes);

} // namespace edgeshade::web
