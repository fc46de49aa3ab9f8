// Epipolar lines: those through the light's place on the screen. Light on its way stays on one of them, so what is
// scattered into neighbouring rays of one line is alike. Places are in pixels, the border is the picture's.
//
// Slices end at the border, the same number on each of its sides, one at each corner; those whose end faces the light's
// side of the picture have no length.

/// Places on the border for 0..4: bottom, right, top, left, counter-clockwise.
vec2 border_place(float q, vec2 size) {
    float side = floor(q);
    float f = q - side;
    vec2 unit = side < 0.5 ? vec2(f, 0.0) : side < 1.5 ? vec2(1.0, f) : side < 2.5 ? vec2(1.0 - f, 1.0) : vec2(0.0, 1.0 - f);
    return (side > 3.5 ? vec2(0.0) : unit) * size;
}

/// The inverse, for a place on the border.
float border_parameter(vec2 place, vec2 size) {
    vec2 unit = clamp(place / size, vec2(0.0), vec2(1.0));
    vec4 away = vec4(unit.y, 1.0 - unit.x, 1.0 - unit.y, unit.x);
    float least = min(min(away.x, away.y), min(away.z, away.w));
    if (away.x == least) return unit.x;
    if (away.y == least) return 1.0 + unit.y;
    if (away.z == least) return 2.0 + (1.0 - unit.x);
    return 3.0 + (1.0 - unit.y);
}

/// Where the line from + t (to - from) is inside the picture.
vec2 inside_picture(vec2 from, vec2 to, vec2 size) {
    vec2 d = to - from;
    d = mix(d, vec2(1e-6), lessThan(abs(d), vec2(1e-6)));
    vec2 a = -from / d, b = (size - from) / d;
    vec2 near = min(a, b), far = max(a, b);
    return vec2(max(near.x, near.y), min(far.x, far.y));
}
