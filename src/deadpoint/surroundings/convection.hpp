#pragma once

/// Nusselt numbers of the surfaces of a machine in air. All properties are those at the film
/// temperature, the mean of surface and ambient temperature. A number outside the tested range is
/// computed and flagged; a negative or non-finite argument throws DomainError.
///
/// Textbook pairs of a laminar and a turbulent law jump where one takes over (24 % on a vertical wall, 6 % on a plate
/// facing up, 15 % on a disk). Here the second takes over smoothly just above the printed limit; below it and above the
/// transition both are as printed.
namespace deadpoint::surroundings {

struct Nusselt {
    double value = 0;      ///< h L / k [-]
    bool in_range = true;  ///< false outside the tested range
};

enum class VerticalLaw {
    churchill_chu,  ///< (0.825 + 0.387 Ra^(1/6) / (1 + (0.492/Pr)^(9/16))^(8/27))^2, Ra 0.1..1e12
    pair            ///< 0.59 Ra^(1/4) for Ra 1e4..1e9, 0.13 Ra^(1/3) to 1e13; transition 1e9..1.5e9
};

/// Natural convection on a vertical wall; L is its height (Churchill and Chu 1975; McAdams 1954 for the pair).
Nusselt nusselt_vertical(double rayleigh, double prandtl, VerticalLaw law = VerticalLaw::churchill_chu);

/// A warm horizontal plate facing up, or a cold one facing down; L = area / perimeter.
/// 0.54 Ra^(1/4) for Ra 1e4..1e7, 0.15 Ra^(1/3) to 1e11; transition 1e7..1.3e7 (McAdams 1954 with the length of
/// Goldstein et al. 1973; Incropera et al., eq. 9.30 and 9.31).
Nusselt nusselt_facing_up(double rayleigh);

enum class DownLaw {
    quarter,  ///< 0.27 Ra^(1/4), Ra 1e5..1e10 (McAdams 1954)
    fifth     ///< 0.52 Ra^(1/5), Ra 1e4..1e9 (Radziemska and Lewandowski 2001; Incropera et al., eq. 9.32)
};

/// A warm horizontal plate facing down, or a cold one facing up; L = area / perimeter.
Nusselt nusselt_facing_down(double rayleigh, DownLaw law = DownLaw::quarter);

/// Natural convection on a long horizontal cylinder at rest; L is the diameter (Churchill and Chu 1975):
/// (0.6 + 0.387 Ra^(1/6) / (1 + (0.559/Pr)^(9/16))^(8/27))^2, Ra 1e-5..1e12.
Nusselt nusselt_horizontal_cylinder(double rayleigh, double prandtl);

enum class RotatingLaw {
    becker,         ///< 0.133 Re^(2/3) Pr^(1/3), Re 800..4.3e5 (Becker 1963; the paper's Eq. 29)
    etemad,         ///< 0.076 Re^0.7, Re 8e3..6.54e4, air (Etemad 1955)
    dropkin_carmi,  ///< 0.073 Re^0.7, Re 1.5e4..4.33e5, air (Dropkin and Carmi 1957)
    kays_bjorklund  ///< 0.135 ((Re^2/2 + Re_c^2 + Gr) Pr)^(1/3); flagged as Becker's (Kays and Bjorklund 1958)
};

/// A horizontal cylinder rotating in air at rest; L is the diameter d, Re = omega d^2 / (2 nu).
///
/// The four laws agree within about 20 %. With the surface's rotation the coefficient grows as omega^(2/3) d^(1/3)
/// (Becker) or omega^0.7 d^0.4. Left out: the effect of walls and cranks nearby, eccentric motion of a crank pin.
/// @param grashof     on the diameter; only kays_bjorklund reads it
/// @param cross_flow  Reynolds number of an air stream across the cylinder; only kays_bjorklund reads it
Nusselt nusselt_rotating_cylinder(RotatingLaw law, double reynolds, double prandtl, double grashof = 0,
                                  double cross_flow = 0);

/// Reynolds number of a rotating cylinder, omega d^2 / (2 nu), from speed of any sign [rad/s],
/// diameter [m] and kinematic viscosity [m2/s]. That of a disk on its radius, omega R^2 / nu, is
/// half of it at equal diameter.
double rotating_reynolds(double speed, double diameter, double kinematic_viscosity);

/// A disk rotating in air at rest, mean over the face; L is the radius R, Re = omega R^2 / nu. 0.36
/// Re^(1/2) for Re < 2.4e5, then 0.015 Re^0.8 - 100 (2.4e5/Re)^(1/2), tested to 4e6; transition
/// 2.4e5..3e5 (Kreith, Convection heat transfer in rotating systems, 1968; Cobb and Saunders 1956).
Nusselt nusselt_rotating_disk(double reynolds);

/// A flat plate in parallel flow, mean over the length, here a link or slide moving through air at rest with its root
/// mean square speed; L is the length along the motion, Re = v L / nu.
/// 0.664 Re^(1/2) Pr^(1/3) for Re < 5e5, then (0.037 Re^0.8 - 871) Pr^(1/3) to 1e8; transition 5e5..6e5 (Incropera et
/// al., eq. 7.30 and 7.38). For a harmonic stroke the rms speed gives 10 % more than the mean of |v|^(1/2) would; sharp
/// edges and reversal of the flow, both left out, raise the true value.
Nusselt nusselt_moving_plate(double reynolds, double prandtl);

/// Exponent of mixed convection (Churchill 1977; Incropera et al., sec. 9.9): 3 on vertical plates and disks,
/// 3.5 on horizontal plates, 4 on cylinders.
inline constexpr double mixed_exponent_plate = 3;
inline constexpr double mixed_exponent_horizontal = 3.5;
inline constexpr double mixed_exponent_cylinder = 4;

/// Mixed convection, Nu^n = |Nu_F^n +- Nu_N^n|; holds for coefficients as for Nusselt numbers on one length.
/// @param assisting  plus where the natural flow goes along with or across the forced one, minus where against it
/// @throws DomainError if a number is negative or not finite, or n is below 1
double mixed_convection(double forced, double natural, double n, bool assisting = true);

}  // namespace deadpoint::surroundings
