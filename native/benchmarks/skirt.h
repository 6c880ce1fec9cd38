#pragma once

#include <string>
#include <vector>

#include "meshknit/surface/surface.h"

namespace meshknit {

/// What a benchmark knits.
struct Workpiece {
  std::string name;
  Surface surface;
  std::vector<double> time;
};

/// A wavy flared tube: hem about 1.4 m round (start), waist 0.8 m, 0.9 m high.
Workpiece skirt();

/// The mesh of a program's arguments (file.obj, scale to mm, start and end point), or the skirt
/// if there are none. Throws: InvalidInput for arguments of another form or a file that cannot
/// be read; NotKnittable if the mesh is none that can be knit.
Workpiece workpiece_of(int argc, char** argv);

}  // namespace meshknit
