#pragma once

#include "preprocess/gltf/json_field.hpp"
#include "src/city/cell_grid.hpp"

namespace edgeshade::city {

/// A range as plans and results have it: [left, bottom, right, top].
inline nlohmann::ordered_json jsonOf(const CellRange& cells) {
    return {cells.left, cells.bottom, cells.right, cells.top};
}

/// Reads what jsonOf() wrote. Throws InputError, also for a range without cells.
inline CellRange cellRangeFrom(const JsonField& field) {
    field.requireArray();
    if (field.size() != 4) field.fail(" is not four numbers");
    const auto at = [&](std::size_t i) { return field.item(i).integer(); };
    const CellRange cells{at(0), at(1), at(2), at(3)};
    if (cells.columns() < 1 || cells.rows() < 1)
        field.fail(" is " + field.value().dump() + ", which is no range of cells");
    return cells;
}

} // namespace edgeshade::city
