// What leaves at each point of the light that has entered elsewhere, and what share of its own.
#include "translucency/points/gather.glsl"
#include "translucency/points/store.glsl"

void main() {
    Four low = four_of_thread(0u), high = four_of_thread(4u);
    gather(low, high);
    for (uint i = 0u; i < 4u; ++i) {
        store(low.points[i], exitance_of(low.sum, i));
        store(high.points[i], exitance_of(high.sum, i));
    }
}
