#include "shade/spectrum.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rb {

namespace {

/// Integral of the hue from 375 nm on, in steps of 5 nm.
constexpr std::array<Rgb, 74> hue_integral{
    // clang-format off
    Rgb{0.0f, 0.0f, 0.0f}, Rgb{0.0009f, 0.0f, 0.0038f}, Rgb{0.0029f, 0.0f, 0.0113f},
    Rgb{0.0058f, 0.0f, 0.0222f}, Rgb{0.0094f, 0.0f, 0.0363f}, Rgb{0.0135f, 0.0f, 0.0534f},
    Rgb{0.0178f, 0.0f, 0.0734f}, Rgb{0.0223f, 0.0f, 0.096f}, Rgb{0.0267f, 0.0f, 0.121f},
    Rgb{0.0308f, 0.0f, 0.1482f}, Rgb{0.0344f, 0.0f, 0.1775f}, Rgb{0.0374f, 0.0f, 0.2085f},
    Rgb{0.0394f, 0.0f, 0.2412f}, Rgb{0.0404f, 0.0f, 0.2753f}, Rgb{0.0404f, 0.0f, 0.3106f},
    Rgb{0.0404f, 0.0f, 0.347f}, Rgb{0.0404f, 0.0f, 0.3841f}, Rgb{0.0404f, 0.0f, 0.4219f},
    Rgb{0.0404f, 0.0f, 0.46f}, Rgb{0.0404f, 0.0f, 0.4984f}, Rgb{0.0404f, 0.0f, 0.5368f},
    Rgb{0.0404f, 0.0f, 0.575f}, Rgb{0.0404f, 0.0f, 0.6128f}, Rgb{0.0404f, 0.0f, 0.65f},
    Rgb{0.0404f, 0.0f, 0.6864f}, Rgb{0.0404f, 0.0045f, 0.7218f}, Rgb{0.0404f, 0.0131f, 0.756f},
    Rgb{0.0404f, 0.0256f, 0.7888f}, Rgb{0.0404f, 0.0417f, 0.82f}, Rgb{0.0404f, 0.0612f, 0.8494f},
    Rgb{0.0404f, 0.0839f, 0.8768f}, Rgb{0.0404f, 0.1095f, 0.902f}, Rgb{0.0404f, 0.1378f, 0.9248f},
    Rgb{0.0404f, 0.1684f, 0.9449f}, Rgb{0.0404f, 0.2013f, 0.9623f}, Rgb{0.0404f, 0.236f, 0.9767f},
    Rgb{0.0404f, 0.2724f, 0.9878f}, Rgb{0.0404f, 0.3102f, 0.9956f}, Rgb{0.0404f, 0.3492f, 0.9997f},
    Rgb{0.0404f, 0.3891f, 1.0f}, Rgb{0.0429f, 0.4297f, 1.0f}, Rgb{0.0502f, 0.4707f, 1.0f},
    Rgb{0.062f, 0.5119f, 1.0f}, Rgb{0.078f, 0.553f, 1.0f}, Rgb{0.0979f, 0.5937f, 1.0f},
    Rgb{0.1215f, 0.634f, 1.0f}, Rgb{0.1483f, 0.6733f, 1.0f}, Rgb{0.1781f, 0.7117f, 1.0f},
    Rgb{0.2105f, 0.7487f, 1.0f}, Rgb{0.2454f, 0.7841f, 1.0f}, Rgb{0.2823f, 0.8178f, 1.0f},
    Rgb{0.321f, 0.8494f, 1.0f}, Rgb{0.3611f, 0.8786f, 1.0f}, Rgb{0.4024f, 0.9054f, 1.0f},
    Rgb{0.4446f, 0.9293f, 1.0f}, Rgb{0.4873f, 0.9501f, 1.0f}, Rgb{0.5302f, 0.9677f, 1.0f},
    Rgb{0.5731f, 0.9817f, 1.0f}, Rgb{0.6155f, 0.9919f, 1.0f}, Rgb{0.6573f, 0.9981f, 1.0f},
    Rgb{0.6982f, 1.0f, 1.0f}, Rgb{0.7377f, 1.0f, 1.0f}, Rgb{0.7756f, 1.0f, 1.0f},
    Rgb{0.8116f, 1.0f, 1.0f}, Rgb{0.8454f, 1.0f, 1.0f}, Rgb{0.8767f, 1.0f, 1.0f},
    Rgb{0.9052f, 1.0f, 1.0f}, Rgb{0.9306f, 1.0f, 1.0f}, Rgb{0.9525f, 1.0f, 1.0f},
    Rgb{0.9707f, 1.0f, 1.0f}, Rgb{0.9849f, 1.0f, 1.0f}, Rgb{0.9947f, 1.0f, 1.0f},
    Rgb{0.9998f, 1.0f, 1.0f}, Rgb{1.0f, 1.0f, 1.0f},
    // clang-format on
};

Rgb integral_to(double wavelength) {
    const double place =
        std::clamp((wavelength - 375.0) / 5.0, 0.0, static_cast<double>(hue_integral.size() - 1));
    const auto index = std::min(static_cast<size_t>(place), hue_integral.size() - 2);
    const auto t = static_cast<float>(place - static_cast<double>(index));
    return hue_integral[index] + t * (hue_integral[index + 1] - hue_integral[index]);
}

}  // namespace

Rgb band_hue(double wavelength, double width) {
    const Rgb band = integral_to(wavelength + 0.5 * width) - integral_to(wavelength - 0.5 * width);
    return band * static_cast<float>(350.0 / width);
}

}  // namespace rb
