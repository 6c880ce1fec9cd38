#pragma once

#include <Eigen/Core>
#include <string>

namespace meshknit {

/// "1 face", "12 faces": a count with its noun, for messages to people.
std::string counted(std::size_t count, const std::string& one, const std::string& many);

/// "12.5 mm": a length to a tenth of a millimetre.
std::string millimetres(double length);

/// "(1.0, -20.5, 3.0) mm": a place to a tenth of a millimetre.
std::string place_text(const Eigen::Vector3d& point);

}  // namespace meshknit
