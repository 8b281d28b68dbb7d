#version 410 core
// The sun's depth map: writes depth only.

void main() {}
