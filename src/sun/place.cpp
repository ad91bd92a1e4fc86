#include "src/sun/place.hpp"

#include "preprocess/base/error.hpp"

#include <cmath>
#include <sstream>

namespace edgeshade::sun {
namespace {

void requireWithin(double value, double limit, const char* name) {
    if (std::abs(value) <= limit) return;
    std::ostringstream sentence;
    sentence << value << " is not a valid " << name << ": it is not between -" << limit << " and "
             << limit << " degrees";
    throw Error(ExitStatus::usage, sentence.str());
}

} // namespace

Place placeAt(double latitude, double longitude) {
    requireWithin(latitude, 90.0, "latitude");
    requireWithin(longitude, 180.0, "longitude");
    return {latitude, longitude};
}

} // namespace edgeshade::sun
