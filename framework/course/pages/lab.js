// Lays the methods of the two boxes on each other. Without this script all pictures are side by side below.
const stage = document.querySelector(".stage");
if (stage) {
  const methods = [...document.querySelectorAll(".methods figure")], [left, right] = stage.querySelectorAll("select");
  const map = stage.querySelector("[value=map]"), scale = stage.querySelector(":has(> .scale)");
  const sides = stage.querySelectorAll(".sides span"), under = stage.querySelector("img"), over = under.cloneNode();
  const name = "wipe from the left method to the right", told = value => `${value} % ${left.value}`;
  const {label, slide} = wipe(under, over, "wipe", name, 50, told);
  stage.querySelector(".laid").after(label);
  const lay = (image, side, box) => {
    const method = methods[box.selectedIndex], source = method.querySelector(map?.checked ? ".map" : ".picture");
    image.src = source.src;
    image.alt = source.alt;
    side.textContent = box.selectedOptions[0].textContent;
  };
  const show = () => {
    lay(over, sides[0], left);
    lay(under, sides[1], right);
    if (scale) scale.hidden = !map.checked;
    slide();
  };
  stage.addEventListener("change", show);
  stage.hidden = false;
  show();
}
