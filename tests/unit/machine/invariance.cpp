#include "fixture.hpp"
#include "near.hpp"

#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <functional>

using namespace machine_test;

namespace {

/// Where a point of the machine goes, and how a length is written and read.
struct Change {
    std::string name;
    std::array<std::size_t, 3> axis{0, 1, 2};  ///< new coordinate i is sign[i] times the old one axis[i] plus shift[i]
    Vec3 sign{1, 1, 1};
    Vec3 shift{};
    std::function<double(double)> length = [](double x) { return x; };

    [[nodiscard]] Vec3 operator()(const Vec3& p) const
    {
        Vec3 q{};
        for (std::size_t i = 0; i < 3; ++i) {
            q[i] = length(sign[i] * p[axis[i]] + shift[i]);
        }
        return q;
    }
    [[nodiscard]] Axis operator()(Axis old) const
    {
        return static_cast<Axis>(std::find(axis.begin(), axis.end(), static_cast<std::size_t>(old)) - axis.begin());
    }
};

Vec3 along_axis(Axis axis, const Vec2& across, double along)
{
    if (axis == Axis::x) {
        return {along, across[0], across[1]};
    }
    return axis == Axis::y ? Vec3{across[0], along, across[1]} : Vec3{across[0], across[1], along};
}

Vec2 without(Axis axis, const Vec3& p)
{
    if (axis == Axis::x) {
        return {p[1], p[2]};
    }
    return axis == Axis::y ? Vec2{p[0], p[2]} : Vec2{p[0], p[1]};
}

struct ChangeShape {
    const Change& change;

    [[nodiscard]] Vec2 point(Axis axis, const Vec2& p) const
    {
        return without(change(axis), change(along_axis(axis, p, 0)));
    }
    void range(Axis axis, double& from, double& to) const
    {
        const auto k = static_cast<std::size_t>(change(axis));
        const double a = change(along_axis(axis, {}, from))[k];
        const double b = change(along_axis(axis, {}, to))[k];
        from = std::min(a, b);
        to = std::max(a, b);
    }
    void operator()(BoxShape& box) const
    {
        const Vec3 a = change(box.min);
        const Vec3 b = change(box.max);
        for (std::size_t i = 0; i < 3; ++i) {
            box.min[i] = std::min(a[i], b[i]);
            box.max[i] = std::max(a[i], b[i]);
        }
    }
    void operator()(CylinderShape& cylinder) const
    {
        cylinder.centre = point(cylinder.axis, cylinder.centre);
        range(cylinder.axis, cylinder.from, cylinder.to);
        cylinder.diameter = change.length(cylinder.diameter);
        cylinder.bore = change.length(cylinder.bore);
        cylinder.axis = change(cylinder.axis);
    }
    void operator()(OutlineShape& outline) const
    {
        for (Vec2& p : outline.points) {
            p = point(outline.axis, p);
        }
        range(outline.axis, outline.from, outline.to);
        outline.axis = change(outline.axis);
    }
    void operator()(ShaftShape& /*shaft*/) const { FAIL("a turned shaft would run backwards"); }
};

/// A plate, an oblique lever with a bore off its middle, a pin, a stepped column and a block of tetrahedra. Lengths of
/// two and a quarter cell sizes are where a last digit decides how many cells there are.
MachineDescription press_in_small()
{
    MachineDescription description;
    description.size = 0.01;
    const Shape plate = add(BoxShape{{-0.0925, 0, 0}, {0.0925, 0.0225, 0.1225}});
    const Shape lever =
        add(OutlineShape{Axis::z,
                         {{-0.0312345, 0.03}, {0.0421234, 0.0456789}, {0.0398765, 0.0861234}, {-0.03, 0.0712345}},
                         {},
                         0,
                         0.0225});
    const Shape eye = cut(cylinder(Axis::z, {0.0123456, 0.06}, 0.02, 0, 0.0225));
    const Shape column = add(cylinder(Axis::y, {0.05, 0.07}, 0.04, 0.0225, 0.0625));
    const Shape foot = add(cylinder(Axis::y, {0.05, 0.07}, 0.06, 0.0225, 0.0325));
    const Shape window = cut(cylinder(Axis::z, {-0.0612345, 0.01}, 0.01, 0, 0.1225));
    const Shape block = add(BoxShape{{-0.09, 0.0225, 0.03}, {-0.0412345, 0.06, 0.1}});
    const Shape cross_bore = cut(cylinder(Axis::x, {0.05, 0.0654321}, 0.015, -0.09, -0.0412345));
    const Shape down_bore = cut(cylinder(Axis::y, {-0.07, 0.0754321}, 0.015, 0.0225, 0.06));
    description.parts = {part("window", "frame", {plate, window}), part("lever", "lever", {lever, eye}),
                         part("pin", "pin", {add(cylinder(Axis::z, {0.0123456, 0.06}, 0.02, -0.01, 0.03))}),
                         part("column", "frame", {column, foot}),
                         part("block", "frame", {block, cross_bore, down_bore}, 0.012)};
    return description;
}

MachineDescription changed(MachineDescription description, const Change& change)
{
    for (PartDescription& part : description.parts) {
        for (Shape& shape : std::get<std::vector<Shape>>(part.source)) {
            std::visit(ChangeShape{change}, shape.form);
        }
        part.size = change.length(part.size);
    }
    description.size = change.length(description.size);
    return description;
}

const MeshPart& named(const Machine& machine, const std::string& name)
{
    const auto found = std::find_if(machine.parts.begin(), machine.parts.end(),
                                    [&](const MeshPart& part) { return part.name == name; });
    REQUIRE(found != machine.parts.end());
    return *found;
}

/// Largest distance of a cell's node from that of the same cell in the machine as it was, both to and fro.
double difference(const Machine& machine, const Machine& original, const Change& change)
{
    double worst = 0;
    for (const MeshPart& part : original.parts) {
        INFO(part.name);
        const MeshPart& other = named(machine, part.name);
        REQUIRE(other.cell_count == part.cell_count);
        for (std::uint32_t c = 0; c < part.cell_count; ++c) {
            const Cell& cell = original.cells[part.first_cell + c];
            const Cell& image = machine.cells[other.first_cell + c];
            for (std::size_t i = 0; i < (cell.kind == CellKind::hexahedron ? 8U : 4U); ++i) {
                worst = std::max(worst, norm(machine.nodes[image.nodes[i]] - change(original.nodes[cell.nodes[i]])));
            }
        }
    }
    return worst;
}

}  // namespace

TEST_CASE("a machine in inches, shifted, or turned by right angles has the same mesh")
{
    const MachineDescription description = press_in_small();
    const Machine original = build(description);
    const auto inches = [](double x) {
        return 0.0254 * std::strtod(fmt::format("{:.15g}", x / 0.0254).c_str(), nullptr);
    };
    const auto micrometres = [](double x) {
        return 1e-6 * std::strtod(fmt::format("{:.15g}", 1e6 * x).c_str(), nullptr);
    };
    const std::vector<Change> changes{{"inches", {0, 1, 2}, {1, 1, 1}, {}, inches},
                                      {"micrometres", {0, 1, 2}, {1, 1, 1}, {}, micrometres},
                                      {"shifted by a metre", {0, 1, 2}, {1, 1, 1}, {1, 0, 0}},
                                      {"shifted", {0, 1, 2}, {1, 1, 1}, {-0.1234567, 3.21, -7.7}},
                                      {"90 degrees about z", {1, 0, 2}, {-1, 1, 1}, {}},
                                      {"90 degrees about x", {0, 2, 1}, {1, -1, 1}, {}},
                                      {"180 degrees about y", {0, 1, 2}, {-1, 1, -1}, {}},
                                      {"x to y to z, shifted", {2, 0, 1}, {1, 1, 1}, {0.3, -1.1, 0.7}}};
    for (const Change& change : changes) {
        CAPTURE(change.name);
        // A picometre of rounding, and what a few metres leave of doubles; a part is 0.1 m long.
        CHECK(difference(build(changed(description, change)), original, change) < 1e-10);
    }
}

TEST_CASE("neither the order of the parts nor other parts' being there changes a part's mesh")
{
    const MachineDescription description = press_in_small();
    const Machine original = build(description);
    MachineDescription backwards = description;
    std::reverse(backwards.parts.begin(), backwards.parts.end());
    CHECK(difference(build(backwards), original, {"none"}) == 0);
    for (const PartDescription& part : description.parts) {
        CAPTURE(part.name);
        MachineDescription alone = description;
        alone.parts = {part};
        CHECK(build(alone).parts[0].cell_count == named(original, part.name).cell_count);
    }
}

TEST_CASE("a half model in inches, or shifted and turned along its plane of symmetry, has the same mesh")
{
    MachineDescription description = press_in_small();
    description.half_model = true;
    const Machine original = build(description);
    const auto inches = [](double x) {
        return 0.0254 * std::strtod(fmt::format("{:.15g}", x / 0.0254).c_str(), nullptr);
    };
    for (const Change& change :
         {Change{"inches", {0, 1, 2}, {1, 1, 1}, {}, inches}, Change{"shifted", {0, 1, 2}, {1, 1, 1}, {0, 1, 0.3}},
          Change{"turned", {0, 2, 1}, {1, 1, -1}, {}}}) {
        CAPTURE(change.name);
        CHECK(difference(build(changed(description, change)), original, change) < 1e-10);
    }
}

TEST_CASE("a length of a whole number of cell sizes and a quarter has as many cells in any unit")
{
    for (const double size : {0.034, 0.03, 0.0115, 0.023, 0.0254}) {
        for (int count = 1; count < 30; count += 4) {
            CAPTURE(size);
            CAPTURE(count);
            for (const double off : {-1e-15, 0.0, 1e-15}) {
                const double length = (count + 0.25) * size * (1 + off);
                const auto cells = [&](double shift) {
                    MachineDescription description;
                    description.parts = {
                        part("p", "b", {add(BoxShape{{shift, 0, 0}, {shift + length, size, size}})}, size)};
                    return build(description).parts[0].cell_count;
                };
                CHECK(cells(0) == static_cast<std::uint32_t>(count));
                CHECK(cells(1) == static_cast<std::uint32_t>(count));
            }
        }
    }
}

TEST_CASE("a STEP part that is moved has the same mesh, whole or cut by the plane of symmetry")
{
    for (const bool half : {false, true}) {
        CAPTURE(half);
        MachineDescription description;
        description.half_model = half;
        description.size = 0.01;
        description.parts = {part("plate", "frame", {})};
        description.parts[0].source = StepSource{DEADPOINT_TEST_DATA "/plate_with_hole.step"};
        const Machine original = build(description);
        const Change moved{"moved", {0, 1, 2}, {1, 1, 1}, {half ? 0.0 : 1.0, -0.7, 0.3}};
        description.parts[0].translation = moved.shift;
        const Machine image = build(description);
        CHECK(difference(image, original, moved) < 1e-10);
        CHECK(image.geometries.size() == original.geometries.size());
        CHECK(image.parts[0].cut == half);
    }
}

TEST_CASE("a STEP part is cut by the plane of symmetry where it stands")
{
    MachineDescription description;
    description.half_model = true;
    description.size = 0.01;
    description.parts = {part("plate", "frame", {})};
    description.parts[0].source = StepSource{DEADPOINT_TEST_DATA "/plate_with_hole.step"};
    description.parts[0].translation = {-0.04, 0, 0};  // 100 mm long: x from -90 to 10 mm
    const Machine machine = build(description);
    CHECK(machine.parts[0].cut);
    double low = 0;
    double high = -1;
    for (const Vec3& node : machine.nodes) {
        low = std::min(low, node[0]);
        high = std::max(high, node[0]);
    }
    CHECK(low == near(-0.09, 1e-9));
    CHECK(high == 0);
}
