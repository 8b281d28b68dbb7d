// The bits of the features that a material can name. labs/08_obj_materials/scene.h includes this file, too.

#define COLOR_MAP 1
#define HIGHLIGHT_MAP 2
#define NORMAL_MAP 4
#define HEIGHT_MAP 8
#define MASK_MAP 16
#define GLASS 32  // its opacity is below 1
