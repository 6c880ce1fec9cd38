#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include "meshknit/surface/triangle_mesh.h"

template class OpenMesh::PropertyT<Eigen::Vector3d>;
