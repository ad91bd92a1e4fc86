#pragma once

#include "preprocess/base/box.hpp"
#include "preprocess/base/copy_on_write.hpp"
#include "preprocess/base/warnings.hpp"
#include "preprocess/scene/deformation.hpp"
#include "preprocess/scene/material.hpp"
#include "preprocess/scene/scene_camera.hpp"
#include "preprocess/scene/scene_light.hpp"
#include "preprocess/scene/section.hpp"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

namespace edgeshade {

/// Triangles of one material within a batch.
struct SurfaceGroup {
    std::size_t material = 0;
    std::uint32_t firstIndex = 0;
    std::uint32_t indexCount = 0; ///< three per triangle
};

/// A node that an animation of the file moves, and its place relative to the animated node above
/// it.
struct AnimatedNode {
    int node = -1;                              ///< in glTF
    int above = -1;                             ///< nearest animated ancestor; -1: the world
    glm::dmat4 aboveFromParent{1.0};            ///< transform of the static nodes between the two
    glm::dmat4 parentFromAnimated{1.0};         ///< at rest
    glm::dmat4 aboveFromParentUnflattened{1.0}; ///< aboveFromParent as if no node scaled by 0
    glm::dmat4 parentFromAnimatedUnflattened{1.0}; ///< parentFromAnimated as if the node didn't
                                                   ///< scale by 0
};

/// The glTF node of the triangles from an index on.
struct SourceNode {
    std::uint32_t firstIndex = 0; ///< of a triangle; up to the next entry's
    int node = -1;                ///< in glTF
};

/// Triangles in their own space.
///
/// Positions are floats relative to a local origin, so that survey coordinates keep their detail
/// (docs/method.md, C6). The transform to the world is double.
struct Geometry {
    std::vector<glm::vec3> positions; ///< no NaN, no infinity, no -0
    std::vector<glm::vec3> normals;   ///< unit length, or 0 for a triangle without area
    std::vector<glm::vec2> texcoords; ///< of the material's first channel
    std::vector<glm::vec4> colors;    ///< linear
    /// Texture coordinates of a material's channels after the first, and tangents with the
    /// bitangent's sign in w, 0 where the file has none. As long as positions if a material of the
    /// batch uses them, otherwise empty.
    std::array<std::vector<glm::vec2>, mostTexcoordChannels - 1> moreTexcoords;
    std::vector<glm::vec4> tangents;
    std::vector<std::uint32_t> indices; ///< counter-clockwise as seen from outside
    std::vector<SurfaceGroup> groups;   ///< opaque first, then mask, then blend
    std::vector<SourceNode> sources;    ///< by index; empty: Batch::placedBy is the node
    /// Corners of simplified casters, three per triangle, from simplifyCasters(); they cast in
    /// place of the opaque triangles. Null: these cast themselves.
    std::optional<std::vector<std::uint32_t>> simplifiedCasters;
};

struct CutOrigins;

/// Triangles that move together. All static nodes are one batch, and every animated node is
/// another. Triangles deformed by an animated skin or animated morph weights are batches of their
/// own. So is each place of a mesh worth keeping once; these batches share their geometry.
struct Batch {
    int node = -1;                  ///< the glTF node that moves it; -1: none, it is static
    glm::dmat4 worldFromBatch{1.0}; ///< at rest
    glm::dmat4 nodeFromBatch{1.0};  ///< to the animated node, or to the world
    CopyOnWrite<Geometry> geometry;
    int placedBy = -1; ///< the glTF node that places a shared mesh here; -1: see Geometry::sources

    /// The batch is the ground, which the program lays beneath a scene; it is in no file, and
    /// visible only from above.
    bool ground = false;

    /// The batch vanishes now: a node scales it to nothing, or out of range. It is neither drawn
    /// nor casts, and its worldFromBatch has no meaning.
    bool hidden = false;

    std::shared_ptr<const Deformation> deformation; ///< null: the batch is rigid
    BatchShape shape;                               ///< its present shape, if it deforms

    /// Origins of the triangles of a geometry that a section has cut; null: the geometry is as it
    /// was before, or of an earlier cut. Whoever edits the geometry must reset this.
    std::shared_ptr<const CutOrigins> origins;

    /// Whether its transform reverses winding.
    bool isMirrored() const { return glm::determinant(glm::dmat3(worldFromBatch)) < 0.0; }
    bool deforms() const { return deformation != nullptr; }
    bool isAnimated() const { return node >= 0 || deforms(); } ///< an animation can move it
};

struct Scene;

/// A section, and the scene that it cuts.
struct CutFrom {
    std::shared_ptr<const Scene> whole; ///< the scene before, with the same batches
    Section section;
};

/// A glTF scene at rest, ready for drawing and for building shadow data.
struct Scene {
    std::vector<Batch> batches;
    std::vector<AnimatedNode> animatedNodes; ///< parents first; some move no batch
    std::vector<Material> materials;
    std::vector<SceneCamera> cameras; ///< in the order of the nodes that place them
    std::vector<SceneLight> lights;   ///< in the order of the nodes that place them
    Warnings warnings;
    /// Triangles of single-sided materials are visible only from their front. They cast from either
    /// side (docs/method.md, C39).
    bool culls = false;
    std::optional<CutFrom> cutFrom; ///< empty: no section cuts the scene

    /// Whether some casters may be in no depth buffer: BLEND ones, with `castMasked` as in
    /// CasterSettings, and those that a section cuts away.
    bool mayHaveHoles(bool castMasked) const {
        return castMasked || (cutFrom && cutFrom->section.shadows == SectionShadows::whole);
    }
    /// The scene without its section.
    const Scene& whole() const { return cutFrom ? *cutFrom->whole : *this; }

    /// All triangles without the ground's.
    std::size_t triangleCount() const {
        std::size_t count = 0;
        for (const Batch& batch : batches)
            if (!batch.ground) count += batch.geometry->indices.size() / 3;
        return count;
    }
};

/// For each batch, the first batch with the same geometry, perhaps itself.
std::vector<std::size_t> firstOfGeometry(const std::vector<Batch>& batches);

/// For each batch make(i), called once a geometry: for the first batch i that has it.
template <class Make>
auto byGeometry(const std::vector<Batch>& batches, const Make& make) {
    const std::vector<std::size_t> first = firstOfGeometry(batches);
    std::vector<std::invoke_result_t<Make, std::size_t>> made;
    made.reserve(first.size());
    for (std::size_t i = 0; i < first.size(); ++i)
        made.push_back(first[i] != i ? made[first[i]] : make(i));
    return made;
}

/// The glTF node of the mesh with the triangle at that index of a batch's geometry; -1 for the
/// ground. `placedBy`: the batch's.
int nodeOf(const Geometry& geometry, int placedBy, std::uint32_t index);

/// Says that the triangles to be added to a geometry, from here on, are a glTF node's.
void addSource(Geometry& geometry, int node);

/// The box of a geometry's vertices, in its own space.
Box boundsOf(const Geometry& geometry);

/// The box of a batch's vertices in the world.
Box worldBounds(const Batch& batch);

/// The box of all vertices in the world, without those of the ground and of hidden batches. A
/// section leaves it as it was.
Box worldBounds(const Scene& scene);

} // namespace edgeshade
