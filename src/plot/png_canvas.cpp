#include "src/plot/canvas.hpp"

#include "preprocess/base/error.hpp"

#ifdef EDGESHADE_HAS_CAIRO
#include "src/image/png.hpp"

#include <cairo.h>
#include <numbers>
#include <vector>
#endif

namespace edgeshade::plot {

#ifdef EDGESHADE_HAS_CAIRO
namespace {

constexpr int scale = 2;

class PngCanvas : public Canvas {
  public:
    PngCanvas(int width, int height)
        : width_(scale * width), height_(scale * height),
          surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_, height_),
                   cairo_surface_destroy),
          cairo_(cairo_create(surface_.get()), cairo_destroy) {
        cairo_scale(cairo_.get(), scale, scale);
        use(0xFFFFFF);
        cairo_paint(cairo_.get());
    }

    void line(std::span<const Point> points, Color color, double width, bool dashed) override {
        constexpr double dashes[] = {5.0, 4.0};
        cairo_set_dash(cairo_.get(), dashes, dashed ? 2 : 0, 0.0);
        cairo_set_line_width(cairo_.get(), width);
        use(color);
        for (const Point& point : points)
            cairo_line_to(cairo_.get(), point.x, point.y);
        cairo_stroke(cairo_.get());
    }

    void mark(Point center, Shape shape, double radius, Color fill, Color rim,
              const std::string&) override {
        cairo_new_sub_path(cairo_.get());
        if (shape == Shape::disc)
            cairo_arc(cairo_.get(), center.x, center.y, radius, 0.0, 2.0 * std::numbers::pi);
        for (const Point& corner : outlineOf(shape, center, radius))
            cairo_line_to(cairo_.get(), corner.x, corner.y);
        cairo_close_path(cairo_.get());
        use(fill);
        cairo_fill_preserve(cairo_.get());
        cairo_set_dash(cairo_.get(), nullptr, 0, 0.0);
        cairo_set_line_width(cairo_.get(), 1.5);
        use(rim);
        cairo_stroke(cairo_.get());
    }

    void rectangle(const Rectangle& rectangle, Color fill) override {
        addPath(rectangle);
        use(fill);
        cairo_fill(cairo_.get());
    }

    void image(const Rectangle& rectangle, std::span<const std::uint8_t> rgba, int width,
               int height) override {
        const std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> picture(
            cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height), cairo_surface_destroy);
        cairo_surface_flush(picture.get());
        unsigned char* row = cairo_image_surface_get_data(picture.get());
        const int stride = cairo_image_surface_get_stride(picture.get());
        for (int y = 0; y < height; ++y, row += stride)
            for (int x = 0; x < width; ++x) {
                const std::uint8_t* from =
                    &rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(x))];
                const std::uint32_t alpha = from[3]; // cairo's colours are multiplied by alpha
                std::uint32_t pixel = alpha << 24;
                for (int c = 0; c < 3; ++c)
                    pixel |= (from[c] * alpha + 127) / 255 << (16 - 8 * c);
                reinterpret_cast<std::uint32_t*>(row)[x] = pixel;
            }
        cairo_surface_mark_dirty(picture.get());
        cairo_save(cairo_.get());
        cairo_translate(cairo_.get(), rectangle.left, rectangle.top);
        cairo_scale(cairo_.get(), (rectangle.right - rectangle.left) / width,
                    (rectangle.bottom - rectangle.top) / height);
        cairo_set_source_surface(cairo_.get(), picture.get(), 0.0, 0.0);
        cairo_pattern_set_filter(cairo_get_source(cairo_.get()), CAIRO_FILTER_NEAREST);
        cairo_paint(cairo_.get());
        cairo_restore(cairo_.get());
    }

    void text(Point baseline, const std::string& text, const TextStyle& style) override {
        cairo_select_font_face(cairo_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                               style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
        cairo_set_font_size(cairo_.get(), style.size);
        use(style.color);
        cairo_text_extents_t extents;
        cairo_text_extents(cairo_.get(), text.c_str(), &extents);
        const double back = 0.5 * static_cast<int>(style.anchor) * extents.x_advance;
        cairo_save(cairo_.get());
        cairo_translate(cairo_.get(), baseline.x, baseline.y);
        if (style.upwards) cairo_rotate(cairo_.get(), -0.5 * std::numbers::pi);
        cairo_move_to(cairo_.get(), -back, 0.0);
        cairo_show_text(cairo_.get(), text.c_str());
        cairo_restore(cairo_.get());
        cairo_new_path(cairo_.get());
    }

    Bytes file() override {
        cairo_surface_flush(surface_.get());
        const unsigned char* row = cairo_image_surface_get_data(surface_.get());
        const int stride = cairo_image_surface_get_stride(surface_.get());
        std::vector<std::uint8_t> rgba;
        for (int y = 0; y < height_; ++y, row += stride)
            for (int x = 0; x < width_; ++x) {
                const std::uint32_t pixel = reinterpret_cast<const std::uint32_t*>(row)[x];
                for (const int shift : {16, 8, 0})
                    rgba.push_back(static_cast<std::uint8_t>(pixel >> shift));
                rgba.push_back(255);
            }
        return encodePng(rgba, width_, height_);
    }

  private:
    void addPath(const Rectangle& rectangle) {
        cairo_rectangle(cairo_.get(), rectangle.left, rectangle.top,
                        rectangle.right - rectangle.left, rectangle.bottom - rectangle.top);
    }

    void use(Color color) {
        const auto part = [&](int shift) { return (color >> shift & 0xFF) / 255.0; };
        cairo_set_source_rgb(cairo_.get(), part(16), part(8), part(0));
    }

    int width_;
    int height_;
    std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface_;
    std::unique_ptr<cairo_t, void (*)(cairo_t*)> cairo_;
};

} // namespace

std::unique_ptr<Canvas> pngCanvas(int width, int height) {
    return std::make_unique<PngCanvas>(width, height);
}

#else

std::unique_ptr<Canvas> pngCanvas(int, int) {
    throw Error(ExitStatus::unavailable, "This program was built without cairo, so it writes "
                                         "plots as .svg and not as .png.");
}

#endif

} // namespace edgeshade::plot
