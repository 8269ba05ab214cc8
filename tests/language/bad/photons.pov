#version 3.7;
global_settings { photons { gather -1, 5 } } //! error: min_gather_count cannot be negative.
global_settings { photons { gather 30, 20 } } //! error: min_gather_count must be less than max_gather_count.
global_settings { photons { media -1 } } //! error: max media steps must be non-negative.
global_settings { photons { media 1, 0 } } //! error: media spacing factor must be greater than zero.
global_settings { photons { load_file "no such file.ph" } } //! error: Could not load photon map (no such file.ph)
sphere { 0, 1 photons { density 1 } } //! error: No matching } in 'photons', density found instead
light_source { 0, 1 photons { target } } //! error: No matching } in 'photons', target found instead
