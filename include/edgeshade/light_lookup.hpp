#pragma once

#include "edgeshade/matrix.hpp"

#include <limits>
#include <memory>
#include <string>

namespace edgeshade {

/// Shadows of a light at rest without masks: one texture, and a function that your own fragment
/// shader calls with a position. It adds no pass and no stencil, and is correct on see-through
/// surfaces and at each shaded sample.
///
/// 1. ShadowMasks::lookupWork() takes a snapshot of the casters and the light.
/// 2. Do the work: advance() it, or finish() it on any thread.
/// 3. Pass it to ShadowMasks::addLookup(), then uploadLookup(); lookup() gives the result, or the
///    reason why there is none.
/// 4. Put lookupSource("sun") into your shader, set its uniforms, call sun_lit().
/// 5. See ShadowMasks::state() in each frame. While the lookup holds and there are movers, draw()
///    counts them on top: the light reaches a fragment if both sun_lit() and the mask let it. Once
///    the lookup no longer holds, draw masks of all casters, and start again.

/// Casters besides solid ones that a map may hold, and that the shader which samples it must know.
struct LookupCasters {
    bool cutouts = false; ///< meshes cast what their alpha leaves, as MaskAlpha::cutsOut says
    bool tints = false;   ///< meshes tint the light, as ShadowMasks::setTint() says
};

/// Limits of a map, and its casters.
struct LookupSettings {
    /// Texels along the map's edge, or along each of a point light's six faces: a power of 2, >= 4.
    /// This is an upper limit: with few casters the map has fewer.
    int size = 512;
    std::size_t mostBytes = std::size_t{64} << 20; ///< smaller maps are tried before giving up
    /// Casters that have moved or changed are left out of the map until they have rested for so
    /// many milliseconds; 0: all casters are in it.
    double restMs = 500.0;
    /// Points of a light with a radius, as in MaskView, 1..4096. Its map has to hold all casters:
    /// `restMs` is 0 then.
    std::size_t lightSamples = 64;
    /// The shader needs lookupSource() with the same. Otherwise such meshes cast as in masks.
    LookupCasters casters{};
    /// The map holds only what masks can't draw, cutouts and tinted meshes, moving ones too: the
    /// light reaches a fragment if both the map and a mask of all casters let it. Such a map may be
    /// built in each frame.
    bool cutoutsAlone = false;
    /// With more triangles than this there is no map.
    std::size_t mostTriangles = std::numeric_limits<std::size_t>::max();
};

/// The map of one light while it is built. Needs no GL. Copies share the same work. It may be
/// abandoned at any time, and may outlive the masks.
class LookupWork {
  public:
    struct Data;

    explicit LookupWork(std::shared_ptr<Data> data) : data_(std::move(data)) {}

    /// Continues for about `milliseconds`; a single step over a large model may exceed them.
    /// Returns whether the map is done.
    bool advance(double milliseconds);
    /// Builds the whole map, on as many threads as there are cores.
    void finish();

    const std::shared_ptr<Data>& data() const { return data_; }

  private:
    std::shared_ptr<Data> data_;
};

/// A lookup's casters compared with the present ones.
struct LookupState {
    /// The light and all of the lookup's casters are as they were when its work began. Otherwise
    /// its shadows are wrong. A light with a radius may have no movers either, and a sun's
    /// receivers have to stay within reach.
    bool holds = false;
    std::size_t movers = 0; ///< casters that aren't in it
    std::size_t rested = 0; ///< those that have rested for the requested time, or never moved
};

/// A light's uniforms, with the names that lookupSource("PREFIX") gives them.
struct LightLookup {
    std::string why; ///< why there is no lookup, a clause; empty if there is one, once uploaded
    bool uploaded = false;            ///< the whole texture is uploaded
    unsigned texture = 0;             ///< PREFIX_table: GL name of a 2D texture of floats
    std::array<float, 3> tableSize{}; ///< PREFIX_tableSize
    std::array<float, 2> begins{};    ///< PREFIX_begins
    float size = 0.0f;                ///< PREFIX_size
    float kind = 0.0f;                ///< PREFIX_kind
    /// PREFIX_places of a light with a radius: call PREFIX_litShare(). {0, 0}: it has none.
    std::array<float, 2> places{};
    Matrix16 mapFromWorld = identity16;
    std::size_t bytes = 0;       ///< on the GPU
    std::size_t longestList = 0; ///< the most triangles that a fragment may have to test
    double buildMs = 0.0;        ///< milliseconds spent building
};

/// The value of PREFIX_mapFromHost, for positions in a camera's space. It is computed in double
/// precision, so that the world may be large. `viewFromWorld`: affine and invertible.
std::array<float, 16> mapFromView(const LightLookup& lookup, const Matrix16& viewFromWorld);

/// The source to include in any fragment shader of GLSL ES 1.00 or 3.00, the same for all lights:
///
///     bool PREFIX_lit(highp vec3 position, highp vec3 towardsEye, bool casts)
///
/// It returns whether the light reaches the fragment past all casters; cones and ranges are not
/// included. `position`: the fragment's, in the space from which PREFIX_mapFromHost maps.
/// `towardsEye`: direction from there to the eye, of any length; -position in a perspective
/// camera's space. `casts`: every triangle drawn with this shader was added with MaskMesh::casts;
/// where eye and light are on different sides of such triangles they are dark. gl_FrontFacing must
/// be true on the side from which their corners in MaskMesh run counter-clockwise: a host turns
/// glFrontFace() for mirrored meshes, or passes false. The function takes derivatives. In
/// GLSL ES 1.00 enable GL_OES_standard_derivatives and define EDGESHADE_DERIVATIVES before the
/// source, and call it where neighbouring fragments call it too. Without derivatives use
///
///     bool PREFIX_litOn(highp vec3 position, highp vec3 towardsEye, highp vec3 normal,
///                       highp float error, bool casts)
///
/// `normal`: the triangle's own, of any length and to either side. `error`: rounding error of the
/// position in units of 2^-24 of its largest coordinate, beyond the 16 that are always allowed for;
/// 16.0 is enough for most.
///
/// `prefix`: letters, digits and single underscores; with a prefix for each, one shader may query
/// several lights. `casters`: those of the maps; all maps without them fit too. With tints there
/// are also PREFIX_litColor() and PREFIX_litColorOn(), with the same arguments, which return the
/// share of red, green and blue as a vec3. `soft`: there are also PREFIX_litShare() and
/// PREFIX_litShareOn(), for maps of lights with a radius alone, which return the share of the
/// light's points that reach the fragment, 0..1. Throws std::runtime_error.
std::string lookupSource(const std::string& prefix, LookupCasters casters = {}, bool soft = false);

} // namespace edgeshade
