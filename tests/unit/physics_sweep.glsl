/// One number from each corner of engine/physics, for arguments made of `x` in [0, 1)^4: the same text runs on the GPU
/// and in C++, and must give the same.
const int kSweeps = 24;

FN float sweep(int which, vec4 x) {
    vec3 n = sample_uniform_sphere(vec2(x.x, x.y));
    vec3 v = to_frame(sample_cosine_hemisphere(vec2(x.z, x.w)), n);
    vec3 l = to_frame(sample_cosine_hemisphere(vec2(x.w, x.x)), n);
    float u = 2.0f * x.x - 1.0f;
    float g = 1.8f * x.y - 0.9f;
    float t0 = 0.0f;
    float t1 = 20.0f;
    float pdf;
    vec3 refracted;
    LightTerms terms;
    switch (which) {
        case 0: return phase_evaluate(int(x.z * float(PHASE_COUNT)), vec4(g, 0.5f, 0.5f, 0.5f), u);
        case 1: return phase_mie_droplets(u, mie_droplet_fit(5.0f + 20.0f * x.y));
        case 2: return sample_henyey_greenstein(x.x, g);
        case 3: return sample_draine(x.x, g, 10.0f * x.z);
        case 4: return sample_rayleigh(x.x) + sample_schlick(x.y, g);
        case 5: return mean_transmittance(exp(20.0f * x.x - 18.0f));
        case 6: return segment_integral(vec3(1.0f), vec3(0.0f, 10.0f * x.x, x.y), x.z).y;
        case 7: return sample_exponential_distance(x.x, 3.0f * x.y, 1.0f + x.z, pdf) + pdf;
        case 8: return height_fog_optical_depth(0.1f, 0.0f, 1.0f + 9.0f * x.x, 20.0f * x.y, 20.0f * x.z, 30.0f);
        case 9: return sample_equi_angular(x.x, 0.0f, 10.0f, vec3(0.0f), n, 5.0f * v, pdf);
        case 10: return airlight_point(1.0f, 0.1f + x.x, 1.0f + 3.0f * x.y, 1.8f * x.z - 0.9f, 1.0f + 10.0f * x.w);
        case 11: return clip_to_box(5.0f * n, v, vec3(-2.0f), vec3(3.0f), t0, t1) ? t1 - t0 : -1.0f;
        case 12: return clip_to_cone(5.0f * n, v, l, -n, 0.3f + 0.6f * x.x, 8.0f, t0, t1) ? t1 - t0 : -1.0f;
        case 13: return fresnel_dielectric(x.x, 0.5f + x.y) + fresnel_conductor(x.z, vec3(1.2f), vec3(3.0f)).x;
        case 14: return refract_ray(-v, n, 1.0f / 1.5f, refracted) ? dot(refracted, v) : 0.0f;
        case 15:
            terms = standard_light(n, v, l, 0.2f + 0.8f * x.x, vec3(1.0f));
            return standard_compose(standard_material(vec3(x.y), x.z, 1.5f, 1.0f, vec3(1.0f)), vec2(0.6f, 0.1f), terms).x;
        case 16: return sample_ggx_visible_normal(vec2(x.x, x.y), vec3(0.6f, 0.0f, 0.8f), 0.1f + x.z).z;
        case 17: return direction_to_equirect(n).y + spot_falloff(SPOT_SMOOTHSTEP, x.x, 0.7f, 0.4f);
        case 18: return hammersley(uint(x.x * 4096.0f), 4096u).y + r2_sequence(uint(x.y * 65536.0f)).x;
        case 19: return exposure_from_ev100(20.0f * x.x) * point_irradiance(x.y, x.z) * range_window(x.w, 0.8f);
        case 20: return noise_density(60.0f * vec3(x.x, x.y, x.z) - 30.0f, 3, 0.2f + 0.8f * x.w);
        case 21: return filtered_noise_density(40.0f * vec3(x.x, x.y, x.z) - 20.0f, NOISE_WORLEY, 3, 0.3f + 0.7f * x.w, x.x);
        case 22: return noise_swirl(30.0f * vec3(x.x, x.y, x.z) - 15.0f, x.w).y;
        case 23: return log(1.0f + black_body_radiance(1000.0f + 6000.0f * x.x).y) + radial_ramp(v, n, 0.2f, 1.0f);
        default: return 0.0f;
    }
}
