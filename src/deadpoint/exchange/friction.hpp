#pragma once

/// What kinds of rubbing joints there are: said by a case, used by the laws of friction.
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

/// How a bearing gets its oil: mist halves, a jet (or a vertical shaft) doubles the viscous torque of an oil bath.
enum class OilSupply { mist, bath, jet };

/// How the rows of a pair stand: back to back (O), the inner rings' growth in length relieves them; face to face (X),
/// it loads them.
enum class PairArrangement { back_to_back, face_to_face, single };

/// Which load a law is given: its own mean over the turn (physics), or the turn's largest load throughout.
enum class LoadMeasure { mean, peak };

/// How the two parts of a calibrated heat scale with speed and load.
enum class FrictionKind {
    rolling,  ///< load part ~ n F^1.33, viscous part ~ n^(5/3) (Palmgren)
    pin,      ///< load part ~ n F, viscous part ~ n^2 (Coulomb and Petroff)
    guide     ///< load part ~ n F; viscous part ~ n^2, usually zero
};

/// Of the load in the load part of rolling friction: Palmgren's load torque with f1 ~ P0^0.33.
inline constexpr double rolling_load_exponent = 1.33;

}  // namespace deadpoint
