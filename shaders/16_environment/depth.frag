#version 410 core
// The sun's depth map: depth alone.

void main() {}
