#ifndef TYNDALL_PHYSICS_CONSTANTS
#define TYNDALL_PHYSICS_CONSTANTS
/// Numbers that every file here uses.

const float kPi = 3.14159265358979f;
const float kTwoPi = 6.28318530717959f;
const float kInversePi = 0.318309886183791f;
const float kInverseFourPi = 0.0795774715459477f;

/// x squared.
FN float square(float x) { return x * x; }

#endif
