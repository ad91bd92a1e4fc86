#include "src/cli/tradeoff_settings.hpp"

#include <sstream>

namespace edgeshade::cli {

std::vector<TradeSetting> tradeSettings(int largestMap) {
    std::vector<TradeSetting> settings = {
        {"volumes", "shadows=volumes"},
        {"published", "shadows=volumes,layout=published"},
        {"three-edge", "shadows=volumes,multiplicity=three-edge"},
        {"single-edge", "shadows=volumes,multiplicity=single-edge"},
        {"one depth range", "shadows=volumes,depth-slices=1"},
        {"two depth slices", "shadows=volumes,depth-slices=2"},
        {"published, a draw a side", "shadows=volumes,layout=published,instancing=multi-draw"},
        {"not instanced", "shadows=volumes,instancing=off"},
        {"mask 1/2", "shadows=volumes,mask-scale=1/2"},
        {"mask 1/4", "shadows=volumes,mask-scale=1/4"},
        {"no shadows", "shadows=none"},
    };
    for (const int pcf : {1, 3})
        for (int size = 512; size <= std::min(largestMap, 8192); size *= 2) {
            std::string name = "map " + std::to_string(size);
            std::string text = "shadows=map,map-size=" + std::to_string(size);
            if (pcf > 1) {
                name += " pcf " + std::to_string(pcf);
                text += ",pcf=" + std::to_string(pcf);
            }
            settings.push_back({name, text});
        }
    return settings;
}

std::string asOptions(const std::string& text) {
    std::string options;
    std::istringstream parts(text);
    for (std::string part; std::getline(parts, part, ',');) {
        part[part.find('=')] = ' ';
        options += (options.empty() ? "--" : " --") + part;
    }
    return options;
}

} // namespace edgeshade::cli
