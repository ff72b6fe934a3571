#pragma once

#include <cstddef>
#include <vector>

/// Mathematics of design studies, of no press in particular: points in the unit cube, indices of sensitivity, minima.
namespace deadpoint::design {

/// A point of the unit cube.
using Point = std::vector<double>;

/// Largest number of coordinates of sobol_points(): those for which Boost.Random states direction numbers (Joe and
/// Kuo, SIAM J. Sci. Comput. 30 (2008)).
inline constexpr std::size_t most_coordinates = 3667;

/// The first points of a Sobol' sequence, its zero point included, with a random digital shift: every coordinate is
/// exclusive-or'ed with 64 random bits, so that the points are uniform in the mean over seeds and stay a net. A power
/// of two of points fills every coordinate evenly.
/// @param seed  of the shift; the same seed gives the same points on any machine
/// @throws DomainError if there are no coordinates, or more than most_coordinates
std::vector<Point> sobol_points(std::size_t coordinates, std::size_t count, unsigned seed);

/// An estimate with a band of a stated probability.
struct Band {
    double value = 0, low = 0, high = 0;
};

/// How bands are made: rows of the design are drawn with replacement, and the estimate is repeated (Efron). The rows of
/// a Sobol' sequence are not independent, so that the bands are those of random points, which are wider.
struct Bootstrap {
    std::size_t resamples = 300;
    double probability = 0.9;  ///< of the band
    unsigned seed = 1;
};

/// Band of an estimate from its resampled values: from the quantile (1 - p) / 2 to (1 + p) / 2.
Band band_of(double value, std::vector<double> resampled, double probability);

/// Rows drawn with replacement, one list for each resample.
std::vector<std::vector<std::size_t>> resampled_rows(std::size_t rows, const Bootstrap& bootstrap);

}  // namespace deadpoint::design
