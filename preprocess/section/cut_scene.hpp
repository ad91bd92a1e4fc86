#pragma once

#include "preprocess/scene/scene.hpp"

#include <map>
#include <memory>
#include <vector>

namespace edgeshade {

/// Cuts a scene by sections, again and again. It keeps the scene as it was, and which of its
/// triangles bound solids.
class SceneCutter {
  public:
    /// `castMasked` as in CasterSettings. `whole` has no section.
    SceneCutter(Scene whole, bool castMasked);

    /// The scene as cut, with the same batches and lights, and with more materials. Batches that
    /// no plane crosses share their geometry with the scene before; those that a section changes no
    /// longer deform. The ground isn't cut. Surfaces are visible from both sides.
    ///
    /// Cut faces of solids, that is of closed and opaque components, are filled. Where shadows are
    /// cut too, the fill casts, and solids are closed again (docs/method.md, C50).
    Scene cut(const Section& section);

    const Scene& whole() const { return *whole_; }

  private:
    struct Cutting;

    const std::vector<std::uint8_t>& solidsOf(const Batch& batch);
    void cutBatch(Batch& batch, Cutting& cutting);

    std::shared_ptr<const Scene> whole_;
    bool castMasked_;
    std::map<const Geometry*, std::vector<std::uint8_t>> solids_; ///< by triangle
};

} // namespace edgeshade
