#pragma once

#include "preprocess/base/file_io.hpp"
#include "src/engine/lookup_work.hpp"

#include <span>

namespace edgeshade::web {

/// A light's map on its way to the worker that builds it, and back, as bytes for another instance
/// of this same program: see archive.hpp.
Bytes taskToTransfer(const LookupWork& work);
/// The returned work has not begun.
LookupWork taskFromTransfer(std::span<const std::uint8_t> bytes);

/// Finished work without its texels, which the page uploads itself.
Bytes resultToTransfer(const LookupWork& work);
/// The returned work is finished, and has no casters.
LookupWork resultFromTransfer(std::span<const std::uint8_t> bytes);

} // namespace edgeshade::web
