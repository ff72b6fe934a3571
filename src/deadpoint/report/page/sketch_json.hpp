#pragma once

#include <nlohmann/json.hpp>

namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint::press {
struct CaseSketch;
}

/// Internal to report/: the picture of a machine before it is solved, as data of a page.
namespace deadpoint::report {

/// The surface and its parts (surface_json), with `marks` (interfaces, surfaces and heated parts), the marks that faces
/// share as `groups`, and per part the group of each triangle; joints, probes, places of the dimension chain, faces
/// that were sought in vain, and overlaps. Lengths in m; triangles' groups as 16-bit numbers in base64.
nlohmann::ordered_json sketch_json(const casefile::Case& input, const press::CaseSketch& sketch);

}  // namespace deadpoint::report
