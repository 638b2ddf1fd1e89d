#version 330 core
uniform sampler2D darkness;
uniform vec3 shadow;
uniform float strength;
in vec2 place;
out vec4 colour;

void main() { colour = vec4(shadow, strength * texture(darkness, place).r); }
