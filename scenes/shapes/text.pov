// Text: kerning, offset, accents, each font of the distribution, letters cut out of a box.
#version 3.7;
global_settings { assumed_gamma 1.0 charset utf8 }

camera { location <0, 1.5, -7> right x*4/3 look_at <0, 1.3, 0> angle 50 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

text { ttf "timrom.ttf" "AVATo j" 0.3, 0 translate <-2.8, 0.1, -1> pigment { rgb <0.85, 0.35, 0.2> } finish { specular 0.4 } }
text { ttf "cyrvetic.ttf" "raise;" 0.5, <0.05, 0.15, 0> rotate y*25 translate <0.6, 0.1, -1.5> pigment { rgb <0.2, 0.5, 0.85> } }
text { internal 3 "cry 8%" 0.4, 0 scale <0.8, 0.8, 1> rotate x*-20 translate <-2.8, 1.2, 0> pigment { rgb <0.3, 0.75, 0.35> } }
text { internal 4 "POV" 0.4, 0 translate <0.4, 1.2, 0> pigment { rgb <0.7, 0.3, 0.7> } }
difference {
    box { <-1.7, 2.0, 0>, <1.7, 3, 0.6> }
    text { ttf "timrom.ttf" "@B&g" 0.5, 0.05*x scale <0.9, 0.9, 1> translate <-1.4, 2.3, -0.2> }
    pigment { rgb <0.8, 0.7, 0.3> }
}
