#pragma once

#include "preprocess/base/box.hpp"
#include "preprocess/base/copy_on_write.hpp"
#include "preprocess/base/warnings.hpp"
#include "preprocess/scene/deformation.hpp"
#include "preprocess/scene/material.hpp"
#include "preprocess/scene/scene_camera.hpp"
#include "preprocess/scene/scene_light.hpp"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

namespace edgeshade {

/// Triangles of one material within a batch.
struct SurfaceGroup {
    std::size_t material = 0;
    std::uint32_t firstIndex = 0;
    std::uint32_t indexCount = 0; ///< three a triangle
};

/// A node that an animation of the file moves, and how it hangs on the animated node above it.
struct AnimatedNode {
    int node = -1;  ///< in glTF
    int above = -1; ///< nearest animated node on the way to the root; -1: the world
    glm::dmat4 aboveFromParent{1.0};               ///< the nodes between the two, which do not move
    glm::dmat4 parentFromAnimated{1.0};            ///< at rest
    glm::dmat4 aboveFromParentUnflattened{1.0};    ///< as if none of these nodes scaled by 0
    glm::dmat4 parentFromAnimatedUnflattened{1.0}; ///< likewise
};

/// Whose triangles begin at an index.
struct SourceNode {
    std::uint32_t firstIndex = 0; ///< of a triangle; they go on until the next one's
    int node = -1;                ///< in glTF
};

/// Triangles in a space of their own.
///
/// Positions are floats relative to a local origin, so that survey coordinates keep their detail
/// (docs/method.md, C6); what places them in the world is double.
struct Geometry {
    std::vector<glm::vec3> positions; ///< no NaN, no infinity, no -0
    std::vector<glm::vec3> normals;   ///< unit length, or 0 for a triangle without area
    std::vector<glm::vec2> texcoords; ///< of the material's first channel
    std::vector<glm::vec4> colors;    ///< linear
    /// Of a material's channels after the first, and tangents with the bitangent's sign, 0 where
    /// the file has none: as long as positions where some material of the batch has them, else
    /// empty.
    std::array<std::vector<glm::vec2>, mostTexcoordChannels - 1> moreTexcoords;
    std::vector<glm::vec4> tangents;
    std::vector<std::uint32_t> indices; ///< counter-clockwise is the outside
    std::vector<SurfaceGroup> groups;   ///< opaque first, then mask, then blend
    std::vector<SourceNode> sources;    ///< by index; empty: Batch::placedBy says
    /// Corners of what casts in place of the opaque triangles, three a triangle, as
    /// simplifyCasters() found them; nothing: they cast themselves.
    std::optional<std::vector<std::uint32_t>> simplifiedCasters;
};

/// Triangles that move together: all static nodes are one batch, every animated node another; what
/// an animated skin or animated morph weights deform are batches of their own. So is each place of
/// a mesh that has many and is worth keeping once: these batches share their geometry.
struct Batch {
    int node = -1;                  ///< the glTF node that moves it; -1: none, it is static
    glm::dmat4 worldFromBatch{1.0}; ///< at rest
    glm::dmat4 nodeFromBatch{1.0};  ///< to the animated node, or to the world
    CopyOnWrite<Geometry> geometry;
    int placedBy = -1; ///< the glTF node that places a mesh kept once here; -1: Geometry::sources

    /// It is the ground, which the program lays beneath a scene: no file has it, and it is seen
    /// from above alone.
    bool ground = false;

    /// There is nothing of it now: a node scales it to nothing, or out of all range. It is neither
    /// drawn nor casts, and where worldFromBatch has it means nothing.
    bool hidden = false;

    std::shared_ptr<const Deformation> deformation; ///< null: the batch is rigid
    BatchShape shape;                               ///< in which it is now, where it deforms

    /// Its place turns windings over.
    bool isMirrored() const { return glm::determinant(glm::dmat3(worldFromBatch)) < 0.0; }
    bool deforms() const { return deformation != nullptr; }
    bool isAnimated() const { return node >= 0 || deforms(); } ///< an animation can move it
};

/// A glTF scene at rest, ready for drawing and for finding its edges.
struct Scene {
    std::vector<Batch> batches;
    std::vector<AnimatedNode> animatedNodes; ///< those above first; some move no batch of their own
    std::vector<Material> materials;
    std::vector<SceneCamera> cameras; ///< in the order of the nodes that place them
    std::vector<SceneLight> lights;   ///< likewise
    Warnings warnings;
    /// Triangles of materials that aren't double-sided are seen from their front alone. They cast
    /// from either side (docs/method.md, C39).
    bool culls = false;

    /// Without those of the ground.
    std::size_t triangleCount() const {
        std::size_t count = 0;
        for (const Batch& batch : batches)
            if (!batch.ground) count += batch.geometry->indices.size() / 3;
        return count;
    }
};

/// By batch: the first of those that have its geometry, which may be itself.
std::vector<std::size_t> firstOfGeometry(const std::vector<Batch>& batches);

/// The glTF node whose mesh has the triangle at that index; -1: none, the ground's.
int nodeOf(const Batch& batch, std::uint32_t index);

/// The box of all vertices in the world, but for the ground's and those of hidden batches.
Box worldBounds(const Scene& scene);

} // namespace edgeshade
