#include "deadpoint/casefile/check/directions.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/describe/case_films.hpp"
#include "deadpoint/casefile/describe/findings.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/exchange/named_axes.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::casefile {
namespace {

constexpr double standard_gravity = 9.81;  // [m/s2]

std::string slide_of(const Case& c)
{
    return c.mechanism.slide_body.empty() && c.chain ? c.chain->slide_body : c.mechanism.slide_body;
}

bool is_ground(const Case& c, const std::string& body)
{
    const auto found = c.bodies.find(body);
    return found != c.bodies.end() && found->second.ground;
}

// Name and joint of the guide that holds the slide on the ground, or the end.
std::map<std::string, Joint>::const_iterator guide_of(const Case& c)
{
    const auto slide = slide_of(c);
    return std::ranges::find_if(c.joints, [&](const auto& entry) {
        const auto& joint = entry.second;
        return joint.kind == Joint::Kind::slide && norm(joint.direction) > 0 &&
               std::ranges::find(joint.bodies, slide) != joint.bodies.end() &&
               std::ranges::any_of(joint.bodies, [&](const auto& body) { return is_ground(c, body); });
    });
}

Vec2 unit(const Vec2& v) { return (1 / norm(v)) * v; }
double cross(const Vec2& a, const Vec2& b) { return a[0] * b[1] - a[1] * b[0]; }

Finding mistake(std::string path, std::string message, std::string help)
{
    return {"inconsistent", std::move(path), std::move(message), std::move(help)};
}

std::variant<Vec2, Finding> stated_direction(const Case& c)
{
    const Vec2 stated = unit(*c.mechanism.stroke_direction);
    const auto guide = guide_of(c);
    if (guide == c.joints.end() || std::abs(cross(stated, unit(guide->second.direction))) < aligned)
        return stated;
    const Vec2 along = unit(guide->second.direction);
    return mistake("mechanism.stroke_direction",
                   fmt::format("the slide's guide '{}' lies along [{:.6g}, {:.6g}], not along the stroke", guide->first,
                               along[0], along[1]),
                   "state it along the guide, from the table towards the slide, or remove it");
}

/// The axis, with its sign, that is nearest to a direction.
Vec3 nearest_axis(const Vec3& direction)
{
    std::size_t most = 1;
    for (const std::size_t i : {0u, 2u})
        if (std::abs(direction[i]) > std::abs(direction[most]) + aligned)
            most = i;
    Vec3 axis{};
    axis[most] = direction[most] < 0 ? -1 : 1;
    return axis;
}

/// Where nothing but `up` is known: along the crankshaft, or of a press drawn on its back along y.
Vec3 usual_front(const Vec3& up) { return std::abs(up[2]) > 0.5 ? Vec3{0, 1, 0} : Vec3{0, 0, 1}; }

Finding front_mistake(const MachineSection& m, std::string message, std::string help)
{
    return mistake(m.front.empty() ? "machine.left" : "machine.front", std::move(message), std::move(help));
}

// Whether the height of a wall follows from the geometry.
bool takes_height(const FilmLaw& law)
{
    const auto* plate = std::get_if<PlateFilm>(&law);
    const auto* moving = std::get_if<MovingFilm>(&law);
    const auto* enclosed = std::get_if<EnclosedFilm>(&law);
    return (plate != nullptr && plate->facing == PlateFilm::Facing::sideways && !plate->length) ||
           (moving != nullptr && !moving->length) || (enclosed != nullptr && !enclosed->length);
}

// Heights of walls that the geometry tells are extents along y.
void check_walls(const Case& c, std::vector<Finding>& findings)
{
    const Vec3 down = normalised(c.machine.gravity_direction);
    if (std::abs(down[1]) > 1 - aligned)
        return;
    for (const auto& [name, surface] : c.surfaces) {
        if (surface.film && takes_height(surface.film->law)) {
            findings.push_back(mistake("surfaces." + name + ".film",
                                       "its height would be taken along y, but gravity does not act along y",
                                       "add length = \"500 mm\", the height of the surface along gravity"));
            findings.back().warning = true;
        }
    }
}

}  // namespace

std::variant<Vec2, Finding> find_stroke_direction(const Case& c)
{
    if (c.mechanism.stroke_direction)
        return stated_direction(c);
    const Vec2 pull = plane_gravity(c);
    const auto guide = guide_of(c);
    if (guide == c.joints.end())
        return norm(pull) > 0 ? Vec2{-unit(pull)[0], -unit(pull)[1]} : Vec2{0, 1};
    const Vec2 along = unit(guide->second.direction);
    const double down = dot(along, pull) / standard_gravity;
    if (std::abs(down) < aligned)
        return mistake(fmt::format("joints.{}.direction", guide->first),
                       "the slide travels across gravity, so it is not known at which end of its stroke the table is",
                       fmt::format("add stroke_direction = [{:.6g}, {:.6g}] to [mechanism], from the table towards the "
                                   "slide, or its opposite",
                                   along[0], along[1]));
    return (down > 0 ? -1.0 : 1.0) * along;
}

Vec2 stroke_direction(const Case& c)
{
    const auto found = find_stroke_direction(c);
    if (const auto* finding = std::get_if<Finding>(&found))
        throw deadpoint::mistake(finding->path, finding->message, finding->help);
    return std::get<Vec2>(found);
}

Vec2 plane_gravity(const Case& c)
{
    const Vec3 direction = normalised(c.machine.gravity_direction);
    return {standard_gravity * direction[0], standard_gravity * direction[1]};
}

std::variant<Viewer, Finding> find_viewer(const Case& c)
{
    const auto& m = c.machine;
    const Vec3 against = -1.0 * normalised(m.gravity_direction);
    Viewer viewer;
    viewer.up = named_axis(m.up).value_or(nearest_axis(against));
    if (dot(viewer.up, against) < std::sqrt(0.5) - aligned)
        return mistake("machine.up",
                       fmt::format("up is {}, but weights act along ({:.4g}, {:.4g}, {:.4g})", axis_name(viewer.up),
                                   -against[0], -against[1], -against[2]),
                       fmt::format("add gravity_direction = [{:g}, {:g}, {:g}], or correct `up`", -viewer.up[0],
                                   -viewer.up[1], -viewer.up[2]));
    const auto front = named_axis(m.front), left = named_axis(m.left);
    viewer.front = front ? *front : left ? deadpoint::cross(viewer.up, *left) : usual_front(viewer.up);
    if ((front || left) && std::abs(dot(front ? *front : *left, viewer.up)) > aligned)
        return front_mistake(m, fmt::format("it is along {}, as `up` is", axis_name(viewer.up)),
                             "front, left and up stand at right angles: name three different axes");
    viewer.left = deadpoint::cross(viewer.front, viewer.up);
    if (left && dot(*left, viewer.left) < 1 - aligned)
        return mistake("machine.left",
                       fmt::format("who looks at the machine from {}, with {} up, has {} on the left, not {}",
                                   axis_name(viewer.front), axis_name(viewer.up), axis_name(viewer.left), m.left),
                       fmt::format("remove `left`, or let it be \"{}\"", axis_name(viewer.left)));
    const auto stroke = find_stroke_direction(c);
    if (const auto* e = std::get_if<Vec2>(&stroke); e != nullptr && c.chain)
        if (std::abs(dot(viewer.front, Vec3{(*e)[0], (*e)[1], 0})) > aligned)
            return front_mistake(m, "the slide travels towards the front, so that its corners have no front and back",
                                 "let the front be across the stroke, such as along the crankshaft: \"z\" or \"-z\"");
    return viewer;
}

Viewer viewer_of(const Case& c)
{
    const auto found = find_viewer(c);
    if (const auto* finding = std::get_if<Finding>(&found))
        throw deadpoint::mistake(finding->path, finding->message, finding->help);
    return std::get<Viewer>(found);
}

std::vector<Finding> check_directions(const Case& c)
{
    std::vector<Finding> findings;
    if (auto viewer = find_viewer(c); auto* finding = std::get_if<Finding>(&viewer))
        findings.push_back(std::move(*finding));
    const bool symmetric =
        c.machine.half_model || std::ranges::any_of(c.bodies, [](const auto& entry) { return entry.second.mirror; });
    if (symmetric && std::abs(normalised(c.machine.gravity_direction)[0]) > aligned)
        findings.push_back(
            mistake("machine.gravity_direction",
                    "gravity must not act across the plane of symmetry, x = 0, of a half model or of bodies "
                    "that have a mirror image",
                    "let it be 0 along x, or describe the whole machine"));
    check_walls(c, findings);
    if (slide_of(c).empty())
        return findings;
    auto stroke = find_stroke_direction(c);
    if (auto* finding = std::get_if<Finding>(&stroke))
        findings.push_back(std::move(*finding));
    else if (symmetric && std::abs(std::get<Vec2>(stroke)[0]) > aligned)
        findings.push_back(mistake(c.mechanism.stroke_direction ? "mechanism.stroke_direction" : "mechanism.slide_body",
                                   "the slide does not travel within the plane of symmetry, x = 0, of a half model or "
                                   "of bodies that have a mirror image",
                                   "turn the coordinates so that it travels along y, or describe the whole machine"));
    return findings;
}

}  // namespace deadpoint::casefile
