#pragma once

#include "deadpoint/machine/cad/cad_contacts.hpp"
#include "deadpoint/machine/cad/cad_model.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

/// A first case from a drawing. Names and contacts tell what is what; every guess is marked as one in the case.
namespace deadpoint::full {

/// What a solid does in a press.
enum class Role { unknown, frame, crank, rod, slide };

/// What a name says: "eccentric_shaft" is a crank, "gib_left" belongs to the frame; English and German words.
Role role_of(const std::string& name);
/// Whether a name is that of a ring of a rolling bearing: "bearing_front_inner", "outer_race", "Lager-Innenring".
bool is_ring(const std::string& name);
/// Key of the material that a name suggests: "iron", "steel", "bronze".
std::string material_of(const std::string& name, Role role);

/// A group of solids that move together.
struct DraftBody {
    std::string name;
    Role role = Role::unknown;
    std::vector<std::size_t> solids;
    bool by_name = true;  ///< its solids' names say what it is, not only what they touch
};

/// Contacts of two bodies that move against each other.
struct DraftJoint {
    enum class Kind { revolute, slide, ball };
    std::string name;
    Kind kind = Kind::revolute;
    bool rolling = false;  ///< all of its contacts are rolling bearings
    std::size_t body_a = 0;
    std::size_t body_b = 0;
    std::vector<std::size_t> contacts;
};

/// Directions of the drawing that are x, y and z of the machine: z along the crankshaft, y from the slide to the
/// crankshaft.
struct DraftAxes {
    std::array<Vec3, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    bool found = false;  ///< false: nothing in the drawing says, and they are the drawing's own
};

/// Solids that the user puts into one body.
struct WantedBody {
    std::string name;
    std::vector<std::string> solids;  ///< names, or patterns with *
};

struct Draft {
    machine::CadModel model;                    ///< turned to the machine's axes
    std::vector<machine::CadContact> contacts;  ///< of that model
    std::set<std::size_t> rolling;              ///< those of two rings, between which balls or rollers are not drawn
    std::vector<DraftBody> bodies;              ///< the ground first
    std::vector<std::size_t> body_of;           ///< of each solid
    std::vector<DraftJoint> joints;
    DraftAxes axes;
    std::vector<machine::CadContact> near_misses;  ///< would be of joints, but are drawn a little too far or too thick
};

/// Groups the solids of a drawing, and proposes joints.
///
/// Solids of a wanted body are together and have the role of its name. A solid whose name says nothing joins the
/// neighbour with the largest contact: a bush its housing, a pressed-in pin its eyes. All solids of the frame are one
/// body. Others are one body if they have the same role and touch. Cylinders along the crankshaft that join two bodies
/// are revolute joints, one for each axis; planes between slide and frame along the direction of travel are slides; a
/// ball in a socket is a ball joint. Two rings of a rolling bearing, by their names, carry each other although they are
/// drawn apart by up to half of their diameter. Everything else is a contact without a joint.
/// @throws InputError if a wanted body names no solid of the drawing, or one that another one has
Draft draft_of(machine::CadModel model, const std::vector<WantedBody>& wanted = {});

/// Whatever in a drawing keeps its case from being a press: solids that are left out or lie in one place, roles that no
/// name tells, bodies that should touch and do not, axes that nothing shows. Each is a sentence with its remedy.
std::vector<std::string> doubts_about(const Draft& draft);

/// The case as text with comments: parts, bodies, joints, surfaces, films, operation and chain, and every contact that
/// is no joint. What the drawing cannot say has a number that is marked "TO DO".
/// @param file  path of the drawing as the case names it
std::string draft_text(const Draft& draft, const std::string& file);

}  // namespace deadpoint::full
