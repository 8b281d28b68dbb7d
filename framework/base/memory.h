// How the process gets its memory.
#pragma once

namespace relief {

/// Takes the first 64 MiB of the heap in large pages, where the system has them, and gives no memory back before the
/// end. Textures and pictures come and go in pieces of megabytes: in small pages the system's work for them is a sixth
/// of a shot's time. Call it first.
void take_large_pages();

}  // namespace relief
