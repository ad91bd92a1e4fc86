#pragma once

#include "web/masks/lookup_transfer.hpp"

#include <emscripten/val.h>
#include <optional>
#include <string>

namespace edgeshade::web {

/// Builds the maps of resting lights in a worker, one at a time. On failure methods return a
/// sentence.
class LookupMaker {
  public:
    /// `size` bytes from malloc(), which it frees.
    std::string begin(std::uintptr_t address, std::size_t size);
    /// Works for about this long; returns whether it has finished.
    bool advance(double milliseconds);
    /// The result for the page's masks. Empty if memory ran out.
    emscripten::val result();
    /// The table's texels, four floats each; valid until begin().
    emscripten::val texels() const;

  private:
    std::optional<LookupWork> work_;
    bool failed_ = false;
    Bytes bytes_;
};

} // namespace edgeshade::web
