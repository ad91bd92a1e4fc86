// make_city FOLDER FORMAT SEED TILES BLOCKS HILLS ROOFS: writes a generated city, TILES by TILES
// tiles of BLOCKS by BLOCKS blocks of 32 m. FORMAT: cityjson, cityjsonseq, gltf, 3dtiles or raster.

#include "tests/city/generated_city.hpp"

#include <cstdio>
#include <cstdlib>
#include <string_view>

int main(int argc, char** argv) {
    if (argc != 8) {
        std::fputs("make_city FOLDER FORMAT SEED TILES BLOCKS HILLS ROOFS\n", stderr);
        return 1;
    }
    edgeshade::city::GeneratedCity city;
    const std::filesystem::path folder = argv[1];
    const std::string_view format = argv[2];
    city.seed = static_cast<std::uint32_t>(std::atoi(argv[3]));
    city.tiles = std::atoi(argv[4]);
    city.blocks = std::atoi(argv[5]);
    city.hills = std::atof(argv[6]);
    city.roofs = std::atoi(argv[7]);
    std::filesystem::create_directories(folder);
    if (format == "cityjson")
        city.writeCityJson(folder);
    else if (format == "cityjsonseq")
        city.writeCityJsonSequence(folder);
    else if (format == "gltf")
        city.writeGltf(folder);
    else if (format == "3dtiles")
        city.writeTileset(folder, {48.14, 11.57});
    else if (format == "raster")
        city.writeRaster(folder, 1.0);
    else
        return 1;
    std::printf("%zu\n", city.triangles());
    return 0;
}
