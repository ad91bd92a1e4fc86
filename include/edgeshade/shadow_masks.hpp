#pragma once

#include "edgeshade/light_lookup.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <utility>

namespace edgeshade {

/// Exact shadows for renderers of others: what is lit in a picture, as textures.
///
/// 1. With an OpenGL ES 2 or 3 context current, make a ShadowMasks.
/// 2. add() what casts or receives shadow; move(), change() and remove() it as it does.
/// 3. Each frame draw() with your camera's matrices, and then your own picture, of the same size:
///    what reaches a fragment of light i is channel i % 4 of textures()[i / 4] at
///    gl_FragCoord.xy / size.
///
/// It draws depth itself. Surfaces that are alpha-tested (MaskMesh::alphaTested) receive shadow
/// where they are, and what is seen through their holes has its own; they cast whole triangles, or
/// nothing. See-through surfaces are no part of masks, which have one surface a pixel: leave them
/// out. All calls need the context; textures and buffers are made in it. All throw
/// std::runtime_error with a full sentence; nothing has changed then.

/// Triangles that move together. Nothing is kept of the spans.
struct MaskMesh {
    std::span<const float> positions;       ///< x, y, z a vertex; finite
    std::span<const std::uint32_t> indices; ///< three a triangle
    bool casts = true;       ///< else it only receives, and is lit from behind as well
    bool doubleSided = true; ///< else it is seen from its front alone, where it is wound
                             ///< counter-clockwise; it casts from either side
    bool bends = false;      ///< another shape comes soon: nothing that takes long is worked out
    /// Where its alpha (setAlpha()) is below the cutoff it isn't there: it isn't seen, nor does it
    /// receive. If it `casts`, then whole triangles, as if it had no holes: shadow volumes can't
    /// follow them.
    bool alphaTested = false;
    std::span<const float> texcoords =
        {}; ///< u, v a vertex, or empty: 0, 0; of what is alpha-tested
};

/// What an alpha-tested mesh has of alpha: `opacity` times the texture's.
struct MaskAlpha {
    enum class Channel { alpha, green };
    /// GL name of a 2D texture of the host's, which is sampled as it is and never changed; the host
    /// keeps it for as long as it is set. 0: none, alpha is `opacity` everywhere.
    unsigned texture = 0;
    Channel channel = Channel::alpha; ///< of the texture
    float opacity = 1.0f;
    float cutoff = 0.5f; ///< alpha below it is a hole
    /// Column-major; (u, v, 1) times it is where the texture is looked up.
    std::array<float, 9> texcoordTransform = {1, 0, 0, 0, 1, 0, 0, 0, 1};
};

/// A mesh whose edges are found, which takes time linear in its triangles: on any thread, and
/// without a GL. Copies are the same mesh, which masks keep once wherever they have it.
class PreparedMesh {
  public:
    struct Data;

    /// Throws std::runtime_error.
    explicit PreparedMesh(const MaskMesh& mesh);
    explicit PreparedMesh(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

    const std::shared_ptr<const Data>& data() const { return data_; }

  private:
    std::shared_ptr<const Data> data_;
};

/// A light in the world.
struct MaskLight {
    enum class Kind { directional, point, spot };
    Kind kind = Kind::directional;
    std::array<double, 3> position{};                ///< of a point or spot
    std::array<double, 3> direction{0.0, -1.0, 0.0}; ///< where a sun or spot shines; any length
    double range =
        std::numeric_limits<double>::infinity(); ///< > 0: dark from there on; not a sun's
    double outerAngle = 0.7853981633974483; ///< of a spot, radians, 0..pi/2: dark from there on
    /// Of its extent: of a point or spot the sphere's, scene units; of a sun its disc's, radians,
    /// to pi/4; 0: its shadows are hard. Each of a spot's points shines in a cone like the
    /// middle's.
    double radius = 0.0;
};

/// What is seen. The projection: perspective, off-axis too, or orthographic; its depths are not
/// used. The view: a turn, a shift and one scale.
struct MaskView {
    Matrix16 viewFromWorld = identity16;
    Matrix16 clipFromView = identity16;
    int width = 1; ///< pixels
    int height = 1;
    std::size_t lightSamples = 64; ///< points of each light that has an extent, 1..4096
    bool nearness = false;         ///< nearness() is drawn too: once more all surfaces
};

/// Which surface a pixel of the masks is of, for hosts whose outlines are others than the masks',
/// as with multisampling: a fragment takes the mask's texel, of those around it, whose nearness is
/// closest to its own. Along a plane nearness changes linearly over the picture.
struct MaskNearness {
    unsigned texture = 0; ///< GL name, RGBA: 24 bits in red, green and blue, red the highest, as a
                          ///< share of 2^24 - 1; 0: no surface, or none was asked for
    double scale = 0.0;   ///< nearness is scale / depth + offset of a perspective, else
    double offset = 0.0;  ///< scale * depth + offset; depth along the viewing direction, in the
                          ///< world's units
};

/// Who keeps the state of the host's GL over a call.
enum class StateKeeper {
    engine, ///< all that it touches is as before
    host,   ///< docs/engine.md lists what is left how; errors aren't asked for either. For WebGL,
            ///< where JavaScript alone can name the host's objects
};

/// What the last draw() took.
struct MaskCost {
    double buildMs = 0.0;       ///< preparing meshes, in add() and change() since the one before
    double drawMs = 0.0;        ///< of the CPU; a software renderer's own work may be in it
    std::size_t vertexRuns = 0; ///< of shadow volumes' shaders, in each light's last picture
    std::size_t bytes = 0;      ///< on the GPU: records, masks, depth
    unsigned hostError = 0;     ///< a GL error that was there before draw(), which clears it
};

class ShadowMasks {
  public:
    using Id = std::uint32_t;
    /// Maps a GL function's name to its address or null, as eglGetProcAddress() does.
    using LookUp = void* (*)(const char*);

    /// Lights that one draw() can have.
    static constexpr std::size_t mostLights = 32;

    explicit ShadowMasks(LookUp lookUp, StateKeeper keeper = StateKeeper::engine);
    ~ShadowMasks();
    ShadowMasks(ShadowMasks&&) noexcept;
    ShadowMasks& operator=(ShadowMasks&&) noexcept;

    /// A mesh of its own: nothing of the others is made anew. `worldFromObject`: affine and
    /// invertible.
    Id add(const PreparedMesh& mesh, const Matrix16& worldFromObject = identity16);
    Id add(const MaskMesh& mesh, const Matrix16& worldFromObject = identity16);
    /// Uploads a mesh ahead of add(), so that no draw() takes long.
    void upload(const PreparedMesh& mesh);
    /// Another mesh in the same place.
    void change(Id id, const PreparedMesh& mesh);
    void change(Id id, const MaskMesh& mesh);
    /// Of an alpha-tested mesh; until it is set, and after change(), it has no holes. Nothing is
    /// made anew.
    void setAlpha(Id id, const MaskAlpha& alpha);
    /// Elsewhere, in the same shape.
    void move(Id id, const Matrix16& worldFromObject);
    void remove(Id id);

    /// Draws the masks: 1 where nothing opaque is between a surface and the light, its own
    /// included, 0 in shadow, outside of cones and ranges; for a light with an extent the share of
    /// its points that is seen; 1 where no surface is. Leaves the GL's state as it was, see
    /// docs/engine.md.
    void draw(const MaskView& view, std::span<const MaskLight> lights);

    /// GL names, RGBA, as large as the view, nearest texels; one for four lights, until the next
    /// draw(). The host doesn't delete them.
    std::span<const unsigned> textures() const;
    /// Of the last draw(), likewise.
    const MaskNearness& nearness() const;
    const MaskCost& cost() const;

    using LookupId = std::uint32_t;

    /// Takes down the casters and a light as they are; see light_lookup.hpp. Needs no context.
    LookupWork lookupWork(const MaskLight& light, const LookupSettings& settings = {}) const;
    /// Takes the map out of what is done and makes its texture, for uploadLookup() to fill. Throws
    /// std::runtime_error where it isn't done, or was added before.
    LookupId addLookup(const LookupWork& work);
    /// Fills it; up to so many bytes and a row, so that frames needn't wait. Returns whether all is
    /// there: of what there is none of at once.
    bool uploadLookup(LookupId id, std::size_t mostBytes = std::numeric_limits<std::size_t>::max());
    const LightLookup& lookup(LookupId id) const;
    /// Another number whenever what casts has changed, or where: lights rest while it does.
    std::size_t casterState() const;
    /// Whether all that casts is as it was when the work began, and the light, but for what
    /// shadows don't depend on. False is no harm: what moved may come back.
    bool isCurrent(LookupId id, const MaskLight& light) const;
    void removeLookup(LookupId id);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace edgeshade
