#pragma once

#include "src/city/city_hours.hpp"

#include <map>

namespace edgeshade::city {

/// Sums up cells by object, job by job. Holds the objects of sources whose jobs are being added.
class ObjectSums {
  public:
    void add(const JobResult& result);
    /// A source's objects by name. Forgets them.
    std::vector<ObjectHours> take(std::size_t source);

  private:
    std::map<std::size_t, std::map<std::string, ObjectHours>> bySource_;
};

/// Adds a job's cells to a map's sums, except its objects.
void addCells(const JobResult& result, CityHours& hours);

} // namespace edgeshade::city
