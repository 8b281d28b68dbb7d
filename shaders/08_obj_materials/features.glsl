// The features of a material. A program is compiled for one set of features, FEATURES. With BRANCHES it is compiled for
// all of them, and each pixel tests u_features.

#define COLOR_MAP 1
#define HIGHLIGHT_MAP 2
#define NORMAL_MAP 4
#define HEIGHT_MAP 8
#define MASK_MAP 16
#define GLASS 32

//(has
#ifdef BRANCHES
uniform int u_features;
#define HAS(feature) ((u_features & feature) != 0)
#else
#define HAS(feature) ((FEATURES & feature) != 0)
#endif
//)
