#version 330 core
uniform vec4 tint;
uniform float line_width;
uniform float fade_below;  // pixels: shorter lines are fainter, so that a dense net does not clot; 0: never
flat in float length_pixels;
noperspective in vec2 place;
out vec4 colour;

void main() {
  vec2 off = vec2(place.x - clamp(place.x, 0.0, length_pixels), place.y);
  float reach = 0.5 * line_width;
  float cover = 1.0 - smoothstep(reach - 0.5, reach + 0.5, length(off));
  if (fade_below > 0.0) cover *= clamp(length_pixels / fade_below, 0.25, 1.0);
  if (cover <= 0.0) discard;
  colour = vec4(tint.rgb, tint.a * cover);
}
