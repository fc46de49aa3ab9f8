#pragma once
/// Phase functions of clouds of water droplets, from the Mie series.

#include <complex>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace tyndall::mie {

/// Droplets and how finely to compute.
struct DropletCloud {
    double radius_um = 10.0;  ///< effective radius: the mean radius, weighted by the cross section
    double variance = 0.1;    ///< effective variance of the sizes (Hansen & Travis 1974); 0 = all alike
    int sizes = 48;           ///< radii over which the distribution is summed
    int wavelengths = 20;     ///< between 390 and 720 nm
    double step_deg = 0.2;    ///< between angles of the table, which holds means over about that width
};

/// What comes out.
struct DropletTable {
    std::vector<double> angles_deg;  ///< from 0 to 180
    std::vector<glm::dvec3> values;  ///< linear Rec. 709 in 1/sr, each channel with an integral of 1 over the sphere
    glm::dvec3 mean_cosine{0.0};
    glm::dvec3 efficiency{0.0};  ///< extinction over the droplets' geometric cross sections, per channel
};

/// Refractive index of water at 20 C relative to air: the real part by Harvey et al. (J. Phys. Chem. Ref. Data 27,
/// 1998, which the IAPWS recommends), the imaginary one from the absorption that Pope & Fry measured (Applied Optics
/// 36, 1997).
[[nodiscard]] std::complex<double> water_index(double wavelength_nm);

/// The phase function under white light (a black body of 6500 K) as a camera with Rec. 709 primaries sees it; colours
/// outside of their gamut are cut off at 0.
[[nodiscard]] DropletTable droplet_table(const DropletCloud& cloud);

/// The text that a medium's `tabulated` phase reads.
[[nodiscard]] std::string table_text(const DropletTable& table, const DropletCloud& cloud);

}  // namespace tyndall::mie
