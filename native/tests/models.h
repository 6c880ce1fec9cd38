#pragma once

#include <optional>
#include <string>
#include <vector>

#include "meshknit/surface/example_shapes.h"

namespace meshknit {

/// Meshes that other people made, with places for openings and times chosen by hand: pants,
/// tshirt, skirt, spot, stuffedtoy, glove (fingertips open) and bob (genus 1); and, with two
/// openings only, spot_two and stuffedtoy_two.
std::vector<std::string> model_names();

/// Nothing if the folder is not there: it is no part of the project. It is
/// named by the environment variable MESHKNIT_MODELS, or lies at shared/models beside the project.
std::optional<ExampleShape> model(const std::string& name);

/// What a test that is skipped without them says.
std::string why_no_models();

/// Where a file of that folder would be.
std::string model_path(const std::string& file);

}  // namespace meshknit
