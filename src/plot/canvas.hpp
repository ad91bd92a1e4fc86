#pragma once

#include "preprocess/base/file_io.hpp"
#include "src/plot/color.hpp"
#include "src/plot/shape.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace edgeshade::plot {

/// A rectangle in pixels.
struct Rectangle {
    double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
};

enum class Anchor { start, middle, end };

struct TextStyle {
    double size = 12.0; ///< pixels
    Color color = 0;
    Anchor anchor = Anchor::start;
    bool bold = false;
    bool upwards = false; ///< rotated by a quarter turn, to be read from the right
};

/// A white sheet to draw a plot on.
class Canvas {
  public:
    virtual ~Canvas() = default;
    virtual void line(std::span<const Point> points, Color color, double width, bool dashed) = 0;
    /// `hover`: text shown when the pointer rests on it, on canvases that can; may be empty.
    virtual void mark(Point center, Shape shape, double radius, Color fill, Color rim,
                      const std::string& hover) = 0;
    virtual void rectangle(const Rectangle& rectangle, Color fill) = 0;
    /// Fills the rectangle with a picture of RGBA pixels, rows top to bottom, without smoothing.
    virtual void image(const Rectangle& rectangle, std::span<const std::uint8_t> rgba, int width,
                       int height) = 0;
    virtual void text(Point baseline, const std::string& text, const TextStyle& style) = 0;
    /// The finished file.
    virtual Bytes file() = 0;
};

/// An SVG canvas with text as text.
std::unique_ptr<Canvas> svgCanvas(int width, int height);

/// A PNG canvas with twice as many pixels along each side. Throws Error(unavailable) if the program
/// was built without cairo.
std::unique_ptr<Canvas> pngCanvas(int width, int height);

} // namespace edgeshade::plot
