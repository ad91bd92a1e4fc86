#pragma once

#include "preprocess/volumes/shadow_data.hpp"
#include "src/rivals/published/volume_program.hpp"
#include "tests/support/probe_points.hpp"

#include <map>

namespace edgeshade::test {

/// Reads back the numbers that the GL computes: one point per record, coloured with its
/// multiplicity or its sign, by the programs that draw the volumes.
class Probe {
  public:
    explicit Probe(MultiplicityMethod method);

    /// Uploads a batch, for later calls of multiplicities() and signs().
    void upload(const BatchShadow& shadow);

    /// One per record, in -5..5.
    std::vector<int> multiplicities(const glm::vec4& light);

    /// One per triangle, -1, 0 or 1.
    std::vector<int> signs(const glm::vec4& light);

  private:
    std::vector<int> draw(gl::Program& program, const gl::Buffer& records, std::size_t vectors,
                          std::size_t count, const glm::vec4& light);

    MultiplicityMethod method_;
    ProbePoints points_;
    std::map<int, gl::Program> sidesPrograms_;
    gl::Program capsProgram_;
    gl::Buffer sides_, caps_;
    int maxMultiplicity_ = 1;
    std::size_t sideCount_ = 0, capCount_ = 0;
};

} // namespace edgeshade::test
