#include "meshknit/surface/wording.h"

#include <iomanip>
#include <locale>
#include <sstream>

namespace meshknit {
namespace {

std::string tenths(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());  // a user's locale must not change what we say
  text << std::fixed << std::setprecision(1) << value;
  return text.str();
}

}  // namespace

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string millimetres(double length) { return tenths(length) + " mm"; }

std::string place_text(const Eigen::Vector3d& point) {
  return "(" + tenths(point.x()) + ", " + tenths(point.y()) + ", " + tenths(point.z()) + ") mm";
}

}  // namespace meshknit
