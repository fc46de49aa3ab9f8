// The levels of a light's map lie in one image: the first at the left, the others, each half as wide, above one another at
// its right. Where a processor renders, images are read more quickly than textures, and mips more slowly.
uniform int map_size;  // of the first level

ivec2 level_origin(int level) { return level == 0 ? ivec2(0) : ivec2(map_size, map_size - 2 * (map_size >> level)); }
