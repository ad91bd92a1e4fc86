#include "src/engine/mesh_clip.hpp"

#include "preprocess/base/error.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

using Planes = std::vector<glm::dvec4>;

/// Where a box lies if only what all planes clip is clipped.
BoxSide sideOfIntersection(const Box& box, const Planes& planes) {
    bool away = true;
    for (const glm::dvec4& plane : planes) {
        const BoxSide side = sideOf(box, {plane});
        if (side == BoxSide::kept) return side;
        away = away && side == BoxSide::away;
    }
    return away ? BoxSide::away : BoxSide::crossed;
}

/// Whether a piece, which no plane crosses, is on the side that a plane clips. Corners on the cut
/// are off the plane by their rounding, so that the farthest corner decides.
bool isBelow(const CutTriangle& piece, const std::vector<glm::vec3>& positions,
             const glm::dvec4& plane) {
    double farthest = 0.0;
    for (const std::uint32_t corner : piece.corners) {
        const double height = glm::dot(plane, glm::dvec4(positions[corner], 1.0));
        if (std::abs(height) > std::abs(farthest)) farthest = height;
    }
    return farthest < 0.0;
}

/// Cuts by all planes; `away` marks what is clipped, unless that is dropped.
std::vector<CutTriangle> piecesOf(Geometry& geometry, const Planes& planes, bool intersection,
                                  bool keepsAway) {
    GeometryCut cut(geometry, geometry.indices);
    for (const glm::dvec4& plane : planes)
        cut.cut(plane, keepsAway || intersection);
    std::vector<CutTriangle> pieces = cut.triangles();
    if (!intersection) return pieces;
    // All planes have cut all pieces, so that neighbours fit on both sides of every plane.
    for (CutTriangle& piece : pieces)
        piece.away = std::all_of(planes.begin(), planes.end(), [&](const glm::dvec4& plane) {
            return isBelow(piece, geometry.positions, plane);
        });
    if (!keepsAway) std::erase_if(pieces, [](const CutTriangle& piece) { return piece.away; });
    return pieces;
}

MeshClip::Mesh clippedMesh(const PreparedMesh::Data& mesh, const Planes& planes, bool intersection,
                           bool keepsAway) {
    Geometry made = *mesh.geometry;
    const std::vector<CutTriangle> pieces = piecesOf(made, planes, intersection, keepsAway);
    std::array<std::vector<std::uint32_t>, maskMaterialCount> corners; // by material
    auto group = mesh.geometry->groups.begin();
    for (const CutTriangle& piece : pieces) { // in the order of their triangles
        while (3 * piece.source >= group->firstIndex + group->indexCount)
            ++group;
        if (const auto material =
                piece.away ? hiddenMaterial(group->material) : std::optional(group->material))
            for (const std::uint32_t corner : piece.corners)
                corners[*material].push_back(corner);
    }
    made.indices.clear();
    made.groups.clear();
    for (std::size_t material = 0; material < corners.size(); ++material) {
        const std::vector<std::uint32_t>& of = corners[material];
        if (of.empty()) continue;
        made.groups.push_back({material, static_cast<std::uint32_t>(made.indices.size()),
                               static_cast<std::uint32_t>(of.size())});
        made.indices.insert(made.indices.end(), of.begin(), of.end());
    }
    const auto& solids = mesh.shadow->solids;
    // Where what is cut away casts, invisible parts close the mesh: it isn't solid to the eye.
    const bool solid = !keepsAway && solids &&
                       std::any_of(solids->begin(), solids->end(), [](auto is) { return is != 0; });
    return preparedFrom(std::move(made), mesh.alphaTested, solid);
}

} // namespace

MeshClip::MeshClip(const MaskClipping& from)
    : intersection_(from.intersection), casts_(from.casts) {
    for (const std::array<double, 4>& plane : from.planes) {
        if (!std::all_of(plane.begin(), plane.end(), [](double n) { return std::isfinite(n); }))
            throw InputError("Clipping plane " + std::to_string(planes_.size()) +
                             " has a number that is not finite.");
        planes_.emplace_back(plane[0], plane[1], plane[2], plane[3]);
    }
}

void MeshClip::takeMade(MeshClip&& other) {
    if (intersection_ != other.intersection_ || casts_ != other.casts_) return;
    from_ = std::move(other.from_);
    made_ = std::move(other.made_);
    side_ = other.side_;
    madeBy_ = std::move(other.madeBy_);
}

const MeshClip::Mesh& MeshClip::clip(const Mesh& mesh, const glm::dmat4& worldFromMesh,
                                     const Box& box) {
    if (planes_.empty() || mesh->triangles() == 0) return mesh;
    Planes planes;
    for (const glm::dvec4& plane : planes_)
        planes.push_back(planeInBatch(plane, worldFromMesh));
    const BoxSide side = intersection_ ? sideOfIntersection(box, planes) : sideOf(box, planes);
    if (side == BoxSide::kept) return mesh;
    const bool stays =
        mesh == from_ && side == side_ && (side == BoxSide::away || planes == madeBy_);
    if (stays) return made_;
    made_ = clippedMesh(*mesh, planes, intersection_, casts_);
    from_ = mesh;
    side_ = side;
    madeBy_ = std::move(planes);
    return made_;
}

} // namespace edgeshade
