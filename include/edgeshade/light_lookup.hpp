#pragma once

#include "edgeshade/matrix.hpp"

#include <memory>
#include <string>

namespace edgeshade {

/// Shadows of a light at rest without masks: one texture, and a function that your own fragment
/// shader asks with a position. No pass of its own, no stencil, right on see-through surfaces and
/// at each shaded sample.
///
/// 1. ShadowMasks::lookupWork() takes down the casters and the light as they are.
/// 2. Do the work: advance() it, or finish() it on any thread.
/// 3. ShadowMasks::addLookup() and uploadLookup() it; lookup() says what there is, or why nothing.
/// 4. Put lookupSource("sun") into your shader, set its uniforms, ask sun_lit().
/// 5. When ShadowMasks::isCurrent() no longer holds draw masks, and begin again once all rests.

/// What a map may take.
struct LookupSettings {
    /// Texels along its edge, of a point light's six sides each: a power of 2, >= 4. At most: where
    /// casters are few it has fewer.
    int size = 512;
    std::size_t mostBytes = std::size_t{64} << 20; ///< smaller maps are tried first
};

/// The map of one light, being built: without a GL. Copies are the same work. May be given up at
/// any time, and outlive the masks.
class LookupWork {
  public:
    struct Data;

    explicit LookupWork(std::shared_ptr<Data> data) : data_(std::move(data)) {}

    /// Goes on for about so long, a single step over a large model more. Returns whether all is
    /// done.
    bool advance(double milliseconds);
    /// Does all of it, on as many threads as there are cores.
    void finish();

    const std::shared_ptr<Data>& data() const { return data_; }

  private:
    std::shared_ptr<Data> data_;
};

/// What a shader needs of a light, by the names of lookupSource("PREFIX").
struct LightLookup {
    std::string why;       ///< there is none, a clause; empty: there is one, once uploaded
    bool uploaded = false; ///< all of it is there
    unsigned texture = 0;  ///< PREFIX_table: GL name of a 2D texture of floats
    std::array<float, 3> tableSize{}; ///< PREFIX_tableSize
    std::array<float, 2> begins{};    ///< PREFIX_begins
    float size = 0.0f;                ///< PREFIX_size
    float kind = 0.0f;                ///< PREFIX_kind
    Matrix16 mapFromWorld = identity16;
    std::size_t bytes = 0;       ///< on the GPU
    std::size_t longestList = 0; ///< triangles that a fragment may have to ask
    double buildMs = 0.0;        ///< worked
};

/// PREFIX_mapFromHost: for positions in the space of a camera, in double until here, so that a
/// world may be large. `viewFromWorld`: affine and invertible.
std::array<float, 16> mapFromView(const LightLookup& lookup, const Matrix16& viewFromWorld);

/// For any fragment shader, of GLSL ES 1.00 or 3.00, of any light:
///
///     bool PREFIX_lit(highp vec3 position, highp vec3 towardsEye, bool casts)
///
/// whether shadow lets the light through, which says nothing of cones and ranges. `position`: the
/// fragment's, in the space of PREFIX_mapFromHost; `towardsEye`: from there, of any length:
/// -position in a perspective camera's space. `casts`: all that is drawn there was added with
/// MaskMesh::casts: what such triangles turn away from the light is dark. It takes derivatives: in
/// GLSL ES 1.00 enable GL_OES_standard_derivatives and define EDGESHADE_DERIVATIVES before it, and
/// call it where neighbours do. Without derivatives there is
///
///     bool PREFIX_litOn(highp vec3 position, highp vec3 towardsEye, highp vec3 normal,
///                       highp float error, bool casts)
///
/// with the triangle's own normal, of any length and either side, and how far off rounding may have
/// put the position beyond its coordinates' 16 last places; 16.0 does for most.
///
/// `prefix`: letters, digits and single underscores, so that a shader may ask several lights.
/// Throws std::runtime_error.
std::string lookupSource(const std::string& prefix);

} // namespace edgeshade
