#pragma once

#include "src/hours/surfaces/cells.hpp"
#include "src/hours/surfaces/sensor_rays.hpp"
#include "src/rays/texture_alpha.hpp"

#include <emscripten/val.h>
#include <memory>
#include <optional>
#include <string>

namespace edgeshade::web {

/// Counts the sun positions that light points of a page's meshes, as `edgeshade sunhours` does:
///
///     setDays() or setTimes(), and addTexels() for each texture that cuts out casters
///     for each mesh: addMesh(), perhaps setAlpha() and addClipping(), then place() for each of its
///         places
///     measureVertices() or measureCells()
///     while (!advance()) report share()
///     counts(), and of cells the rest
///
/// Numbers are passed as addresses in the program's memory. Failures are returned as sentences, ""
/// for success.
class HoursCounter {
  public:
    HoursCounter();

    /// Positions of days on a clock, as hours::Schedule has them. `from`, `to`: "2026-03-21";
    /// `offset`: "+01:00", or "" for the one that is near the longitude. Hours are since 0:00.
    std::string setDays(double latitude, double longitude, const std::string& from,
                        const std::string& to, const std::string& offset, int step, double opens,
                        double closes, double minAltitude, double north);
    /// Positions at times at which the sun is up. `seconds`: `count` doubles, since 1970.
    std::string setTimes(double latitude, double longitude, std::uintptr_t seconds,
                         std::size_t count, double minAltitude, double north);

    /// Adds a texture's alpha, `count` numbers of 16 bits as in rays::AlphaImage; the first one has
    /// the index 0.
    std::string addTexels(std::uintptr_t alpha, std::size_t count, int width, int height);

    /// Adds triangles; place(), called at least once, says where. `positions`: floats; `indices`:
    /// 32 bits each. Triangles that aren't finite are left out.
    std::string addMesh(std::uintptr_t positions, std::size_t floats, std::uintptr_t indices,
                        std::size_t count);
    /// Cuts the last mesh out as a caster, where `opacity` times its alpha is below `cutoff`.
    /// `texels`: an index, or -1 for an alpha of 1; `texcoords`: 2 floats for each vertex; wraps
    /// and filter are GL's enums.
    std::string setAlpha(float opacity, float cutoff, int texels, std::uintptr_t texcoords,
                         int wrapS, int wrapT, int filter);
    /// Clips the last mesh as a caster by `count` planes in the world, as MaskClipping; those
    /// before clip it too. `planes`: 4 doubles for each.
    std::string addClipping(std::uintptr_t planes, std::size_t count, bool intersection);
    /// Places the last mesh. `matrix`: 16 doubles, to the world, by columns. `measured`: by
    /// measureCells().
    std::string place(std::uintptr_t matrix, bool casts, bool measured);

    /// Measures the vertices of the last mesh at its last place. A vertex faces its normal's side;
    /// those without a finite place or normal, or with the normal 0, are dark.
    /// `normals`: floats, 3 for each vertex, in the mesh's space.
    std::string measureVertices(std::uintptr_t normals);
    /// Measures the cells of a grid on meshes that say so; see hours::cellsOf(). `width` and
    /// `offset` in scene units.
    std::string measureCells(double width, double offset);

    /// Counts some more; returns whether all is done. Throws nothing.
    bool advance();
    /// The share that is done.
    double share() const;
    std::string problem() const { return problem_; }

    std::size_t positions() const { return directions_.size(); }
    /// The number of positions that light each point, 32 bits each.
    emscripten::val counts() const;
    // Cells: 3 doubles for sensors and normals, areas in scene units squared, states as
    // hours::CellState. Of each cell the number of its faces, of each face that of its corners, and
    // their 3 doubles each.
    emscripten::val points() const;
    emscripten::val normals() const;
    emscripten::val areas() const;
    emscripten::val states() const;
    emscripten::val faceCounts() const;
    emscripten::val cornerCounts() const;
    emscripten::val corners() const;

  private:
    /// Planes in the world, of which any clips, or all together.
    struct Clipping {
        std::vector<glm::dvec4> planes;
        bool intersection = false;

        bool clips(const glm::dvec3& place) const;
    };

    Material& holedMaterial();
    void startTracing();
    bool isHole(const rays::SurfaceTriangle& triangle, double u, double v) const;
    void begin(std::size_t count);

    Scene scene_;
    std::size_t castingMaterial_ = 0; ///< of the last mesh
    rays::AlphaImages images_;
    std::vector<std::vector<Clipping>> clippings_; ///< by material
    std::vector<bool> measured_;                   ///< by batch
    std::vector<glm::dvec3> directions_;
    std::unique_ptr<hours::SensorRays> rays_;
    hours::SurfaceCells cells_;
    std::vector<rays::SurfacePoint> vertices_; ///< empty: cells are measured
    std::vector<std::size_t> unsound_;         ///< vertices that are dark in any case
    std::vector<std::uint32_t> counts_;
    std::size_t counted_ = 0;
    std::string problem_;

    std::vector<double> points_, normals_, areas_, corners_;
    std::vector<std::uint32_t> faceCounts_, cornerCounts_;
    std::vector<std::uint8_t> states_;
};

} // namespace edgeshade::web
