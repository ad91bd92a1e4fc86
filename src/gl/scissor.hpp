#pragma once

namespace edgeshade::gl {

/// Pixels as GL counts them, from the lower left.
struct PixelRectangle {
    int x = 0, y = 0;
    int width = 0, height = 0;

    bool empty() const { return width <= 0 || height <= 0; }
};

/// What is in both; empty where nothing is.
PixelRectangle intersection(const PixelRectangle& a, const PixelRectangle& b);

/// The smallest rectangle around both.
PixelRectangle united(const PixelRectangle& a, const PixelRectangle& b);

/// What the scissor lets through of a framebuffer of this size.
PixelRectangle scissored(int width, int height);

/// Draws within a rectangle alone, for as long as it lives; then the scissor is as before.
class ScissorScope {
  public:
    explicit ScissorScope(const PixelRectangle& rectangle);
    ~ScissorScope();
    ScissorScope(const ScissorScope&) = delete;
    ScissorScope& operator=(const ScissorScope&) = delete;

  private:
    int box_[4] = {};
    bool enabled_;
};

} // namespace edgeshade::gl
