#pragma once

#include "edgeshade/light_lookup.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace edgeshade {

/// Exact shadows for other renderers: textures that say which pixels of a picture are lit.
///
/// 1. With an OpenGL ES 2 or 3 context current, make a ShadowMasks.
/// 2. add() everything that casts or receives shadow; move(), change() and remove() it as your
///    scene changes.
/// 3. Each frame call draw() with your camera's matrices, then draw your own picture at the same
///    size: the share of light i that reaches a fragment is channel i % 4 of textures()[i / 4] at
///    gl_FragCoord.xy / size.
///
/// ShadowMasks draws its own depth. Alpha-tested surfaces (MaskMesh::alphaTested) receive shadow
/// where they are opaque, and surfaces seen through their holes have their own shadow. In masks
/// they cast whole triangles, or nothing; in lookups also what their alpha leaves. See-through
/// surfaces are invisible (MaskMesh::visible), as masks have one surface a pixel; lookups may tint
/// light by them. All calls need the context, and create textures and buffers in it. All throw
/// std::runtime_error with a full sentence, and have then changed nothing.

/// Triangles that move together. The spans are not kept after the call.
struct MaskMesh {
    std::span<const float> positions;       ///< x, y, z per vertex; finite
    std::span<const std::uint32_t> indices; ///< three per triangle
    bool casts = true;       ///< otherwise it only receives, and is lit from behind as well
    bool doubleSided = true; ///< otherwise only its front is visible, where it is wound
                             ///< counter-clockwise; it casts from either side
    bool bends = false;      ///< its shape changes again soon: skip lengthy preparation
    /// Where its alpha (setAlpha()) is below the cutoff the mesh has a hole: it isn't visible
    /// there, and doesn't receive shadow. If it `casts`, it casts whole triangles as if it had no
    /// holes: shadow volumes can't follow them.
    bool alphaTested = false;
    std::span<const float> texcoords =
        {}; ///< u, v per vertex, for alpha-tested meshes; empty: 0, 0
    /// Whether masks show it. Otherwise they show what is behind it, as behind see-through
    /// surfaces, and it only casts.
    bool visible = true;
};

/// The alpha of a texture, texel by texel.
struct MaskTexels {
    enum class Wrap { repeat, mirror, clamp };
    static constexpr int full = 4080; ///< an alpha of 1: 16 times that of 8 bits
    static constexpr std::size_t most = std::size_t{1} << 24; ///< texels

    int width = 0, height = 0;
    std::vector<std::uint16_t> alpha; ///< 0..full; rows from v = 0 on
    Wrap wrapS = Wrap::repeat, wrapT = Wrap::repeat;
    bool linear = true; ///< filtered linearly between texels; otherwise the nearest
};

/// Alpha of an alpha-tested mesh: `opacity` times the texture's.
struct MaskAlpha {
    enum class Channel { alpha, green };
    /// GL name of the host's 2D texture, sampled with its own settings and never changed; the host
    /// keeps it for as long as it is set. 0: no texture, alpha is `opacity` everywhere.
    unsigned texture = 0;
    Channel channel = Channel::alpha; ///< channel of the texture that holds alpha
    float opacity = 1.0f;
    float cutoff = 0.5f; ///< alpha below it is a hole
    /// Column-major; maps (u, v, 1) to the texture coordinates of the sample.
    std::array<float, 9> texcoordTransform = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    /// In lookups that have cutouts, the mesh casts what its alpha leaves, whether or not it
    /// `casts` in masks.
    bool cutsOut = false;
    /// For `cutsOut`: the texture's texels, which lookups filter as they are, without mipmaps.
    /// Null: alpha is `opacity` everywhere.
    std::shared_ptr<const MaskTexels> texels = {};
};

/// A texture that multiplies what a tinted mesh lets through, by the mesh's texture coordinates.
struct MaskTintTexture {
    /// Its red, green and blue, one after another: three times as many numbers as texels, up to
    /// MaskTexels::most. Null: none.
    std::shared_ptr<const MaskTexels> texels = {};
    /// As in MaskAlpha.
    std::array<float, 9> texcoordTransform = {1, 0, 0, 0, 1, 0, 0, 0, 1};

    bool operator==(const MaskTintTexture&) const = default;
};

/// Planes that clip a mesh.
struct MaskClipping {
    /// A plane keeps the points with a x + b y + c z + d >= 0; world space, of any length, finite.
    std::span<const std::array<double, 4>> planes;
    /// Clips only what all planes clip away; otherwise what any of them does.
    bool intersection = false;
    /// The part that is clipped away is invisible, and still casts; otherwise it casts nothing.
    bool casts = false;
};

/// A mesh with its edges found. Preparing it takes time linear in its triangles, on any thread and
/// without a GL. Copies are the same mesh, which masks store once however often it is added.
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

/// Small meshes in their places, merged: one draw shows them all until one of them changes. Merging
/// takes time linear in their triangles, on any thread and without a GL.
class MergedMeshes {
  public:
    struct Data;
    struct Member {
        PreparedMesh mesh;
        Matrix16 worldFromObject = identity16; ///< affine and invertible
    };

    /// Merges neighbours among `meshes`. Large and alpha-tested meshes, and those without enough
    /// neighbours, are left out: add them one by one. Throws std::runtime_error.
    static std::vector<MergedMeshes> of(std::span<const Member> meshes);
    explicit MergedMeshes(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

    /// The merged ones, as indices into `meshes`.
    std::span<const std::size_t> members() const;
    const std::shared_ptr<const Data>& data() const { return data_; }

  private:
    std::shared_ptr<const Data> data_;
};

/// A light in the world.
struct MaskLight {
    enum class Kind { directional, point, spot };
    Kind kind = Kind::directional;
    std::array<double, 3> position{};                ///< of a point light or spot
    std::array<double, 3> direction{0.0, -1.0, 0.0}; ///< in which a sun or spot shines; of any
                                                     ///< length
    double range = std::numeric_limits<double>::infinity(); ///< > 0: dark from this distance on;
                                                            ///< ignored for a sun
    double outerAngle = 0.7853981633974483; ///< of a spot, radians, 0..pi/2: dark from this angle
                                            ///< on
    /// The light's extent: radius of the sphere of a point light or spot, scene units; of a sun's
    /// disc, radians, up to pi/4. 0: hard shadows. Every point of a spot shines in the same cone as
    /// its centre.
    double radius = 0.0;
};

/// The camera. The projection is perspective, off-axis too, or orthographic; its depth range is
/// ignored. The view is a rotation, a translation and one scale.
struct MaskView {
    Matrix16 viewFromWorld = identity16;
    Matrix16 clipFromView = identity16;
    int width = 1; ///< pixels
    int height = 1;
    std::size_t lightSamples = 64; ///< points for each light with an extent, 1..4096
    bool nearness = false;         ///< also draw nearness(): one more pass over all surfaces
};

/// Identifies the surface at each pixel of the masks, for hosts whose outlines differ from those of
/// the masks, as with multisampling. A fragment takes, of the mask's texels around it, the one
/// whose nearness is closest to its own. Along a plane nearness changes linearly over the picture.
struct MaskNearness {
    unsigned texture = 0; ///< GL name, RGBA: 24 bits in red, green and blue, red the highest, as a
                          ///< fraction of 2^24 - 1; 0: no surface, or not requested
    double scale = 0.0;   ///< nearness is scale / depth + offset in perspective, otherwise
    double offset = 0.0;  ///< scale * depth + offset; depth along the viewing direction, in world
                          ///< units
};

/// A rectangle of pixels, from the lower left.
struct MaskRegion {
    int x = 0, y = 0, width = 0, height = 0;
};

/// The party that preserves the host's GL state during a call.
enum class StateKeeper {
    engine, ///< the engine restores everything it changes
    host,   ///< docs/engine.md lists the state left behind; glGetError() isn't called either. For
            ///< WebGL, where only JavaScript can name the host's objects
};

/// Cost of the last draw().
struct MaskCost {
    double buildMs = 0.0; ///< preparing meshes, in add() and change() since the previous draw()
    double drawMs = 0.0;  ///< CPU time; may include a software renderer's own work
    std::size_t vertexRuns = 0; ///< of the shadow volumes' shaders, in the last mask of each light
    std::size_t bytes = 0;      ///< on the GPU: records, masks, depth
    std::size_t batches = 0;    ///< drawn one by one: single meshes, and merged ones that rest
    unsigned hostError = 0;     ///< a GL error from before draw(), which clears it
};

class ShadowMasks {
  public:
    using Id = std::uint32_t;
    using LookupId = std::uint32_t;
    /// In draw(): all casters of the light are counted.
    static constexpr LookupId noLookup = ~LookupId{0};
    /// Milliseconds after which a caster that has moved counts as being at rest, see
    /// restingState().
    static constexpr double longRestMs = 5000.0;
    /// Maps a GL function's name to its address or null, as eglGetProcAddress() does.
    using LookUp = void* (*)(const char*);

    /// The most lights of one draw().
    static constexpr std::size_t mostLights = 32;
    /// The most planes that clip one mesh.
    static constexpr std::size_t mostClippingPlanes = 12;

    explicit ShadowMasks(LookUp lookUp, StateKeeper keeper = StateKeeper::engine);
    ~ShadowMasks();
    ShadowMasks(ShadowMasks&&) noexcept;
    ShadowMasks& operator=(ShadowMasks&&) noexcept;

    /// Adds a mesh; the others stay as they are. `worldFromObject`: affine and invertible.
    Id add(const PreparedMesh& mesh, const Matrix16& worldFromObject = identity16);
    Id add(const MaskMesh& mesh, const Matrix16& worldFromObject = identity16);
    /// Adds each of the merged meshes, in the order of members(). What moves or changes later is
    /// drawn by itself, and so are its neighbours, until they have rested.
    std::vector<Id> add(const MergedMeshes& meshes);
    /// Uploads a mesh ahead of add(), so that no draw() is slowed by it.
    void upload(const PreparedMesh& mesh);
    void upload(const MergedMeshes& meshes);
    /// Takes one step of upload() a call, as large meshes take long. Returns whether all is there.
    bool uploadStep(const PreparedMesh& mesh);
    bool uploadStep(const MergedMeshes& meshes);
    /// Replaces the mesh, and keeps its place.
    void change(Id id, const PreparedMesh& mesh);
    void change(Id id, const MaskMesh& mesh);
    /// Sets the alpha of an alpha-tested mesh, without rebuilding anything. Until it is set, and
    /// after change(), the mesh has no holes.
    void setAlpha(Id id, const MaskAlpha& alpha);
    /// Makes a mesh tint the light in lookups that have tints (LookupCasters), whether or not it
    /// casts in masks: each of its triangles lets this share of red, green and blue through, 0..1.
    /// A ray counts a mesh whose triangles close it once. Empty: it isn't tinted. The tint stays
    /// when the mesh is moved or changed. `texture` multiplies it, in lookups.
    void setTint(Id id, const std::optional<std::array<float, 3>>& tint,
                 const MaskTintTexture& texture = {});
    /// Moves a mesh, and keeps its shape.
    void move(Id id, const Matrix16& worldFromObject);
    /// Clips a mesh, by all of the clippings, in place of those before; up to mostClippingPlanes in
    /// all. They stay when the mesh is moved or changed. Cut surfaces stay open. Cutting takes time
    /// linear in the mesh's triangles, when planes cross its box.
    void setClippings(Id id, std::span<const MaskClipping> clippings);
    void remove(Id id);

    /// From now on prepareToDraw() also makes what such a mesh takes. Until it has, the mesh can
    /// be held back, so that no draw() waits.
    void expect(const PreparedMesh& mesh);
    /// Whether prepareToDraw() has made what the expected meshes take beyond closed casters.
    bool isPrepared() const;
    /// Begins to make the programs and textures that draw() takes in such a view of such lights
    /// and closed casters, and of expected ones. After a draw() it makes programs alone.
    /// Returns whether they are there; call it again until they are, so that no frame waits for the
    /// GL's compiler, where the GL has GL_KHR_parallel_shader_compile. draw() makes whatever is
    /// missing.
    bool prepareToDraw(const MaskView& view, std::span<const MaskLight> lights);

    /// Takes one step of what draw() of the same takes before it draws: uploads meshes, bounds
    /// layers, lists silhouettes. Returns whether all of it is there. For hosts that add many
    /// meshes to a still picture, and can wait some frames for their shadows so that none takes
    /// long; draw() does whatever is missing, and lists the silhouettes of lights with a radius.
    /// Throws as draw() does.
    bool planAhead(const MaskView& view, std::span<const MaskLight> lights,
                   std::span<const LookupId> lookups = {});

    /// Draws the masks: 1 where nothing opaque, the surface itself included, lies between the
    /// surface and the light; 0 in shadow and outside cones and ranges. For a light with an extent
    /// it is the share of its points that are visible. 1 where there is no surface. Leaves the GL's
    /// state as it was, see docs/engine.md.
    ///
    /// `lookups`: empty, or for each light the lookup that the host samples as well, or noLookup.
    /// Only the movers of such a light are counted, the casters that its lookup doesn't hold. Its
    /// mask is 1 where they don't shadow, and undefined outside cones and ranges, and where there
    /// is no surface. Throws std::runtime_error if the lookup no longer holds.
    void draw(const MaskView& view, std::span<const MaskLight> lights,
              std::span<const LookupId> lookups = {});

    /// GL names of RGBA textures of the view's size with nearest filtering, one for every four
    /// lights, valid until the next draw(). The host doesn't delete them.
    std::span<const unsigned> textures() const;
    /// Nearness of the last draw(), valid until the next.
    const MaskNearness& nearness() const;
    /// The pixels where a mask of the last draw() may be less than 1. Beyond it masks needn't be
    /// sampled, and nearness is undefined.
    const MaskRegion& region() const;
    const MaskCost& cost() const;

    /// A box in the world around surfaces that sample lookups of suns with a radius, and aren't
    /// added here. Corners that aren't finite: there are none.
    void setReceivers(const std::array<double, 3>& low, const std::array<double, 3>& high);

    /// Takes a snapshot of the resting casters (LookupSettings::restMs) and a light; see
    /// light_lookup.hpp. Needs no context.
    LookupWork lookupWork(const MaskLight& light, const LookupSettings& settings = {}) const;
    /// Takes the map out of finished work and creates its texture, which uploadLookup() fills.
    /// Throws std::runtime_error if the work isn't done, or was added before.
    LookupId addLookup(const LookupWork& work);
    /// Uploads up to `mostBytes` more of the map, and at least one row, so that no frame has to
    /// wait. Returns whether the upload is complete, which it is at once if there is no map.
    bool uploadLookup(LookupId id, std::size_t mostBytes = std::numeric_limits<std::size_t>::max());
    const LightLookup& lookup(LookupId id) const;
    /// Changes whenever casters, or their places, have changed.
    std::size_t casterState() const;
    /// Changes whenever a caster is added or removed, and when one moves or changes that had never
    /// moved before or had rested for longRestMs. A lookup that is built while it stays the same
    /// will probably hold for long.
    std::size_t restingState() const;
    /// Compares a lookup's casters with the present ones. The light has to be as it was,
    /// except for properties that shadows don't depend on. `restMs`: for LookupState::rested.
    LookupState state(LookupId id, const MaskLight& light, double restMs = longRestMs) const;
    /// Whether the lookup holds, and there are no movers: it needs no mask.
    bool isCurrent(LookupId id, const MaskLight& light) const {
        const LookupState now = state(id, light);
        return now.holds && now.movers == 0;
    }
    void removeLookup(LookupId id);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace edgeshade
