#pragma once

#include <string>

namespace deadpoint::casefile {
struct Case;
}

/// What meshes, unknowns, factors and the dimension chain are made of.
namespace deadpoint::press {

/// The part of a case that the mesh and the model on it are made of; everything else has its default. Meshing,
/// unknowns, dimension chain, gaps, frame and their adjoints are given this case and no other, so two cases with the
/// same part can share them, whatever else differs: operation, loads, friction, lubricants, oil, conductances,
/// convection, media.
///
/// - A surface keeps its place and whether it has a film or a flux, a temperature, insulation, or nothing: the faces
/// that
///   it claims follow from that. A bond keeps whether it conducts.
/// - Materials keep their values. Those over temperature count from the initial temperature, which is kept with them.
casefile::Case model_part(const casefile::Case& input);
/// The same as bytes, to compare cases within one call of the program.
std::string model_key(const casefile::Case& input);

}  // namespace deadpoint::press
