#pragma once

#include "deadpoint/core/vec.hpp"

#include <memory>
#include <string>

namespace deadpoint {

/// A formula of place and time typed by a user, such as "293.15 + 100*sin(pi*t/40)*x".
///
/// Known names: x, y, z [m], t [s], pi, e; functions and operators are those of muParser (sin, exp, min, ?: ...)
/// without assignments. A formula has one result: "293,15" has two. Not for concurrent calls on one object.
class Formula {
public:
    /// @throws InputError if the text is not a formula, with the place of the mistake
    explicit Formula(const std::string& text);
    ~Formula();
    Formula(Formula&&) noexcept;

    /// @throws DomainError if the value is not finite
    double operator()(const Vec3& position, double time) const;

    /// True if it contains x, y or z.
    [[nodiscard]] bool depends_on_place() const;

private:
    struct Parser;
    std::unique_ptr<Parser> parser_;
};

}  // namespace deadpoint
