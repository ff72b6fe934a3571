#include "deadpoint/calibration/curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace deadpoint::calibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Rows [first, last] between which time increases.
struct Piece {
    Index first = 0, last = 0;
};

Piece piece_of(const std::vector<double>& rows, Index row)
{
    Piece piece{row, row + 1};
    const auto count = static_cast<Index>(rows.size());
    while (piece.first > 0 &&
           rows[static_cast<std::size_t>(piece.first - 1)] < rows[static_cast<std::size_t>(piece.first)])
        --piece.first;
    while (piece.last + 1 < count &&
           rows[static_cast<std::size_t>(piece.last)] < rows[static_cast<std::size_t>(piece.last + 1)])
        ++piece.last;
    return piece;
}

// Adds the weights of the slope at a row, of the parabola through three rows of the piece (two: of the line).
void add_slope(const std::vector<double>& rows, const Piece& piece, Index row, double factor,
               Eigen::Ref<VectorXd> weights)
{
    const auto at = [&](Index k) { return rows[static_cast<std::size_t>(k)]; };
    if (piece.last - piece.first < 2) {
        const double width = at(piece.last) - at(piece.first);
        weights[piece.first] -= factor / width;
        weights[piece.last] += factor / width;
        return;
    }
    const Index middle = std::clamp(row, piece.first + 1, piece.last - 1);
    const std::array<Index, 3> k{middle - 1, middle, middle + 1};
    for (std::size_t a = 0; a < 3; ++a) {
        const Index b = k[(a + 1) % 3], c = k[(a + 2) % 3];
        weights[k[a]] += factor * (2 * at(row) - at(b) - at(c)) / ((at(k[a]) - at(b)) * (at(k[a]) - at(c)));
    }
}

}  // namespace

MatrixXd interpolation(const std::vector<double>& rows, const std::vector<double>& times)
{
    const auto count = static_cast<Index>(rows.size());
    MatrixXd result = MatrixXd::Zero(static_cast<Index>(times.size()), count);
    for (std::size_t t = 0; t < times.size(); ++t) {
        const double time = std::clamp(times[t], rows.front(), rows.back());
        Index row = std::upper_bound(rows.begin(), rows.end(), time) - rows.begin() - 1;
        while (row > 0 &&
               (row + 1 >= count || rows[static_cast<std::size_t>(row + 1)] <= rows[static_cast<std::size_t>(row)]))
            --row;
        const double from = rows[static_cast<std::size_t>(row)], width = rows[static_cast<std::size_t>(row + 1)] - from;
        const double s = (time - from) / width;
        VectorXd weights = VectorXd::Zero(count);
        weights[row] += (1 + 2 * s) * (1 - s) * (1 - s);
        weights[row + 1] += s * s * (3 - 2 * s);
        const auto piece = piece_of(rows, row);
        add_slope(rows, piece, row, width * s * (1 - s) * (1 - s), weights);
        add_slope(rows, piece, row + 1, width * s * s * (s - 1), weights);
        result.row(static_cast<Index>(t)) = weights;
    }
    return result;
}

Lagged lagged(const std::vector<double>& rows, const VectorXd& value, double constant)
{
    Lagged result{value, VectorXd::Zero(value.size())};
    for (Index k = 1; k < value.size(); ++k) {
        const double width = rows[static_cast<std::size_t>(k)] - rows[static_cast<std::size_t>(k - 1)];
        const double x = width / constant, kept = std::exp(-x);
        // z' = kept z + (1 - kept - m) y0 + m y1 with m = 1 - (1 - kept) / x, the ramp's response.
        const double share = x > 0 ? -std::expm1(-x) / x : 1;
        const double m = 1 - share;
        const double y0 = value[k - 1], y1 = value[k], z = result.value[k - 1];
        result.value[k] = kept * z + (1 - kept - m) * y0 + m * y1;
        // By ln(constant): x falls by x, so kept rises by x kept and share by share - kept.
        const double by_kept = x * kept, by_m = -(share - kept);
        result.by_log_constant[k] = kept * result.by_log_constant[k - 1] + by_kept * (z - y0) + by_m * (y1 - y0);
    }
    return result;
}

}  // namespace deadpoint::calibration
