#include "../record.hpp"
#include "../scratch_folder.hpp"
#include "grid_mesh.hpp"
#include "solved_case.hpp"

#include <cmath>
#include <fmt/format.h>

// Observed orders in space of an exact solution with a jump in a film, or a bond of two materials, and a film to air.

using namespace verification;

namespace {

constexpr double wave = 16, decay = 22.627416997969522;  // [1/m]; decay^2 = 2 wave^2
constexpr double edge = 0.05;                            // of either block [m]
constexpr double k_left = 45, k_right = 20, air_film = 300;

/// On x < 0: (a e^{decay x} + b e^{-decay x}) sin(wave y) sin(wave z) above 20 degC, on x > 0 the same with c and d.
struct TwoMedia {
    double a, b, c, d;

    /// @param film  between the blocks [W/m2/K]
    explicit TwoMedia(double film)
    {
        // Air at x = edge: -k T' = air_film T; at x = 0: k_left T' = k_right T' = film times the jump.
        const double s = k_right * decay;
        d = 20;
        c = d * std::exp(-2 * decay * edge) * (s - air_film) / (s + air_film);
        const double slope = k_right / k_left * (c - d);
        const double sum = c + d - k_right * decay * (c - d) / film;
        a = (sum + slope) / 2;
        b = (sum - slope) / 2;
    }
    [[nodiscard]] double operator()(const deadpoint::Vec3& x) const
    {
        const double grow = std::exp(decay * x[0]);
        return (x[0] < 0 ? a * grow + b / grow : c * grow + d / grow) * std::sin(wave * x[1]) * std::sin(wave * x[2]);
    }
    static std::string formula(double grow, double fall)
    {
        return fmt::format("293.15 + ({:.17g}*exp({:.17g}*x) + ({:.17g})*exp(-{:.17g}*x))*sin({}*y)*sin({}*z)", grow,
                           decay, fall, decay, wave, wave);
    }
};

struct Media {
    std::array<int, 2> order;
    bool tetrahedra;
    bool bonded;  ///< instead of the film
};

/// Points in some bricks spread over both blocks: at the same places in their bricks on every mesh.
std::vector<deadpoint::Vec3> points_in_bricks(int cells)
{
    std::vector<deadpoint::Vec3> points;
    for (int i = 0; i < 80; ++i) {
        const bool left = i % 2 == 0;
        const int count = left ? cells : cells * 3 / 2;
        const double size = edge / count;
        for (int point = 0; point < 8; ++point) {
            deadpoint::Vec3 x{};
            for (std::size_t k = 0; k < 3; ++k) {
                constexpr std::array<double, 3> spread{0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
                const double brick = std::floor(count * std::fmod(0.5 + spread[k] * i, 1.0));
                x[k] = size * (brick + std::fmod(0.5 + spread[(k + 1) % 3] * (8 * i + point), 1.0));
            }
            x[0] -= left ? edge : 0;
            points.push_back(x);
        }
    }
    return points;
}

/// Root mean square error in both blocks; the right one has half as many cells again along an edge as the left one.
double media_error(const Media& media, int cells)
{
    const ScratchFolder folder;
    const std::array<std::string, 2> names{"left", "right"};
    for (std::size_t i = 0; i < 2; ++i) {
        const int count = i == 0 ? cells : cells * 3 / 2;
        const double low = i == 0 ? -edge : 0;
        write_grid(folder.path / (names[i] + ".msh"),
                   {{count, count, count}, box_map({low, 0, 0}, {low + edge, edge, edge}), media.tetrahedra, {}});
    }
    const TwoMedia exact(media.bonded ? 1e30 : 1e3);
    std::vector<std::string> overrides{
        "surfaces.left_outside.temperature_formula=" + TwoMedia::formula(exact.a, exact.b),
        "surfaces.right_outside.temperature_formula=" + TwoMedia::formula(exact.c, exact.d)};
    for (std::size_t i = 0; i < 2; ++i) {
        overrides.push_back("parts." + names[i] + ".mesh=" + (folder.path / (names[i] + ".msh")).string());
        overrides.push_back("parts." + names[i] + ".order=" + std::to_string(media.order[i]));
    }
    auto input = read("two-media", overrides);
    if (media.bonded) {
        input.joints.clear();
        input.parts["right"].body = "left";
    }
    const auto points = points_in_bricks(cells);
    for (std::size_t i = 0; i < points.size(); ++i)
        input.probes[std::to_string(10000 + i)] = {points[i][0] < 0 ? "left" : "right", points[i], ""};
    const auto solved = solve(input);
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        sum += std::pow(solved.history().probes[i].value.back() - 293.15 - exact(points[i]), 2);
    return std::sqrt(sum / static_cast<double>(points.size()));
}

void check_order(const Media& media, int cells)
{
    const double coarse = media_error(media, cells), fine = media_error(media, 2 * cells);
    const double order = std::log2(coarse / fine);
    const int lower = std::min(media.order[0], media.order[1]);
    const auto name = fmt::format("{} of order {}, {}", media.tetrahedra ? "tetrahedra" : "hexahedra",
                                  media.order[0] == media.order[1] ? std::to_string(lower) : "1 and 2",
                                  media.bonded ? "bond of two materials" : "film between two materials");
    MESSAGE(name << ": errors " << coarse << ", " << fine << " K, order " << order);
    record_order(
        {"order in space, temperature, " + name + " and film to air", "p + 1", "", lower + 1.0, 0.1, "0.1 asked"}, "K",
        {{2, coarse}, {1, fine}});
}

}  // namespace

TEST_CASE("order in space: two materials with a film between them, meshes that do not match")
{
    for (const bool tetrahedra : {false, true}) {
        check_order({{1, 1}, tetrahedra, false}, 6);
        check_order({{2, 2}, tetrahedra, false}, 4);
    }
    check_order({{1, 2}, false, false}, 6);
}

TEST_CASE("order in space: two bonded materials, meshes that do not match")
{
    for (const bool tetrahedra : {false, true}) {
        check_order({{1, 1}, tetrahedra, true}, 6);
        check_order({{2, 2}, tetrahedra, true}, 4);
    }
    check_order({{2, 1}, false, true}, 6);
}
