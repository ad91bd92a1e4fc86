#include "src/render/volumes/grazed_surfaces.hpp"

#include "shaders_es2.hpp"
#include "src/render/drawing/attributes.hpp"
#include "src/render/drawing/batch_view.hpp"
#include "src/shadow/geometry/box_plane.hpp"
#include "src/shadow/lights/light_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <GLES2/gl2.h>

namespace edgeshade {
namespace {

/// Cosine of an angle below one degree, up to which normals count as parallel.
constexpr float parallel = 0.9999f;

/// Rounding of a light's distance from a plane in floats, as a share of the coordinates.
constexpr float planeRounding = 0x1p-20f;

std::array<glm::vec3, 3> cornersOf(const Geometry& geometry, std::size_t triangle) {
    const auto corner = [&](std::size_t c) {
        return geometry.positions[geometry.indices[3 * triangle + c]];
    };
    return {corner(0), corner(1), corner(2)};
}

/// Whether the triangle has an area in doubles. Others have no contact (contactOf()).
bool hasArea(const std::array<glm::vec3, 3>& corners) {
    const glm::dvec3 a(corners[0]), b(corners[1]), c(corners[2]);
    return glm::length(glm::cross(b - a, c - a)) > 0.0;
}

} // namespace

const GrazedSurfaces::Triangles& GrazedSurfaces::trianglesOf(const GpuBatch& batch) {
    const Geometry& geometry = *batch.geometry;
    auto [found, isNew] = triangles_.try_emplace(&geometry);
    Triangles& triangles = found->second;
    triangles.used = true;
    if (!isNew) return triangles;
    triangles.geometry = batch.geometry;
    std::vector<std::uint32_t> flat;
    std::vector<glm::vec4> planes; // by triangle
    for (std::uint32_t t = 0; t < geometry.indices.size() / 3; ++t) {
        const auto corners = cornersOf(geometry, t);
        const glm::vec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const float size = glm::length(across);
        const glm::vec3 normal = size > 0.0f ? across / size : glm::vec3(0.0f);
        planes.emplace_back(normal, -glm::dot(normal, corners[0]));
        bool smooth = false;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t vertex = geometry.indices[3 * t + c];
            smooth = smooth || (!geometry.normals.empty() &&
                                glm::dot(normal, geometry.normals[vertex]) < parallel);
            triangles.box.add(corners[c]);
            triangles.farthest = std::max(triangles.farthest, glm::length(corners[c]));
        }
        if (hasArea(corners)) (smooth ? triangles.order : flat).push_back(t);
    }
    triangles.smooth = triangles.order.size();
    triangles.order.insert(triangles.order.end(), flat.begin(), flat.end());
    for (const std::uint32_t t : triangles.order)
        triangles.planes.add(planes[t]);
    return triangles;
}

void GrazedSurfaces::find(const Triangles& triangles, Grazed& grazed) {
    const glm::vec4 light(grazed.light);
    const glm::vec3 place(light);
    const float reach =
        light.w == 0.0f ? glm::length(place) : glm::length(place) + triangles.farthest;
    const float most =
        reach * (static_cast<float>(LightContact::grazingSine) * 1.01f + planeRounding);
    corners_.clear();
    const std::size_t end = grazed.smoothAlone ? triangles.smooth : triangles.order.size();
    triangles.planes.forNear(light, most, end, [&](std::size_t i) {
        const auto at = cornersOf(*triangles.geometry, triangles.order[i]);
        if (contactOf({at[0], at[1], at[2]}, grazed.light).grazes)
            corners_.insert(corners_.end(), at.begin(), at.end());
    });
    grazed.count = static_cast<int>(corners_.size());
    if (grazed.count > 0) grazed.corners = gl::vertexBuffer<glm::vec3>(corners_);
}

void GrazedSurfaces::beginProgram() {
    if (program_) return;
    program_.emplace(shaders::surface_vert, shaders::fill_frag, std::vector<std::string>{},
                     std::vector<std::string>{"a_position"});
}

void GrazedSurfaces::mark(const GpuScene& scene, const FrameView& view, const DepthSlice& slice,
                          std::size_t index) {
    for (auto& [geometry, triangles] : triangles_)
        triangles.used = false;
    bool any = false;
    for (std::size_t b = 0; b < scene.batches.size(); ++b) {
        const GpuBatch& batch = scene.batches[b];
        if (batch.hidden || (batch.ground && !view.ground)) continue;
        if (view.lights[index].animatedAlone && !batch.animated) continue;
        const Triangles& triangles = trianglesOf(batch);
        if (areApart(view.visible, triangles.box, batch.worldFromBatch)) continue;
        const glm::dvec4 light = placeInObject(view.lights[index].light, batch.worldFromBatch);
        Grazed& grazed = grazed_[{view.numberOf(index), b}];
        const Geometry* geometry = &*batch.geometry;
        if (grazed.geometry != geometry || grazed.light != light ||
            grazed.smoothAlone == view.mask) {
            grazed.geometry = geometry;
            grazed.light = light;
            grazed.smoothAlone = !view.mask;
            find(triangles, grazed);
        }
        if (grazed.count == 0) continue;
        if (!any) {
            any = true;
            beginProgram();
            program_->use();
            glDepthFunc(GL_EQUAL);
            glStencilFunc(GL_ALWAYS, 1, 0xFF);
            glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        }
        program_->set("u_clipFromObject", batchViewOf(batch, view, slice).clipFromObject);
        AttributeBinding binding(nullptr);
        binding.add(grazed.corners, 3, GL_FLOAT, false, sizeof(glm::vec3), 0, false);
        glDrawArrays(GL_TRIANGLES, 0, grazed.count);
    }
    if (any) glDepthFunc(GL_LESS);
    std::erase_if(triangles_, [](const auto& entry) { return !entry.second.used; });
}

} // namespace edgeshade
