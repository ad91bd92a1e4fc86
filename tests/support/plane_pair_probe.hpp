#pragma once

#include "src/render/volumes/plane_pair_volumes.hpp"
#include "tests/support/plane_pair_chain.hpp"
#include "tests/support/probe_points.hpp"

namespace edgeshade::test {

/// Reads back the results of the GL for plane-pair records; see Probe.
class PlanePairProbe {
  public:
    PlanePairProbe();

    /// Uploads a batch, for later calls of signs().
    void upload(const PlanePairShadow& shadow);

    PlanePairSigns signs(const glm::vec4& light, const glm::vec2& counted);

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
