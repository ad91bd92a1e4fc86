#pragma once

#include "preprocess/base/file_io.hpp"
#include "src/engine/lookup_work.hpp"

#include <memory>
#include <span>
#include <vector>

namespace edgeshade::web {

// A light's map on its way to the worker that builds it, and back, as bytes for another instance of
// this same program: see archive.hpp.

/// A task as bytes, part by part. It shares the casters' data with the work, so that the bytes stay
/// those of the work whatever happens to the casters meanwhile.
class TaskTransfer {
  public:
    /// Takes time linear in the number of casters, not of their triangles.
    explicit TaskTransfer(const LookupWork& work);

    /// The next bytes, as many as `most` (> 0), fewer only at the end; empty once all were
    /// returned.
    Bytes next(std::size_t most);

  private:
    /// Goes on to the next piece. Returns false once there is none.
    bool begin();

    std::shared_ptr<const LookupWork::Data> work_;
    // Values that casters share, by first use.
    std::vector<const PlanePairShadow*> shapes_;
    std::vector<const PreparedMesh::Data*> meshes_;
    std::vector<const MaskTexels*> texels_;
    // The present piece: bytes of its own, then bytes of the work.
    Bytes own_;
    std::span<const std::uint8_t> shared_;
    std::size_t begun_ = 0; ///< bytes of the piece that were returned
    std::size_t next_ = 0;  ///< number of the next piece
};

/// The returned work has not begun.
LookupWork taskFromTransfer(std::span<const std::uint8_t> bytes);

/// Finished work without its texels, which the page uploads itself.
Bytes resultToTransfer(const LookupWork& work);
/// The returned work is finished, and has no casters.
LookupWork resultFromTransfer(std::span<const std::uint8_t> bytes);

} // namespace edgeshade::web
