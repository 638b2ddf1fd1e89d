#version 330 core
uniform vec3 top, bottom;
in float height;
out vec4 colour;

// A grain of half a shade, fixed to the pixel: keeps the slow gradient from showing steps.
float grain() {
  ivec2 p = ivec2(gl_FragCoord.xy) & 3, q = p >> 1;
  int rank = 8 * ((p.x ^ p.y) & 1) + 4 * (p.y & 1) + 2 * (q.x ^ q.y) + q.y;  // Bayer's 4 x 4 pattern
  return (float(rank) + 0.5) / 16.0 - 0.5;
}

void main() { colour = vec4(mix(bottom, top, smoothstep(0.0, 1.0, height)) + grain() / 255.0, 1.0); }
