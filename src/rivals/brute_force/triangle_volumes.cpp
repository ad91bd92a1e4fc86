#include "src/rivals/brute_force/triangle_volumes.hpp"

#include "shaders_es2.hpp"
#include "shaders_es2/record_layout.glsl"
#include "src/render/drawing/cap_alpha_test.hpp"
#include "src/rivals/brute_force/triangle_draws.hpp"
#include "src/rivals/published/cap_records.hpp"
#include "src/rivals/published/corner_records.hpp"

#include <glm/gtc/matrix_access.hpp>
#include <limits>

namespace edgeshade {
namespace {

/// Sine of the angle between light and near plane below which ZP+ is not used.
constexpr double leastSlope = 1e-3;

using Shape = VolumeDraw::Shape;

/// The near plane in the batch's space, as that matrix clips; positive beyond it.
glm::vec4 nearPlaneOf(const glm::mat4& clipFromObject) {
    return glm::row(clipFromObject, 2) + glm::row(clipFromObject, 3);
}

/// Whether the light is clearly on one side of the slice's near plane, seen from the near
/// rectangle.
bool isClearOfNearPlane(const CasterGroupInSlice& casters) {
    const Frustum& frustum = casters.view.frustum;
    const glm::dvec4& light = casters.source().light.position;
    const glm::dvec3 forward = frustum.forward();
    const glm::dvec3 middle = frustum.position() + casters.slice.near * forward;
    const glm::dvec3 towards = glm::dvec3(light) - middle * light.w;
    return std::abs(glm::dot(towards, forward)) > leastSlope * glm::length(towards);
}

} // namespace

TriangleVolumes::TriangleVolumes(BruteForceCount count, SidesLayout layout,
                                 std::optional<gl::Instancing> instancing,
                                 std::optional<VolumeTints> tints)
    : count_(count), copied_(layout == SidesLayout::notInstanced), instancing_(instancing),
      tints_(tints) {
    std::vector<glm::vec2> corners;
    for (int vertex = 0; vertex < VERTICES_PER_TRIANGLE_VOLUME; ++vertex)
        corners.emplace_back(static_cast<float>(vertex), 0.0f);
    corners_ = gl::vertexBuffer<glm::vec2>(corners);
}

void TriangleVolumes::plan(const GpuScene& scene, const CasterGroupInSlice& casters,
                           CountPlan& plan) {
    TriangleCount count{.zFail = count_ == BruteForceCount::zFail || !isClearOfNearPlane(casters),
                        .directional = casters.source().light.position.w == 0.0};
    planCornerRecords(scene, casters, layout(), plan,
                      [&](const ShadowBuffers& records, std::size_t batch, std::size_t index,
                          std::vector<VolumeDraw>& draws) {
                          count.nearDiscard = casters.view.mayMeetNear(batch, casters.slice);
                          appendTriangleDraws(records.groups, index, count, scene.materials, draws);
                      });
}

TriangleVolumes::Variant TriangleVolumes::variantOf(const VolumeDraw& draw, const BatchPlan& plan) {
    return {draw.shape == Shape::nearCaps, draw.nearDiscard, draw.alphaTested.has_value(),
            isInContact(plan)};
}

TriangleVolumes::Vertices TriangleVolumes::verticesOf(const VolumeDraw& draw,
                                                      const DrawnBatch& batch) {
    const bool negative = draw.shape == Shape::negativeSides;
    if (!negative && draw.shape != Shape::triangleVolumes) return {0, verticesPerCap};
    const bool directional = batch.plan.light.w == 0.0f, sidesAlone = negative || !draw.zFail;
    const int end = directional  ? SECOND_SIDE_VERTEX
                    : sidesAlone ? BACK_CAP_VERTEX
                                 : VERTICES_PER_TRIANGLE_VOLUME;
    const int first = sidesAlone ? FIRST_SIDE_VERTEX : 0;
    return {first, end - first};
}

gl::Program TriangleVolumes::makeProgram(const Variant& variant) const {
    std::vector<std::string> defines;
    std::vector<std::string> attributes = {"a_capA", "a_capB", "a_capC"};
    if (!copied_) {
        defines.push_back("INSTANCED");
        attributes.insert(attributes.begin(), "a_corner");
    }
    if (variant.nearDiscard) defines.push_back("NEAR_DISCARD");
    if (variant.contact) defines.push_back("CONTACT");
    if (variant.alphaTest) {
        defines.push_back("ALPHA_TEST");
        attributes.insert(attributes.end(), {"a_alphaCornerA", "a_alphaCornerB", "a_alphaCornerC"});
    }
    for (std::string& define : tintDefines(tints_))
        defines.push_back(std::move(define));
    if (!variant.nearCaps)
        return {shaders::triangle_volume_vert, shaders::caps_frag, defines, attributes};
    defines.push_back("CLIPPED");
    return {shaders::near_cap_vert, shaders::projected_frag, defines, attributes};
}

void TriangleVolumes::prepare(const CountPlan& plan, GpuScene&, const CasterGroupInSlice&) {
    for (const VolumeDraw& draw : plan.draws.once) {
        const Variant variant = variantOf(draw, plan.batches[draw.batch]);
        programs_.get(variant, [&] { return makeProgram(variant); });
    }
}

void TriangleVolumes::draw(const VolumeDraw& draw, const DrawnBatch& batch) const {
    const gl::Program& program = programs_.use(variantOf(draw, batch.plan));
    const ShadowBuffers& triangles = cornerRecordsOf(batch.volumes, layout());
    const glm::vec4& light = batch.plan.light;
    setVolume(program, draw, batch, tints_);
    if (draw.shape == Shape::nearCaps) {
        const glm::vec4 near = nearPlaneOf(batch.clipFromObject);
        const float height = glm::dot(near, light);
        const float side = height < 0.0f ? -1.0f : 1.0f;
        program.set("u_plane", side * near);
        program.set("u_heights", glm::vec2(0.0f, light.w == 0.0f ? std::numeric_limits<float>::max()
                                                                 : std::abs(height) / light.w));
    }
    const bool negative = draw.shape == Shape::negativeSides;
    if (draw.shape != Shape::nearCaps) program.set("u_multiplicity", negative ? -1.0f : 1.0f);
    const Vertices all = verticesOf(draw, batch);
    if (!draw.alphaTested) {
        drawRecords(program, triangles, draw.range, all, false);
        return;
    }
    setCapAlphaTest(program, *batch.scene, batch.plan.batch, *draw.alphaTested);
    if (!draw.cutoutsAlone) {
        program.set("u_frontCapAtInfinity", 1.0f);
        drawRecords(program, triangles, draw.range, all, true);
    }
    if (negative) return;
    program.set("u_frontCapAtInfinity", 0.0f);
    drawRecords(program, triangles, draw.range, {0, verticesPerCap}, true);
}

void TriangleVolumes::drawRecords(const gl::Program& program, const ShadowBuffers& triangles,
                                  const RecordRange& range, const Vertices& vertices,
                                  bool alphaTested) const {
    if (copied_)
        program.set("u_vertices", glm::vec2(vertices.first, vertices.first + vertices.count));
    drawCapRecords(triangles, range,
                   {copied_ ? nullptr : &*instancing_, corners_, VERTICES_PER_TRIANGLE_VOLUME,
                    vertices.first, vertices.count},
                   alphaTested);
}

} // namespace edgeshade
