#pragma once

namespace rb {

/// `radiosity { ... }` of global_settings, in the language's own words and with its defaults.
struct RadiositySettings {
    float adc_bailout = 0.01f;  ///< of the rays that gather
    bool always_sample = false;
    float brightness = 1;  ///< factor for what is gathered, at every bounce
    int count = 35;        ///< rays of a gather
    double error_bound = 1.8;
    float gray_threshold = 0;  ///< 0..1: how far what is gathered loses its colour
    double low_error_factor = 0.5;
    float max_sample = -1;  ///< if positive, limits the brightest channel of what one ray brings
    double maximum_reuse = 0.2;
    double minimum_reuse = 0.015;
    int nearest_count = 5;
    bool normal = false;  ///< gather around the perturbed normal
    bool media = false;   ///< fog and media act on the rays that gather
    bool subsurface = false;
    double pretrace_start = 0.08;  ///< shares of the picture's longer side
    double pretrace_end = 0.04;
    int recursion_limit = 2;  ///< diffuse bounces
};

}  // namespace rb
