#include "src/shadow/geometry/face_outlines.hpp"

#include "src/shadow/geometry/light_range.hpp"

#include <cmath>

namespace edgeshade {
namespace {

using Rays = std::array<glm::dvec3, 3>;

/// Of a triangle that the face wholly holds.
Outline outlineWithin(const glm::dmat3& face, const Rays& rays) {
    Outline outline;
    for (const glm::dvec3& ray : rays)
        outline.add(ray * face);
    return outline;
}

/// Whether all of a triangle is farther away than the light reaches.
bool isOutOfRange(const Rays& rays, const LightView& from) {
    if (!std::isfinite(from.range)) return false;
    Box box;
    for (const glm::dvec3& ray : rays)
        box.add(ray);
    return isBeyond(box, glm::dvec3(0.0), from.range);
}

} // namespace

std::vector<FaceOutlines> outlinesByFace(const Scene& scene, bool castMasked,
                                         const LightView& from) {
    std::vector<FaceOutlines> result(from.faces.size());
    std::uint32_t triangle = 0;
    const auto add = [&](std::size_t face, const Outline& outline) {
        result[face].outlines.push_back(outline);
        result[face].triangles.push_back(triangle);
    };
    forEachCaster(scene, castMasked, from, [&](const Rays& rays) {
        if (isOutOfRange(rays, from)) {
            ++triangle;
            return;
        }
        const int only = from.directional ? 0 : faceAround(rays);
        if (only >= 0) {
            const auto face = static_cast<std::size_t>(only);
            add(face, outlineWithin(from.faces[face], rays));
        }
        for (std::size_t face = 0; only < 0 && face < from.faces.size(); ++face) {
            const Outline outline = outlineOn(from.faces[face], rays);
            if (!outline.misses(from.wholeFace())) add(face, outline);
        }
        ++triangle;
    });
    return result;
}

} // namespace edgeshade
