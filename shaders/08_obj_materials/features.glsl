// What a material names. A program is compiled for one set of features, FEATURES; or for all of them, and looks at
// u_features in each pixel (BRANCHES).

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
