#pragma once

#include "src/scene/primitive_map_worker.hpp"

#include <emscripten/val.h>

namespace edgeshade::web {

/// The page's side of building primitive maps in a web worker. `maps`, a JavaScript object, has
/// ask(bytes), which copies a task's bytes, and giveUp().
class PageMapWorker : public PrimitiveMapWorker {
  public:
    explicit PageMapWorker(emscripten::val maps) : maps_(std::move(maps)) {}

    bool works() const override { return works_; }
    void ask(const PrimitiveMapTask& task) override;
    void giveUp() override;
    std::optional<BuiltPrimitiveMap> take() override;

    /// Delivers the result of the latest task.
    void done(std::span<const std::uint8_t> bytes);
    void fail() { works_ = false; }

  private:
    emscripten::val maps_;
    bool works_ = true;
    std::optional<BuiltPrimitiveMap> built_;
};

} // namespace edgeshade::web
