#pragma once

#include "src/policy/shadow_method.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace edgeshade {

/// What makes one light's shadows in one frame.
enum class Technique { none, volumes, lookup, points, map, planar };

/// The word for a technique in reports.
const char* wordFor(Technique technique);

/// What is asked for.
struct PolicySettings {
    ShadowMethod asked = ShadowMethod::volumes;
    bool planePairs = true; ///< volumes are drawn from plane-pair records
    int maskScale = 1;      ///< volumes are counted once for so many by so many pixels
    /// See-through surfaces are shown, which volumes can't give shadows: lights that reach them are
    /// looked up there.
    bool seeThroughReceives = false;
    /// Lookups are built beside drawing; else a picture waits for them.
    bool inBackground = false;

    bool asksForLookups() const {
        return asked == ShadowMethod::primitiveMap || asked == ShadowMethod::automatic;
    }
    /// Whether lookups are built at all.
    bool usesLookups() const {
        return asksForLookups() || (asked == ShadowMethod::volumes && seeThroughReceives);
    }
};

/// What the GL can do.
struct DeviceFacts {
    bool floatTables = false; ///< shaders look up tables of floats of 32 bits
    int textureUnits = 0;     ///< of fragment shaders
    int fragmentUniformVectors = 0;
    bool isSoftware = false;       ///< the processor draws
    bool hasDepthOfItsOwn = false; ///< framebuffers of one's own have depth and stencil
    int samples = 0;               ///< of a pixel
};

/// What the scene's casters are.
struct SceneFacts {
    std::size_t triangles = 0;
    bool anyAnimated = false;
    bool allAnimated = false;
    bool simplified = false;  ///< casters are others than the surfaces that are seen
    bool alphaTested = false; ///< some records are of casters that are tested as they are drawn
    bool cutoutsCast = false; ///< a lookup can tell where alpha leaves holes
};

/// What one light is.
struct LightFacts {
    bool isDrawn = true;    ///< it reaches something that is visible
    bool isShadowed = true; ///< it is among the lights that get a shadow at all
    bool rests = true;
    bool hasExtent = false;
    bool hasRange = false;
    bool isSpot = false;
    bool reachesSeeThrough = true; ///< see-through surfaces
    /// Silhouette edges of all casters; only asked for where they decide. Null: unknown, many.
    std::function<std::size_t()> silhouetteEdges = nullptr;
};

/// What became of one light's lookup, which is built once and kept.
struct LookupFacts {
    bool isSettled = false;    ///< it was built, or given up
    bool isUsable = false;     ///< it was built, and is what this pass can ask
    std::string_view reason{}; ///< once it is settled; somebody else's text
};

/// What building a lookup came to.
struct LookupOutcome {
    std::string fault{};   ///< why it came to nothing; empty: it is there
    double meanList = 0.0; ///< triangles in its lists, on the average
};

/// One light's technique in one frame.
struct LightChoice {
    Technique technique = Technique::none;
    /// What counts the casters that a lookup doesn't hold, which are animated; for other
    /// techniques the same as `technique`.
    Technique counted = Technique::none;
    std::string_view rule; ///< its name in the table of shadow_policy.cpp
};

/// Whether a light takes part in lookups.
struct LookupWish {
    bool isKept = false;   ///< a lookup that is there stays
    bool isWanted = false; ///< one is built where there is none
};

/// Decides which technique each light's shadows are made by, and why: from what was asked for, what
/// the GL can do, and what scene and light are. It is a function of these facts alone, without GL
/// or state, and the only place where a technique is chosen. Each rule is a row of a table; the
/// first that applies decides.
class ShadowPolicy {
  public:
    ShadowPolicy(const PolicySettings& settings, const DeviceFacts& device, const SceneFacts& scene)
        : settings_(settings), device_(device), scene_(scene) {}

    LightChoice choose(const LightFacts& light, const LookupFacts& lookup) const;

    /// Why choose() chooses so; a clause, empty: it was asked for by name. Apart from that, as
    /// frames choose for every light and nobody reads it there.
    std::string reasonFor(const LightFacts& light, const LookupFacts& lookup) const;

    LookupWish lookupWish(const LightFacts& light) const;

    /// Why no lookup should be built for a light, as long as scene and light rest; a clause, empty:
    /// one should.
    std::string lookupObstacle(const LightFacts& light) const;

    /// The same of how many bytes it may take.
    std::string roomObstacle(std::size_t room) const;

    /// The same of one that was built: why it should not be used.
    std::string lookupRefusal(const LookupOutcome& built) const;

    /// Whether any light of the scene may get a lookup; false is certain. `records`: edges of
    /// casters at rest.
    bool mayLookUp(std::size_t records) const;

    /// Whether lights without a lookup have no volumes: each visible point is asked in their place.
    bool asksPoints() const;

    /// Whether asksPoints() may be true of some scene.
    bool mayAskPoints() const;

    const PolicySettings& settings() const { return settings_; }

  private:
    PolicySettings settings_;
    DeviceFacts device_;
    SceneFacts scene_;
};

/// Triangles from which asking each visible point takes less than filling volumes: as measured, of
/// 4,000 volumes are filled in less time, of 22,000 in 1.2 times as much (docs/measured/fill.md).
inline constexpr std::size_t leastTrianglesForPoints = 8192;

/// At or below this many silhouette edges, volumes cost less than looking up every pixel.
inline constexpr std::size_t fewSilhouettes = 1000;

/// Mean triangles of a lookup's lists above which volumes cost less.
inline constexpr double longLists = 100.0;

/// Bytes below which no lookup is tried.
inline constexpr std::size_t leastLookupBytes = std::size_t{1} << 16;

} // namespace edgeshade
