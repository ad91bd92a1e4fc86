#pragma once

#include "preprocess/base/file_io.hpp"
#include "src/scene/primitive_map_job.hpp"

#include <emscripten/val.h>
#include <memory>
#include <string>

namespace edgeshade::web {

/// The worker's side of building primitive maps of one scene:
///
///     show(scene)
///     for each task: begin(task), while not advance(ms) check for messages, result()
///
/// Bytes are passed as an address and a `size` from malloc(), and are freed. Failures are returned
/// as sentences, "" for success.
class MapMaker {
  public:
    /// `scene`: from toTransfer(LoadedScene).
    std::string show(std::uintptr_t address, std::size_t size);
    /// `task`: from toTransfer(PrimitiveMapTask). Drops the previous task.
    std::string begin(std::uintptr_t address, std::size_t size);
    /// Works for about this long; returns whether it has finished, or failed.
    bool advance(double milliseconds);
    /// From toTransfer(BuiltPrimitiveMap); empty if it failed.
    emscripten::val result();

  private:
    void cutBy(const Section& section);

    LoadedScene loaded_;
    KeptEdges edges_;
    std::unique_ptr<PrimitiveMapJob> job_;
    bool failed_ = false;
    Bytes bytes_;
};

} // namespace edgeshade::web
