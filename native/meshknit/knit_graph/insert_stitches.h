#pragma once

#include <vector>

#include "meshknit/knit_graph/editable_graph.h"

namespace meshknit {

/// The nodes of the shortest short row, and the least that lie between two turns.
inline constexpr int fewest_between_turns = 3;

/// Where the loops are as in a plain tube: the node ends no short row, and none that it has a column
/// to does.
bool is_calm(const EditableGraph& graph, int node);

/// A new short row between `count` neighbouring nodes, `first` and those after it, and what they have
/// columns up to: every column there is divided in two. Returns its nodes in yarn order.
/// Changes nothing and returns none where Properties 1-6 would not hold, or where turns would come
/// too near to each other: the row needs three nodes and room for three between its turns and others,
/// 1-1 columns at its ends and beside them, and no split or merge right above.
std::vector<int> insert_short_row(EditableGraph& graph, int first, int count);

/// On which side of a new stitch the loop lies that it shares an increase or decrease with.
enum class Beside { previous, next };

/// A new wale: a stitch between `left` and the node after it, and one in each of the rows above that,
/// in `count` rows altogether. It begins with an increase in the row below and ends with a decrease
/// in the row above. Returns its nodes, upwards.
/// Changes nothing and returns none where Properties 1-6 would not hold, where the row is a
/// junction's, or where an increase would stand upon another shaped stitch or beside a turn.
std::vector<int> insert_wale(EditableGraph& graph, int left, int count, Beside at_increase,
                             Beside at_decrease);

}  // namespace meshknit
