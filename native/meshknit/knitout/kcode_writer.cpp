#include <cstdlib>
#include <string>

#include "meshknit/knitout/kcode.h"

namespace meshknit {
namespace {

std::string columns(const std::vector<int>& needles_at_work, int needles) {
  const std::string beside(kColumnsBeside, '.');
  std::string bed = beside + std::string(static_cast<std::size_t>(needles), '_') + beside;
  for (const int needle : needles_at_work) bed[column_of(needle)] = '-';
  return bed;
}

/// The stops of carriage and carrier stand in front of their columns: rightmost first, so that
/// columns to the left keep their numbers.
std::string with_stops(std::string bed, const KcodePass& pass) {
  const auto put = [&](int column, char what) { bed.insert(bed.begin() + column, what); };
  const char carrier = static_cast<char>('0' + pass.carrier);
  put(pass.carriage_right, '\\');
  if (pass.carrier > 0) put(pass.carrier_right, carrier);
  if (pass.carrier > 0) put(pass.carrier_left, carrier);
  put(pass.carriage_left, '/');
  return bed;
}

std::string cams(const KcodePass& pass) {
  const bool right = pass.direction == Side::right;
  if (pass.kind == KcodePass::Kind::front_to_back) return right ? "Tr-Rr" : "Tr-Rl";
  if (pass.kind == KcodePass::Kind::back_to_front) return right ? "Rr-Tr" : "Rl-Tr";
  return std::string(pass.front_tucks ? "Tu" : "Kn") + "-" + (pass.rear_tucks ? "Tu" : "Kn");
}

std::string decimal(double racking) {
  const int halves = static_cast<int>(2.0 * racking);
  if (halves % 2 == 0) return std::to_string(halves / 2);
  return (halves < 0 ? "-" : "") + std::to_string(std::abs(halves) / 2) + ".5";
}

}  // namespace

std::string write_kcode(const std::vector<KcodePass>& passes, int needles) {
  const std::size_t width = static_cast<std::size_t>(needles) + 2 * kColumnsBeside;
  std::string text = "HOME\nRACK:0\n";
  double racking = 0.0;
  for (const KcodePass& pass : passes) {
    text += "// " + pass.comment + "\n";
    if (pass.racking != racking) text += "RACK:" + decimal(pass.racking) + "\n";
    racking = pass.racking;
    text += "FRNT:" + with_stops(columns(pass.front, needles), pass) + "\n";
    text += "STIF:" + std::string(width, pass.front_size) + "\n";
    text += "REAR:" + with_stops(columns(pass.rear, needles), pass) + "\n";
    text += "STIR:" + std::string(width, pass.rear_size) + "\n";
    text += (pass.direction == Side::right ? ">> " : "<< ") + cams(pass) + " " +
            std::to_string(pass.carrier) + " " + std::to_string(pass.speed) + " " +
            std::to_string(pass.roller) + "\n";
  }
  return text;
}

}  // namespace meshknit
