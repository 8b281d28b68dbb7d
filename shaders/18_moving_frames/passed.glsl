// What task 18.5 can hand on from the vertex stage to the fragment stage: a number that is not interpolated, and one
// that is.

#ifdef VERTEX_STAGE
flat out int v_index;
out float v_number;
#else
flat in int v_index;
in float v_number;
#endif
