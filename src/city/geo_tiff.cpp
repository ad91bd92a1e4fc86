#include "src/city/geo_tiff.hpp"

#include "preprocess/base/error.hpp"

#ifdef EDGESHADE_HAS_GEOTIFF
#include "src/city/coordinate_system.hpp"
#include "src/city/tiff_memory.hpp"
#endif

namespace edgeshade::city {

#ifdef EDGESHADE_HAS_GEOTIFF

namespace {

constexpr std::int64_t tileSide = 256;
constexpr float noData = -1.0f;

void declareNoData(TIFF* tiff) {
    static const TIFFFieldInfo field[] = {{noDataTag, TIFF_VARIABLE, TIFF_VARIABLE, TIFF_ASCII,
                                           FIELD_CUSTOM, 1, 0, const_cast<char*>("GDAL_NODATA")}};
    TIFFMergeFieldInfo(tiff, field, 1);
}

void setTags(TIFF* tiff, const CellRange& region, double grid) {
    declareNoData(tiff);
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(region.columns()));
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(region.rows()));
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, static_cast<std::uint32_t>(tileSide));
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, static_cast<std::uint32_t>(tileSide));
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 32);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
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

Bytes geoTiffOf(const CityMap& map, const Plan& plan) {
    TiffMemory memory;
    TiffHandle tiff = openTiff(memory, "w");
    bool isWritten = tiff != nullptr;
    if (isWritten) {
        setTags(tiff.get(), map.region, plan.grid);
        setKeys(tiff.get(), plan.epsg);
        const std::int64_t columns = map.region.columns(), rows = map.region.rows();
        std::vector<float> tile(tileSide * tileSide);
        for (std::int64_t top = 0; top < rows; top += tileSide)
            for (std::int64_t left = 0; left < columns; left += tileSide) {
                for (std::int64_t y = 0; y < tileSide; ++y)
                    for (std::int64_t x = 0; x < tileSide; ++x) {
                        const bool isIn = top + y < rows && left + x < columns;
                        const std::int32_t lit =
                            isIn ? map.lit[static_cast<std::size_t>((top + y) * columns + left + x)]
                                 : CityMap::nothing;
                        tile[static_cast<std::size_t>(y * tileSide + x)] =
                            lit == CityMap::nothing ? noData : static_cast<float>(map.hoursOf(lit));
                    }
                isWritten = isWritten &&
                            TIFFWriteTile(tiff.get(), tile.data(), static_cast<std::uint32_t>(left),
                                          static_cast<std::uint32_t>(top), 0, 0) > 0;
            }
        isWritten = TIFFFlush(tiff.get()) != 0 && isWritten;
        tiff.reset();
    }
    if (!isWritten)
        throw Error(ExitStatus::output, "The GeoTIFF of " + std::to_string(map.region.columns()) +
                                            " by " + std::to_string(map.region.rows()) +
                                            " cells can't be made: it exceeds TIFF's 4 GiB.");
    return std::move(memory.bytes);
}

#else

Bytes geoTiffOf(const CityMap&, const Plan&) {
    throw Error(ExitStatus::unavailable,
                "city merge writes a GeoTIFF, but this program was built without libgeotiff.");
}

#endif

} // namespace edgeshade::city
