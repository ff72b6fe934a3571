#include "deadpoint/report/loads/linkage_drawing.hpp"

#include "deadpoint/core/names/plain_text.hpp"
#include "deadpoint/core/vec.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/cycle.hpp"
#include "deadpoint/exchange/linkage.hpp"
#include "deadpoint/report/tables/table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <utility>

namespace deadpoint::report {
namespace {

constexpr std::array<const char*, 8> body_palette{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                  "#56b4e9", "#e69f00", "#8a6d3b", "#444444"};
constexpr const char* path_grey = "#8a8a8a";
constexpr double panel_height = 460;
constexpr double widest_panel = 420;
constexpr double margin = 26;
constexpr double narrowest_pitch = 140;  // space for the panel's title

Vec2 turned(const PlanarPose& pose, const Vec2& point)
{
    const double c = std::cos(pose.angle), s = std::sin(pose.angle);
    return {pose.translation[0] + c * point[0] - s * point[1], pose.translation[1] + s * point[0] + c * point[1]};
}

double cross_of(const Vec2& a, const Vec2& b) { return a[0] * b[1] - a[1] * b[0]; }

// Convex hull, counter-clockwise (Andrew's monotone chain); points that coincide count once.
std::vector<Vec2> hull(std::vector<Vec2> points, double tolerance)
{
    std::ranges::sort(points);
    std::vector<Vec2> distinct;
    for (const auto& p : points)
        if (std::ranges::none_of(distinct, [&](const Vec2& q) { return norm(p - q) < tolerance; }))
            distinct.push_back(p);
    if (distinct.size() < 3)
        return distinct;
    std::vector<Vec2> chain;
    for (int side = 0; side < 2; ++side) {
        const std::size_t start = chain.size();
        for (const auto& p : distinct) {
            while (chain.size() >= start + 2 && cross_of(chain.back() - chain[chain.size() - 2], p - chain.back()) <= 0)
                chain.pop_back();
            chain.push_back(p);
        }
        chain.pop_back();
        std::ranges::reverse(distinct);
    }
    return chain;
}

struct Bounds {
    Vec2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Vec2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    void add(const Vec2& p)
    {
        for (std::size_t i = 0; i < 2; ++i) {
            low[i] = std::min(low[i], p[i]);
            high[i] = std::max(high[i], p[i]);
        }
    }
};

class Drawing {
public:
    Drawing(const Linkage& linkage, const CycleHistory& history) : linkage_(linkage), history_(history)
    {
        for (const auto& joint : history.joints)
            for (const auto& centre : joint.centre)
                bounds_.add(centre);
        const Vec2 span = bounds_.high - bounds_.low;
        size_ = std::max({span[0], span[1], 1e-9});
        block_ = 0.035 * size_;
        for (std::size_t i = 0; i < 2; ++i) {
            bounds_.low[i] -= 2.2 * block_;
            bounds_.high[i] += 2.2 * block_;
        }
        const Vec2 whole = bounds_.high - bounds_.low;
        scale_ = std::min(panel_height / whole[1], widest_panel / whole[0]);
        colour_bodies();
    }

    [[nodiscard]] double width() const { return scale_ * (bounds_.high[0] - bounds_.low[0]); }
    [[nodiscard]] double height() const { return scale_ * (bounds_.high[1] - bounds_.low[1]); }

    std::string panel(std::size_t position, double left, double top, bool labelled)
    {
        left_ = left;
        top_ = top;
        std::string svg;
        for (std::size_t j = 0; j < linkage_.joints.size(); ++j)
            svg += path_of(j);
        for (std::size_t j = 0; j < linkage_.joints.size(); ++j)
            if (linkage_.joints[j].kind == LinkageJoint::Kind::slide)
                svg += guide(j, position);
        for (std::size_t b = 0; b < linkage_.bodies.size(); ++b)
            if (static_cast<int>(b) != linkage_.ground)
                svg += body(static_cast<int>(b), position);
        for (std::size_t j = 0; j < linkage_.joints.size(); ++j)
            if (linkage_.joints[j].kind == LinkageJoint::Kind::revolute)
                svg += pin(j, position);
        return labelled ? svg + labels(position) : svg;
    }

private:
    [[nodiscard]] Vec2 at(const Vec2& p) const
    {
        return {left_ + scale_ * (p[0] - bounds_.low[0]), top_ + scale_ * (bounds_.high[1] - p[1])};
    }

    void colour_bodies()
    {
        std::vector<std::string> seen;
        for (const auto& name : linkage_.bodies) {
            const std::string original = name.ends_with('\'') ? name.substr(0, name.size() - 1) : name;
            auto found = std::ranges::find(seen, original);
            if (found == seen.end()) {
                seen.push_back(original);
                found = seen.end() - 1;
            }
            colours_.push_back(body_palette.at(static_cast<std::size_t>(found - seen.begin()) % body_palette.size()));
        }
    }

    [[nodiscard]] bool has(const LinkageJoint& joint, int body) const
    {
        return joint.body_a == body || joint.body_b == body;
    }

    [[nodiscard]] std::vector<Vec2> corners(int body, std::size_t position) const
    {
        std::vector<Vec2> points;
        const auto& pose = history_.bodies[static_cast<std::size_t>(body)].pose[position];
        for (const auto& joint : linkage_.joints)
            if (has(joint, body))
                points.push_back(turned(pose, joint.centre));
        return hull(points, 1e-6 * size_);
    }

    [[nodiscard]] std::string outline(const std::vector<Vec2>& points) const
    {
        std::string text;
        for (const auto& p : points) {
            const Vec2 q = at(p);
            text += fmt::format("{}{:.1f} {:.1f}", text.empty() ? "M" : "L", q[0], q[1]);
        }
        return text;
    }

    // Leaves out points that would coincide with the previous one.
    [[nodiscard]] std::vector<Vec2> thinned(const std::vector<Vec2>& points) const
    {
        std::vector<Vec2> kept;
        for (const auto& p : points)
            if (kept.empty() || scale_ * norm(p - kept.back()) > 1)
                kept.push_back(p);
        return kept;
    }

    std::string body(int index, std::size_t position) const
    {
        const auto points = corners(index, position);
        const char* colour = colours_[static_cast<std::size_t>(index)];
        std::string svg;
        if (points.size() >= 2)
            svg +=
                fmt::format("<path d=\"{}{}\" fill=\"{}\" fill-opacity=\"0.25\" stroke=\"{}\" stroke-width=\"4\" "
                            "stroke-linejoin=\"round\" stroke-linecap=\"round\"/>\n",
                            outline(points), points.size() > 2 ? "Z" : "", points.size() > 2 ? colour : "none", colour);
        for (const auto& joint : linkage_.joints)
            if (joint.kind == LinkageJoint::Kind::slide && has(joint, index))
                svg += slide_block(joint, index, position, colour);
        return svg;
    }

    // Draws the block that slides in a guide, for the body that is not the ground.
    std::string slide_block(const LinkageJoint& joint, int index, std::size_t position, const char* colour) const
    {
        const auto& pose = history_.bodies[static_cast<std::size_t>(index)].pose[position];
        const Vec2 centre = turned(pose, joint.centre);
        const Vec2 along = (1 / norm(joint.direction)) * joint.direction;
        const Vec2 across{along[1], -along[0]};
        std::vector<Vec2> box;
        for (const auto& [s, t] : {std::pair{-1.0, -1.4}, {1.0, -1.4}, {1.0, 1.4}, {-1.0, 1.4}})
            box.push_back(centre + (s * block_) * across + (t * block_) * along);
        return fmt::format("<path d=\"{}Z\" fill=\"{}\" fill-opacity=\"0.35\" stroke=\"{}\" stroke-width=\"2\"/>\n",
                           outline(box), colour, colour);
    }

    // Draws two hatched lines beside the block, as long as its travel.
    std::string guide(std::size_t j, std::size_t position) const
    {
        const auto& joint = linkage_.joints[j];
        (void)position;
        const Vec2 along = (1 / norm(joint.direction)) * joint.direction;
        const Vec2 across{along[1], -along[0]};
        const int body = joint.body_b == linkage_.ground ? joint.body_a : joint.body_b;
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const auto& pose : history_.bodies[static_cast<std::size_t>(body)].pose) {
            const double s = dot(turned(pose, joint.centre), along);
            low = std::min(low, s);
            high = std::max(high, s);
        }
        low -= 1.9 * block_;
        high += 1.9 * block_;
        const double offset = dot(joint.centre, across);
        std::string svg;
        for (const double side : {-1.0, 1.0}) {
            const Vec2 base = (offset + side * 1.05 * block_) * across;
            std::string path = outline({base + low * along, base + high * along});
            const double pitch = 0.45 * block_;
            const long strokes = std::lround((high - low) / pitch);
            for (long i = 0; i < strokes; ++i) {
                const Vec2 foot = base + (low + (static_cast<double>(i) + 0.5) * pitch) * along;
                path += outline({foot, foot + (side * 0.35 * block_) * across - (0.35 * block_) * along});
            }
            svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1\"/>\n", path, path_grey);
        }
        return svg;
    }

    std::string path_of(std::size_t j) const
    {
        const auto& joint = linkage_.joints[j];
        if (joint.kind == LinkageJoint::Kind::slide || joint.body_a == linkage_.ground ||
            joint.body_b == linkage_.ground)
            return {};
        return fmt::format("<path d=\"{}Z\" fill=\"none\" stroke=\"{}\" stroke-width=\"0.8\"/>\n",
                           outline(thinned(history_.joints[j].centre)), path_grey);
    }

    std::string pin(std::size_t j, std::size_t position) const
    {
        const auto& joint = linkage_.joints[j];
        const Vec2 centre = history_.joints[j].centre[position];
        const Vec2 q = at(centre);
        std::string svg;
        if (joint.body_a == linkage_.ground || joint.body_b == linkage_.ground) {
            const double w = 9;
            std::string hatch;
            for (int i = 0; i < 4; ++i)
                hatch += fmt::format("M{:.1f} {:.1f}l-4 4", q[0] - w + 2 + 6 * i, q[1] + 13);
            svg += fmt::format("<path d=\"M{0:.1f} {1:.1f}L{2:.1f} {3:.1f}H{4:.1f}Z{5}\" fill=\"#ffffff\" "
                               "stroke=\"#222222\" stroke-width=\"1.1\"/>\n",
                               q[0], q[1], q[0] + w, q[1] + 13, q[0] - w, hatch);
        }
        return svg + fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.6\" fill=\"#ffffff\" stroke=\"#222222\" "
                                 "stroke-width=\"1.4\"/>\n",
                                 q[0], q[1]);
    }

    // Writes names at the right of the panel, at the height of each body's centre, spread so that none overlap.
    std::string labels(std::size_t position) const
    {
        struct Label {
            std::string text;
            Vec2 from;
            double y;
            const char* colour;
        };
        std::vector<Label> list;
        for (std::size_t b = 0; b < linkage_.bodies.size(); ++b) {
            const auto points = corners(static_cast<int>(b), position);
            if (static_cast<int>(b) == linkage_.ground || points.empty() || hidden_image(b))
                continue;
            Vec2 middle{};
            for (const auto& p : points)
                middle = middle + (1.0 / static_cast<double>(points.size())) * p;
            const Vec2 q = at(middle);
            list.push_back({linkage_.bodies[b], q, q[1], colours_[b]});
        }
        std::ranges::sort(list, {}, [](const Label& l) { return l.y; });
        for (std::size_t i = 1; i < list.size(); ++i)
            list[i].y = std::max(list[i].y, list[i - 1].y + 16);
        double limit = top_ + height() - 4;
        for (std::size_t i = list.size(); i-- > 0;) {
            list[i].y = std::min(list[i].y, limit);
            limit = list[i].y - 16;
        }
        const double x = left_ + width() + 14;
        std::string svg;
        for (const auto& label : list)
            svg += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"{}\" stroke-width=\"0.8\" "
                               "opacity=\"0.6\"/>\n<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"12\" "
                               "fill=\"{}\">{}</text>\n",
                               label.from[0], label.from[1], x - 4, label.y, label.colour, x, label.y + 4, label.colour,
                               xml_text(label.text));
        return svg;
    }

    // True for the left one of a body and its mirror image: only the right one is named.
    [[nodiscard]] bool hidden_image(std::size_t b) const
    {
        const auto& name = linkage_.bodies[b];
        const bool image = name.ends_with('\'');
        const std::string twin = image ? name.substr(0, name.size() - 1) : name + "'";
        const auto found = std::ranges::find(linkage_.bodies, twin);
        if (found == linkage_.bodies.end())
            return false;
        const auto mean_x = [&](std::size_t index) {
            double x = 0;
            for (const auto& p : corners(static_cast<int>(index), 0))
                x += p[0];
            return x;
        };
        const double here = mean_x(b), there = mean_x(static_cast<std::size_t>(found - linkage_.bodies.begin()));
        return here < there || (here == there && image);
    }

    const Linkage& linkage_;
    const CycleHistory& history_;
    Bounds bounds_;
    double size_ = 1, block_ = 1, scale_ = 1, left_ = 0, top_ = 0;
    std::vector<const char*> colours_;
};

}  // namespace

std::string linkage_drawing(const std::string& title, const Linkage& linkage, const CycleHistory& history,
                            const std::vector<std::size_t>& positions)
{
    if (positions.empty() || history.joints.size() != linkage.joints.size() ||
        history.bodies.size() != linkage.bodies.size())
        throw InputError("the history of the turn does not belong to the linkage that is to be drawn");
    Drawing drawing(linkage, history);
    std::size_t longest = 4;
    for (const auto& name : linkage.bodies)
        longest = std::max(longest, display_width(name));
    const double gap = std::max(24.0, narrowest_pitch - drawing.width()),
                 names = 24 + 6.8 * static_cast<double>(longest);
    const double count = static_cast<double>(positions.size());
    const double inset = std::max(margin, 0.5 * (narrowest_pitch - drawing.width()));
    const double width = std::max(margin + inset + count * drawing.width() + (count - 1) * gap + names, 420.0);
    const double height = drawing.height() + 112;
    std::string svg =
        fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 "
                    "{0:.0f} {1:.0f}\" font-family=\"Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', "
                    "sans-serif\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n<text x=\"20\" "
                    "y=\"30\" font-size=\"17\" font-weight=\"bold\" fill=\"#222222\">{2}</text>\n",
                    width, height, xml_text(title));
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const double left = inset + static_cast<double>(i) * (drawing.width() + gap);
        const double degrees = (history.angle[positions[i]] - history.angle.front()) * 180 / std::numbers::pi;
        svg += fmt::format("<text x=\"{:.1f}\" y=\"58\" font-size=\"12.5\" fill=\"#222222\" "
                           "text-anchor=\"middle\">{}</text>\n",
                           left + drawing.width() / 2,
                           positions[i] == 0 ? std::string("bottom dead point")
                                             : fmt::format("{:.0f}\u00b0 past it", degrees));
        svg += drawing.panel(positions[i], left, 72, i + 1 == positions.size());
    }
    svg += fmt::format("<text x=\"20\" y=\"{:.0f}\" font-size=\"12\" fill=\"#6b6b6b\">thin grey lines: paths of the "
                       "joints over the turn</text>\n",
                       height - 14);
    return svg + "</svg>\n";
}

}  // namespace deadpoint::report
