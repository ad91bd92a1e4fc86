#pragma once

#include "src/render/volumes/adapted_volumes.hpp"
#include "tests/support/adapted_chain.hpp"
#include "tests/support/probe_points.hpp"

namespace edgeshade::test {

/// Reads back what the GL implementation computes for adapted records; see Probe.
class AdaptedProbe {
  public:
    AdaptedProbe();

    /// Uploads a batch; signs() is about it.
    void upload(const AdaptedShadow& shadow);

    AdaptedSigns signs(const glm::vec4& light, const glm::vec2& counted);

  private:
    std::vector<int> draw(gl::Program& program, const gl::Buffer& records,
                          const std::vector<int>& components, std::size_t count,
                          const glm::vec4& light, const glm::vec2& counted);

    ProbePoints points_;
    gl::Program pairsProgram_, singlesProgram_, capsProgram_;
    gl::Buffer pairs_, singles_, caps_;
    std::size_t pairCount_ = 0, singleCount_ = 0, capCount_ = 0;
};

} // namespace edgeshade::test
