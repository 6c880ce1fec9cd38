#include "schedule/random_map.h"

#include <vector>

namespace meshknit {

SlotMap random_map(Dice& dice, int stacks) {
  std::vector<int> slot_of_stack;
  int slots = 0;
  bool joined = true;
  for (int i = 0; i < stacks; ++i) {
    const int choice = dice.roll(5);
    if (choice == 0 && !joined && slots + stacks - i > 3) {
      slot_of_stack.push_back(slots - 1);
      joined = true;
      continue;
    }
    slot_of_stack.push_back(slots++);
    joined = false;
    if (choice == 1) {
      ++slots;
      joined = true;
    }
  }
  return {slot_of_stack, slots,
          dice.roll(2) == 0 ? Direction::clockwise : Direction::anticlockwise};
}

}  // namespace meshknit
