#include "src/plot/canvas.hpp"

#include "preprocess/base/base64.hpp"
#include "preprocess/base/markup.hpp"
#include "src/image/png.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace edgeshade::plot {
namespace {

/// Rounds to a tenth of a pixel, which is precise enough.
std::string number(double value) {
    std::ostringstream text;
    text << std::round(10.0 * value) / 10.0;
    return text.str();
}

std::string hex(Color color) {
    std::ostringstream text;
    text << '#' << std::hex << std::setw(6) << std::setfill('0') << color;
    return text.str();
}

/// A rectangle's SVG attributes.
std::string placed(const Rectangle& rectangle) {
    return " x=\"" + number(rectangle.left) + "\" y=\"" + number(rectangle.top) + "\" width=\"" +
           number(rectangle.right - rectangle.left) + "\" height=\"" +
           number(rectangle.bottom - rectangle.top) + "\"";
}

class SvgCanvas : public Canvas {
  public:
    SvgCanvas(int width, int height) {
        text_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\""
              << height << "\" viewBox=\"0 0 " << width << " " << height
              << "\" font-family=\"DejaVu Sans, Verdana, sans-serif\">\n"
              << "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
    }

    void line(std::span<const Point> points, Color color, double width, bool dashed) override {
        text_ << "<polyline fill=\"none\" stroke=\"" << hex(color) << "\" stroke-width=\""
              << number(width) << "\"" << (dashed ? " stroke-dasharray=\"5 4\"" : "")
              << " points=\"";
        addPlaces(points);
        text_ << "\"/>\n";
    }

    void mark(Point center, Shape shape, double radius, Color fill, Color rim,
              const std::string& hover) override {
        const std::string colors =
            "\" fill=\"" + hex(fill) + "\" stroke=\"" + hex(rim) + "\" stroke-width=\"1.5\"";
        const char* element = shape == Shape::disc ? "circle" : "polygon";
        if (shape == Shape::disc) {
            text_ << "<circle cx=\"" << number(center.x) << "\" cy=\"" << number(center.y)
                  << "\" r=\"" << number(radius) << colors;
        } else {
            text_ << "<polygon points=\"";
            addPlaces(outlineOf(shape, center, radius));
            text_ << colors;
        }
        if (hover.empty())
            text_ << "/>\n";
        else
            text_ << "><title>" << escapedForMarkup(hover) << "</title></" << element << ">\n";
    }

    void rectangle(const Rectangle& rectangle, Color fill) override {
        text_ << "<rect" << placed(rectangle) << " fill=\"" << hex(fill) << "\"/>\n";
    }

    void image(const Rectangle& rectangle, std::span<const std::uint8_t> rgba, int width,
               int height) override {
        text_ << "<image" << placed(rectangle)
              << " preserveAspectRatio=\"none\" style=\"image-rendering:pixelated\" "
                 "href=\"data:image/png;base64,"
              << base64(encodePng(rgba, width, height)) << "\"/>\n";
    }

    void text(Point baseline, const std::string& text, const TextStyle& style) override {
        constexpr const char* anchors[] = {"start", "middle", "end"};
        text_ << "<text x=\"" << number(baseline.x) << "\" y=\"" << number(baseline.y)
              << "\" font-size=\"" << number(style.size) << "\" fill=\"" << hex(style.color)
              << "\" text-anchor=\"" << anchors[static_cast<int>(style.anchor)] << "\""
              << (style.bold ? " font-weight=\"bold\"" : "");
        if (style.upwards)
            text_ << " transform=\"rotate(-90 " << number(baseline.x) << " " << number(baseline.y)
                  << ")\"";
        text_ << ">" << escapedForMarkup(text) << "</text>\n";
    }

    Bytes file() override {
        const std::string whole = text_.str() + "</svg>\n";
        return Bytes(whole.begin(), whole.end());
    }

  private:
    void addPlaces(std::span<const Point> points) {
        for (std::size_t i = 0; i < points.size(); ++i)
            text_ << (i > 0 ? " " : "") << number(points[i].x) << "," << number(points[i].y);
    }

    std::ostringstream text_;
};

} // namespace

std::unique_ptr<Canvas> svgCanvas(int width, int height) {
    return std::make_unique<SvgCanvas>(width, height);
}

} // namespace edgeshade::plot
