#version 330 core
uniform vec4 tint;
flat in float facing;
out vec4 colour;

// Thin film: more to see where the view grazes it.
void main() { colour = vec4(tint.rgb, tint.a * mix(1.6, 0.7, facing)); }
