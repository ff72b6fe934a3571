#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/exchange/machine.hpp"

#include <vector>

/// Finds cells by position.
namespace deadpoint::machine {

struct Assembly;

/// Divides a box into equal bins.
class Bins {
public:
    /// @param per_axis  bins along each axis; 1 to 100 are made
    Bins(const BoxShape& box, double per_axis);
    [[nodiscard]] std::size_t size() const { return count_ * count_ * count_; }
    /// The bin of a point; for points outside, that of the nearest point in the box.
    [[nodiscard]] std::size_t at(const Vec3& point) const
    {
        return number(place(point[0], 0), place(point[1], 1), place(point[2], 2));
    }
    /// Calls back with every bin that a box touches.
    template <typename Visitor>
    void visit(const BoxShape& box, Visitor visitor) const
    {
        for (std::size_t k = place(box.min[2], 2); k <= place(box.max[2], 2); ++k) {
            for (std::size_t j = place(box.min[1], 1); j <= place(box.max[1], 1); ++j) {
                for (std::size_t i = place(box.min[0], 0); i <= place(box.max[0], 0); ++i) {
                    visitor(number(i, j, k));
                }
            }
        }
    }

private:
    [[nodiscard]] std::size_t place(double value, std::size_t axis) const;
    [[nodiscard]] std::size_t number(std::size_t i, std::size_t j, std::size_t k) const
    {
        return (k * count_ + j) * count_ + i;
    }

    BoxShape box_;
    std::size_t count_ = 1;
};

/// The cells of one part that hold a point.
class CellFinder {
public:
    /// Keeps a reference to the assembly's machine.
    CellFinder(const Assembly& assembly, std::uint32_t part);
    [[nodiscard]] const Bins& bins() const { return bins_; }
    [[nodiscard]] bool holds(const Vec3& point) const;
    /// Indices into Machine::cells; several where cells overlap or the point is on a face.
    [[nodiscard]] std::vector<std::uint32_t> cells_at(const Vec3& point) const;

private:
    const Machine& machine_;
    Bins bins_;
    std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace deadpoint::machine
