#pragma once

#include "src/gl/program.hpp"
#include "src/scene/gpu_scene.hpp"
#include "src/shadow/geometry/plane_columns.hpp"
#include "src/shadow/lights/light.hpp"
#include "src/shadow/view/frame_view.hpp"

#include <map>
#include <optional>

namespace edgeshade {

/// Marks surfaces that a light grazes, and so does not light, in the stencil in which its volumes
/// were counted. Volumes decide by a sign on which side of a surface the light is, and that sign
/// means nothing there (docs/method.md, C47).
class GrazedSurfaces {
  public:
    /// Sets the stencil to 1 where such a surface is visible, and leaves it unchanged elsewhere.
    /// Colour and depth masks, viewport and scissor are the caller's state; leaves depth function
    /// LESS and the stencil test on. `index`: the light's index in the view. Unless a mask is
    /// drawn, surfaces whose normals are their triangles' own are skipped: Lambert's law leaves no
    /// light there.
    void mark(const GpuScene& scene, const FrameView& view, const DepthSlice& slice,
              std::size_t index);

    /// Begins to make its program, which mark() makes otherwise.
    void beginProgram();
    void forEachProgram(const gl::ProgramVisitor& visit) const {
        if (program_) visit(*program_);
    }

  private:
    /// A geometry's triangles.
    struct Triangles {
        CopyOnWrite<Geometry> geometry; ///< shared, so that nobody edits it in place
        /// Indices of triangles with an area: first those of which some vertex has another normal.
        std::vector<std::uint32_t> order;
        std::size_t smooth = 0; ///< number of these
        PlaneColumns planes;    ///< in that order; 0 if the area is 0 in floats
        Box box;                ///< around all positions
        float farthest = 0.0f;  ///< greatest distance of a position from the origin
        bool used = true;
    };
    /// The grazed triangles of a batch for one light.
    struct Grazed {
        const Geometry* geometry = nullptr;
        glm::dvec4 light{0.0};
        bool smoothAlone = false;
        gl::Buffer corners; ///< positions, three per triangle
        int count = 0;      ///< number of corners
    };

    const Triangles& trianglesOf(const GpuBatch& batch);
    void find(const Triangles& triangles, Grazed& grazed);

    std::optional<gl::Program> program_;
    std::map<const Geometry*, Triangles> triangles_;
    std::map<std::pair<std::size_t, std::size_t>, Grazed> grazed_; ///< by light and batch
    std::vector<glm::vec3> corners_;                               ///< scratch space for find()
};

} // namespace edgeshade
