#include "deadpoint/press/loads/turn_cache.hpp"

#include "deadpoint/mechanism/bottom_dead_point.hpp"
#include "deadpoint/mechanism/turn.hpp"

#include <algorithm>
#include <tuple>

namespace deadpoint::press {
namespace {

bool same(const LinkageJoint& a, const LinkageJoint& b)
{
    const auto all = [](const LinkageJoint& j) {
        return std::tie(j.name, j.kind, j.body_a, j.body_b, j.centre, j.direction, j.guides_rotation);
    };
    return all(a) == all(b);
}

bool same(const Linkage& a, const Linkage& b)
{
    const auto all = [](const Linkage& l) {
        return std::tie(l.bodies, l.ground, l.driver, l.slide_body, l.stroke_direction);
    };
    return all(a) == all(b) &&
           std::ranges::equal(a.joints, b.joints, [](const auto& x, const auto& y) { return same(x, y); });
}

}  // namespace

std::shared_ptr<const mechanism::Turn> TurnCache::get(const Linkage& linkage, int positions)
{
    const std::scoped_lock lock(mutex_);
    if (!turn_ || positions_ != positions || !same(linkage_, linkage)) {
        turn_ = std::make_shared<const mechanism::Turn>(mechanism::turn_of(linkage, positions));
        linkage_ = linkage;
        positions_ = positions;
    }
    return turn_;
}

BottomDeadPointSensitivity TurnCache::bottom(const Linkage& linkage)
{
    const std::scoped_lock lock(mutex_);
    if (!bottom_ || !same(bottom_->first, linkage))
        bottom_.emplace(linkage, mechanism::bottom_dead_point(linkage));
    return bottom_->second;
}

}  // namespace deadpoint::press
