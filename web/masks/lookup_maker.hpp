#pragma once

#include "web/masks/lookup_transfer.hpp"

#include <emscripten/val.h>
#include <optional>
#include <string>

namespace edgeshade::web {

/// A worker's part: builds the maps of lights at rest, one at a time. What fails returns a
/// sentence.
class LookupMaker {
  public:
    /// `size` bytes that malloc() gave, which it frees.
    std::string begin(std::uintptr_t address, std::size_t size);
    /// Goes on for about so long; returns whether all is done.
    bool advance(double milliseconds);
    /// What the page's masks take. Empty where memory ran out.
    emscripten::val result();
    /// The table's texels, four floats each; until begin().
    emscripten::val texels() const;

  private:
    std::optional<LookupWork> work_;
    bool failed_ = false;
    Bytes bytes_;
};

} // namespace edgeshade::web
