#include "src/hours/surfaces/cells_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace edgeshade::hours {
namespace {

/// Samples along a pixel's side, for smooth edges.
constexpr int samples = 2;
/// Shares of the cells' extent around them, where they are all of the scene, and where they are a
/// part. Share of the extent by which cells are nearer than the surfaces that they lie on.
constexpr double marginOfAll = 0.03, marginOfSome = 0.3, nearer = 2e-4;
/// Brightness of surfaces that are turned away from the eye, and what is added for those that face
/// it.
constexpr double darkest = 150.0, brighter = 75.0;

/// A parallel view: x right and y down in samples, z towards the eye in scene units.
class View {
  public:
    /// Fits `points` into the picture, with a margin.
    View(std::span<const glm::dvec3> points, double margin, const glm::dvec3& towardsEye, int width,
         int height)
        : towardsEye_(towardsEye),
          right_(glm::normalize(glm::cross(glm::dvec3(0.0, 1.0, 0.0), towardsEye))),
          up_(glm::cross(towardsEye, right_)) {
        glm::dvec2 low(std::numeric_limits<double>::infinity()), high(-low);
        for (const glm::dvec3& point : points) {
            const glm::dvec2 at(glm::dot(point, right_), -glm::dot(point, up_));
            low = glm::min(low, at);
            high = glm::max(high, at);
        }
        const glm::dvec2 extent = glm::max(high - low, glm::dvec2(1e-300));
        const glm::dvec2 size(width * samples, height * samples);
        scale_ = std::min(size.x / extent.x, size.y / extent.y) / (1.0 + 2.0 * margin);
        offset_ = 0.5 * size - scale_ * 0.5 * (low + high);
        nearer_ = nearer * std::max(extent.x, extent.y);
    }

    glm::dvec3 place(const glm::dvec3& point) const {
        return {scale_ * glm::dot(point, right_) + offset_.x,
                -scale_ * glm::dot(point, up_) + offset_.y, glm::dot(point, towardsEye_)};
    }
    double facing(const glm::dvec3& normal) const { return glm::dot(normal, towardsEye_); }
    double lift() const { return nearer_; }
    /// How far depths may differ within a sample on a surface that isn't seen edge-on.
    double roundingOfDepth() const { return nearer_ + 4.0 / scale_; }

  private:
    glm::dvec3 towardsEye_, right_, up_;
    double scale_ = 1.0, nearer_ = 0.0;
    glm::dvec2 offset_{0.0};
};

/// Samples with their depths.
class Raster {
  public:
    Raster(int width, int height)
        : width_(width * samples), height_(height * samples),
          colors_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0xFFFFFF),
          depths_(colors_.size(), -std::numeric_limits<double>::infinity()) {}

    void draw(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, DisplayColor color) {
        const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        if (area == 0.0 || !std::isfinite(area)) return;
        const auto first = [](double low) {
            return static_cast<int>(std::max(0.0, std::ceil(low - 0.5)));
        };
        const auto last = [](double high, int size) {
            return static_cast<int>(std::min(size - 1.0, std::floor(high - 0.5)));
        };
        const int x0 = first(std::min({a.x, b.x, c.x})),
                  x1 = last(std::max({a.x, b.x, c.x}), width_),
                  y0 = first(std::min({a.y, b.y, c.y})),
                  y1 = last(std::max({a.y, b.y, c.y}), height_);
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x) {
                const double px = x + 0.5, py = y + 0.5;
                const double u = ((px - a.x) * (c.y - a.y) - (py - a.y) * (c.x - a.x)) / area,
                             v = ((b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x)) / area;
                if (u < 0.0 || v < 0.0 || u + v > 1.0) continue;
                const double depth = a.z + u * (b.z - a.z) + v * (c.z - a.z);
                const std::size_t at =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                    static_cast<std::size_t>(x);
                if (depth <= depths_[at]) continue;
                depths_[at] = depth;
                colors_[at] = color;
            }
    }

    /// The depth of what is drawn at a sample; infinity outside the picture.
    double depthAt(const glm::dvec3& place) const {
        if (!(place.x >= 0.0 && place.x < width_ && place.y >= 0.0 && place.y < height_))
            return std::numeric_limits<double>::infinity();
        return depths_[static_cast<std::size_t>(place.y) * static_cast<std::size_t>(width_) +
                       static_cast<std::size_t>(place.x)];
    }

    /// Means of samples, opaque.
    std::vector<std::uint8_t> rgba() const {
        std::vector<std::uint8_t> pixels;
        for (int y = 0; y < height_; y += samples)
            for (int x = 0; x < width_; x += samples) {
                for (const int shift : {16, 8, 0}) {
                    std::uint32_t sum = 0;
                    for (int i = 0; i < samples * samples; ++i)
                        sum += colors_[static_cast<std::size_t>(y + i / samples) *
                                           static_cast<std::size_t>(width_) +
                                       static_cast<std::size_t>(x + i % samples)] >>
                                   shift &
                               0xFF;
                    pixels.push_back(static_cast<std::uint8_t>(sum / (samples * samples)));
                }
                pixels.push_back(255);
            }
        return pixels;
    }

  private:
    int width_, height_;
    std::vector<DisplayColor> colors_;
    std::vector<double> depths_;
};

void drawCell(const SurfaceRun& run, const Cell& cell, const View& view, DisplayColor color,
              Raster& raster) {
    const glm::dvec3 lift(0.0, 0.0, view.lift());
    for (std::uint32_t f = cell.firstFace; f < cell.firstFace + cell.faceCount; ++f) {
        const CellFace& face = run.cells.faces[f];
        const auto corner = [&](std::uint32_t i) {
            return view.place(run.cells.corners[face.firstCorner + i]) + lift;
        };
        for (std::uint32_t i = 2; i < face.cornerCount; ++i)
            raster.draw(corner(0), corner(i - 1), corner(i), color);
    }
}

} // namespace

CellsPicture pictureOf(const SurfaceRun& run, std::span<const WorldTriangle> scene,
                       const std::function<DisplayColor(std::size_t cell)>& color,
                       const glm::dvec3& towardsEye, int width, int height) {
    const bool all = run.cells.triangles.size() == scene.size() && !run.ofWindows;
    const View view(run.cells.corners, all ? marginOfAll : marginOfSome, towardsEye, width, height);
    Raster raster(width, height);
    for (const WorldTriangle& triangle : scene) {
        const double length = glm::length(normalOf(triangle));
        if (!(length > 0.0)) continue;
        const double facing = std::abs(view.facing(normalOf(triangle))) / length;
        const auto grey = static_cast<DisplayColor>(darkest + brighter * facing);
        raster.draw(view.place(triangle.a), view.place(triangle.b), view.place(triangle.c),
                    grey << 16 | grey << 8 | grey);
    }
    CellsPicture picture{width, height, {}, {}};
    for (std::size_t i = 0; i < run.cells.cells.size(); ++i)
        if (view.facing(run.cells.cells[i].normal) > 0.0)
            drawCell(run, run.cells.cells[i], view, color(i), raster);
    for (const Cell& cell : run.cells.cells) {
        const glm::dvec3 place = view.place(cell.point);
        std::optional<glm::dvec2>& seen = picture.places.emplace_back();
        if (view.facing(cell.normal) > 0.0 &&
            raster.depthAt(place) <= place.z + view.lift() + view.roundingOfDepth())
            seen = glm::dvec2(place) / static_cast<double>(samples);
    }
    picture.rgba = raster.rgba();
    return picture;
}

} // namespace edgeshade::hours
