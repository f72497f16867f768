// A paper whose curves are lost still says in words what they show. A finding is such a sentence as a comparison of two
// measured values, so that it can be held against our numbers.
#pragma once

#include <functional>
#include <optional>

#include "modules/bench/paper/sampling_data.h"
#include "modules/bench/table.h"

namespace regista::bench {

/// The measured value of a quantity ("success") for a planner of the table at a place of its curve; nothing where there
/// was no sample. Throws std::runtime_error where the table has no such planner, place or quantity.
using Measurement =
    std::function<std::optional<double>(const std::string& quantity, const std::string& planner, double at)>;

/// From rows {text, quantity, of, at, relation ">" or "<", than, than_at or value}: the sentence, both values, whether
/// it holds. Throws std::runtime_error for a row that makes no sense.
Table findings_table(const std::string& title, const std::vector<DataTable>& rows, const Measurement& measured);

}  // namespace regista::bench
