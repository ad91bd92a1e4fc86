#pragma once

#include "src/scene/primitive_map_worker.hpp"

#include <string>

namespace edgeshade {

/// What became of a light's primitive map.
struct PrimitiveMapState {
    std::shared_ptr<const GpuPrimitiveMap> map; ///< null: shadows are counted by volumes
    std::string why;                            ///< a clause
    double buildMs = 0.0;                       ///< on the CPU
};

/// Which lights get a primitive map.
enum class MapChoice {
    all,
    thatPay, ///< those whose volumes would cost more
};

/// Primitive maps of a scene's lights, kept while lights rest: static casters are in them, others
/// are counted. Of a light with an extent it is one for all of it, which animated casters rule out.
/// clear() comes before the scene goes, or static batches move.
class PrimitiveMaps {
  public:
    /// Has maps built there from now on where they are built in the background.
    void buildWith(std::shared_ptr<PrimitiveMapWorker> worker) { worker_ = std::move(worker); }

    /// Has maps of all lights, and of no others, when it returns. Throws Error(unavailable) if the
    /// GL can't.
    void make(const LoadedScene& loaded, const std::vector<Light>& lights, MapChoice choice,
              const PrimitiveMapSettings& settings, const gl::Capabilities& capabilities);

    /// The same in the background, light after light: returns whether one has been finished. Where
    /// there are neither threads nor a worker it works for so long.
    bool advance(const LoadedScene& loaded, const std::vector<Light>& lights, MapChoice choice,
                 const PrimitiveMapSettings& settings, const gl::Capabilities& capabilities,
                 double milliseconds);

    /// Null: nobody has made one yet.
    const PrimitiveMapState* of(const Light& light) const;

    void clear();
    std::size_t bytes() const;

  private:
    struct Kept {
        glm::dvec4 light; ///< its position
        std::optional<LightExtent> extent;
        PrimitiveMapState state;

        bool isOf(const Light& of) const { return light == of.position && extent == of.extent; }
    };

    void keepOnly(const std::vector<Light>& lights);
    /// Settles what needs no map; returns whether the light needs one.
    bool needsJob(const LoadedScene& loaded, const Light& light, MapChoice choice,
                  const gl::Capabilities& capabilities);
    /// The first light's that needs a job; nothing: none does.
    std::optional<PrimitiveMapTask> nextTask(const LoadedScene& loaded,
                                             const std::vector<Light>& lights, MapChoice choice,
                                             const PrimitiveMapSettings& settings,
                                             const gl::Capabilities& capabilities);
    /// With what the scene adds to the settings: what MASK surfaces are cut out by, if they cast.
    PrimitiveMapTask taskOf(const LoadedScene& loaded, const Light& light,
                            PrimitiveMapSettings settings, const gl::Capabilities& capabilities);
    void take(const BuiltPrimitiveMap& built, std::size_t batches, MapChoice choice,
              const PrimitiveMapSettings& settings, const gl::Capabilities& capabilities);
    void giveUp();

    std::vector<Kept> kept_;
    KeptEdges edges_;
    CutoutTextures textures_;                     ///< once they were asked for
    std::shared_ptr<const AlphaTexture> cutouts_; ///< the atlas on the GPU
    std::unique_ptr<PrimitiveMapJob> job_;        ///< in the background
    std::shared_ptr<PrimitiveMapWorker> worker_;  ///< null: there is none
    std::optional<Light> asked_;                  ///< whose map it builds
};

/// Whether any light of the scene may get a map; false is certain.
bool mayHaveMaps(const LoadedScene& loaded, MapChoice choice, const gl::Capabilities& capabilities);

/// Why a scene's casters can't be in a primitive map; empty if they can.
std::string primitiveMapObstacle(const LoadedScene& loaded, const gl::Capabilities& capabilities);

/// The same of all of a light that has an extent: of one that reaches everywhere, where nothing is
/// animated and nothing that casts is alpha-tested.
std::string extendedMapObstacle(const LoadedScene& loaded, const Light& light,
                                const gl::Capabilities& capabilities);

/// Triangles in the lists of such a map, on the average, from which volumes of its points one by
/// one cost less.
inline constexpr double longLists = 100.0;

/// Lights of a picture that may have maps, the first of them: each takes megabytes. Of the others
/// volumes are counted, and see-through surfaces get their light without shadows.
inline constexpr std::size_t mostMappedLights = 32;

/// Places of a light that one pass counts by its map.
inline constexpr std::size_t placesAtOnce = 16;

/// Of a light's volumes, silhouette edges up to which they cost less than looking up every pixel.
inline constexpr std::size_t fewSilhouettes = 1000;

} // namespace edgeshade
