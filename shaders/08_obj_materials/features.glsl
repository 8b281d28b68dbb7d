// The features of a material. A program is compiled for one set of features, FEATURES. With BRANCHES it is compiled for
// all of them, and each pixel tests u_features.

#include "08_obj_materials/feature_bits.glsl"

//(has
#ifdef BRANCHES
uniform int u_features;
#define HAS(feature) ((u_features & feature) != 0)
#else
#define HAS(feature) ((FEATURES & feature) != 0)
#endif
//)
