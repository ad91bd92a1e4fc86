#pragma once

#include <array>
#include <map>
#include <string>
#include <utility>

namespace edgeshade::test {

/// The text of an EnergyPlus weather file of a made-up station. The direct normal radiation of the
/// n-th hour, from 0, is n % 1000 Wh/m².
struct WeatherText {
    std::string location = "LOCATION,Testville,-,UTO,made up,000000,48.14,11.57,1.0,520.0";
    bool leap = false;
    std::string lineEnd = "\n";

    /// Replaces a field of the n-th hour, both from 0; field 14 is direct normal radiation.
    void setField(std::size_t hour, std::size_t field, const std::string& value) {
        fields_[{hour, field}] = value;
    }

    std::string text() const {
        std::string all = location + lineEnd;
        for (const char* line :
             {"DESIGN CONDITIONS,0", "TYPICAL/EXTREME PERIODS,0", "GROUND TEMPERATURES,0",
              "HOLIDAYS/DAYLIGHT SAVINGS,No,0,0,0", "COMMENTS 1,made up", "COMMENTS 2,",
              "DATA PERIODS,1,1,Data,Sunday, 1/ 1,12/31"})
            all += line + lineEnd;
        constexpr std::array days = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
        std::size_t number = 0;
        for (std::size_t month = 0; month < 12; ++month)
            for (int day = 1; day <= days[month] + (leap && month == 1); ++day)
                for (int hour = 1; hour <= 24; ++hour)
                    addHour(number++, {1999, static_cast<int>(month) + 1, day, hour}, all);
        return all;
    }

  private:
    void addHour(std::size_t number, const std::array<int, 4>& time, std::string& all) const {
        for (std::size_t field = 0; field < 35; ++field) {
            std::string value = field < 4 ? std::to_string(time[field]) : field == 5 ? "?9?9" : "0";
            if (field == 14) value = std::to_string(number % 1000);
            const auto found = fields_.find({number, field});
            if (found != fields_.end()) value = found->second;
            all += (field == 0 ? "" : ",") + value;
        }
        all += lineEnd;
    }

    std::map<std::pair<std::size_t, std::size_t>, std::string> fields_; ///< by hour and field
};

} // namespace edgeshade::test
