// What a light sees of an object: where light enters.
in vec4 v_normal_z;
layout(location = 0) out vec4 entry;  // world normal; metres along the light's axis. A normal of 0: nothing there

void main() { entry = vec4(normalize(v_normal_z.xyz), v_normal_z.w); }
