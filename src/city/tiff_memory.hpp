#pragma once

// A TIFF in memory, read or written by libtiff. Only sources include this.

#include "preprocess/base/file_io.hpp"

#include <geo_normalize.h>
#include <geotiff.h>
#include <geovalues.h>
#include <memory>
#include <xtiffio.h>

namespace edgeshade::city {

/// GDAL's tag of the value that means no data, as text.
inline constexpr ttag_t noDataTag = 42113;

/// Bytes with libtiff's position in them.
struct TiffMemory {
    Bytes bytes;
    std::size_t at = 0;
};

struct CloseTiff {
    void operator()(TIFF* tiff) const { XTIFFClose(tiff); }
};
using TiffHandle = std::unique_ptr<TIFF, CloseTiff>;

struct FreeKeys {
    void operator()(GTIF* keys) const { GTIFFree(keys); }
};
using GeoKeys = std::unique_ptr<GTIF, FreeKeys>;

/// Opens `memory`, which must outlive the handle; null: it is no TIFF. `mode`: "r" or "w".
TiffHandle openTiff(TiffMemory& memory, const char* mode);

} // namespace edgeshade::city
