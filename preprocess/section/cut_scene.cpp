#include "preprocess/section/cut_scene.hpp"

#include "preprocess/section/cut_writer.hpp"
#include "preprocess/section/section_fill.hpp"
#include "preprocess/section/solid_triangles.hpp"
#include "preprocess/section/vertex_attributes.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

namespace edgeshade {

/// One cut of the scene.
struct SceneCutter::Cutting {
    const Section& section;
    const std::vector<Material>& materials; ///< of the whole scene
    bool castMasked = false;

    bool keepsAway() const { return section.shadows == SectionShadows::whole; }
    std::size_t fillMaterial() const { return materials.size(); }

    /// The material of what is cut away; empty if that casts nothing.
    std::optional<std::size_t> awayMaterial(std::size_t material) const {
        const Material& of = materials[material];
        const bool mayCast = of.casts(castMasked) || of.alphaMode == AlphaMode::mask;
        if (!keepsAway() || !mayCast) return std::nullopt;
        return materials.size() + 1 + material;
    }
};

namespace {

/// Gives a fill vertices of its own, with the attributes of a flat face.
void completeFill(Geometry& geometry, const glm::vec3& normal,
                  std::vector<std::array<std::uint32_t, 3>>& triangles) {
    std::map<std::uint32_t, std::uint32_t> copies;
    for (auto& triangle : triangles)
        for (std::uint32_t& corner : triangle) {
            const auto [found, isNew] =
                copies.try_emplace(corner, static_cast<std::uint32_t>(geometry.positions.size()));
            if (isNew) geometry.positions.push_back(geometry.positions[corner]);
            corner = found->second;
        }
    const std::size_t count = geometry.positions.size();
    geometry.normals.resize(count, normal);
    geometry.texcoords.resize(count, glm::vec2(0.0f));
    geometry.colors.resize(count, glm::vec4(1.0f));
    const auto complete = [&](auto& values) {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        if (!values.empty()) values.resize(count, Value(0.0f));
    };
    forEachAttribute(complete, geometry);
}

/// The corners of simplified casters, cut.
std::vector<std::uint32_t> cutIndices(const std::vector<std::uint32_t>& indices,
                                      const std::vector<glm::dvec4>& planes, Geometry& geometry) {
    GeometryCut cut(geometry, indices);
    for (const glm::dvec4& plane : planes)
        cut.cut(plane, false);
    std::vector<std::uint32_t> kept;
    for (const CutTriangle& triangle : cut.triangles())
        kept.insert(kept.end(), triangle.corners.begin(), triangle.corners.end());
    return kept;
}

/// The numbers of triangles that planes meet.
std::vector<std::uint32_t> metOf(const std::vector<TriangleFate>& fates) {
    std::vector<std::uint32_t> met;
    for (std::uint32_t t = 0; t < fates.size(); ++t)
        if (fates[t] == TriangleFate::met) met.push_back(t);
    return met;
}

} // namespace

SceneCutter::SceneCutter(Scene whole, bool castMasked, KnownTopologies topologies)
    : whole_(std::make_shared<const Scene>(std::move(whole))), castMasked_(castMasked) {
    for (auto& [geometry, topology] : topologies)
        knownOf(*geometry).topology = std::move(topology);
}

std::optional<MeshTopology> SceneCutter::takeTopology(const Geometry& geometry) {
    return std::exchange(knownOf(geometry).topology, std::nullopt);
}

SceneCutter::Known& SceneCutter::knownOf(const Geometry& geometry) {
    const auto [found, isNew] = known_.try_emplace(&geometry);
    if (isNew) found->second.bounds = boundsOf(geometry);
    return found->second;
}

void SceneCutter::addMaterials(const Section& section, std::vector<Material>& materials) const {
    const bool castsWhole = section.shadows == SectionShadows::whole;
    Material fill;
    fill.baseColorFactor = glm::vec4(section.fill.value_or(glm::vec3(0.0f)), 1.0f);
    fill.metallic = 0.0f;
    fill.doubleSided = true;
    if (castsWhole) fill.section = SectionPart::fill;
    materials.push_back(fill);
    if (!castsWhole) return;
    for (Material away : whole_->materials) {
        away.section = SectionPart::away;
        if (away.alphaMode == AlphaMode::opaque) away.alphaMode = AlphaMode::blend;
        materials.push_back(away);
    }
}

Scene SceneCutter::cut(const Section& section) {
    Scene scene = *whole_;
    if (section.planes.empty()) return scene;
    scene.cutFrom = CutFrom{whole_, section};
    scene.culls = false;
    addMaterials(section, scene.materials);
    const Cutting cutting{section, whole_->materials, castMasked_};
    for (Batch& batch : scene.batches)
        if (!batch.ground && !batch.hidden && !batch.geometry->indices.empty())
            cutBatch(batch, cutting);
    return scene;
}

void SceneCutter::cutBatch(Batch& batch, const Cutting& cutting) {
    std::vector<glm::dvec4> planes;
    for (const glm::dvec4& plane : cutting.section.planes)
        planes.push_back(planeInBatch(plane, batch.worldFromBatch));
    const CopyOnWrite<Geometry> before = batch.geometry;
    const Geometry& from = *before;
    Known& known = knownOf(from);
    const BoxSide side = sideOf(known.bounds, planes);
    if (side != BoxSide::crossed) {
        known.made.clear();
        known.origins.clear();
    }
    if (side == BoxSide::kept) return;
    batch.deformation = nullptr;
    if (side == BoxSide::away) {
        if (!cutting.keepsAway()) {
            batch.geometry = nothing_;
            return;
        }
        if (known.away) {
            batch.geometry = *known.away;
            return;
        }
    }
    const std::vector<TriangleFate> fates = fatesOf(from, planes);
    CutOrigins origins = known.origins.take();
    origins.from = before;
    origins.ofTriangle.clear();
    origins.met = metOf(fates);
    if (known.solid.empty() && !origins.met.empty())
        known.solid = solidTriangles(from, whole_->materials, known.topology);
    Geometry made = known.made.take();
    takeVertices(from, 3 * origins.met.size(), made);
    GeometryCut cut(made, from.indices, known.solid, origins.met);
    const auto firstFill = static_cast<std::uint32_t>(from.indices.size() / 3);
    for (const glm::dvec4& plane : planes) {
        const std::vector<CutLine> lines = cut.cut(plane, cutting.keepsAway());
        if (!cutting.section.fill) continue;
        std::vector<std::array<std::uint32_t, 3>> fill = fillOf(lines, plane, made);
        completeFill(made, glm::vec3(-glm::normalize(glm::dvec3(plane))), fill);
        for (const auto& corners : fill)
            cut.add({corners, firstFill, true, false});
    }

    const std::span<const CutTriangle> pieces = cut.triangles();
    const std::size_t parts = static_cast<std::size_t>(
        std::find_if(pieces.begin(), pieces.end(),
                     [&](const CutTriangle& piece) { return piece.source == firstFill; }) -
        pieces.begin());
    CutWriter writer(from, fates, pieces.first(parts), batch.placedBy, made, origins);
    const auto isOpaque = [&](const SurfaceGroup& group) {
        return cutting.materials[group.material].alphaMode == AlphaMode::opaque;
    };
    // Opaque surfaces come first.
    const auto firstOther = std::find_if_not(from.groups.begin(), from.groups.end(), isOpaque);
    for (auto group = from.groups.begin(); group != firstOther; ++group)
        writer.addPart(*group, group->material, false);
    writer.addFill(pieces.subspan(parts), cutting.fillMaterial());
    for (auto group = firstOther; group != from.groups.end(); ++group)
        writer.addPart(*group, group->material, false);
    for (const bool masked : {true, false})
        for (const SurfaceGroup& group : from.groups) {
            const AlphaMode mode = cutting.materials[group.material].alphaMode;
            if ((mode == AlphaMode::mask) != masked) continue;
            if (const auto away = cutting.awayMaterial(group.material))
                writer.addPart(group, *away, true);
        }
    if (from.simplifiedCasters)
        made.simplifiedCasters = cutting.keepsAway()
                                     ? *from.simplifiedCasters
                                     : cutIndices(*from.simplifiedCasters, planes, made);
    batch.geometry = CopyOnWrite<Geometry>(known.made.share(std::move(made)));
    if (!origins.ofTriangle.empty()) batch.origins = known.origins.share(std::move(origins));
    if (side == BoxSide::away) known.away = batch.geometry;
}

} // namespace edgeshade
