#pragma once

#include "src/gl/program.hpp"

namespace edgeshade {

/// One triangle over the whole viewport that draws 0 in all channels; what is written of it, and
/// where, is the caller's state.
class WholePicture {
  public:
    WholePicture();

    void draw() const;

  private:
    gl::Program program_;
    gl::Buffer triangle_;
};

} // namespace edgeshade
