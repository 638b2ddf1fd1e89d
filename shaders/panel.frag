#version 330 core
uniform vec3 card;
uniform vec3 edge;
uniform float line_width;  // pixels
uniform int fine;
uniform float shade;    // of light and shade, how much colours show
uniform float opacity;  // of the panel; its lines are opaque

// The colour map; see colour_map.h for what the numbers mean.
uniform int coloured;
uniform sampler2D map;
uniform float low, tolerance, per_unit_below, per_unit_above, below_end, above_start;

flat in uint edges;
flat in vec3 light;
smooth in vec3 corner;
smooth in float presence;
smooth in float quantity;
out vec4 colour;

const float kNoValue = 1e38;

float map_position(float v) {
  if (v > tolerance) return clamp(above_start + (v - max(tolerance, low)) * per_unit_above, above_start, 1.0);
  return clamp((v - low) * per_unit_below, 0.0, below_end);
}

void main() {
  // Distance to each edge of the triangle in pixels, from how fast the barycentric coordinate changes.
  vec3 dx = dFdx(corner), dy = dFdy(corner);
  vec3 steepness = max(sqrt(dx * dx + dy * dy), vec3(1e-9));
  vec3 away = corner / steepness;
  float line = 0.0;
  for (int k = 0; k < 3; ++k) {
    if ((edges >> k & 1u) == 0u) continue;
    // Each of two neighbours draws half of the line; at a border one draws it all.
    float reach = (edges >> (k + 3) & 1u) == 0u ? 0.5 * line_width : line_width;
    line = max(line, 1.0 - smoothstep(reach - 0.5, reach + 0.5, away[k]));
  }
  // A dot in each corner, all of which are corners of the panel: the triangles that only touch a line's end would
  // leave a notch there.
  float reach = 0.5 * line_width;
  for (int k = 0; k < (fine != 0 ? 3 : 0); ++k) {
    if ((1.0 - corner[k]) / steepness[k] > reach + 0.5) continue;
    int i = (k + 1) % 3, j = (k + 2) % 3;
    float area = dx[i] * dy[j] - dx[j] * dy[i];
    if (abs(area) < 1e-9) continue;
    vec2 to_corner = vec2(corner[i] * dy[j] - corner[j] * dy[i], corner[j] * dx[i] - corner[i] * dx[j]) / area;
    line = max(line, 1.0 - smoothstep(reach - 0.5, reach + 0.5, length(to_corner)));
  }

  vec3 fill = card * light;
  vec3 line_colour = edge;
  if (coloured != 0 && quantity < kNoValue) {
    // Less light and shade than on card, and edges in the colour's own dark shade: the colour has to be read.
    fill = texture(map, vec2((map_position(quantity) * 255.0 + 0.5) / 256.0, 0.5)).rgb;
    fill *= mix(vec3(1.0), light, shade);
    line_colour = 0.40 * fill;
  }
  float drawn = line * presence;
  colour = vec4(mix(fill, line_colour, drawn), mix(opacity, 1.0, drawn));
}
