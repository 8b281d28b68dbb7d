// The variables by which task 18.5 can pass a number from the vertex stage to the fragment stage. The first one is not
// interpolated, the second one is.

#ifdef VERTEX_STAGE
flat out int v_index;
out float v_number;
#else
flat in int v_index;
in float v_number;
#endif
