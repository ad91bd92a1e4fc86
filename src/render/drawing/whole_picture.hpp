#pragma once

#include "src/gl/program.hpp"

namespace edgeshade {

/// One triangle over the whole viewport; what is written of it, and where, is the caller's state.
class WholePicture {
  public:
    /// Draws 0 in all channels.
    WholePicture();

    /// Draws what this fragment shader says.
    explicit WholePicture(const char* fragmentSource, const std::vector<std::string>& defines = {});

    /// In use, for uniforms to be set before draw().
    const gl::Program& use() const;

    void draw() const;

  private:
    gl::Program program_;
    gl::Buffer triangle_;
};

} // namespace edgeshade
