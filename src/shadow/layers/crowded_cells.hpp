#pragma once

#include "src/shadow/layers/flat_casters.hpp"
#include "src/shadow/layers/touch_grid.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace edgeshade {

/// Indices of casting triangles, in the order of batches and their casters.
using TriangleIndices = std::vector<std::uint32_t>;

/// A triangle that may touch a cell of a light's face.
struct CellMember {
    static constexpr std::uint32_t isWhole = ~std::uint32_t{0};

    std::uint32_t triangle;
    std::uint32_t part; ///< index in FlatCasters::parts(), or isWhole

    /// Calls use(polygon) with its polygon on the face.
    template <class Use>
    void withPolygon(const FlatCasters& casters, Use use) const {
        if (part != isWhole) return use(casters.parts()[part].polygon.all());
        const FlatCasters::Corners corners = casters.cornersOf(triangle);
        use(std::span<const glm::dvec2>(corners));
    }
};

/// A cell that too many triangles may touch.
struct CrowdedCell {
    Outline part;
    std::vector<CellMember> members{};
};

/// The crowded cells of a grid.
class CrowdedCells {
  public:
    CrowdedCells() = default;
    /// Takes from a summed grid the cells that count more than `limit`, without members yet. Raises
    /// `most` to the largest count of the others, if that is more.
    CrowdedCells(const TouchGrid& grid, std::size_t limit, std::size_t& most);
    /// A single cell that covers the whole grid.
    static CrowdedCells ofAll(const Outline& part);

    void add(const CellMember& member, std::span<const glm::dvec2> polygon, const TouchGrid& grid);

    bool empty() const { return cells_.empty(); }
    const std::vector<CrowdedCell>& all() const { return cells_; }

  private:
    std::vector<CrowdedCell> cells_;
    std::vector<std::int32_t> at_; ///< index in cells_, by the grid's rows and columns; -1: not
                                   ///< crowded
};

} // namespace edgeshade
