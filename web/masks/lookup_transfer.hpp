#pragma once

#include "preprocess/base/file_io.hpp"
#include "src/engine/lookup_work.hpp"

#include <span>

namespace edgeshade::web {

/// A light's map on its way to the worker that builds it, and back, as bytes for another instance
/// of this same program: see archive.hpp.
Bytes taskToTransfer(const LookupWork& work);
/// Not begun.
LookupWork taskFromTransfer(std::span<const std::uint8_t> bytes);

/// Of what is done, without the texels, which the page uploads itself.
Bytes resultToTransfer(const LookupWork& work);
/// Done, and without its casters.
LookupWork resultFromTransfer(std::span<const std::uint8_t> bytes);

} // namespace edgeshade::web
