#pragma once

#include "edgeshade/shadow_masks.hpp"
#include "preprocess/base/file_io.hpp"

#include <emscripten/val.h>
#include <string>
#include <vector>

namespace edgeshade::web {

/// Finds the edges of meshes and merges small neighbours, in a worker. Failures are returned as
/// sentences, "" for success.
class MeshPacker {
  public:
    /// Forgets all meshes.
    void clear();
    /// The arguments are those of meshAt(). A mesh that fails has a number, too.
    std::string pack(std::uintptr_t positions, std::size_t floats, std::uintptr_t indices,
                     std::size_t count, std::uintptr_t texcoords, std::size_t texcoordFloats,
                     unsigned flags);
    /// Merges neighbours among `count` places: numbers of meshes since clear(), and 16 numbers for
    /// each place.
    std::string merge(std::uintptr_t meshes, std::uintptr_t matrices, std::size_t count);
    std::size_t mergedCount() const { return merged_.size(); }
    /// The merged places of one of them, which the page copies before the next call.
    emscripten::val members(std::size_t merged);
    /// For Masks.takeMerged().
    emscripten::val mergedBytes(std::size_t merged);
    /// The last mesh, for Masks.take().
    emscripten::val bytes() const;

  private:
    std::vector<PreparedMesh> meshes_;
    std::vector<MergedMeshes> merged_;
    std::vector<double> members_;
    Bytes bytes_;
};

} // namespace edgeshade::web
