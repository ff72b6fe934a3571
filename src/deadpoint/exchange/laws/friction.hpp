#pragma once

/// Kinds of joints with friction: a case states them, the friction laws use them.
namespace deadpoint {

enum class BearingType {
    deep_groove_ball,
    angular_contact_ball,
    angular_contact_ball_pair,
    cylindrical_roller,
    needle_roller,
    tapered_roller,
    spherical_roller
};

/// Oil supply of a bearing. Relative to an oil bath, mist halves the viscous torque, and a jet (or
/// a vertical shaft) doubles it.
enum class OilSupply { mist, bath, jet };

/// Arrangement of a pair of ball rows. Growth of the inner rings in length relieves a back-to-back
/// pair (O) and loads a face-to-face pair (X).
enum class PairArrangement { back_to_back, face_to_face, single };

/// Load that a friction law uses: the course over the turn, averaged by the law, or the turn's
/// largest load at all times.
enum class LoadMeasure { mean, peak };

/// How the two parts of a calibrated heat scale with speed and load.
enum class FrictionKind {
    rolling,  ///< load part ~ n F^1.33, viscous part ~ n^(5/3) (Palmgren)
    pin,      ///< load part ~ n F, viscous part ~ n^2 (Coulomb and Petroff)
    guide     ///< load part ~ n F; viscous part ~ n^2, usually zero
};

/// Exponent of the load in the load part of rolling friction: Palmgren's load torque with f1 ~
/// P0^0.33.
inline constexpr double rolling_load_exponent = 1.33;

}  // namespace deadpoint
