#include "src/shadow/view/scene_tree.hpp"

#include "preprocess/base/morton.hpp"

#include <algorithm>
#include <utility>

namespace edgeshade {
namespace {

/// A batch's box in the world, but for rounding.
Box inWorld(const Box& box, const glm::dmat4& worldFromBatch) {
    const glm::dvec3 center(worldFromBatch * glm::dvec4(box.center(), 1.0));
    const glm::dvec3 half = box.high - box.center();
    glm::dvec3 reach(0.0);
    for (glm::length_t axis = 0; axis < 3; ++axis)
        reach += glm::abs(glm::dvec3(worldFromBatch[axis])) * half[axis];
    return {center - reach, center + reach};
}

/// The box around a batch's origin that SceneTree::extent() is around.
Box extentOf(const glm::dvec3& farthest, const glm::dmat4& worldFromBatch) {
    return inWorld({-farthest, farthest}, worldFromBatch);
}

} // namespace

/// Whether the tree has the batch's triangles, perhaps at other positions.
bool SceneTree::isOf(const Batch& batch, const OfBatch& of) const {
    if (batch.deforms()) return of.deformation == batch.deformation;
    return of.geometry && &**of.geometry == &*batch.geometry;
}

/// The tree of a rigid batch's geometry. Keeps the tree of the geometry before a cut with the
/// batch. `trees`: those of known geometries, to which it adds.
CopyOnWrite<TriangleTree> SceneTree::treeOf(const Scene& scene, const Batch& batch, Trees& trees,
                                            OfBatch& of) const {
    const auto known = [&](const Geometry& geometry) {
        const auto [found, isNew] = trees.try_emplace(&geometry);
        if (isNew) found->second = CopyOnWrite(treeFor(geometry, scene.materials));
        return found->second;
    };
    if (!batch.origins || trees.contains(&*batch.geometry)) return known(*batch.geometry);
    const CutOrigins& origins = *batch.origins;
    if (!of.whole || &*of.whole->geometry != &*origins.from)
        of.whole = Whole{origins.from, known(*origins.from)};
    CopyOnWrite cut(TriangleTree(*of.whole->triangles, *batch.geometry, origins, scene.materials));
    trees.emplace(&*batch.geometry, cut);
    return cut;
}

TriangleTree SceneTree::treeFor(const Geometry& geometry,
                                const std::vector<Material>& materials) const {
    return {geometry, materials, ofCut_ ? Cones::none : Cones::found};
}

void SceneTree::update(const Scene& scene, Trees made) {
    std::vector<std::uint8_t> doubleSided;
    for (const Material& material : scene.materials)
        doubleSided.push_back(material.doubleSided);
    // Materials that a section adds are of batches that it changes.
    const std::size_t known = std::min(doubleSided.size(), doubleSided_.size());
    if (!std::equal(doubleSided.begin(), doubleSided.begin() + static_cast<std::ptrdiff_t>(known),
                    doubleSided_.begin()))
        batches_.clear();
    doubleSided_ = std::move(doubleSided);
    const bool ofCut = scene.cutFrom.has_value();
    if (ofCut_ && !ofCut) batches_.clear(); // their trees may have no cones
    ofCut_ = ofCut;
    Trees trees = std::move(made);
    for (const OfBatch& of : batches_) {
        if (of.geometry) trees.emplace(&**of.geometry, of.triangles);
        if (of.whole) trees.emplace(&*of.whole->geometry, of.whole->triangles);
    }
    bool same = batches_.size() == scene.batches.size();
    std::vector<OfBatch> before = std::exchange(batches_, {});
    before.resize(scene.batches.size());
    ground_.reset();
    for (std::size_t i = 0; i < scene.batches.size(); ++i) {
        const Batch& batch = scene.batches[i];
        if (batch.ground) ground_ = i;
        OfBatch& of = batches_.emplace_back(std::move(before[i]));
        if (isOf(batch, of)) {
            if (batch.deforms() && of.shape != batch.shape) {
                of.triangles.edit().refit(*batch.geometry, scene.materials);
                of.shape = batch.shape;
            }
            continue;
        }
        same = false;
        of = {{}, {}, std::move(of.whole), {}, {}};
        of.deformation = batch.deformation;
        of.shape = batch.shape;
        if (batch.deforms()) {
            of.triangles = CopyOnWrite(treeFor(*batch.geometry, scene.materials));
        } else {
            of.triangles = treeOf(scene, batch, trees, of);
            of.geometry = batch.geometry;
        }
    }
    if (!same) orderPlaces(scene);
    placeAll(scene);
}

/// Sorts the places along the Morton curve.
void SceneTree::orderPlaces(const Scene& scene) {
    places_.clear();
    std::vector<glm::dvec3> middles;
    Box all;
    for (std::size_t i = 0; i < batches_.size(); ++i) {
        const Box box = inWorld(batches_[i].triangles->bounds(), scene.batches[i].worldFromBatch);
        all.add(middles.emplace_back(box.center()));
        if (!scene.batches[i].ground && batches_[i].triangles->size() > 0)
            places_.push_back(static_cast<std::uint32_t>(i));
    }
    std::vector<std::uint64_t> codes;
    for (const glm::dvec3& middle : middles)
        codes.push_back(mortonCode(middle, all));
    std::stable_sort(places_.begin(), places_.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return codes[a] < codes[b]; });
    boxes_ = BoxTree<double>(places_.size());
}

/// Fits the boxes of the places.
void SceneTree::placeAll(const Scene& scene) {
    extent_ = {};
    leaves_ = 0;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const glm::dmat4& worldFromBatch = scene.batches[places_[i]].worldFromBatch;
        const TriangleTree& triangles = trianglesOf(places_[i]);
        leaves_ += triangles.boxes().items();
        const Box box = inWorld(triangles.bounds(), worldFromBatch);
        boxes_.set(i, box.low, box.high);
        const Box extent = extentOf(triangles.farthest(), worldFromBatch);
        extent_.add(extent.low);
        extent_.add(extent.high);
    }
    boxes_.fit();
}

} // namespace edgeshade
