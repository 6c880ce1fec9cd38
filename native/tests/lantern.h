#pragma once

#include "meshknit/surface/example_shapes.h"

namespace meshknit {

/// A shape that must be sewn: a trunk that parts into a left and a right limb, each of which parts
/// into a front and a back one. Both front limbs meet, and both back ones, and then these meet in a
/// trunk: nothing crosses in space, but on two beds something would. From the lower rim (start) to
/// the upper one (end); genus 3.
ExampleShape lantern();

}  // namespace meshknit
