#pragma once

// TIFFs that libtiff reads from memory, or writes into files. Only sources include this.

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

/// Opens `memory`, which must outlive the handle, for reading; null: it is no TIFF.
TiffHandle openTiff(TiffMemory& memory);
/// Makes a new file, a BigTIFF or one of at most 4 GiB; null: it can't be written.
TiffHandle createTiff(const std::filesystem::path& path, bool isBig);

} // namespace edgeshade::city
