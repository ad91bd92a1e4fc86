#pragma once

#include "src/gl/program.hpp"

namespace edgeshade {

/// A triangle over the whole viewport. The caller's state decides which of its pixels and channels
/// are written.
class WholePicture {
  public:
    /// Draws 0 in all channels.
    WholePicture();

    /// Draws with this fragment shader.
    explicit WholePicture(const char* fragmentSource, const std::vector<std::string>& defines = {});

    /// Puts its program into use, so that uniforms can be set before draw().
    const gl::Program& use() const;

    void draw() const;

    void forEachProgram(const gl::ProgramVisitor& visit) const { visit(program_); }

  private:
    gl::Program program_;
    gl::Buffer triangle_;
};

} // namespace edgeshade
