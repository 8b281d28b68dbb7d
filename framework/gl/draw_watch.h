// Draw calls as they are made, for whoever wants to make one again in another way. Behind the GL function pointers,
// like the counters, so raw calls of a lab are seen, too.
#pragma once

#include <functional>

namespace relief {

/// While this lives, each draw call is handed to `watch`, which has to make it: `draw` may be called any number of
/// times. One at a time.
class DrawWatch {
public:
    using Watch = std::function<void(const std::function<void()>& draw)>;
    explicit DrawWatch(Watch watch);
    ~DrawWatch();
    DrawWatch(const DrawWatch&) = delete;
    DrawWatch& operator=(const DrawWatch&) = delete;
};

}  // namespace relief
