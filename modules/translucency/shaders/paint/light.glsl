// Lux that 1 in the target paint_light stands for, so that the sun is no more than a half float can hold.
const float kLightOfHalf = 16.0;
