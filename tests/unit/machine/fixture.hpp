#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/machine/assembly/build.hpp"
#include "deadpoint/observer.hpp"

#include <doctest/doctest.h>
#include <numbers>
#include <string>
#include <vector>

/// Small machines for the tests of the machine stage.
namespace machine_test {

using namespace deadpoint;

struct Log : Observer {
    std::vector<std::string> infos;
    std::vector<std::string> warnings;
    void info(std::string_view text) override { infos.emplace_back(text); }
    void warn(std::string_view text) override { warnings.emplace_back(text); }
};

inline Shape add(std::variant<BoxShape, CylinderShape, OutlineShape, ShaftShape> form)
{
    return {Shape::Operation::add, std::move(form)};
}
inline Shape cut(std::variant<BoxShape, CylinderShape, OutlineShape, ShaftShape> form)
{
    return {Shape::Operation::cut, std::move(form)};
}
inline CylinderShape cylinder(Axis axis, Vec2 centre, double diameter, double from, double to, double bore = 0)
{
    return {axis, centre, diameter, bore, from, to};
}

inline PartDescription part(std::string name, std::string body, std::vector<Shape> shapes, double size = 0)
{
    PartDescription result;
    result.name = std::move(name);
    result.body = std::move(body);
    result.source = std::move(shapes);
    result.size = size;
    result.density = 1000;
    return result;
}

inline SurfaceSelector on_cylinder(std::string part_name, Vec2 centre, double diameter, Axis axis = Axis::z)
{
    SurfaceSelector selector;
    selector.kind = SurfaceSelector::Kind::cylinder;
    selector.parts = {std::move(part_name)};
    selector.axis = axis;
    selector.centre = centre;
    selector.diameter = diameter;
    return selector;
}

inline SurfaceSelector on_plane(std::string part_name, Axis axis, double position)
{
    SurfaceSelector selector;
    selector.kind = SurfaceSelector::Kind::plane;
    selector.parts = {std::move(part_name)};
    selector.axis = axis;
    selector.position = position;
    return selector;
}

inline Machine build(const MachineDescription& description)
{
    Log log;
    return machine::build_machine(description, log);
}

/// The message of the InputError that building must throw.
inline std::string complaint(const MachineDescription& description)
{
    try {
        build(description);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

inline bool contains(const std::string& text, const std::string& piece)
{
    return text.find(piece) != std::string::npos;
}

/// Area of a circle's inscribed regular polygon over that of the circle.
inline double polygon_share(int corners)
{
    const double angle = 2 * std::numbers::pi / corners;
    return std::sin(angle) / angle;
}

}  // namespace machine_test
