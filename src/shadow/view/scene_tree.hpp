#pragma once

#include "src/shadow/geometry/triangle_tree.hpp"

#include <map>
#include <optional>

namespace edgeshade {

/// Boxes around all triangles of a scene: a tree for each geometry, and above these a tree of the
/// places of batches. makeFrameView() searches it for the visible geometry. Callers that draw many
/// frames keep one beside their scene, and update it whenever the scene changes. Copies share the
/// trees of geometries.
class SceneTree {
  public:
    using Trees = std::map<const Geometry*, CopyOnWrite<TriangleTree>>;

    SceneTree() = default; ///< of a scene without batches
    explicit SceneTree(const Scene& scene) { update(scene); }

    /// Follows a scene whose batches have moved, deformed, come or gone. Makes trees only for
    /// geometries that it doesn't know; of batches that have deformed, and places that have moved,
    /// it fits the boxes. The trees of geometries that a section cuts follow from those before it.
    /// `made`: trees that were made ahead, with cones.
    void update(const Scene& scene, Trees made = {});

    /// The boxes of places in the world; the item with number i is the batch places()[i].
    const BoxTree<double>& boxes() const { return boxes_; }
    /// The batches that have triangles, without the ground.
    const std::vector<std::uint32_t>& places() const { return places_; }
    /// The batch of the ground.
    const std::optional<std::size_t>& ground() const { return ground_; }
    const TriangleTree& trianglesOf(std::size_t batch) const { return *batches_[batch].triangles; }
    /// Number of leaves of all places.
    std::size_t leaves() const { return leaves_; }

    /// Boxes around the origins of all places, each as large as its vertices' coordinates allow: no
    /// sum on the way from a vertex to the world exceeds its coordinates.
    const Box& extent() const { return extent_; }

  private:
    /// A geometry that a section cuts, and its tree.
    struct Whole {
        CopyOnWrite<Geometry> geometry;
        CopyOnWrite<TriangleTree> triangles;
    };
    struct OfBatch {
        CopyOnWrite<TriangleTree> triangles;
        /// The geometry of a rigid batch, kept as it is: whoever edits it gets a copy.
        std::optional<CopyOnWrite<Geometry>> geometry;
        std::optional<Whole> whole; ///< since a section cut the batch; kept while the scene is cut
        // If the batch deforms:
        std::shared_ptr<const Deformation> deformation;
        BatchShape shape;
    };

    bool isOf(const Batch& batch, const OfBatch& of) const;
    CopyOnWrite<TriangleTree> treeOf(const Scene& scene, const Batch& batch, Trees& trees,
                                     OfBatch& of) const;
    TriangleTree treeFor(const Geometry& geometry, const std::vector<Material>& materials) const;
    void placeAll(const Scene& scene);
    void orderPlaces(const Scene& scene);

    std::vector<OfBatch> batches_;
    std::vector<std::uint8_t> doubleSided_; ///< by material
    bool ofCut_ = false;                    ///< a section cuts the scene, which then culls nothing
    std::vector<std::uint32_t> places_;
    BoxTree<double> boxes_;
    Box extent_;
    std::optional<std::size_t> ground_;
    std::size_t leaves_ = 0;
};

} // namespace edgeshade
