#include "preprocess/section/cut_scene.hpp"

#include "preprocess/section/section_fill.hpp"
#include "preprocess/section/solid_triangles.hpp"

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
    for (std::vector<glm::vec2>& texcoords : geometry.moreTexcoords)
        if (!texcoords.empty()) texcoords.resize(count, glm::vec2(0.0f));
    if (!geometry.tangents.empty()) geometry.tangents.resize(count, glm::vec4(0.0f));
}

/// Collects triangles by material, with their nodes, into a geometry's indices.
class IndexWriter {
  public:
    /// `placedBy`: the batch's.
    IndexWriter(const Geometry& from, int placedBy, Geometry& to)
        : from_(from), placedBy_(placedBy), to_(to) {
        to_.indices.clear();
        to_.groups.clear();
        to_.sources.clear();
    }

    void begin(std::size_t material) {
        to_.groups.push_back({material, static_cast<std::uint32_t>(to_.indices.size()), 0});
    }
    /// `source`: number of the triangle that it was.
    void add(const std::array<std::uint32_t, 3>& corners, std::uint32_t source) {
        if (!from_.sources.empty() || !to_.sources.empty())
            addSource(to_, nodeOf(from_, placedBy_, 3 * source));
        append(corners);
    }
    /// A triangle of no node.
    void addFill(const std::array<std::uint32_t, 3>& corners) {
        addSource(to_, -1);
        append(corners);
    }
    void end() {
        if (to_.groups.back().indexCount == 0) to_.groups.pop_back();
    }

  private:
    void append(const std::array<std::uint32_t, 3>& corners) {
        to_.indices.insert(to_.indices.end(), corners.begin(), corners.end());
        to_.groups.back().indexCount += 3;
    }

    const Geometry& from_;
    int placedBy_;
    Geometry& to_;
};

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

/// The pieces of triangles [first, end) of the geometry; cutting keeps their order.
std::span<const CutTriangle> piecesOf(const std::vector<CutTriangle>& pieces, std::uint32_t first,
                                      std::uint32_t end) {
    const auto from = [&](std::uint32_t source) {
        return std::lower_bound(
            pieces.begin(), pieces.end(), source,
            [](const CutTriangle& piece, std::uint32_t of) { return piece.source < of; });
    };
    return std::span(pieces).subspan(static_cast<std::size_t>(from(first) - pieces.begin()),
                                     static_cast<std::size_t>(from(end) - from(first)));
}
std::span<const CutTriangle> piecesOf(const std::vector<CutTriangle>& pieces,
                                      const SurfaceGroup& group) {
    return piecesOf(pieces, group.firstIndex / 3, (group.firstIndex + group.indexCount) / 3);
}

} // namespace

SceneCutter::SceneCutter(Scene whole, bool castMasked)
    : whole_(std::make_shared<const Scene>(std::move(whole))), castMasked_(castMasked) {}

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
    Geometry made = from;
    made.simplifiedCasters.reset();
    if (!known.solid) known.solid = solidTriangles(from, whole_->materials);
    GeometryCut cut(made, from.indices, *known.solid);
    const auto firstFill = static_cast<std::uint32_t>(from.indices.size() / 3);
    for (const glm::dvec4& plane : planes) {
        const std::vector<CutLine> lines = cut.cut(plane, cutting.keepsAway());
        if (!cutting.section.fill) continue;
        std::vector<std::array<std::uint32_t, 3>> fill = fillOf(lines, plane, made);
        completeFill(made, glm::vec3(-glm::normalize(glm::dvec3(plane))), fill);
        for (const auto& corners : fill)
            cut.add({corners, firstFill, true, false});
    }

    const std::vector<CutTriangle>& pieces = cut.triangles();
    const std::span<const CutTriangle> fills = piecesOf(pieces, firstFill, firstFill + 1);
    IndexWriter writer(from, batch.placedBy, made);
    auto writeFill = [&, written = false]() mutable {
        if (std::exchange(written, true) || fills.empty()) return;
        writer.begin(cutting.fillMaterial());
        for (const CutTriangle& piece : fills)
            if (!piece.away) writer.addFill(piece.corners);
        writer.end();
    };
    for (const SurfaceGroup& group : from.groups) {
        // Opaque surfaces come first.
        if (cutting.materials[group.material].alphaMode != AlphaMode::opaque) writeFill();
        writer.begin(group.material);
        for (const CutTriangle& piece : piecesOf(pieces, group))
            if (!piece.away) writer.add(piece.corners, piece.source);
        writer.end();
    }
    writeFill();
    for (const bool masked : {true, false})
        for (const SurfaceGroup& group : from.groups) {
            const AlphaMode mode = cutting.materials[group.material].alphaMode;
            if ((mode == AlphaMode::mask) != masked) continue;
            const std::optional<std::size_t> away = cutting.awayMaterial(group.material);
            if (!away) continue;
            writer.begin(*away);
            for (const CutTriangle& piece : piecesOf(pieces, group))
                if (piece.away) writer.add(piece.corners, piece.source);
            writer.end();
        }
    if (from.simplifiedCasters)
        made.simplifiedCasters = cutting.keepsAway()
                                     ? *from.simplifiedCasters
                                     : cutIndices(*from.simplifiedCasters, planes, made);
    batch.geometry = CopyOnWrite<Geometry>(std::move(made));
    if (side == BoxSide::away) known.away = batch.geometry;
}

} // namespace edgeshade
