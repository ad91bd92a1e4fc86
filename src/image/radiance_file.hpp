#pragma once

#include "preprocess/base/file_io.hpp"

#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

namespace edgeshade {

/// Reads a Radiance picture (.hdr; RGBE, flat or run-length encoded), row by row from the top. Safe
/// on untrusted input: it keeps one row, and its time is bounded by the file's bytes. stb_image, up
/// to 2.27, never ends on some truncated files. XYZE, and pictures whose rows don't start at the
/// top left, are refused. EXPOSURE and COLORCORR are not applied.
class RadianceFile {
  public:
    static constexpr int largest = 16384; ///< pixels along an edge

    /// Reads the header. `bytes` must outlive this; `name` is for messages. Throws InputError.
    RadianceFile(std::span<const std::uint8_t> bytes, std::string name);

    int width() const { return width_; }
    int height() const { return height_; }

    /// The next row, linear RGB, finite and 0 or more; valid until the next call. May be called
    /// height() times. Throws InputError.
    std::span<const glm::vec3> readRow();

  private:
    using Rgbe = glm::vec<4, std::uint8_t>;

    [[noreturn]] void refuse(const std::string& what) const;
    std::string readLine();
    void readHeader();
    void readSize(const std::string& line);
    std::uint8_t readByte();
    bool startsEncodedRow() const;
    void readEncodedRow();
    void readFlatRow();

    std::span<const std::uint8_t> rest_; ///< not read yet
    std::string name_;
    int width_ = 0, height_ = 0;
    int rowsRead_ = 0;
    std::vector<Rgbe> stored_;
    std::vector<glm::vec3> row_;
};

} // namespace edgeshade
