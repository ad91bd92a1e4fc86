#!/usr/bin/env python3
"""read_back.py EDGESHADE MAKE_CITY: opens the files of `city merge` with GDAL, without any code of this
program, and lets the program read a BigTIFF of GDAL's. Skipped (77) without GDAL's Python."""

import json
import os
import subprocess
import sys
import tempfile

try:
    from osgeo import gdal
except ImportError:
    # Debian's packages belong to Debian's own Python.
    debian = "/usr/bin/python3"
    if os.path.exists(debian) and os.path.realpath(sys.executable) != os.path.realpath(debian):
        os.execv(debian, [debian, *sys.argv])
    sys.exit(77)

edgeshade, make_city = sys.argv[1:]
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)

    def run(*words):
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    run(make_city, "tiles", "cityjson", "2", "3", "1", "15", "1")
    run(edgeshade, "city", "plan", "tiles", "--from", "2026-06-30", "--to", "2026-07-01", "--step", "60", "--tiles",
        "4", "--months", "--bits", "-o", "plan.json")
    jobs = json.load(open("plan.json"))["jobs"]
    for job in range(1, len(jobs) + 1):
        run(edgeshade, "city", "run", "plan.json", "--job", str(job))
    run(edgeshade, "city", "merge", "plan.json", "-o", "map")
    report = json.load(open("map/report.json"))

    gdal.UseExceptions()
    raster = gdal.Open("map/hours.tif")
    band = raster.GetRasterBand(1)
    assert (raster.RasterXSize, raster.RasterYSize) == (96, 96)
    assert raster.GetGeoTransform() == (691200.0, 1.0, 0.0, 5334112.0, 0.0, -1.0)
    assert raster.GetSpatialRef().GetAuthorityCode(None) == "25832"
    assert band.GetBlockSize() == [256, 256] and band.GetNoDataValue() == -1
    low, high, mean, _ = band.ComputeStatistics(False)
    hours = report["hours"]
    assert low == hours["min"] and high == hours["max"], (low, high, hours)
    assert abs(mean - hours["mean"]) < 1e-4
    months = gdal.Open("map/months.tif")
    assert months.RasterCount == 12 and months.GetGeoTransform() == raster.GetGeoTransform()
    assert months.GetRasterBand(7).GetDescription() == "July"
    means = [months.GetRasterBand(month + 1).ComputeStatistics(False)[2] for month in range(12)]
    assert abs(sum(means) - mean) < 1e-3 and [m > 0 for m in means] == [m in (5, 6) for m in range(12)], means
    try:
        import numpy
    except ImportError:
        numpy = None
    if numpy:
        bits = numpy.unpackbits(numpy.load("map/bits.npy"), axis=2, count=report["positions"])
        assert (bits.sum(axis=2) == raster.ReadAsArray()).all()
    gdal.Translate("map/cog.tif", raster, format="COG")
    assert gdal.Open("map/cog.tif").GetMetadataItem("LAYOUT", "IMAGE_STRUCTURE") == "COG"
    preview = gdal.Open("map/preview.png")
    assert (preview.RasterXSize, preview.RasterYSize) == (96, 96)
    table = gdal.OpenEx("map/objects.csv")  # owns its layer
    assert sum(int(row.GetField("cells")) for row in table.GetLayer(0)) == report["cells_with_surface"]

    # The same heights as a TIFF and as a BigTIFF.
    run(make_city, "rasters", "raster", "2", "1", "2", "15", "1")
    (name,) = [file for file in os.listdir("rasters") if file.endswith(".tif")]
    os.mkdir("big")
    gdal.Translate(f"big/{name}", f"rasters/{name}", creationOptions=["BIGTIFF=YES", "TILED=YES"])
    headers = [open(f"{tiles}/{name}", "rb").read(4) for tiles in ("rasters", "big")]
    assert headers == [b"II*\0", b"II+\0"], headers
    for tiles in ("rasters", "big"):
        run(edgeshade, "city", "plan", tiles, "--place", "48.14,11.57", "--date", "2026-06-30", "--step", "60", "-o",
            f"{tiles}.json")
        run(edgeshade, "city", "run", f"{tiles}.json", "--job", "1")
        run(edgeshade, "city", "merge", f"{tiles}.json", "-o", f"{tiles}-map")
    assert open("rasters-map/hours.tif", "rb").read() == open("big-map/hours.tif", "rb").read()
print("read back")
