#include "src/city/surface_raster.hpp"

#include "preprocess/base/error.hpp"
#include "src/city/tile_writer.hpp"

#ifdef EDGESHADE_HAS_GEOTIFF
#include "src/city/tiff_memory.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#endif

namespace edgeshade::city {

#ifdef EDGESHADE_HAS_GEOTIFF

namespace {

constexpr std::uint64_t mostPixels = std::uint64_t{1} << 26;

/// Heights row by row from the north, NaN without data.
struct Heights {
    std::uint32_t columns = 0, rows = 0;
    double west = 0.0, north = 0.0;   ///< of the first pixel's corner
    double width = 1.0, height = 1.0; ///< of a pixel, in metres
    std::vector<double> values;

    double at(std::int64_t row, std::int64_t column) const {
        return values[static_cast<std::size_t>(row) * columns + static_cast<std::size_t>(column)];
    }
};

class RasterReading {
  public:
    RasterReading(const Bytes& bytes, const std::filesystem::path& path)
        : path_(path), memory_{bytes, 0}, tiff_(openTiff(memory_)) {
        if (!tiff_) fail("is not a TIFF, or is cut short");
    }

    Heights heights() {
        Heights heights;
        TIFFGetField(tiff_.get(), TIFFTAG_IMAGEWIDTH, &heights.columns);
        TIFFGetField(tiff_.get(), TIFFTAG_IMAGELENGTH, &heights.rows);
        if (heights.columns < 1 || heights.rows < 1 ||
            std::uint64_t{heights.columns} * heights.rows > mostPixels)
            fail("has " + std::to_string(heights.columns) + " by " + std::to_string(heights.rows) +
                 " pixels, but must have from 1 to 2^26");
        place(heights);
        readSamples(heights);
        return heights;
    }

    std::optional<int> epsg() {
        const GeoKeys keys(GTIFNew(tiff_.get()));
        unsigned short code = 0;
        if (!keys || GTIFKeyGetSHORT(keys.get(), ProjectedCSTypeGeoKey, &code, 0, 1) != 1 ||
            code == 0 || code == KvUserDefined)
            return std::nullopt;
        return code;
    }

  private:
    [[noreturn]] void fail(const std::string& what) const {
        throw InputError("'" + path_.string() + "' " + what + ".");
    }

    void place(Heights& heights) {
        std::uint16_t count = 0;
        const double* scale = nullptr;
        if (!TIFFGetField(tiff_.get(), TIFFTAG_GEOPIXELSCALE, &count, &scale) || count < 2 ||
            !(scale[0] > 0.0 && scale[1] > 0.0))
            fail("has no GeoTIFF pixel scale; only rasters along the axes are read");
        heights.width = scale[0];
        heights.height = scale[1];
        const double* tie = nullptr;
        if (!TIFFGetField(tiff_.get(), TIFFTAG_GEOTIEPOINTS, &count, &tie) || count < 6)
            fail("has no GeoTIFF tie point");
        heights.west = tie[3] - tie[0] * heights.width;
        heights.north = tie[4] + tie[1] * heights.height;
        const GeoKeys keys(GTIFNew(tiff_.get()));
        unsigned short type = 0;
        if (keys && GTIFKeyGetSHORT(keys.get(), GTRasterTypeGeoKey, &type, 0, 1) == 1 &&
            type == RasterPixelIsPoint) {
            heights.west -= 0.5 * heights.width;
            heights.north += 0.5 * heights.height;
        }
    }

    std::optional<double> noData() {
        const TIFFField* const known = TIFFFindField(tiff_.get(), noDataTag, TIFF_ANY);
        const char* text = nullptr;
        std::uint32_t length = 0;
        const bool found = known && (TIFFFieldPassCount(known)
                                         ? TIFFGetField(tiff_.get(), noDataTag, &length, &text)
                                         : TIFFGetField(tiff_.get(), noDataTag, &text));
        if (!found || !text) return std::nullopt;
        double value = 0.0;
        const auto read = std::from_chars(text, text + std::strlen(text), value);
        if (read.ec != std::errc()) return std::nullopt;
        return value;
    }

    /// Puts one sample into a height.
    double sampleAt(const std::uint8_t* from) const {
        const auto as = [&](auto value) {
            std::memcpy(&value, from, sizeof value);
            return static_cast<double>(value);
        };
        if (format_ == SAMPLEFORMAT_IEEEFP) return bits_ == 32 ? as(float()) : as(double());
        if (format_ == SAMPLEFORMAT_INT)
            return bits_ == 16 ? as(std::int16_t()) : as(std::int32_t());
        return bits_ == 16 ? as(std::uint16_t()) : as(std::uint32_t());
    }

    void readSamples(Heights& heights) {
        std::uint16_t bands = 1;
        TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_BITSPERSAMPLE, &bits_);
        TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_SAMPLESPERPIXEL, &bands);
        TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_SAMPLEFORMAT, &format_);
        const bool isFloat = format_ == SAMPLEFORMAT_IEEEFP;
        const bool isWhole = format_ == SAMPLEFORMAT_INT || format_ == SAMPLEFORMAT_UINT;
        if (bands != 1 || !((isFloat && (bits_ == 32 || bits_ == 64)) ||
                            (isWhole && (bits_ == 16 || bits_ == 32))))
            fail("has " + std::to_string(bands) + " bands of " + std::to_string(bits_) +
                 " bits, but must have one of 16- or 32-bit integers or of floats");
        const std::optional<double> none = noData();
        heights.values.assign(std::size_t{heights.columns} * heights.rows,
                              std::numeric_limits<double>::quiet_NaN());
        const bool isTiled = TIFFIsTiled(tiff_.get()) != 0;
        std::uint32_t width = heights.columns, length = heights.rows;
        if (isTiled) {
            TIFFGetField(tiff_.get(), TIFFTAG_TILEWIDTH, &width);
            TIFFGetField(tiff_.get(), TIFFTAG_TILELENGTH, &length);
        } else {
            TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_ROWSPERSTRIP, &length);
            length = std::min(length, heights.rows);
        }
        const std::uint64_t size = std::uint64_t{width} * length * (bits_ / 8);
        if (width < 1 || length < 1 || width > 65536 || size > 8 * mostPixels)
            fail("has parts of " + std::to_string(width) + " by " + std::to_string(length) +
                 " pixels, which are too large");
        Bytes part(size);
        for (std::uint32_t top = 0; top < heights.rows; top += length)
            for (std::uint32_t left = 0; left < heights.columns; left += width) {
                const std::uint32_t rows = std::min(length, heights.rows - top);
                const auto wanted = static_cast<tmsize_t>(
                    isTiled ? size : std::uint64_t{width} * rows * (bits_ / 8));
                const tmsize_t got =
                    isTiled
                        ? TIFFReadTile(tiff_.get(), part.data(), left, top, 0, 0)
                        : TIFFReadEncodedStrip(tiff_.get(), TIFFComputeStrip(tiff_.get(), top, 0),
                                               part.data(), wanted);
                if (got < wanted)
                    fail("is broken or cut short: pixels from row " + std::to_string(top) +
                         " can't be read");
                for (std::uint32_t y = 0; y < rows; ++y)
                    for (std::uint32_t x = 0; x < std::min(width, heights.columns - left); ++x) {
                        const double value =
                            sampleAt(part.data() + (std::size_t{y} * width + x) * (bits_ / 8));
                        if (none != value && std::isfinite(value))
                            heights.values[std::size_t{top + y} * heights.columns + left + x] =
                                value;
                    }
            }
    }

    const std::filesystem::path& path_;
    TiffMemory memory_;
    TiffHandle tiff_;
    std::uint16_t bits_ = 0, format_ = 0;
};

/// Triangles between the middles of pixels, and out to the raster's edge.
class Triangulation {
  public:
    Triangulation(const Heights& heights, CityTile& tile, std::string where)
        : heights_(heights), writer_(tile), where_(std::move(where)),
          object_(writer_.addObject("surface", false)) {
        for (const double value : heights.values)
            if (value < lowest_) lowest_ = value;
    }

    void add() {
        for (std::int64_t row = -1; row < rows(); ++row)
            for (std::int64_t column = -1; column < columns(); ++column)
                addSquare(row, column);
        for (std::int64_t column = -1; column < columns(); ++column) {
            addWall(-1, column + 1, -1, column);
            addWall(rows(), column, rows(), column + 1);
        }
        for (std::int64_t row = -1; row < rows(); ++row) {
            addWall(row, -1, row + 1, -1);
            addWall(row + 1, columns(), row, columns());
        }
    }

  private:
    std::int64_t rows() const { return heights_.rows; }
    std::int64_t columns() const { return heights_.columns; }

    /// A corner of the surface: a pixel's middle, or for -1 and the count the raster's edge.
    glm::dvec3 corner(std::int64_t row, std::int64_t column) const {
        const auto along = [](std::int64_t i, std::int64_t count) {
            return std::clamp(static_cast<double>(i) + 0.5, 0.0, static_cast<double>(count));
        };
        const std::int64_t y = std::clamp<std::int64_t>(row, 0, rows() - 1),
                           x = std::clamp<std::int64_t>(column, 0, columns() - 1);
        return {heights_.west + along(column, columns()) * heights_.width,
                heights_.north - along(row, rows()) * heights_.height, heights_.at(y, x)};
    }

    /// The square between a corner and the next row and column, unless a height is missing.
    void addSquare(std::int64_t row, std::int64_t column) {
        const glm::dvec3 a = corner(row, column), b = corner(row, column + 1),
                         c = corner(row + 1, column), d = corner(row + 1, column + 1);
        if (std::isnan(a.z + b.z + c.z + d.z)) return;
        addTriangle({a, c, b});
        addTriangle({b, c, d});
    }

    /// The wall below an edge, which runs with the surface on its left.
    void addWall(std::int64_t row, std::int64_t column, std::int64_t toRow, std::int64_t toColumn) {
        const glm::dvec3 a = corner(row, column), b = corner(toRow, toColumn);
        if (std::isnan(a.z + b.z)) return;
        const glm::dvec3 below(a.x, a.y, lowest_), belowNext(b.x, b.y, lowest_);
        addTriangle({below, belowNext, b});
        addTriangle({below, b, a});
    }

    void addTriangle(const std::array<glm::dvec3, 3>& corners) {
        writer_.addTriangle(corners, object_, SurfaceKind::none, where_);
    }

    const Heights& heights_;
    TileWriter writer_;
    std::string where_;
    std::uint32_t object_;
    double lowest_ = std::numeric_limits<double>::infinity();
};

} // namespace

CityTile tileFromRaster(const Bytes& bytes, const std::filesystem::path& path) {
    RasterReading reading(bytes, path);
    CityTile tile;
    const Heights heights = reading.heights();
    tile.epsg = reading.epsg();
    Triangulation(heights, tile, "'" + path.string() + "'").add();
    return tile;
}

#else

CityTile tileFromRaster(const Bytes&, const std::filesystem::path& path) {
    throw Error(ExitStatus::unavailable, "'" + path.string() +
                                             "' is a raster, but this program was built without "
                                             "libgeotiff.");
}

#endif

} // namespace edgeshade::city
