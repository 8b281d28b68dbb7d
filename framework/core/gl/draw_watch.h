// Intercepts draw calls, so that a caller can repeat them with other state. The hook wraps the GL function pointers,
// like the counters, so a lab's raw calls are seen as well.
#pragma once

#include <functional>

namespace relief {

/// While it lives, each draw call goes to `watch` instead of GL. `watch` must issue the draw itself: it may call `draw`
/// any number of times. At most one DrawWatch at a time.
class DrawWatch {
public:
    using Watch = std::function<void(const std::function<void()>& draw)>;
    explicit DrawWatch(Watch watch);
    ~DrawWatch();
    DrawWatch(const DrawWatch&) = delete;
    DrawWatch& operator=(const DrawWatch&) = delete;
};

}  // namespace relief
