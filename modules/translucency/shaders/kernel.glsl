// The kernel's table (radial_kernel.h): exitance by the squared distance, 1/m2; a: luminance of the
// part from deep inside.
layout(std430) readonly buffer Kernel { vec4 kernel[]; };
uniform uint kernel_low_bits;

const int kKernelEntries = 26 * 16, kKernelFractionBits = 23 - 4;

// A float's bits are linear between powers of two: they index the table without a logarithm.
vec4 kernel_at(float r2) {
    int place = clamp(int(floatBitsToUint(r2)) - int(kernel_low_bits), 0, ((kKernelEntries - 1) << kKernelFractionBits) - 1);
    int i = place >> kKernelFractionBits;
    float f = float(place & ((1 << kKernelFractionBits) - 1)) * (1.0 / float(1 << kKernelFractionBits));
    vec4 a = kernel[i];
    return a + f * (kernel[i + 1] - a);
}
