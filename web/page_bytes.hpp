#pragma once

#include "preprocess/base/file_io.hpp"

#include <cstdlib>
#include <emscripten/val.h>
#include <memory>
#include <span>

namespace edgeshade::web {

/// Bytes that JavaScript has put into memory from malloc(); frees it.
class PageBytes {
  public:
    PageBytes(std::uintptr_t address, std::size_t size)
        : memory_(reinterpret_cast<std::uint8_t*>(address), std::free), size_(size) {}

    std::span<const std::uint8_t> view() const { return {memory_.get(), size_}; }

  private:
    std::unique_ptr<std::uint8_t, decltype(&std::free)> memory_;
    std::size_t size_;
};

/// JavaScript must copy it before it calls anything else.
inline emscripten::val viewOf(const Bytes& bytes) {
    return emscripten::val(emscripten::typed_memory_view(bytes.size(), bytes.data()));
}

} // namespace edgeshade::web
