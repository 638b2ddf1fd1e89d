#version 330 core
uniform vec3 outline;
uniform vec3 rim;  // a thin dark line round the outline, for light grounds
uniform float strength;
uniform float pixel_scale;
flat in vec3 disc_colour;
flat in float disc_radius;
flat in float disc_scale;
noperspective in vec2 place;
out vec4 colour;

void main() {
  float away = length(place);
  float outer = disc_radius + 1.1 * disc_scale * pixel_scale;
  float inside = 1.0 - smoothstep(disc_radius - 0.5, disc_radius + 0.5, away);
  float cover = 1.0 - smoothstep(outer - 0.5, outer + 0.5, away);
  float soft = 0.35 * (1.0 - smoothstep(outer - 0.5, outer + 1.2 * pixel_scale, away));
  vec3 disc = mix(outline, disc_colour, inside);
  float alpha = max(cover, soft);
  if (alpha <= 0.004) discard;
  colour = vec4(mix(rim, disc, cover / alpha), alpha * strength);
}
