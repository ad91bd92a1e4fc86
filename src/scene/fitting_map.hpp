#pragma once

#include "src/shadow/primitive_map/primitive_map_builder.hpp"

#include <memory>

namespace edgeshade {

/// Triangles in one list, up to which a map is used. GLs may end a loop after so many turns, and
/// light would leak: Mesa's llvmpipe was seen to at 5,699 and not at 4,754, softpipe not at all.
inline constexpr std::size_t longestAsked = 3072;

/// A light's primitive map. It begins with as many texels as suit its casters, and no more than
/// its settings say; where it takes more memory than it may, half as many along an edge are tried,
/// down to an eighth. Where a list is longer than longestAsked it is given up at once: larger
/// texels have longer ones.
class FittingMap {
  public:
    FittingMap(const Light& light, std::vector<PlacedCasters> casters,
               const PrimitiveMapSettings& settings);

    /// Builds a part. Returns whether there is more to do.
    bool step();
    /// Builds all parts of the size that is tried, on as many threads as there are cores.
    void buildAllParts();

    /// Once there is no more to do.
    bool tooFar() const { return tooFar_; }
    /// Triangles in a list for which it was given up, or 0.
    std::size_t tooLong() const { return tooLong_; }
    std::optional<PrimitiveMap>& map() { return map_; }

  private:
    Light light_;
    std::vector<PlacedCasters> casters_;
    PrimitiveMapSettings settings_;
    int smallest_ = 0; ///< size that is tried
    std::unique_ptr<PrimitiveMapBuilder> builder_;
    std::size_t nextPart_ = 0;
    bool joined_ = false, tooFar_ = false;
    std::size_t tooLong_ = 0;
    std::optional<PrimitiveMap> map_;
};

/// What came of a map that was asked for.
struct MapOutcome {
    bool built = false, tooFar = false;
    std::size_t tooLong = 0;   ///< FittingMap::tooLong()
    std::size_t mostBytes = 0; ///< what it might take
};

/// Why it can't be used, a clause; empty: it can.
std::string refusalOf(const MapOutcome& outcome);

} // namespace edgeshade
