#version 330 core
// Panels: flat-shaded card. Light and side are the same over a whole panel, so they are found here.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;      // of the whole panel
layout(location = 2) in uint edge_mask;   // bits 0..2: edge opposite corner k is a panel edge; 3..5: a border
layout(location = 3) in float panel_size;
layout(location = 4) in float value;

uniform mat4 view_projection;
uniform vec3 eye;
uniform vec3 key_light;        // unit, towards the light
uniform vec3 back_tint;
uniform float pixels_per_unit;  // at distance 1 from the eye

flat out uint edges;
flat out vec3 light;        // display RGB is multiplied by this
smooth out vec3 corner;     // barycentric
smooth out float presence;  // of the panel edges: less where panels are but a few pixels wide
smooth out float quantity;

void main() {
  gl_Position = view_projection * vec4(position, 1.0);
  vec3 n = normalize(normal.xyz);
  bool back = dot(n, eye - position) < 0.0;
  if (back) n = -n;

  // A key light from above over a soft sky, in linear light.
  float key = max(dot(n, key_light), 0.0);
  float sky = 0.5 + 0.5 * n.z;
  float linear = 0.10 + 0.24 * sky + 0.62 * key;
  vec3 tint = mix(vec3(0.985, 0.985, 1.0), vec3(1.0), smoothstep(0.2, 0.8, linear));  // shade is a hint cooler
  light = pow(linear, 1.0 / 2.2) * tint * (back ? back_tint : vec3(1.0));

  edges = edge_mask;
  int k = gl_VertexID % 3;
  corner = vec3(k == 0, k == 1, k == 2);
  presence = clamp(panel_size * pixels_per_unit / max(gl_Position.w, 1e-6) / 16.0, 0.22, 1.0);
  quantity = value;
}
