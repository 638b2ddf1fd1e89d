#version 330 core
uniform sampler2D darkness;
uniform vec3 shadow;
uniform float strength;
in vec2 place;
out vec4 colour;

// As in backdrop.frag, against steps.
float grain() {
  ivec2 p = ivec2(gl_FragCoord.xy) & 3, q = p >> 1;
  int rank = 8 * ((p.x ^ p.y) & 1) + 4 * (p.y & 1) + 2 * (q.x ^ q.y) + q.y;  // Bayer's 4 x 4 pattern
  return (float(rank) + 0.5) / 16.0 - 0.5;
}

void main() {
  float dark = texture(darkness, place).r;
  colour = vec4(shadow, strength * dark + (dark > 0.0 ? 1.5 * grain() / 255.0 : 0.0));
}
