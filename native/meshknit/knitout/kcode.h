#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "meshknit/core/problem.h"
#include "meshknit/machine/machine_profile.h"
#include "meshknit/machine/program.h"

namespace meshknit {

/// One sweep of the Kniterate's carriage, as its own files (.kc) describe it (primer, section 3.1).
/// Columns count from 0 on the left: 15 beside the bed, one a needle, 15 beside it again. Carriage
/// and carrier stop in front of a column.
struct KcodePass {
  enum class Kind { yarn, front_to_back, back_to_front };
  Kind kind = Kind::yarn;
  Side direction = Side::right;
  bool front_tucks = false, rear_tucks = false;  ///< yarn: else the bed knits
  double racking = 0.0;
  std::vector<int> front, rear;               ///< needles at work, numbered from 1, ascending
  int carrier = 0;                            ///< number in the list of carriers, 0 for none
  int carrier_left = 0, carrier_right = 0;    ///< the ends of its way; both 0 without a carrier
  int carriage_left = 0, carriage_right = 0;  ///< the ends of the carriage's way
  char front_size = '0', rear_size = '0';     ///< stitch sizes, '0' where a bed rests
  int speed = 0, roller = 0;
  std::string comment;
  int line = 0;  ///< of its FRNT line, in a file that was read, from 1
};

constexpr int kColumnsBeside = 15;   ///< the bed, on each side
constexpr int kParkingColumn = 8;    ///< where carriers wait that are out
constexpr int kCarrierDistance = 2;  ///< columns from the last needle to where a carrier stops
constexpr int kCarrierSpacing = 2;   ///< columns between carriers that wait

/// The column of a needle.
inline int column_of(int needle) { return kColumnsBeside + needle - 1; }

/// A .kc file that was read: the passes that could be understood, and a problem for every other.
struct KcodeText {
  std::vector<KcodePass> passes;
  Problems problems;
};

/// Passes -> text.
std::string write_kcode(const std::vector<KcodePass>& passes, int needles);

/// Text -> passes, with checks of the form: that directions alternate, that the carriage turns where
/// it stands, that both beds name the same stops. Never throws on any text. Comments are lost.
KcodeText read_kcode(std::string_view text, int needles);

/// What the passes do, as a program: operations in the direction of travel, carriers in where they
/// leave their parking place and out where they come back to it. Sources are not known.
/// Requires: passes that read_kcode found no problem with; carriers within the profile's.
Program program_of(const std::vector<KcodePass>& passes, const MachineProfile& profile);

}  // namespace meshknit
