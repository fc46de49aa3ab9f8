// Which way media scatter, and whether they are at a place, for programs that look at several.
#include "participating_media/media.glsl"

#ifdef PHASE_KIND
#define phase_kind_of(medium) PHASE_KIND
#else
#define phase_kind_of(medium) int(media[medium].sigma_s_phase.w)
#endif

uniform sampler2D phase_tables;  // a row for each medium, over the scattering angle

vec3 medium_phase(int medium, float u) {
#if !defined(PHASE_KIND) || PHASE_KIND == 8
    float width = float(textureSize(phase_tables, 0).x);
    float column = 0.5 + acos(clamp(u, -1.0, 1.0)) * 0.31830989 * (width - 1.0);
    vec3 table = textureLod(phase_tables, vec2(column / width, (float(medium) + 0.5) / 16.0), 0.0).rgb;
#if defined(PHASE_KIND)
    return table;
#else
    if (phase_kind_of(medium) == 8) return table;
#endif
#endif
    return vec3(phase_evaluate(phase_kind_of(medium), media[medium].phase_parameters, u));
}

// The place is in medium i's box, or in its ellipsoid.
bool medium_holds(int i, vec3 p) {
    vec3 local = medium_place(i, p);
    return all(lessThan(abs(local), vec3(0.5))) && media[i].shape.x * dot(local, local) < 0.25;
}
