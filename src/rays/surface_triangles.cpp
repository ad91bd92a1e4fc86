#include "src/rays/surface_triangles.hpp"

#include "preprocess/section/solid_triangles.hpp"
#include "src/rays/section_clip.hpp"
#include "src/shadow/view/visible_depth.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace edgeshade::rays {

namespace {

/// Whether the eye, homogeneous and relative to the frustum's position, is behind the triangle.
bool isSeenFromBehind(const SurfaceTriangle& triangle, const glm::dvec4& eye, bool mirrored) {
    const double side = glm::dot(normalOf(triangle), glm::dvec3(eye) - triangle.a * eye.w);
    return (mirrored ? -side : side) < 0.0;
}

/// Collects a scene's triangles.
class Collector {
  public:
    /// `eye`: homogeneous, relative to `position`; null: triangles are seen from both sides.
    Collector(const Scene& scene, const glm::dvec3& position, const std::optional<glm::dvec4>& eye,
              bool castMasked, bool cutoutsCast)
        : scene_(scene), position_(position), eye_(eye), castMasked_(castMasked),
          cutoutsCast_(cutoutsCast) {
        triangles.reserve(scene.triangleCount());
    }

    /// Adds a group of a batch. `geometry`: the batch's, or the one before a section. `clip`: null:
    /// none. `solid`: by triangle.
    void add(std::uint32_t batch, const Geometry& geometry, const SurfaceGroup& group,
             const SectionClip* clip = nullptr, const std::vector<std::uint8_t>& solid = {}) {
        const Batch& of = scene_.batches[batch];
        const glm::dmat4 eyeFromBatch =
            glm::translate(glm::dmat4(1.0), -position_) * of.worldFromBatch;
        const auto corner = [&](std::uint32_t index) {
            const glm::vec3& at = geometry.positions[geometry.indices[index]];
            return glm::dvec3(eyeFromBatch * glm::dvec4(at, 1.0));
        };
        const Material& material = scene_.materials[group.material];
        SurfaceTriangle triangle;
        triangle.batch = batch;
        triangle.material = static_cast<std::uint32_t>(group.material);
        triangle.geometry = &geometry;
        triangle.casts =
            material.casts(castMasked_) || (cutoutsCast_ && material.alphaMode == AlphaMode::mask);
        const std::uint32_t end = group.firstIndex + group.indexCount;
        for (std::uint32_t i = group.firstIndex; i < end; i += 3) {
            triangle.a = corner(i);
            triangle.b = corner(i + 1);
            triangle.c = corner(i + 2);
            triangle.firstIndex = i;
            triangle.visible = material.alphaMode != AlphaMode::blend &&
                               !(eye_ && scene_.culls && !material.doubleSided &&
                                 isSeenFromBehind(triangle, *eye_, of.isMirrored()));
            if (clip)
                clip->add(triangle, solid[i / 3] != 0, triangles);
            else
                triangles.push_back(triangle);
        }
    }

    /// Adds the groups of a batch, and the fill of its cuts.
    void add(std::uint32_t batch) {
        const Batch& of = scene_.batches[batch];
        if (!scene_.cutFrom || of.ground || of.hidden) {
            for (const SurfaceGroup& group : of.geometry->groups)
                add(batch, *of.geometry, group);
            return;
        }
        const Scene& whole = scene_.whole();
        const Geometry& before = *whole.batches[batch].geometry;
        const SectionClip clip(scene_.cutFrom->section, of.worldFromBatch);
        std::optional<MeshTopology> topology;
        const std::vector<std::uint8_t> solid = solidTriangles(before, whole.materials, topology);
        for (const SurfaceGroup& group : before.groups)
            add(batch, before, group, &clip, solid);
        for (const SurfaceGroup& group : of.geometry->groups)
            if (group.material >= whole.materials.size() &&
                scene_.materials[group.material].isSeen())
                add(batch, *of.geometry, group);
    }

    std::vector<SurfaceTriangle> triangles;

  private:
    const Scene& scene_;
    glm::dvec3 position_;
    std::optional<glm::dvec4> eye_;
    bool castMasked_, cutoutsCast_;
};

} // namespace

std::vector<SurfaceTriangle> surfaceTriangles(const Scene& scene, const Frustum& frustum,
                                              bool castMasked, bool cutoutsCast) {
    const glm::dvec3 position = frustum.position();
    const glm::dvec4 eye = frustum.eye();
    Collector collector(scene, position, glm::dvec4(glm::dvec3(eye) - position * eye.w, eye.w),
                        castMasked, cutoutsCast);
    for (std::uint32_t b = 0; b < scene.batches.size(); ++b)
        if (!scene.batches[b].ground || isAboveGround(frustum, scene.batches[b])) collector.add(b);
    return std::move(collector.triangles);
}

std::vector<SurfaceTriangle> surfaceTriangles(const Scene& scene, const glm::dvec3& origin,
                                              bool castMasked, bool cutoutsCast) {
    Collector collector(scene, origin, std::nullopt, castMasked, cutoutsCast);
    for (std::uint32_t b = 0; b < scene.batches.size(); ++b)
        collector.add(b);
    return std::move(collector.triangles);
}

} // namespace edgeshade::rays
