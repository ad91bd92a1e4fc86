#include "src/city/detail_files.hpp"

#include "preprocess/base/error.hpp"
#include "src/city/city_hours.hpp"
#include "src/hours/surfaces/npy_header.hpp"

namespace edgeshade::city {
namespace {

const std::array<std::string, monthsOfYear>& monthNames() {
    static const std::array<std::string, monthsOfYear> names = {
        "January", "February", "March",     "April",   "May",      "June",
        "July",    "August",   "September", "October", "November", "December"};
    return names;
}

} // namespace

MonthsFile::MonthsFile(const std::filesystem::path& path, const Plan& plan)
    : hoursOfPosition_(hoursOfPosition(plan)), writer_(path, plan, monthNames()) {}

void MonthsFile::add(const MapRow& row) {
    std::vector<float> hours;
    hours.reserve(row.months.size());
    for (std::size_t i = 0; i < row.months.size(); ++i)
        hours.push_back(row.lit[i / monthsOfYear] == nothing
                            ? noHours
                            : static_cast<float>(row.months[i] * hoursOfPosition_));
    writer_.add(hours);
}

BitsFile::BitsFile(const std::filesystem::path& path, const Plan& plan)
    : path_(path), file_(path, std::ios::binary) {
    file_ << hours::npyHeaderOf(
        std::array{static_cast<std::size_t>(plan.region.rows()),
                   static_cast<std::size_t>(plan.region.columns()),
                   hours::bytesOfRow(hours::positionsOf(plan.schedule).size())});
    require();
}

void BitsFile::add(const MapRow& row) {
    file_.write(reinterpret_cast<const char*>(row.bits.data()),
                static_cast<std::streamsize>(row.bits.size()));
    require();
}

void BitsFile::finish() {
    file_.flush();
    require();
}

void BitsFile::require() const {
    if (!file_) throw Error(ExitStatus::output, "'" + path_.string() + "' can't be written.");
}

} // namespace edgeshade::city
