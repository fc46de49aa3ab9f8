// A gobo image into its layer of light_gobos, rows as they are.
in vec2 uv;
layout(location = 0) out vec4 transmittance;

uniform sampler2D image;

void main() { transmittance = vec4(clamp(texture(image, uv).rgb, 0.0, 1.0), 1.0); }
