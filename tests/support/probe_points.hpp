#pragma once

#include "src/gl/headless_context.hpp"
#include "src/gl/program.hpp"
#include "src/render/drawing/attributes.hpp"

#include <functional>

namespace edgeshade::test {

/// Draws one point per record, with programs of the variant PROBE, and reads their numbers back.
/// Owns the GL context that the rest of a probe needs.
class ProbePoints {
  public:
    ProbePoints();

    /// The numbers of `count` records. The program must be in use with its uniforms set; `bind`
    /// adds the attributes of the records from `first` on, before the last one, a_pixel.
    std::vector<int>
    draw(std::size_t count,
         const std::function<void(AttributeBinding& binding, std::size_t first)>& bind) const;

    /// The pixels' centres: two floats each, for as many records as one draw has.
    const gl::Buffer& pixels() const { return pixels_; }

  private:
    static constexpr int side = 1024; ///< side in pixels of the square that points are drawn into

    gl::HeadlessContext context_;
    gl::Buffer pixels_; ///< row by row
};

} // namespace edgeshade::test
