#include "src/rivals/planar/planar_shadow_pass.hpp"

#include "shaders_es2.hpp"
#include "src/render/drawing/attributes.hpp"
#include "src/render/drawing/batch_view.hpp"
#include "src/render/drawing/caster_chunk.hpp"
#include "src/shadow/geometry/box_plane.hpp"

#include <algorithm>
#include <limits>

namespace edgeshade {
namespace {

constexpr GLuint allBits = 0xFF, shadowBit = 0x01;
constexpr std::size_t planesAtOnce = 7; ///< number of planes that the stencil's other bits
                                        ///< distinguish

/// Least height above a plane, in tolerances of it, at which casters cast: triangles in the plane
/// do not.
constexpr double leastHeight = 2.0;
/// Greatest height of casters above a plane, as a share of the light's: higher ones project too far
/// out.
constexpr double mostHeight = 1.0 - 1e-6;

/// The plane with the light, or its direction, on its positive side; w is the plane's height.
glm::dvec4 towardsLight(const ShadowPlane& plane, const Light& light) {
    return glm::dot(plane.plane, light.position) < 0.0 ? -plane.plane : plane.plane;
}

/// Whether light grazes the plane, or shines from within it: the whole plane is dark.
bool isGrazed(const ShadowPlane& plane, const Light& light) {
    const glm::dvec4& of = light.position;
    const double height = std::abs(glm::dot(plane.plane, of));
    return of.w == 0.0 ? height <= 1e-9 * glm::length(glm::dvec3(of))
                       : height <= leastHeight * plane.tolerance * of.w;
}

bool isOutOfView(const ShadowPlane& plane, const ViewPlanes& planes) {
    return std::ranges::any_of(planes,
                               [&](const glm::dvec4& of) { return isOutside(plane.bounds, of); });
}

glm::dvec4 inObject(const glm::dvec4& plane, const glm::dmat4& worldFromObject) {
    return glm::transpose(worldFromObject) * plane;
}

} // namespace

PlanarShadowPass::PlanarShadowPass()
    : receivers_(shaders::surface_vert, shaders::fill_frag, {}, {"a_position"}) {}

const gl::Program& PlanarShadowPass::program(const Variant& variant) {
    const gl::Program& program = programs_.get(variant, [&] {
        return gl::Program(
            shaders::projected_caster_vert, shaders::projected_frag,
            gl::definesOf({{"CLIPPED", variant.clipped}, {"ALPHA_TEST", variant.alphaTest}}),
            casterAttributes);
    });
    program.use();
    return program;
}

std::size_t PlanarShadowPass::mark(const Target& target, const ShadowPlanes& planes) {
    vertexRuns_ = 0;
    const ViewPlanes ofView = viewPlanes(target.view, target.slice, glm::dmat4(1.0));
    std::vector<const ShadowPlane*> seen;
    for (const ShadowPlane& plane : planes.all())
        if (!isOutOfView(plane, ofView)) seen.push_back(&plane);
    for (std::size_t first = 0; first < seen.size(); first += planesAtOnce) {
        const std::size_t count = std::min(planesAtOnce, seen.size() - first);
        const auto bitOf = [](std::size_t i) { return shadowBit << (i + 1); };
        glDepthFunc(GL_EQUAL);
        for (std::size_t i = 0; i < count; ++i)
            markReceivers(target, *seen[first + i], bitOf(i));
        glDisable(GL_DEPTH_TEST);
        for (std::size_t i = 0; i < count; ++i)
            if (!isGrazed(*seen[first + i], target.light))
                projectCasters(target, *seen[first + i], bitOf(i));
        glEnable(GL_DEPTH_TEST);
        glStencilMask(allBits & ~shadowBit);
        glClearStencil(0);
        glClear(GL_STENCIL_BUFFER_BIT);
    }
    glDepthFunc(GL_LESS);
    glStencilMask(allBits);
    return vertexRuns_;
}

/// Sets the plane's bit where its surfaces are visible. Sets the shadow bit instead where they face
/// away from the light and cast, or where light grazes them.
void PlanarShadowPass::markReceivers(const Target& target, const ShadowPlane& plane,
                                     unsigned planeBit) {
    const bool away = isGrazed(plane, target.light) ||
                      glm::dot(towardsLight(plane, target.light), target.view.frustum.eye()) < 0.0;
    receivers_.use();
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    for (const PlaneReceivers& of : plane.receivers) {
        const GpuBatch& batch = target.scene.batches[of.batch];
        if (batch.hidden || (batch.ground && !target.view.ground)) continue;
        const SurfaceChunk& chunk = (*batch.surfaces)[of.chunk];
        const bool casts = target.scene.castsInMaps(target.scene.materials[chunk.material]);
        const GLuint bit = away && casts ? shadowBit : planeBit;
        glStencilMask(bit);
        glStencilFunc(GL_ALWAYS, static_cast<GLint>(bit), allBits);
        receivers_.set("u_clipFromObject",
                       batchViewOf(batch, target.view, target.slice).clipFromObject);
        AttributeBinding binding(nullptr);
        binding.add(chunk.vertices, 3, GL_FLOAT, false, sizeof(SurfaceVertex),
                    offsetof(SurfaceVertex, position), false);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, of.indices.name());
        glDrawElements(GL_TRIANGLES, of.indexCount, GL_UNSIGNED_SHORT, nullptr);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
        vertexRuns_ += static_cast<std::size_t>(of.indexCount);
    }
}

/// Sets the shadow bit where the plane's bit is set and a caster is between the plane and the
/// light.
void PlanarShadowPass::projectCasters(const Target& target, const ShadowPlane& plane,
                                      unsigned planeBit) {
    glStencilMask(shadowBit);
    glStencilFunc(GL_EQUAL, static_cast<GLint>(planeBit | shadowBit), planeBit);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    for (const GpuBatch& batch : target.scene.batches) {
        if (batch.hidden) continue;
        const glm::mat4 clipFromObject =
            batchViewOf(batch, target.view, target.slice).clipFromObject;
        for (const SurfaceChunk& chunk : *batch.surfaces)
            if (target.scene.castsInMaps(target.scene.materials[chunk.material]))
                projectChunk(target, plane, chunk, batch.worldFromBatch, clipFromObject);
    }
}

void PlanarShadowPass::projectChunk(const Target& target, const ShadowPlane& plane,
                                    const SurfaceChunk& chunk, const glm::dmat4& worldFromBatch,
                                    const glm::mat4& clipFromObject) {
    const glm::dvec4 up = inObject(towardsLight(plane, target.light), worldFromBatch);
    const glm::dvec4& light = target.light.position;
    const double least = leastHeight * plane.tolerance;
    const double most = light.w == 0.0
                            ? std::numeric_limits<float>::max()
                            : mostHeight * std::abs(glm::dot(plane.plane, light)) / light.w;
    const double rounding = roundingOf(chunk.bounds, up);
    const double highest = largestOver(chunk.bounds, up), lowest = -largestOver(chunk.bounds, -up);
    if (highest + rounding <= least || lowest - rounding >= most) return;
    const bool clipped = lowest - rounding <= least || highest + rounding >= most;
    const bool alphaTest = target.scene.materials[chunk.material].alphaMode == AlphaMode::mask;
    const gl::Program& used = program({clipped, alphaTest});
    used.set("u_clipFromObject", clipFromObject);
    used.set("u_plane", glm::vec4(up));
    used.set("u_light", lightInObject(target.light, worldFromBatch));
    used.set("u_heights", glm::vec2(least, most));
    vertexRuns_ += drawCasterChunk(target.scene, chunk, used);
}

} // namespace edgeshade
