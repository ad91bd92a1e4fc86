#pragma once

#include "src/policy/shadow_method.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace edgeshade {

/// The technique that makes one light's shadows in one frame.
enum class Technique { none, volumes, lookup, points, map, planar };

/// The name of a technique in reports.
const char* wordFor(Technique technique);

/// The requested settings.
struct PolicySettings {
    ShadowMethod asked = ShadowMethod::volumes;
    bool planePairs = true; ///< volumes are drawn from plane-pair records
    int maskScale = 1;      ///< n: volumes are counted once for each n by n pixels
    /// See-through surfaces are shown. Volumes can't shade them, so lights that reach them get
    /// lookups for these surfaces.
    bool seeThroughReceives = false;
    /// Lookups are built while drawing goes on; otherwise a picture waits for them.
    bool inBackground = false;

    bool asksForLookups() const {
        return asked == ShadowMethod::primitiveMap || asked == ShadowMethod::automatic;
    }
    /// Whether lookups are built at all.
    bool usesLookups() const {
        return asksForLookups() || (asked == ShadowMethod::volumes && seeThroughReceives);
    }
};

/// Capabilities of the GL.
struct DeviceFacts {
    bool floatTables = false; ///< shaders can sample tables of 32-bit floats
    int textureUnits = 0;     ///< of fragment shaders
    int fragmentUniformVectors = 0;
    bool isSoftware = false;       ///< the processor draws
    bool hasDepthOfItsOwn = false; ///< the GL's own framebuffer objects can have depth and stencil
    int samples = 0;               ///< per pixel
};

/// Facts about the scene's casters.
struct SceneFacts {
    std::size_t triangles = 0;
    bool anyAnimated = false;
    bool allAnimated = false;
    bool simplified = false;  ///< casters differ from the visible surfaces
    bool alphaTested = false; ///< some records belong to casters that are alpha-tested while
                              ///< drawing
    bool cutoutsCast = false; ///< a lookup knows the casters' cutouts
};

/// Facts about one light.
struct LightFacts {
    bool isDrawn = true;    ///< it reaches something visible
    bool isShadowed = true; ///< it is among the lights that get a shadow at all
    bool rests = true;
    bool hasExtent = false;
    bool hasRange = false;
    bool isSpot = false;
    bool reachesSeeThrough = true; ///< it reaches see-through surfaces
    /// Counts silhouette edges of all casters; called only if the number matters. Null: unknown,
    /// many.
    std::function<std::size_t()> silhouetteEdges = nullptr;
};

/// State of one light's lookup, which is built once and kept.
struct LookupFacts {
    bool isSettled = false;    ///< it was built, or given up
    bool isUsable = false;     ///< it was built, and this pass can sample it
    std::string_view reason{}; ///< set once it is settled; not owned
};

/// Result of building a lookup.
struct LookupOutcome {
    std::string fault{};   ///< why building failed; empty: it succeeded
    double meanList = 0.0; ///< mean number of triangles in its lists
};

/// One light's technique in one frame.
struct LightChoice {
    Technique technique = Technique::none;
    /// The technique for animated casters, which a lookup doesn't hold; equals `technique` if that
    /// is not a lookup.
    Technique counted = Technique::none;
    std::string_view rule; ///< its name in the table of shadow_policy.cpp

    /// Whether only animated casters are counted.
    bool countsAnimatedAlone() const { return technique == Technique::lookup; }
};

/// Whether a light takes part in lookups.
struct LookupWish {
    bool isKept = false;   ///< keep an existing lookup
    bool isWanted = false; ///< build one if there is none
};

/// Chooses the technique for each light's shadows and gives the reason, from the requested
/// settings, the GL's capabilities, the scene and the light. It is a pure function of these facts,
/// and the only place where a technique is chosen. Each rule is a row of a table; the first that
/// applies decides.
class ShadowPolicy {
  public:
    ShadowPolicy(const PolicySettings& settings, const DeviceFacts& device, const SceneFacts& scene)
        : settings_(settings), device_(device), scene_(scene) {}

    LightChoice choose(const LightFacts& light, const LookupFacts& lookup) const;

    /// The reason for the choice of choose(), as a clause; empty: the user requested it by name.
    /// Separate from choose(), because frames choose for every light and read no reasons.
    std::string reasonFor(const LightFacts& light, const LookupFacts& lookup) const;

    LookupWish lookupWish(const LightFacts& light) const;

    /// Why no lookup should be built for a light, as long as scene and light rest: a clause; empty:
    /// one should be built.
    std::string lookupObstacle(const LightFacts& light) const;

    /// As above, for the bytes that it may take.
    std::string roomObstacle(std::size_t room) const;

    /// As above, for a lookup that was built: why it should not be used.
    std::string lookupRefusal(const LookupOutcome& built) const;

    /// Whether any light of the scene may get a lookup; false is certain. `records`: number of
    /// edges of casters at rest.
    bool mayLookUp(std::size_t records) const;

    /// Whether each visible point is tested instead of counting volumes, for lights without a
    /// lookup.
    bool asksPoints() const;

    /// Whether asksPoints() could be true for some scene.
    bool mayAskPoints() const;

    const PolicySettings& settings() const { return settings_; }

  private:
    PolicySettings settings_;
    DeviceFacts device_;
    SceneFacts scene_;
};

/// Number of triangles from which testing each visible point is quicker than filling volumes. As
/// measured, filling volumes takes less time at 4,000 triangles, and 1.2 times as much at 22,000
/// (docs/measured/fill.md).
inline constexpr std::size_t leastTrianglesForPoints = 8192;

/// Number of silhouette edges up to which volumes cost less than a lookup in every pixel.
inline constexpr std::size_t fewSilhouettes = 1000;

/// Mean length of a lookup's lists, in triangles, above which volumes cost less.
inline constexpr double longLists = 100.0;

/// Least memory in bytes for which a lookup is tried.
inline constexpr std::size_t leastLookupBytes = std::size_t{1} << 16;

} // namespace edgeshade
