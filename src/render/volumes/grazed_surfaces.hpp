#pragma once

#include "src/gl/program.hpp"
#include "src/scene/gpu_scene.hpp"
#include "src/shadow/lights/light.hpp"
#include "src/shadow/view/frame_view.hpp"

#include <map>
#include <optional>

namespace edgeshade {

/// Marks surfaces that a light grazes, which it doesn't light, in the stencil that its volumes were
/// counted in: volumes say on which side of a surface the light is by a sign that means nothing
/// there (docs/method.md, C47).
class GrazedSurfaces {
  public:
    /// Where such a surface is seen the stencil is 1 afterwards, elsewhere as before. Colour and
    /// depth masks, viewport and scissor are the caller's state; leaves depth function LESS, the
    /// stencil's test on. `index`: the light's in the view. Where no mask is drawn, surfaces whose
    /// normals are their triangles' own are left as they are: Lambert's law leaves nothing of the
    /// light there.
    void mark(const GpuScene& scene, const FrameView& view, const DepthSlice& slice,
              std::size_t index);

  private:
    /// Of a geometry, by triangle.
    struct Triangles {
        CopyOnWrite<Geometry> geometry;   ///< it is shared, so that nobody edits it in place
        std::vector<glm::vec4> planes;    ///< unit normal and offset; 0 for triangles without area
        std::vector<std::uint8_t> smooth; ///< 1: some vertex has another normal
        float farthest = 0.0f;            ///< position, from the origin
        bool used = true;
    };
    /// Of a batch and a light.
    struct Grazed {
        const Geometry* geometry = nullptr;
        glm::dvec4 light{0.0};
        bool smoothAlone = false;
        gl::Buffer corners; ///< positions, three a triangle
        int count = 0;      ///< corners
    };

    const Triangles& trianglesOf(const GpuBatch& batch);
    void find(const Triangles& triangles, Grazed& grazed);

    std::optional<gl::Program> program_;
    std::map<const Geometry*, Triangles> triangles_;
    std::map<std::pair<std::size_t, std::size_t>, Grazed> grazed_; ///< by light and batch
};

} // namespace edgeshade
