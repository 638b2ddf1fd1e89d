#version 330 core
// The faces of the input, a hint of colour.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;

uniform mat4 view_projection;
uniform vec3 eye;
flat out float facing;  // 1: seen straight on, 0: edge-on

void main() {
  gl_Position = view_projection * vec4(position, 1.0);
  facing = abs(dot(normalize(normal.xyz), normalize(eye - position)));
}
