#pragma once

/// Elliptic point contact of two elastic bodies (Hertz 1881; notation of Harris, Rolling Bearing Analysis).
namespace deadpoint::tribology {

/// Complete elliptic integrals of the modulus k = sqrt(1 - k'^2).
struct EllipticIntegrals {
    double first = 0;   ///< K(k)
    double second = 0;  ///< E(k)
};

/// By the arithmetic-geometric mean, to rounding.
///
/// @param complementary  k', above 0 and at most 1: of an ellipse, minor over major axis
/// @throws DomainError outside of that
EllipticIntegrals elliptic_integrals(double complementary);

/// Principal curvatures of the two bodies taken together.
struct ContactCurvature {
    double sum = 0;         ///< of all four [1/m], > 0
    double difference = 0;  ///< F(rho) = |sum over one plane - sum over the other| / sum, 0 up to (not) 1
};

/// Ellipse and approach in units of the contact's own length: the numbers of Harris's table of a*, b*, delta*.
struct ContactShape {
    double axis_ratio = 1;  ///< minor over major
    double major = 1;       ///< a*
    double minor = 1;       ///< b*
    double approach = 1;    ///< delta*
};

/// Solves F(rho) = ((1 + k'^2) E - 2 k'^2 K) / ((1 - k'^2) E) for k' = b/a; then a* = (2 E / (pi k'^2))^(1/3),
/// b* = k' a*, delta* = (2 K / pi) (pi k'^2 / (2 E))^(1/3).
///
/// @param difference  F(rho), 0 (ball on ball) up to 0.99999999; line contact (1) has no ellipse
/// @throws DomainError outside of that
ContactShape contact_shape(double difference);

/// (1 - nu1^2)/E1 + (1 - nu2^2)/E2 [1/Pa].
/// @throws InputError if a modulus is not positive or a Poisson's ratio outside 0 .. 0.5
double contact_compliance(double modulus_1, double poisson_1, double modulus_2, double poisson_2);

struct ContactEllipse {
    double major = 0;     ///< semi-axis a [m]
    double minor = 0;     ///< semi-axis b [m]
    double approach = 0;  ///< of the two bodies [m]
    double pressure = 0;  ///< at the centre, 3 Q / (2 pi a b) [Pa]
};

/// a = a* (3 Q C / (2 sum))^(1/3), b likewise, approach = delta* (3 Q C / (2 sum))^(2/3) sum / 2, C the compliance.
///
/// Left out: friction, the oil film, plastic flow (bearing steel flows above some 4 GPa: not checked here).
/// @param load  Q [N], not negative
/// @throws DomainError on curvatures that do not touch in a point; InputError on a negative load or compliance
ContactEllipse contact_ellipse(const ContactCurvature& curvature, double compliance, double load);

}  // namespace deadpoint::tribology
