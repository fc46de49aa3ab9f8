// One triangle that covers the target; made from gl_VertexID alone.
out vec2 uv;  // 0..1 over the target, origin at the bottom left

void main() {
    uv = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);
}
