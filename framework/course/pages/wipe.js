// wipe() lays `over` on `under` with a slider between them. It returns the slider's `label`, with `words`, for the
// caller to insert, and slide(), to call after a change. Screen readers get the slider's `name`, and told(value) as its
// text. At 0 only `under` is visible, at 100 only `over`.
const wipe = (under, over, words, name, value, told) => {
  const make = (tag, kind = "") => Object.assign(document.createElement(tag), {className: kind});
  const laid = make("div", "laid"), edge = make("i"), label = make("label", "wipe");
  const text = make("span"), slider = make("input");
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
