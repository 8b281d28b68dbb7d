// The only file that includes librsvg, and Cairo, which librsvg draws with. Built as a module of its own.
#include "framework/course/pages/librsvg.h"

#include <librsvg/rsvg.h>

#include <cstdint>
#include <memory>

#include "framework/core/base/error.h"

namespace {

template <auto release>
struct Release {
    void operator()(auto* object) const { release(object); }
};
using Surface = std::unique_ptr<cairo_surface_t, Release<cairo_surface_destroy>>;
using Pen = std::unique_ptr<cairo_t, Release<cairo_destroy>>;
using Drawing = std::unique_ptr<RsvgHandle, Release<g_object_unref>>;

void check(bool done, GError* error) {
    if (done) return;
    const std::unique_ptr<GError, Release<g_error_free>> owned(error);
    throw relief::Error("not an SVG picture: " + std::string(owned ? owned->message : "librsvg does not say why"));
}

}  // namespace

relief::Image relief_draw_svg(const std::string& svg, glm::ivec2 size) {
    GError* error = nullptr;
    // Data without a base address cannot refer to other files.
    const Drawing drawing(rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(), &error));
    check(drawing != nullptr, error);
    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, size.x, size.y));
    const Pen pen(cairo_create(surface.get()));
    cairo_set_source_rgb(pen.get(), 1, 1, 1);
    cairo_paint(pen.get());
    const RsvgRectangle all{0, 0, double(size.x), double(size.y)};
    check(rsvg_handle_render_document(drawing.get(), pen.get(), &all, &error), error);
    cairo_surface_flush(surface.get());
    if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS)
        throw relief::Error(cairo_status_to_string(cairo_surface_status(surface.get())));

    const unsigned char* const bytes = cairo_image_surface_get_data(surface.get());
    const int row_bytes = cairo_image_surface_get_stride(surface.get());
    relief::Image image(size.x, size.y, 3, 8);
    for (int y = 0; y < size.y; ++y) {
        const auto* const row = reinterpret_cast<const uint32_t*>(bytes + std::ptrdiff_t(y) * row_bytes);
        for (int x = 0; x < size.x; ++x)
            for (int c = 0; c < 3; ++c)  // red is in the highest bits
                image.pixel(x, y)[c] = float(row[x] >> (16 - 8 * c) & 255) / 255;
    }
    return image;
}
