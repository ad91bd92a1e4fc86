#pragma once

#include "edgeshade/shadow_masks.hpp"
#include "preprocess/section/geometry_cut.hpp"
#include "src/engine/prepared_mesh.hpp"

namespace edgeshade {

/// Clips a mesh, and keeps what it made until mesh or planes change.
class MeshClip {
  public:
    using Mesh = std::shared_ptr<const PreparedMesh::Data>;

    /// Throws InputError if a plane has a number that is not finite.
    explicit MeshClip(const MaskClipping& from);

    /// Whether what is clipped away casts.
    bool casts() const { return casts_; }
    bool hasSamePlanes(const MeshClip& other) const {
        return planes_ == other.planes_ && intersection_ == other.intersection_ &&
               casts_ == other.casts_;
    }
    std::size_t planes() const { return planes_.size(); }
    /// Takes over what another made, which stays right where the planes cross nothing.
    void takeMade(MeshClip&& other);

    /// The mesh, clipped; the mesh itself if nothing of it is. `box`: of its positions.
    const Mesh& clip(const Mesh& mesh, const glm::dmat4& worldFromMesh, const Box& box);

  private:
    std::vector<glm::dvec4> planes_; ///< in the world
    bool intersection_ = false, casts_ = false;
    Mesh from_, made_;
    BoxSide side_ = BoxSide::kept;
    std::vector<glm::dvec4> madeBy_; ///< in the mesh's space
};

} // namespace edgeshade
