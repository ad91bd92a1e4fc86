#include "src/city/geo_tiff.hpp"

#include "preprocess/base/error.hpp"

#ifdef EDGESHADE_HAS_GEOTIFF
#include "src/city/coordinate_system.hpp"
#include "src/city/tiff_memory.hpp"

#include <algorithm>
#endif

namespace edgeshade::city {
namespace {

constexpr std::int64_t tileSide = 256;

} // namespace

bool takesBigTiff(const CellRange& region, std::size_t bands) {
    const auto along = [](std::int64_t cells) {
        return static_cast<std::uint64_t>((cells + tileSide - 1) / tileSide);
    };
    constexpr std::uint64_t rest = std::uint64_t{1} << 20; // header, tags and names of bands
    constexpr std::uint64_t bytesOfEntry = 8;              // where a tile is, and its length
    const std::uint64_t tile = tileSide * tileSide * sizeof(float) * bands;
    // zlib's compressBound(): 5 bytes for each 16 kB, and more, that don't get smaller.
    const std::uint64_t deflated = tile + (tile >> 12) + (tile >> 14) + (tile >> 25) + 13;
    return along(region.columns()) * along(region.rows()) >
           ((std::uint64_t{1} << 32) - rest) / (deflated + bytesOfEntry);
}

#ifdef EDGESHADE_HAS_GEOTIFF

namespace {

/// GDAL's tag of band names, as XML.
constexpr ttag_t metadataTag = 42112;

void declareTags(TIFF* tiff) {
    static const TIFFFieldInfo fields[] = {{noDataTag, TIFF_VARIABLE, TIFF_VARIABLE, TIFF_ASCII,
                                            FIELD_CUSTOM, 1, 0, const_cast<char*>("GDAL_NODATA")},
                                           {metadataTag, TIFF_VARIABLE, TIFF_VARIABLE, TIFF_ASCII,
                                            FIELD_CUSTOM, 1, 0,
                                            const_cast<char*>("GDAL_METADATA")}};
    TIFFMergeFieldInfo(tiff, fields, 2);
}

void setBands(TIFF* tiff, std::span<const std::string> bands) {
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, static_cast<std::uint16_t>(bands.size()));
    if (bands.size() == 1) return;
    const std::vector<std::uint16_t> more(bands.size() - 1, EXTRASAMPLE_UNSPECIFIED);
    TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, static_cast<std::uint16_t>(more.size()), more.data());
    std::string names = "<GDALMetadata>";
    for (std::size_t i = 0; i < bands.size(); ++i)
        names += "<Item name=\"DESCRIPTION\" sample=\"" + std::to_string(i) +
                 "\" role=\"description\">" + bands[i] + "</Item>";
    TIFFSetField(tiff, metadataTag, (names + "</GDALMetadata>").c_str());
}

void setTags(TIFF* tiff, const CellRange& region, double grid) {
    declareTags(tiff);
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(region.columns()));
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(region.rows()));
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, static_cast<std::uint32_t>(tileSide));
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, static_cast<std::uint32_t>(tileSide));
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 32);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
    TIFFSetField(tiff, noDataTag, "-1");
    const double scale[] = {grid, grid, 0.0};
    TIFFSetField(tiff, TIFFTAG_GEOPIXELSCALE, 3, scale);
    const double tie[] = {0.0,
                          0.0,
                          0.0,
                          static_cast<double>(region.left) * grid,
                          static_cast<double>(region.top) * grid,
                          0.0};
    TIFFSetField(tiff, TIFFTAG_GEOTIEPOINTS, 6, tie);
}

void setKeys(TIFF* tiff, const std::optional<int>& epsg) {
    const GeoKeys keys(GTIFNew(tiff));
    GTIFKeySet(keys.get(), GTModelTypeGeoKey, TYPE_SHORT, 1, ModelTypeProjected);
    GTIFKeySet(keys.get(), GTRasterTypeGeoKey, TYPE_SHORT, 1, RasterPixelIsArea);
    if (epsg)
        GTIFKeySet(keys.get(), ProjectedCSTypeGeoKey, TYPE_SHORT, 1, horizontalSystemOf(*epsg));
    GTIFWriteKeys(keys.get());
}

} // namespace

class GeoTiffWriter::Writing {
  public:
    Writing(const std::filesystem::path& path, const Plan& plan, std::span<const std::string> bands)
        : region_(plan.region), bands_(bands.size()),
          tiff_(createTiff(path, takesBigTiff(plan.region, bands.size()))) {
        if (!tiff_) throw Error(ExitStatus::output, "'" + path.string() + "' can't be written.");
        setTags(tiff_.get(), region_, plan.grid);
        setBands(tiff_.get(), bands);
        setKeys(tiff_.get(), plan.epsg);
    }

    void add(std::span<const float> hours) {
        rows_.insert(rows_.end(), hours.begin(), hours.end());
        ++next_;
        if (next_ % tileSide == 0) writeTiles();
    }

    void finish() {
        if (!rows_.empty()) writeTiles();
        require(TIFFFlush(tiff_.get()) != 0);
        tiff_.reset();
    }

  private:
    /// Writes the rows that are held as tiles, filled up beyond the map.
    void writeTiles() {
        // Numbers along a row of the map, and of a tile.
        const std::size_t columns = bands_ * static_cast<std::size_t>(region_.columns()),
                          side = bands_ * static_cast<std::size_t>(tileSide);
        const std::size_t rows = rows_.size() / columns;
        const auto top = static_cast<std::uint32_t>(next_ - static_cast<std::int64_t>(rows));
        std::vector<float> tile;
        for (std::size_t left = 0; left < columns; left += side) {
            tile.assign(side * static_cast<std::size_t>(tileSide), noHours);
            const std::size_t width = std::min(side, columns - left);
            for (std::size_t y = 0; y < rows; ++y)
                std::copy_n(rows_.data() + y * columns + left, width, tile.data() + y * side);
            require(TIFFWriteTile(tiff_.get(), tile.data(),
                                  static_cast<std::uint32_t>(left / bands_), top, 0, 0) > 0);
        }
        rows_.clear();
    }

    void require(bool isWritten) const {
        if (!isWritten)
            throw Error(ExitStatus::output, "The GeoTIFF of " + std::to_string(region_.columns()) +
                                                " by " + std::to_string(region_.rows()) +
                                                " cells can't be written: the disk is full.");
    }

    CellRange region_;
    std::size_t bands_;
    TiffHandle tiff_;
    std::vector<float> rows_; ///< those of the tiles that are being filled
    std::int64_t next_ = 0;   ///< the row that comes next
};

GeoTiffWriter::GeoTiffWriter(const std::filesystem::path& path, const Plan& plan,
                             std::span<const std::string> bands)
    : writing_(std::make_unique<Writing>(path, plan, bands)) {}
void GeoTiffWriter::add(std::span<const float> hours) {
    writing_->add(hours);
}
void GeoTiffWriter::finish() {
    writing_->finish();
}

#else

class GeoTiffWriter::Writing {};

GeoTiffWriter::GeoTiffWriter(const std::filesystem::path&, const Plan&,
                             std::span<const std::string>) {
    throw Error(ExitStatus::unavailable,
                "city merge writes a GeoTIFF, but this program was built without libgeotiff.");
}
void GeoTiffWriter::add(std::span<const float>) {}
void GeoTiffWriter::finish() {}

#endif

GeoTiffWriter::~GeoTiffWriter() = default;

} // namespace edgeshade::city
