#pragma once

namespace deadpoint {
class Mistakes;
class Observer;
struct MachineDescription;
}  // namespace deadpoint

namespace deadpoint::machine {

/// Looks at the drawings of all parts before anything is meshed: whether their solids are there, how large they are,
/// and about how many cells they get. A part longer than 100 m is refused and one longer than 20 m or shorter than 1 mm
/// is warned of, since then its unit is hardly the one that is meant. Needs a GmshSession.
void survey_drawings(const MachineDescription& description, Mistakes& mistakes, Observer& observer);

}  // namespace deadpoint::machine
