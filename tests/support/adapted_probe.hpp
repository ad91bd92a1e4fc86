#pragma once

#include "src/gl/headless_context.hpp"
#include "src/render/adapted_volumes.hpp"
#include "tests/support/adapted_chain.hpp"

namespace edgeshade::test {

/// Reads back what the GL implementation computes for adapted records; see Probe.
class AdaptedProbe {
  public:
    AdaptedProbe();

    /// Uploads a batch; signs() is about it.
    void upload(const AdaptedShadow& shadow);

    AdaptedSigns signs(const glm::vec4& light, const glm::vec2& counted);

  private:
    static constexpr int side = 1024; ///< pixels of the square that points are drawn into

    std::vector<int> draw(gl::Program& program, const gl::Buffer& records,
                          const std::vector<int>& components, std::size_t count,
                          const glm::vec4& light, const glm::vec2& counted);

    gl::HeadlessContext context_;
    gl::Buffer pixels_; ///< centres of the square's pixels, row by row
    gl::Program pairsProgram_, singlesProgram_, capsProgram_;
    gl::Buffer pairs_, singles_, caps_;
    std::size_t pairCount_ = 0, singleCount_ = 0, capCount_ = 0;
};

} // namespace edgeshade::test
