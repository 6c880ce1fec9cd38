#pragma once

#include <string>

#include "meshknit/core/problem.h"

namespace meshknit {

/// Codes and messages of the errors among problems, a line each.
std::string errors_of(const Problems& problems);

}  // namespace meshknit
