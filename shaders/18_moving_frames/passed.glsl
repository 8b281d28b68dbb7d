// Lab 18, your task: what the vertex stage hands on. Both stages include this file.

#include "common/unfinished.glsl"

// TASK 18.5 (2 points): hand the index of an instance's material on from the vertex stage to the fragment stage. All
// three corners of a triangle have the same index, but what is interpolated is a sum of three rounded products, times a
// rounded depth: 2.9999998 becomes 2, and the material flickers. A variable between stages that is `flat` is not
// interpolated. Declare one in both stages, `out` in the first and `in` in the second, and write and read it.
//(passed
#ifdef VERTEX_STAGE
//[solution
flat out int v_material;
void pass_material(int index) { v_material = index; }
//]starter
//| void pass_material(int index) {}
//]
#else
//[solution
flat in int v_material;
int passed_material() { return v_material; }
//]starter
//| int passed_material() { return unfinished(0); }
//]
#endif
//)
