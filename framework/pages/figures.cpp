#include "framework/pages/figures.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/image/visualize.h"
#include "framework/pages/page.h"

namespace relief {
namespace {

/// The colours of visualize_error(), which are linear in between.
std::string heat_gradient() {
    std::string stops;
    for (int i = 0; i <= 5; ++i) {
        const glm::dvec3 color = 255.0 * heat_color(i / 5.0);
        stops += fmt::format(", rgb({:.0f} {:.0f} {:.0f})", color.r, color.g, color.b);
    }
    return "linear-gradient(to right" + stops + ")";
}

constexpr const char* style = R"(
.laid { position: relative; overflow: hidden; border-radius: 6px; box-shadow: 0 0 0 1px var(--line); cursor: ew-resize; touch-action: pan-y; }
.laid img { display: block; width: 100%; height: auto; } .laid img + img { position: absolute; inset: 0; }
.laid i { position: absolute; top: 0; bottom: 0; width: 2px; margin-left: -1px; background: #fff; box-shadow: 0 0 0 1px #000; }
.scale { display: flex; flex-wrap: wrap; justify-content: space-between; font-size: 14px; color: var(--quiet); }
.scale[hidden] { display: none; }
.scale div { flex: 0 0 100%; height: 10px; border-radius: 5px; border: 1px solid var(--line); margin: 4px 0; background: HEAT; }
.wipe { display: flex; flex-wrap: wrap; gap: 0 10px; align-items: center; font-size: 15px; color: var(--quiet); }
.wipe span { white-space: nowrap; } .wipe input { flex: 1 1 110px; min-width: 0; height: 24px; accent-color: var(--accent); }
@media print { .wipe, .laid i { display: none; } .laid img + img { visibility: hidden; } }
)";

}  // namespace

std::string figures_style() {
    std::string all = style;
    return all.replace(all.find("HEAT"), 4, heat_gradient());
}

std::string error_scale(const std::vector<std::string>& marks) {
    std::string text = R"(<div class="scale" aria-hidden="true"><div></div>)";
    for (const std::string& mark : marks)
        text += "<span>" + html(mark) + (&mark == &marks.back() ? " and more</span>" : "</span>");
    return text + "</div>";
}

const char* const wipe_function = R"(
const wipe = (under, over, words, name, value, told) => {
  const make = (tag, kind = "") => Object.assign(document.createElement(tag), {className: kind});
  const laid = make("div", "laid"), edge = make("i"), label = make("label", "wipe"), text = make("span"), slider = make("input");
  under.replaceWith(laid);
  laid.append(under, over, edge);
  text.textContent = words;
  Object.assign(slider, {type: "range", min: 0, max: 100, value, autocomplete: "off"});
  slider.setAttribute("aria-label", name);
  label.append(text, slider);
  const slide = () => {
    over.style.clipPath = `inset(0 ${100 - slider.value}% 0 0)`;
    edge.style.left = slider.value + "%";
    edge.hidden = slider.value % 100 == 0;
    slider.setAttribute("aria-valuetext", told(slider.value));
  };
  const drag = event => {
    if (!event.buttons) return;
    const box = laid.getBoundingClientRect();
    slider.value = 100 * (event.clientX - box.left) / box.width;
    slide();
  };
  laid.addEventListener("pointerdown", drag);
  laid.addEventListener("pointermove", drag);
  laid.addEventListener("dragstart", event => event.preventDefault());
  slider.addEventListener("input", slide);
  slide();
  return {label, slide};
};
)";

}  // namespace relief
