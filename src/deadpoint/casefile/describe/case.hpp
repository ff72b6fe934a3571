#pragma once

#include "deadpoint/casefile/describe/case_elastic.hpp"
#include "deadpoint/casefile/describe/case_films.hpp"
#include "deadpoint/casefile/describe/case_friction.hpp"
#include "deadpoint/casefile/describe/case_heat.hpp"
#include "deadpoint/casefile/describe/case_loads.hpp"
#include "deadpoint/casefile/describe/case_reduce.hpp"
#include "deadpoint/casefile/describe/spelling.hpp"
#include "deadpoint/core/vec.hpp"
#include "deadpoint/exchange/machine.hpp"

#include <array>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The case file as plain data, in SI units. One describe() per struct (describe.hpp) names each key, its unit, its
/// range and its meaning; reading, checking, writing back and docs/case-file.md all come from that one description.
namespace deadpoint::casefile {

struct Material {
    /// mean: from the reference temperature on; instantaneous: the slope of the length over the temperature.
    enum class Expansion { mean, instantaneous };
    std::string library;  ///< name in the shipped library; given keys override it
    double density = 0;
    double conductivity = 0;  ///< for a table, its first value; likewise below
    double specific_heat = 0;
    double expansion = 0;
    Table conductivity_table;  ///< over temperature [W/m/K over K]; empty: constant
    Table specific_heat_table;
    Table expansion_table;
    std::optional<Expansion> expansion_kind;    ///< of a table
    std::optional<double> expansion_reference;  ///< of mean coefficients [K]
    double youngs_modulus = 0;
    double poissons_ratio = 0;
    std::string source;
};

struct Lubricant {
    enum class Law { table, walther, vogel };
    std::string library;
    double density = 0;
    Law law = Law::table;
    Table viscosity;                     ///< kinematic, over temperature [m2/s over K]
    std::optional<double> vogel_factor;  ///< [m2/s]
    std::optional<double> vogel_b;       ///< [K]
    double vogel_pole = 178.15;          ///< [K]
    std::string source;
};

struct Body {
    std::optional<double> mass;  ///< stated mass of the whole body (not of its modelled half) [kg]
    std::optional<Vec2> centre_of_mass;
    std::optional<double> inertia;
    bool ground = false;
    bool mirror = false;                        ///< exists twice: the loads include its image at x = 0
    std::optional<double> initial_temperature;  ///< else the machine's [K]
    bool thermal_only = false;  ///< bearing rings: part of the heat problem, but not a link of the dimension chain
};

struct Part {
    std::string body;
    std::string material;
    std::optional<double> size;
    std::vector<Shape> shapes;
    std::string step;               ///< path, relative to the file that names it
    std::string solid;              ///< SolidReference as text
    std::vector<std::string> axes;  ///< of the STEP file: "x", "-z", ...; none or three
    int circle_cells = 24;
    std::optional<double> smallest_cell;
    std::optional<double> omit;
    std::string mesh;
    std::optional<double> unit;  ///< of the file's lengths
    Vec3 position{};
    std::optional<double> initial_temperature;  ///< else the body's [K]
    bool tetrahedra = false;
    int order = 0;  ///< of its elements; 0: that of [numerics]
};

/// One of the bearings or bushes that share a joint.
struct JointElement {
    enum class Type { rolling, plain, guide };
    std::string name;
    Type type = Type::rolling;
    double position = 0;  ///< along the axis [m]
    double width = 0;
    double diameter = 0;
};

struct Interface {
    std::string name;
    std::string a;  ///< part or surface; the integrated side
    std::string b;
    std::optional<double> diameter;  ///< of the cylinder about the joint's centre; else both sides are surfaces
    Conductance conductance;
    double oil = 0;             ///< oil coefficient per area of the joint [W/m2/K]
    double heat_share = 1;      ///< relative share per area of the heat of its friction law
    std::string heat_into;      ///< part whose volume receives that heat; empty: the contact layer between the sides
    bool load_zone = false;     ///< the load part of that heat is distributed over the pressed zone
    bool stands_still = false;  ///< does not turn, although the joint turns fully (outer rings)
    bool seat = false;          ///< it carries the joint in the ground body (press/translate/linkage)
    bool journal = false;       ///< it carries the joint in the body that moves in the ground
    bool partial = false;       ///< side a may reach beyond side b
    std::optional<double> drawn_gap;  ///< largest distance of the sides as drawn [m]
};

/// Touching parts of one body that move together, but are not one solid for the heat.
struct Bond {
    std::vector<std::string> between;  ///< "part|part" patterns
    Conductance conductance;
};

/// The seat of a ball joint: the zone of the ball between two circles about the line on which it is pressed.
struct BallSeat {
    double diameter = 0;                 ///< [m]
    double from = 0;                     ///< half angle of the relief in its middle, seen from the ball's centre [rad]
    double to = 0.5 * std::numbers::pi;  ///< half angle to its rim [rad]
};

struct Joint {
    enum class Kind { revolute, slide, ball };
    Kind kind = Kind::revolute;
    std::vector<std::string> bodies;  ///< two
    Vec2 centre{};
    Vec2 direction{0, 1};
    bool guides_rotation = true;
    bool swept = true;                   ///< slide: its contact is distributed over the swept length
    double preload = 0;                  ///< slide: force that presses each of its two faces together [N]
    std::optional<double> guide_length;  ///< slide: distance of the guide's two ends, along the travel [m]
    bool turns_fully = false;
    bool driver = false;
    std::string friction;
    double oil_temperature = 293.15;
    std::optional<BallSeat> ball;
    std::optional<double> clearance;  ///< at the start: diametral, or of both faces of a slide together [m]
    std::vector<JointElement> elements;
    std::vector<Interface> interfaces;
};

struct Surface {
    /// exposed: faces that nothing touches and no other surface claims.
    enum class Select { exposed, all, plane, cylinder, box, group };
    std::vector<std::string> parts;
    Select select = Select::exposed;
    std::optional<Axis> axis;
    std::optional<double> position;
    Vec3 normal{};  ///< of an inclined plane, of any length, either way; else 0
    Vec3 point{};   ///< on an inclined plane [m]
    std::optional<Vec2> centre;
    std::optional<double> diameter;
    std::string group;
    std::optional<BoxShape> within;
    std::optional<Film> film;
    std::optional<Course> temperature;  ///< prescribed, over time [K]
    std::string temperature_formula;    ///< prescribed, in x, y, z, t (SI), kelvin
    std::optional<Course> heat_flux;    ///< into the part [W/m2]
    bool insulated = false;             ///< claims its faces against an "exposed" surface
};

struct Segment {
    std::string name;
    double duration = 0;
    double speed = 0;               ///< [rad/s]
    double force = 0;               ///< [N]
    std::optional<Course> ambient;  ///< [K], time counted from the segment's start
};

struct Probe {
    std::string part;
    Vec3 position{};
    std::string note;
};

struct Chain {
    /// Motion of the crank when heat opens or closes its bearings.
    enum class Play { limited, none, paper };
    std::string slide_body;
    std::string slide_surface;
    std::string table_surface;
    std::string ground_surface;            ///< the feet
    std::string crank_joint;               ///< its seats give E_BG, its rings E_BC
    std::optional<double> reaction_angle;  ///< direction in which the crank is pressed into its bearings at bottom dead
                                           ///< point [rad from x]; else along the stroke
    std::optional<Play> bearing_play;      ///< else by joint and bearing type
    double drift_rate_limit = 0;           ///< warm-up is over when |dE/dt| stays below [m/s]
    bool corners = true;                   ///< also the gap at the slide's four corners
    bool clearances = true;                ///< also the clearances of guides and bearings
    std::optional<double> press_stiffness;  ///< press and tool in series, at the slide [N/m]
};

struct Numerics {
    double size = 0.03;
    double seam_tolerance = 1e-5;  ///< between shapes of one part [m]
    double deformation_size = 0;   ///< cell sizes of the deformation's mesh relative to the heat's; 0: automatic
    int deformation_order = 0;     ///< of the deformation's elements; 0: that of the heat's
    double time_tolerance = 0.02;  ///< at probes and joints, in sumps and enclosed air [K]
    double initial_step = 1;
    double max_step = 1800;
    double solver_tolerance = 1e-6;
    int order = 1;                ///< of the elements
    std::string accuracy;         ///< of rises or gap (casefile/check/accuracy.hpp); empty: the mesh stays as it is
    int accuracy_rounds = 8;      ///< meshes at most
    int accuracy_cells = 500000;  ///< of a mesh at most
};

struct Output {
    /// How contributions are computed: by the number of temperatures, in all unknowns, or on a few fields.
    enum class CausesBy { size, steps, basis };
    double history_interval = 60;
    std::vector<double> field_times;  ///< [s]; the end is always written
    bool fields = true;
    bool causes = true;
    CausesBy causes_by = CausesBy::size;
    std::vector<std::string> stress;  ///< bodies, parts or patterns of parts
};

struct MachineSection {
    std::string name;
    std::string description;
    bool half_model = false;
    double initial_temperature = 293.15;
    double ambient = 293.15;
    Vec3 gravity_direction{0, -1, 0};   ///< of any length
    std::vector<std::string> unbonded;  ///< "part|part" patterns
    std::string front, left, up;        ///< "x", "-z", ...; empty: see casefile/check/directions.hpp
};

struct ReferenceRise {
    std::string probe;
    double rise = 0;
};

/// Published or measured values shown beside the result; never an input of the model.
struct Reference {
    std::string source;
    double time = 0;
    std::map<std::string, double> rises;     ///< by probe [K]
    std::vector<std::string> calibrated_on;  ///< keys of the case that were fitted to these values
};

struct CaseSource;

struct Case {
    int format = 1;
    MachineSection machine;
    std::map<std::string, Material> materials;
    std::map<std::string, Lubricant> lubricants;
    std::map<std::string, Body> bodies;
    std::map<std::string, Part> parts;
    std::map<std::string, Friction> friction;
    std::map<std::string, double> oil;  ///< oil coefficient per area of the joints, by friction law [W/m2/K]
    std::map<std::string, SpeedGrowth> oil_with_speed;  ///< of the oil coefficients, by friction law
    std::map<std::string, OilCircuit> oil_circuits;
    std::map<std::string, Joint> joints;
    std::map<std::string, Bond> bonds;
    std::map<std::string, Surface> surfaces;
    std::map<std::string, HeatInput> heat_sources;
    std::map<std::string, Enclosure> enclosures;
    Mechanism mechanism;
    std::optional<Crankshaft> crankshaft;
    std::optional<ProcessForce> process_force;
    std::vector<Segment> operation;
    std::map<std::string, Probe> probes;
    std::optional<Chain> chain;
    std::optional<Foundation> foundation;
    std::map<std::string, Preload> preload;
    Numerics numerics;
    Output output;
    std::optional<Reduce> reduce;
    std::optional<Reference> reference;
    /// The texts it was read from, for errors found later (files/case_source.hpp); null for a case made in memory.
    std::shared_ptr<const CaseSource> source;
};

template <>
inline constexpr auto spelling<Material::Expansion> = std::array<std::string_view, 2>{"mean", "instantaneous"};
template <>
inline constexpr auto spelling<Lubricant::Law> = std::array<std::string_view, 3>{"table", "walther", "vogel"};
template <>
inline constexpr auto spelling<JointElement::Type> = std::array<std::string_view, 3>{"rolling", "plain", "guide"};
template <>
inline constexpr auto spelling<Joint::Kind> = std::array<std::string_view, 3>{"revolute", "slide", "ball"};
template <>
inline constexpr auto spelling<Surface::Select> =
    std::array<std::string_view, 6>{"exposed", "all", "plane", "cylinder", "box", "group"};
template <>
inline constexpr auto spelling<Output::CausesBy> = std::array<std::string_view, 3>{"size", "steps", "basis"};
template <>
inline constexpr auto spelling<Chain::Play> = std::array<std::string_view, 3>{"limited", "none", "paper"};

}  // namespace deadpoint::casefile
