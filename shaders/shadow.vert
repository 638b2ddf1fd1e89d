#version 330 core
// The model's soft shadow on the ground beneath it: a rectangle with a prepared picture.
uniform mat4 view_projection;
uniform vec3 low, high;  // of the rectangle; its height is low.z
out vec2 place;

void main() {
  place = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = view_projection * vec4(mix(low.xy, high.xy, place), low.z, 1.0);
}
