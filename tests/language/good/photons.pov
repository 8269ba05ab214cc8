// What scenes say about photons.
#version 3.7;
global_settings {
  photons {
    spacing 0.02 count 5000 gather 10, 50 radius , 2, , 0.3 jitter 0.3 autostop 0.4
    expand_thresholds 0.3, 20 media 30, 2 max_trace_level 7 adc_bailout 0.01
  }
}
light_source { 10*y, 1 photons { refraction on reflection off area_light } }
light_source { 9*y, 1 looks_like { sphere { 0, 0.1 } } }
sphere { 0, 1 photons { target } }
sphere { 0, 1 photons { target 0.5 refraction on reflection on collect off } }
sphere { 0, 1 photons { target 3 target -1 pass_through } }
union {
  sphere { 0, 1 photons { refraction off } }
  box { 0, 1 }
  photons { target 2 } photons { refraction 1 collect 0 }
}
light_group { sphere { 0, 1 } light_source { y, 1 } photons { pass_through } }
