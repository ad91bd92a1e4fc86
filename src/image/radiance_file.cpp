#include "src/image/radiance_file.hpp"

#include "preprocess/base/error.hpp"
#include "src/image/image.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace edgeshade {
namespace {

/// Width from which rows may be run-length encoded channel by channel.
constexpr int leastEncodedWidth = 8;

/// Removes a decimal number from the start of `text` and returns it; -1 if there is none.
int takeNumber(std::string_view& text) {
    int number = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) return -1;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

bool takeText(std::string_view& text, std::string_view start) {
    if (!text.starts_with(start)) return false;
    text.remove_prefix(start.size());
    return true;
}

} // namespace

RadianceFile::RadianceFile(std::span<const std::uint8_t> bytes, std::string name)
    : rest_(bytes), name_(std::move(name)) {
    readHeader();
    stored_.resize(static_cast<std::size_t>(width_));
    row_.resize(static_cast<std::size_t>(width_));
}

void RadianceFile::refuse(const std::string& what) const {
    throw InputError(name_ + " " + what + ".");
}

std::string RadianceFile::readLine() {
    const auto end = std::find(rest_.begin(), rest_.end(), std::uint8_t{'\n'});
    if (end == rest_.end()) refuse("ends within its header");
    std::string line(rest_.begin(), end);
    rest_ = rest_.subspan(line.size() + 1);
    if (line.ends_with('\r')) line.pop_back();
    return line;
}

void RadianceFile::readHeader() {
    const std::string_view text(reinterpret_cast<const char*>(rest_.data()), rest_.size());
    if (!text.starts_with("#?RADIANCE") && !text.starts_with("#?RGBE"))
        refuse("is not a Radiance picture (.hdr), which begins with #?RADIANCE");
    bool isRgbe = false;
    for (std::string line = readLine(); !line.empty(); line = readLine()) {
        if (line.starts_with("FORMAT=") && line != "FORMAT=32-bit_rle_rgbe")
            refuse("has " + line.substr(0, 40) + "; only 32-bit_rle_rgbe is read");
        isRgbe |= line.starts_with("FORMAT=");
    }
    if (!isRgbe) refuse("has no FORMAT=32-bit_rle_rgbe");
    readSize(readLine());
}

void RadianceFile::readSize(const std::string& line) {
    std::string_view text = line;
    bool isSize = takeText(text, "-Y ");
    height_ = takeNumber(text);
    isSize = isSize && takeText(text, " +X ");
    width_ = takeNumber(text);
    if (!isSize || height_ < 0 || width_ < 0 || !text.empty())
        refuse("has the size '" + line.substr(0, 40) + "'; only '-Y height +X width' is read");
    if (width_ == 0 || height_ == 0) refuse("has " + sizeText(width_, height_));
    if (width_ > largest || height_ > largest)
        refuse("has " + sizeText(width_, height_) + "; at most " + std::to_string(largest) +
               " a side are read");
}

std::uint8_t RadianceFile::readByte() {
    if (rest_.empty())
        refuse("ends within row " + std::to_string(rowsRead_) + " of " + std::to_string(height_));
    const std::uint8_t byte = rest_.front();
    rest_ = rest_.subspan(1);
    return byte;
}

bool RadianceFile::startsEncodedRow() const {
    return width_ >= leastEncodedWidth && rest_.size() >= 4 && rest_[0] == 2 && rest_[1] == 2 &&
           rest_[2] < 128;
}

void RadianceFile::readEncodedRow() {
    const int width = rest_[2] << 8 | rest_[3];
    if (width != width_)
        refuse("has " + std::to_string(width) + " pixels in row " + std::to_string(rowsRead_) +
               ", but is " + std::to_string(width_) + " wide");
    rest_ = rest_.subspan(4);
    for (int channel = 0; channel < 4; ++channel)
        for (int x = 0; x < width_;) {
            const int code = readByte();
            const bool repeats = code > 128;
            const int count = repeats ? code - 128 : code;
            if (count == 0 || count > width_ - x)
                refuse("has a run of " + std::to_string(count) + " pixels in row " +
                       std::to_string(rowsRead_) + ", where " + std::to_string(width_ - x) +
                       " are left");
            std::uint8_t value = repeats ? readByte() : std::uint8_t{0};
            for (const int end = x + count; x < end; ++x) {
                if (!repeats) value = readByte();
                stored_[static_cast<std::size_t>(x)][channel] = value;
            }
        }
}

void RadianceFile::readFlatRow() {
    int digits = 0; // digits of a run's length, 8 bits each, lowest first
    for (std::size_t x = 0; x < stored_.size();) {
        Rgbe pixel;
        for (int channel = 0; channel < 4; ++channel)
            pixel[channel] = readByte();
        if (glm::vec<3, std::uint8_t>(pixel) != glm::vec<3, std::uint8_t>(1)) {
            stored_[x++] = pixel;
            digits = 0;
            continue;
        }
        // The old encoding: (1, 1, 1, n) repeats the previous pixel.
        const std::size_t count = digits < 4 ? std::size_t{pixel[3]} << (8 * digits) : 0;
        if (x == 0 || digits == 4 || count > stored_.size() - x)
            refuse("has a run in row " + std::to_string(rowsRead_) +
                   " that does not fit between its pixels");
        std::fill_n(stored_.begin() + static_cast<std::ptrdiff_t>(x), count, stored_[x - 1]);
        x += count;
        ++digits;
    }
}

std::span<const glm::vec3> RadianceFile::readRow() {
    if (startsEncodedRow())
        readEncodedRow();
    else
        readFlatRow();
    ++rowsRead_;
    constexpr int exponentBias = 128 + 8; // mantissas are fractions of 256
    std::transform(stored_.begin(), stored_.end(), row_.begin(), [](const Rgbe& pixel) {
        return pixel[3] == 0 ? glm::vec3(0.0f)
                             : glm::vec3(pixel) * std::ldexp(1.0f, pixel[3] - exponentBias);
    });
    return row_;
}

} // namespace edgeshade
