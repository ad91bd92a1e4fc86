#!/usr/bin/python3
"""city_raster.py EDGESHADE MAKE_CITY: hours of sun on a surface raster by `edgeshade city`, by GRASS r.sun with and
without r.horizon, and by a march along rays over the raster's bilinear surface with a sun of its own. Prints how
much the first three differ from the last. Takes GRASS and Debian's python3-gdal.
"""

import math
import os
import pathlib
import struct
import subprocess
import sys
import tempfile

from osgeo import gdal

SIDE = 256  # cells and pixels of 1 m
LATITUDE, LONGITUDE, NORTH = 48.13, 11.57, -1.915  # of the raster's middle; NORTH as `city plan` finds it
DAY, STEP = 79, 10  # 20 March, minutes
MARCH = 0.3  # metres from one height to the next

GRASS = f"""
r.in.gdal -o input=tiles/surface-1.tif output=dsm --quiet
g.region raster=dsm
r.slope.aspect elevation=dsm slope=slope aspect=aspect --quiet
r.sun elevation=dsm slope=slope aspect=aspect day={DAY} step=0.1667 insol_time=hours distance_step=0.5 nprocs=1 --quiet
r.horizon elevation=dsm step=5 output=horizon maxdistance=500 distance=0.5 --quiet
r.sun elevation=dsm slope=slope aspect=aspect horizon_basename=horizon horizon_step=5 day={DAY} step=0.1667 \\
    insol_time=hours_horizon nprocs=1 --quiet
r.out.gdal -f input=hours output=r.sun.tif format=GTiff type=Float32 --quiet
r.out.gdal -f input=hours_horizon output=r.horizon.tif format=GTiff type=Float32 --quiet
"""


def read(path):
    raster = gdal.Open(path)  # owns its band
    return struct.unpack(f"{SIDE * SIDE}f", raster.GetRasterBand(1).ReadRaster(buf_type=gdal.GDT_Float32))


def sun(minute):
    """Altitude and azimuth from the raster's north, in radians, by Spencer 1971."""
    g = 2 * math.pi / 365 * (DAY - 1 + minute / 1440)
    declination = (0.006918 - 0.399912 * math.cos(g) + 0.070257 * math.sin(g) - 0.006758 * math.cos(2 * g)
                   + 0.000907 * math.sin(2 * g))
    equation = 229.18 * (0.000075 + 0.001868 * math.cos(g) - 0.032077 * math.sin(g) - 0.014615 * math.cos(2 * g)
                         - 0.040849 * math.sin(2 * g))
    hour = math.radians((minute + equation + 4 * LONGITUDE) / 4 - 180)
    latitude = math.radians(LATITUDE)
    altitude = math.asin(math.sin(latitude) * math.sin(declination)
                         + math.cos(latitude) * math.cos(declination) * math.cos(hour))
    azimuth = math.atan2(-math.sin(hour), math.tan(declination) * math.cos(latitude)
                         - math.sin(latitude) * math.cos(hour))
    return altitude, azimuth + math.radians(NORTH)


def marched_hours(heights, x, y, suns):
    def height(px, py):
        column, row = min(int(px), SIDE - 2), min(int(py), SIDE - 2)
        u, v, at = px - column, py - row, row * SIDE + column
        return ((heights[at] * (1 - u) + heights[at + 1] * u) * (1 - v)
                + (heights[at + SIDE] * (1 - u) + heights[at + SIDE + 1] * u) * v)

    top, lit = max(heights), 0
    for altitude, azimuth in suns:
        east, south, rise = math.sin(azimuth), -math.cos(azimuth), math.tan(altitude)
        start, way = heights[y * SIDE + x] + 0.02, MARCH
        while True:
            px, py, ray = x + east * way, y + south * way, start + rise * way
            if not (0 <= px <= SIDE - 1 and 0 <= py <= SIDE - 1) or ray > top:
                lit += 1
                break
            if height(px, py) > ray:
                break
            way += MARCH
    return lit * STEP / 60


def main():
    edgeshade, make_city = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)

        def run(*words):
            subprocess.run([str(word) for word in words], check=True, stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL)

        run(make_city, "tiles", "raster", 3, 4, 2, 30, 1)
        run(edgeshade, "city", "plan", "tiles", "--date", "2026-03-20", "--step", STEP, "--min-altitude", 0, "-o",
            "plan.json")
        run(edgeshade, "city", "run", "plan.json", "--job", 1)
        run(edgeshade, "city", "merge", "plan.json", "-o", "map")
        pathlib.Path("grass.sh").write_text("set -e\n" + GRASS)
        os.environ["PATH"] = "/usr/bin:" + os.environ["PATH"]  # GRASS takes Debian's Python
        run("grass", "-c", "tiles/surface-1.tif", "location", "--exec", "bash", "grass.sh")
        heights = read("tiles/surface-1.tif")
        suns = [at for at in map(sun, range(STEP // 2, 1440, STEP)) if at[0] > 0]
        cells = [(x, y) for y in range(2, SIDE - 2, 23) for x in range(2, SIDE - 2, 19)]
        marched = [marched_hours(heights, x, y, suns) for x, y in cells]
        for name, path in (("city", "map/hours.tif"), ("r.sun", "r.sun.tif"), ("r.sun, r.horizon", "r.horizon.tif")):
            hours = read(path)
            off = [hours[y * SIDE + x] - known for (x, y), known in zip(cells, marched)]
            off = [value for value in off if not math.isnan(value)]
            print(f"{name}: {len(off)} cells, mean {sum(off) / len(off):+.2f} h; "
                  + ", ".join(f"within {most} h {100 * sum(abs(v) <= most for v in off) / len(off):.0f} %"
                              for most in (0.17, 0.5, 1, 2)))


if __name__ == "__main__":
    main()
