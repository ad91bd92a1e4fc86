#pragma once

#include "preprocess/base/file_io.hpp"
#include "src/scene/primitive_map_job.hpp"

#include <emscripten/val.h>
#include <memory>
#include <string>

namespace edgeshade::web {

/// The worker's half of building primitive maps of one scene:
///
///     show(scene)
///     for each task: begin(task), while not advance(ms) look for messages, result()
///
/// Bytes are given as `size` of them that malloc() gave, which are freed. Failures are returned as
/// sentences, "" where all went well.
class MapMaker {
  public:
    /// `scene`: of toTransfer(LoadedScene).
    std::string show(std::uintptr_t address, std::size_t size);
    /// `task`: of toTransfer(PrimitiveMapTask). What was begun before is given up.
    std::string begin(std::uintptr_t address, std::size_t size);
    /// Goes on for about so long; returns whether all is done, or has failed.
    bool advance(double milliseconds);
    /// Of toTransfer(BuiltPrimitiveMap); none where it failed.
    emscripten::val result();

  private:
    LoadedScene loaded_;
    KeptEdges edges_;
    std::unique_ptr<PrimitiveMapJob> job_;
    bool failed_ = false;
    Bytes bytes_;
};

} // namespace edgeshade::web
