#version 330 core
// A line of constant width on the screen with round ends: four vertices per line, pushed apart here.
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;

uniform mat4 view, projection;
uniform vec2 viewport;          // pixels
uniform float line_width;       // pixels
uniform float lift_pixels;      // the line is drawn this much nearer to the eye: in pixels at its distance, ...
uniform float lift;             // ... and in scene units
uniform float pixels_per_unit;  // at distance 1 from the eye
uniform float near;

flat out float length_pixels;
noperspective out vec2 place;  // pixels along the line from its start, and across

vec3 lifted(vec3 p) {
  float amount = lift + lift_pixels * -p.z / pixels_per_unit;
  return p * (1.0 - min(amount / max(length(p), 1e-9), 0.5));  // along the ray: its place on the screen stays
}

void main() {
  vec3 a = (view * vec4(from, 1.0)).xyz, b = (view * vec4(to, 1.0)).xyz;
  if (a.z > -near && b.z > -near) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);  // behind the eye: outside
    length_pixels = 0.0;
    place = vec2(0.0);
    return;
  }
  if (a.z > -near) a = mix(b, a, (-near - b.z) / (a.z - b.z));
  if (b.z > -near) b = mix(a, b, (-near - a.z) / (b.z - a.z));
  vec4 start = projection * vec4(lifted(a), 1.0), end = projection * vec4(lifted(b), 1.0);

  vec2 start_pixel = 0.5 * viewport * start.xy / start.w, end_pixel = 0.5 * viewport * end.xy / end.w;
  vec2 along = end_pixel - start_pixel;
  length_pixels = length(along);
  along = length_pixels > 1e-6 ? along / length_pixels : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);

  int corner = gl_VertexID & 3;
  float reach = 0.5 * line_width + 1.0;  // a pixel more, for the soft rim
  float side = (corner & 1) == 0 ? -1.0 : 1.0;
  bool at_end = corner >= 2;
  vec4 clip = at_end ? end : start;
  vec2 shift = reach * (side * across + (at_end ? along : -along));
  place = vec2(at_end ? length_pixels + reach : -reach, side * reach);
  gl_Position = clip + vec4(shift * 2.0 / viewport * clip.w, 0.0, 0.0);
}
