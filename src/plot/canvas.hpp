#pragma once

#include "preprocess/base/file_io.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace edgeshade::plot {

/// 0xRRGGBB.
using Color = std::uint32_t;

struct Point {
    double x = 0.0; ///< pixels, from the left
    double y = 0.0; ///< from the top
};

enum class Anchor { start, middle, end };

struct TextStyle {
    double size = 12.0; ///< pixels
    Color color = 0;
    Anchor anchor = Anchor::start;
    bool bold = false;
    bool upwards = false; ///< turned by a quarter, to be read from the right
};

/// A white sheet to draw a plot on.
class Canvas {
  public:
    virtual ~Canvas() = default;
    virtual void line(std::span<const Point> points, Color color, double width, bool dashed) = 0;
    virtual void disc(Point center, double radius, Color fill, Color rim) = 0;
    virtual void text(Point baseline, const std::string& text, const TextStyle& style) = 0;
    /// The finished file.
    virtual Bytes file() = 0;
};

/// An SVG, its text as text.
std::unique_ptr<Canvas> svgCanvas(int width, int height);

/// A PNG with twice as many pixels along each side. Throws Error(unavailable) where the program was
/// built without cairo.
std::unique_ptr<Canvas> pngCanvas(int width, int height);

} // namespace edgeshade::plot
