#include "deadpoint/casefile/syntax/value_texts.hpp"
#include "deadpoint/core/names/plain_text.hpp"
#include "deadpoint/full/draft/draft.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numbers>
#include <set>

namespace deadpoint::full {
namespace {

using machine::CadContact;
using machine::CadFace;
using machine::CadPlane;
using machine::CadSolid;

constexpr double drawn_exactly = 1e-5;  ///< clearance that the mesh takes for none [m]

/// A length in millimetres, to a tenth of a micrometre and without zeros at its end.
std::string in_words(double metres)
{
    std::string text = fmt::format("{:.4f}", 1e3 * metres);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) {
        text.pop_back();
    }
    return fmt::format("{} mm", text == "-0" ? "0" : text);
}

/// The same as a value of a case.
std::string mm(double metres) { return fmt::format("\"{}\"", in_words(metres)); }

std::string place(const Vec3& p) { return fmt::format("{:.1f}, {:.1f}, {:.1f}", 1e3 * p[0], 1e3 * p[1], 1e3 * p[2]); }

const char* letter(std::size_t axis) { return axis == 0 ? "x" : (axis == 1 ? "y" : "z"); }

/// The axis along which a direction lies; 3 where it lies along none.
std::size_t axis_of(const Vec3& direction)
{
    for (std::size_t i = 0; i < 3; ++i) {
        if (std::abs(direction[i]) > 1 - 1e-6) {
            return i;
        }
    }
    return 3;
}

double exterior(const CadSolid& solid)
{
    double sum = 0;
    for (const CadFace& face : solid.faces) {
        sum += face.area;
    }
    return sum;
}

/// Area of the faces of a solid that lie in the plane, or on the cylinder, of a contact.
double area_at(const CadSolid& solid, const CadContact& contact, bool is_a)
{
    double sum = 0;
    for (const CadFace& face : solid.faces) {
        if (const auto* plane = std::get_if<CadPlane>(&face.form);
            plane != nullptr && contact.kind == CadContact::Kind::plane) {
            const Vec3 normal = (is_a ? 1.0 : -1.0) * contact.direction;
            const double at = dot(normal, contact.point) + (is_a ? 0.0 : -contact.clearance);
            sum += norm(plane->normal - normal) < 1e-3 && std::abs(plane->offset - at) < 1e-5 ? face.area : 0;
        }
        if (const auto* c = std::get_if<machine::CadCylinder>(&face.form);
            c != nullptr && contact.kind == CadContact::Kind::cylinder && c->bore == is_a) {
            const Vec3 way = c->point - contact.point;
            const bool same = norm(way - dot(way, contact.direction) * contact.direction) < 1e-5 &&
                              std::abs(2 * c->radius - contact.diameter - (is_a ? contact.clearance : 0)) < 1e-5;
            sum += same ? face.area : 0;
        }
    }
    return sum;
}

/// Text of a case, and what was asked of its reader.
class Writer {
public:
    Writer(const Draft& draft, std::string file) : draft_(draft), file_(std::move(file)) {}

    std::string all()
    {
        head();
        materials();
        bodies();
        parts();
        joints();
        other_contacts();
        surfaces();
        operation();
        chain();
        numerics();
        return std::move(out_);
    }

private:
    template <class... T>
    void line(fmt::format_string<T...> format, T&&... values)
    {
        out_ += fmt::format(format, std::forward<T>(values)...) + "\n";
    }
    void section(const char* title)
    {
        line("\n# ---------------------------------------------------------------- {}\n", title);
    }
    const CadSolid& solid(std::size_t i) const { return draft_.model.solids[i]; }
    const std::string& body(std::size_t i) const { return draft_.bodies[i].name; }
    const DraftBody* body_with(Role role) const
    {
        const auto found = std::ranges::find(draft_.bodies, role, &DraftBody::role);
        return found == draft_.bodies.end() ? nullptr : &*found;
    }

    void head()
    {
        line("# A first case from '{}': {} solids, {} contacts between them. Every line with TO DO holds a guess; "
             "replace it, then",
             one_line(file_), draft_.model.solids.size(), draft_.contacts.size());
        line("#   deadpoint check case.toml               is it sound, and what would be computed?");
        line("#   deadpoint run case.toml -o results      how far does it drift?");
        line("# The drawing must show the press at bottom dead point. y points up, z along the crankshaft; seen from z "
             "> 0, "
             "x points to the right.");
        for (const auto& doubt : doubts_about(draft_)) {
            line("# TO DO: {}.", doubt);
        }
        line("format = 1\n\n[machine]\nname = \"press\"\ninitial_temperature = \"20 degC\"\nambient = \"20 degC\"");
        line("{:<33} # TO DO: where the operator stands: \"z\", \"-z\" or, with the crankshaft from left to right, "
             "\"x\", \"-x\"",
             fmt::format("front = \"{}\"", front()));
    }

    /// The machine's axis that points to the viewer of a drawing's front view: -y where its z points up, else z.
    std::string front() const
    {
        const bool z_up = axis_of(draft_.axes.rows[1]) == 2;
        const std::size_t viewer = z_up ? 1 : 2;
        for (std::size_t i = 0; i < 3; ++i) {
            if (axis_of(draft_.axes.rows[i]) == viewer) {
                return fmt::format("{}{}", (draft_.axes.rows[i][viewer] < 0) != z_up ? "-" : "", letter(i));
            }
        }
        return "z";
    }

    void materials()
    {
        section("what things are made of");
        constexpr std::array<std::pair<const char*, const char*>, 3> known{
            {{"iron", "GJL-250"}, {"steel", "42CrMo4"}, {"bronze", "CuSn8"}}};
        std::set<std::string> used;
        for (std::size_t i = 0; i < draft_.model.solids.size(); ++i) {
            used.insert(material(i));
        }
        line("# TO DO: guessed from names; docs/case-file.md lists the shipped library.");
        for (const auto& [key, library] : known) {
            if (used.contains(key)) {
                line("[materials.{}]\nlibrary = \"{}\"", key, library);
            }
        }
        line("[lubricants.oil]\nlibrary = \"ISO-VG-68\"   # TO DO: your oil");
    }

    std::string material(std::size_t i) const
    {
        return material_of(solid(i).name, draft_.bodies[draft_.body_of[i]].role);
    }

    void bodies()
    {
        section("what moves as one");
        for (std::size_t b = 0; b < draft_.bodies.size(); ++b) {
            const DraftBody& one = draft_.bodies[b];
            if (!one.by_name) {
                line("# TO DO: no name says what this is.");
            }
            line("[bodies.{}]{}", one.name, b == 0 ? "\nground = true" : "");
            if (b > 0 && !has_joint(b)) {
                line("# TO DO: nothing that moves touches it; give it a joint, or add its parts to another body.");
            }
        }
    }

    bool has_joint(std::size_t b) const
    {
        return std::ranges::any_of(draft_.joints, [&](const DraftJoint& j) { return j.body_a == b || j.body_b == b; });
    }

    /// Walls of a plate count twice in its surface, so that two volumes over the surface are its thickness.
    double size_of(const CadSolid& one) const
    {
        const double thickness = 2 * one.volume / exterior(one);
        return std::clamp(std::round(1e3 * thickness), 1e3 * global_size() / 4, 1e3 * global_size()) * 1e-3;
    }
    double global_size() const { return std::max(1e-3, std::round(1e3 * extent(draft_.model) / 35) * 1e-3); }

    std::string axes() const
    {
        std::vector<std::string> names;
        for (const Vec3& row : draft_.axes.rows) {
            const std::size_t axis = axis_of(row);
            names.push_back(fmt::format("\"{}{}\"", row[axis] < 0 ? "-" : "", letter(axis)));
        }
        const std::string text = fmt::format("{}", fmt::join(names, ", "));
        return text == "\"x\", \"y\", \"z\"" ? "" : fmt::format("axes = [{}]\n", text);
    }

    void parts()
    {
        section("its solids; touching parts of one body are bonded by themselves");
        for (std::size_t i = 0; i < draft_.model.solids.size(); ++i) {
            const CadSolid& one = solid(i);
            const Vec3 edges = one.bounds.max - one.bounds.min;
            line("# {:.4g} litres, {:.1f} x {:.1f} x {:.1f} mm{}{}", 1e3 * one.volume, 1e3 * edges[0], 1e3 * edges[1],
                 1e3 * edges[2], one.path.empty() ? "" : ", in " + one_line(one.path),
                 one.colour.empty() ? "" : ", colour " + one_line(one.colour));
            line("[parts.{}]\nbody = \"{}\"\nmaterial = \"{}\"\nstep = {}\nsolid = {}\nfingerprint = \"{}\"\n{}size = "
                 "{}\n",
                 one.name, body(draft_.body_of[i]), material(i), casefile::in_quotes(file_),
                 casefile::in_quotes(name_in_case(one)), text_of(one.fingerprint), axes(), mm(size_of(one)));
        }
    }

    /// The joint of crankshaft and frame with the largest contact.
    const DraftJoint* crank_joint() const
    {
        const DraftJoint* best = nullptr;
        double largest = 0;
        for (const DraftJoint& joint : draft_.joints) {
            const bool fits = joint.kind == DraftJoint::Kind::revolute && joint.body_b == 0 &&
                              draft_.bodies[joint.body_a].role == Role::crank;
            if (fits && area_of(joint) > largest) {
                best = &joint;
                largest = area_of(joint);
            }
        }
        return best;
    }

    double area_of(const DraftJoint& joint) const
    {
        double sum = 0;
        for (const std::size_t c : joint.contacts) {
            sum += draft_.contacts[c].area;
        }
        return sum;
    }

    void joints()
    {
        section("what connects the bodies, and what rubs");
        line("# TO DO: coefficients of friction, clearances and films are customary values, not yours.");
        for (const DraftJoint& joint : draft_.joints) {
            if (joint.kind == DraftJoint::Kind::slide) {
                guide(joint);
            } else if (joint.kind == DraftJoint::Kind::ball) {
                ball(joint);
            } else if (joint.rolling) {
                rolling_bearing(joint);
            } else {
                bearing(joint);
            }
        }
    }

    bool turns(const DraftJoint& joint) const
    {
        return draft_.bodies[joint.body_a].role == Role::crank || draft_.bodies[joint.body_b].role == Role::crank;
    }

    void head_of(const DraftJoint& joint)
    {
        const CadContact& first = draft_.contacts[joint.contacts.front()];
        line("[joints.{}]\nkind = \"revolute\"\nbodies = [\"{}\", \"{}\"]\ncentre = [{}, {}]{}{}\nfriction = \"{}\"",
             joint.name, body(joint.body_a), body(joint.body_b), mm(first.point[0]), mm(first.point[1]),
             turns(joint) ? "\nturns_fully = true" : "", &joint == crank_joint() ? "\ndriver = true" : "", joint.name);
    }

    /// Smallest and largest diameter of two rings about their axis.
    std::array<double, 2> bore_and_outside(const CadContact& contact) const
    {
        std::array<double, 2> found{contact.diameter, contact.diameter + contact.clearance};
        for (const std::size_t side : {contact.a, contact.b}) {
            for (const CadFace& face : solid(side).faces) {
                if (const auto* cylinder = std::get_if<machine::CadCylinder>(&face.form);
                    cylinder != nullptr && norm(cross(cylinder->axis, contact.direction)) < 1e-3) {
                    found = {std::min(found[0], 2 * cylinder->radius), std::max(found[1], 2 * cylinder->radius)};
                }
            }
        }
        return found;
    }

    void rolling_bearing(const DraftJoint& joint)
    {
        const CadContact& first = draft_.contacts[joint.contacts.front()];
        const auto [bore, outside] = bore_and_outside(first);
        const double mean = 0.5 * (bore + outside);
        // Rollers of the height of the gap, side by side with a fifth of it between them; a third of them carries load.
        const double roller = 0.5 * first.clearance;
        const double pitch = first.diameter + roller;
        const double width = first.range[1] - first.range[0];
        constexpr double rating = 60e6;  // [N/m2] of width times mean diameter, of catalogues of roller bearings
        line("[friction.{}]\nlaw = \"palmgren\"\nlubricant = \"oil\"\nbearing = \"cylindrical_roller\"   # TO DO: its "
             "type\nmean_diameter = {}\nstatic_rating = \"{:.0f} kN\"   # TO DO: C0 of its catalogue; guessed from its "
             "size\n",
             joint.name, mm(mean), 1e-3 * rating * width * mean);
        head_of(joint);
        line("elements = [");
        for (const std::size_t c : joint.contacts) {
            const CadContact& contact = draft_.contacts[c];
            line("    {{ name = \"{}\", type = \"rolling\", position = {}, width = {}, diameter = {} }},",
                 solid(contact.a).name, mm(middle_of(contact)[2]), mm(contact.range[1] - contact.range[0]),
                 mm(contact.diameter));
        }
        line("]\n# TO DO: rollers and their contacts are guessed from the gap between the rings.\ninterfaces = [");
        for (const std::size_t c : joint.contacts) {
            interface(joint, draft_.contacts[c],
                      fmt::format("law = \"rolling_elements\", loaded_elements = {:.0f}, element_diameter = {}, "
                                  "pitch_diameter = {}, inner_spot = [{}, \"0.1 mm\"], outer_spot = [{}, \"0.1 mm\"], "
                                  "thickness = \"1 um\", fluid_conductivity = \"0.14 W/m/K\"",
                                  std::max(1.0, std::numbers::pi * pitch / (1.2 * roller) / 3), mm(roller), mm(pitch),
                                  mm(0.4 * width), mm(0.4 * width)),
                      &joint == crank_joint());
        }
        line("]\n");
        cylinders_of(joint);
    }

    void bearing(const DraftJoint& joint)
    {
        const CadContact& first = draft_.contacts[joint.contacts.front()];
        double length = 0;
        for (const std::size_t c : joint.contacts) {
            length += draft_.contacts[c].area / (std::numbers::pi * draft_.contacts[c].diameter);
        }
        const double radial = first.clearance > drawn_exactly ? 0.5 * first.clearance : 5e-4 * first.diameter;
        line("[friction.{}]\nlaw = \"pin\"\nlubricant = \"oil\"\ncoefficient = 0.03     # TO DO\ndiameter = {}\nlength "
             "= {}\nclearance = {}   # TO DO: "
             "{}\n",
             joint.name, mm(first.diameter), mm(length), mm(radial),
             first.clearance > drawn_exactly ? "half of the clearance in the drawing"
                                             : "radial; drawn without, a thousandth of the diameter here");
        head_of(joint);
        line("clearance = {}\ninterfaces = [", mm(2 * radial));
        for (const std::size_t c : joint.contacts) {
            interface(joint, draft_.contacts[c],
                      fmt::format(
                          "law = \"oil_film\", fluid_conductivity = \"0.14 W/m/K\", clearance = {}, eccentricity = 0.6",
                          mm(radial)),
                      &joint == crank_joint());
        }
        line("]\n");
        cylinders_of(joint);
    }

    void ball(const DraftJoint& joint)
    {
        const CadContact& first = draft_.contacts[joint.contacts.front()];
        line("# {} | {}: ball of {} about ({}) mm, at most {:.4g} cm2, drawn with {} of clearance.",
             solid(first.a).name, solid(first.b).name, in_words(first.diameter), place(first.point), 1e4 * first.area,
             in_words(first.clearance));
        line(
            "# TO DO: spherical faces of a drawing make no contact: no heat passes here and none arises. Draw ball and "
            "socket as a cylinder\n# about z, and give the joint its interface and friction "
            "(docs/how-to/ball-joints.md).");
        line("[joints.{}]\nkind = \"ball\"\nbodies = [\"{}\", \"{}\"]\ncentre = [{}, {}]\nball = {{ diameter = {} "
             "}}\n",
             joint.name, body(joint.body_a), body(joint.body_b), mm(first.point[0]), mm(first.point[1]),
             mm(first.diameter));
    }

    void guide(const DraftJoint& joint)
    {
        Vec3 middle{};
        for (const std::size_t c : joint.contacts) {
            middle = middle + (1.0 / static_cast<double>(joint.contacts.size())) * draft_.contacts[c].point;
        }
        line("[friction.{}]\nlaw = \"guide\"\nlubricant = \"oil\"\ncoefficient = 0.05     # TO DO\nfilm_thickness = "
             "\"20 um\"   # TO DO\nfilm_area = \"{:.5g} "
             "m^2\"\n",
             joint.name, area_of(joint));
        line("[joints.{}]\nkind = \"slide\"\nbodies = [\"{}\", \"{}\"]\ncentre = [{}, {}]\ndirection = [0, 1]\npreload "
             "= \"1 kN\"         # TO DO: of the "
             "gibs\nfriction = \"{}\"\ninterfaces = [",
             joint.name, body(joint.body_a), body(joint.body_b), mm(crank_x()), mm(middle[1]), joint.name);
        for (const std::size_t c : joint.contacts) {
            interface(joint, draft_.contacts[c],
                      "law = \"oil_film\", fluid_conductivity = \"0.14 W/m/K\", thickness = \"20 um\"", false);
        }
        line("]\n");
        planes_of(joint);
    }

    double crank_x() const
    {
        const DraftJoint* joint = crank_joint();
        return joint == nullptr ? 0 : draft_.contacts[joint->contacts.front()].point[0];
    }

    std::string surface_name(const DraftJoint& joint, std::size_t solid_index, const CadContact& contact) const
    {
        std::size_t number = 0;
        for (const std::size_t c : joint.contacts) {
            const CadContact& other = draft_.contacts[c];
            if (&other == &contact) {
                break;
            }
            number += other.a == solid_index || other.b == solid_index ? 1 : 0;
        }
        return fmt::format("{}_at_{}{}", solid(solid_index).name, joint.name,
                           number == 0 ? "" : fmt::format("_{}", number + 1));
    }

    /// Whether both sides go by the joint's centre and one diameter.
    static bool by_diameter(const CadContact& contact)
    {
        return contact.kind == CadContact::Kind::cylinder && std::abs(contact.clearance) <= drawn_exactly;
    }

    /// "bush_shaft", with a number from the second contact of a joint's same two solids on.
    std::string interface_name(const DraftJoint& joint, const CadContact& contact, const std::string& stem) const
    {
        std::size_t number = 1;
        for (const std::size_t c : joint.contacts) {
            const CadContact& other = draft_.contacts[c];
            if (&other == &contact) {
                break;
            }
            number += std::minmax(other.a, other.b) == std::minmax(contact.a, contact.b) ? 1 : 0;
        }
        return number == 1 ? stem : fmt::format("{}_{}", stem, number);
    }

    void interface(const DraftJoint& joint, const CadContact& contact, const std::string& conductance, bool seat)
    {
        // The other side must cover side a: the smaller face.
        const double areas[2] = {area_at(solid(contact.a), contact, true), area_at(solid(contact.b), contact, false)};
        const bool a_first = areas[0] <= areas[1];
        const std::size_t one = a_first ? contact.a : contact.b;
        const std::size_t other = a_first ? contact.b : contact.a;
        const bool by_part = by_diameter(contact);
        const std::string more =
            fmt::format("{}{}{}{}", by_part ? fmt::format(", diameter = {}", mm(contact.diameter)) : "",
                        contact.area < 0.985 * std::min(areas[0], areas[1]) ? ", partial = true" : "",
                        seat ? ", seat = true, journal = true" : "",
                        std::abs(contact.clearance) > drawn_exactly
                            ? fmt::format(", drawn_gap = {}", mm(1.01 * std::abs(contact.clearance) + 1e-5))
                            : "");
        line("    # {:.4g} cm2, drawn with {} of clearance", 1e4 * contact.area, in_words(contact.clearance));
        line("    {{ name = \"{}\", a = \"{}\", b = \"{}\"{}, conductance = {{ {} }} }},",
             interface_name(joint, contact, solid(one).name + "_" + solid(other).name),
             by_part ? solid(one).name : surface_name(joint, one, contact),
             by_part ? solid(other).name : surface_name(joint, other, contact), more, conductance);
    }

    void cylinders_of(const DraftJoint& joint)
    {
        for (const std::size_t c : joint.contacts) {
            const CadContact& contact = draft_.contacts[c];
            if (by_diameter(contact)) {
                continue;
            }
            for (const std::size_t side : {contact.a, contact.b}) {
                line("[surfaces.{}]\nparts = [\"{}\"]\nselect = \"cylinder\"\naxis = \"z\"\ncentre = [{}, "
                     "{}]\ndiameter = {}\n",
                     surface_name(joint, side, contact), solid(side).name, mm(contact.point[0]), mm(contact.point[1]),
                     mm(contact.diameter + (side == contact.a ? contact.clearance : 0)));
            }
        }
    }

    void plane(const std::string& name, std::size_t of, const Vec3& normal, const Vec3& point)
    {
        const std::size_t axis = axis_of(normal);
        const std::string where =
            axis < 3 ? fmt::format("axis = \"{}\"\nposition = {}", letter(axis), mm(point[axis]))
                     : fmt::format("normal = [{:.9g}, {:.9g}, {:.9g}]\npoint = [{}, {}, {}]", normal[0], normal[1],
                                   normal[2], mm(point[0]), mm(point[1]), mm(point[2]));
        line("[surfaces.{}]\nparts = [\"{}\"]\nselect = \"plane\"\n{}\n", name, solid(of).name, where);
    }

    void planes_of(const DraftJoint& joint)
    {
        for (const std::size_t c : joint.contacts) {
            const CadContact& contact = draft_.contacts[c];
            plane(surface_name(joint, contact.a, contact), contact.a, contact.direction, contact.point);
            plane(surface_name(joint, contact.b, contact), contact.b, contact.direction,
                  contact.point + contact.clearance * contact.direction);
        }
    }

    static std::string form_of(const CadContact& contact)
    {
        if (contact.kind == CadContact::Kind::plane) {
            return "planes";
        }
        return fmt::format("{} of {} about ({}) mm", contact.kind == CadContact::Kind::sphere ? "spheres" : "cylinders",
                           in_words(contact.diameter), place(middle_of(contact)));
    }

    void other_contacts()
    {
        section("contacts that are no joint");
        line("# Within a body, touching parts are bonded. What is drawn apart is not: change the drawing, or leave it "
             "so.");
        for (std::size_t i = 0; i < draft_.contacts.size(); ++i) {
            const CadContact& contact = draft_.contacts[i];
            const bool inside = draft_.body_of[contact.a] == draft_.body_of[contact.b];
            const bool in_joint = std::ranges::any_of(draft_.joints, [&](const DraftJoint& j) {
                return std::ranges::find(j.contacts, i) != j.contacts.end();
            });
            if (in_joint) {
                continue;
            }
            const std::string form = form_of(contact);
            const bool apart = std::abs(contact.clearance) > drawn_exactly;
            line("# {} | {}: {}, {:.4g} cm2, clearance {}: {}", solid(contact.a).name, solid(contact.b).name, form,
                 1e4 * contact.area, in_words(contact.clearance),
                 inside ? (apart ? "not bonded, since drawn apart" : "bonded")
                        : "TO DO: two bodies that touch without a joint; no heat passes here");
        }
        for (const CadContact& miss : draft_.near_misses) {
            line("# {} | {}: {}, {:.4g} cm2, {} {}: TO DO: too far to touch; if they should, correct the drawing",
                 solid(miss.a).name, solid(miss.b).name, form_of(miss), 1e4 * miss.area,
                 miss.clearance < 0 ? "drawn into each other by" : "apart by", in_words(std::abs(miss.clearance)));
        }
    }

    std::string parts_of(bool ground) const
    {
        std::vector<std::string> names;
        for (std::size_t i = 0; i < draft_.model.solids.size(); ++i) {
            if ((draft_.body_of[i] == 0) == ground) {
                names.push_back(fmt::format("\"{}\"", solid(i).name));
            }
        }
        return fmt::format("{}", fmt::join(names, ", "));
    }

    void surfaces()
    {
        section("what cools");
        line("# TO DO: still air at the frame, moved air at what moves.");
        for (const bool ground : {true, false}) {
            const std::string names = parts_of(ground);
            if (!names.empty()) {
                line("[surfaces.air_{}]\nparts = [{}]\nselect = \"exposed\"\nfilm = {{ coefficient = \"{} W/m^2/K\", "
                     "emissivity = 0.6 }}\n",
                     ground ? "frame" : "moving", names, ground ? 5 : 12);
            }
        }
    }

    void operation()
    {
        section("what the press does");
        line("[[operation]]\nname = \"warm-up\"\nduration = \"3 h\"");
        if (crank_joint() != nullptr) {
            line("speed = \"60 rpm\"      # TO DO\nforce = \"100 kN\"      # TO DO: of the process");
        } else {
            line("speed = \"60 rpm\"\n# TO DO: no joint of crankshaft and frame was found; without it nothing is "
                 "driven and nothing rubs.");
        }
    }

    struct Found {
        std::size_t solid = 0;
        double position = 0;
        double area = 0;
    };

    /// The plane face of a body across y with the largest measure of `worth`.
    template <class Worth>
    std::optional<Found> face_across_y(const DraftBody& of, double sign, const Worth& worth) const
    {
        std::optional<Found> best;
        double most = 0;
        for (const std::size_t i : of.solids) {
            for (const CadFace& face : solid(i).faces) {
                const auto* plane = std::get_if<CadPlane>(&face.form);
                if (plane == nullptr || sign * plane->normal[1] < 1 - 1e-6) {
                    continue;
                }
                const Found found{i, sign * plane->offset, face.area};
                if (const double value = worth(found); value > 0 && value > most) {
                    most = value;
                    best = found;
                }
            }
        }
        return best;
    }

    void chain()
    {
        const DraftBody* slide = body_with(Role::slide);
        const DraftJoint* crank = crank_joint();
        if (slide == nullptr || crank == nullptr) {
            line("\n# TO DO: the dimension chain ([chain] in docs/case-file.md) needs a slide and the joint of "
                 "crankshaft and frame.");
            return;
        }
        const double top = draft_.contacts[crank->contacts.front()].point[1];
        const auto area = [](const Found& f) { return f.area; };
        const auto below = face_across_y(*slide, -1, area);
        const auto table = !below ? below : face_across_y(draft_.bodies[0], 1, [&](const Found& f) {
            return f.position < below->position + 1e-6 && f.area > 1e-4 ? 1 / (below->position - f.position + 1e-3) : 0;
        });
        const auto feet =
            face_across_y(draft_.bodies[0], -1, [&](const Found& f) { return f.area > 1e-4 ? top - f.position : 0; });
        if (!below || !table || !feet) {
            line("\n# TO DO: the dimension chain needs plane faces across y on slide and table.");
            return;
        }
        section("the gap between slide and table");
        line("# TO DO: {} of {} faces {} of {} over {:.1f} mm; are these the two faces of your tool?",
             in_words(below->position), solid(below->solid).name, in_words(table->position), solid(table->solid).name,
             1e3 * (below->position - table->position));
        plane("slide_face", below->solid, {0, 1, 0}, {0, below->position, 0});
        plane("table_top", table->solid, {0, 1, 0}, {0, table->position, 0});
        plane("feet", feet->solid, {0, 1, 0}, {0, feet->position, 0});
        line("[chain]\nslide_body = \"{}\"\nslide_surface = \"slide_face\"\ntable_surface = "
             "\"table_top\"\nground_surface = \"feet\"\ncrank_joint = \"{}\"\n"
             "reaction_angle = \"90 deg\"\ndrift_rate_limit = \"1 um/h\"",
             slide->name, crank->name);
    }

    void numerics()
    {
        section("how finely");
        line("[numerics]\nsize = {}", mm(global_size()));
    }

    const Draft& draft_;
    std::string file_;
    std::string out_;
};

}  // namespace

std::string draft_text(const Draft& draft, const std::string& file) { return Writer(draft, file).all(); }

}  // namespace deadpoint::full
