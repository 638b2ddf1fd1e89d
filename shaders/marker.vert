#version 330 core
// Discs of constant size on the screen, smaller where the panels under them are: one instance each, a square
// of four vertices.
layout(location = 0) in vec3 centre;
layout(location = 1) in vec3 fill;
layout(location = 2) in vec2 radius;  // pixels, without the outline: usual, least

uniform mat4 view, projection;
uniform vec2 viewport;          // pixels
uniform float pixel_scale;
uniform float pixels_per_unit;  // at distance 1 from the eye
uniform float largest;          // radius in scene units that a disc should not exceed; 0: any

flat out vec3 disc_colour;
flat out float disc_radius;
flat out float disc_scale;  // 1 for the usual size
noperspective out vec2 place;  // pixels from the centre

void main() {
  disc_colour = fill;
  vec3 p = (view * vec4(centre, 1.0)).xyz;
  float usual = radius.x * pixel_scale, least = radius.y * pixel_scale;
  float limit = largest > 0.0 ? largest * pixels_per_unit / max(-p.z, 1e-9) : usual;
  disc_radius = clamp(limit, least, usual);
  disc_scale = disc_radius / usual;
  float reach = disc_radius + 3.0 * pixel_scale;
  // Nearer to the eye by some radii, so that the surface it lies on does not cut it.
  float lift = 4.0 * reach * -p.z / pixels_per_unit;
  p *= 1.0 - min(lift / max(length(p), 1e-9), 0.5);
  vec4 clip = projection * vec4(p, 1.0);
  place = reach * vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, (gl_VertexID & 2) == 0 ? -1.0 : 1.0);
  gl_Position = clip + vec4(place * 2.0 / viewport * clip.w, 0.0, 0.0);
}
