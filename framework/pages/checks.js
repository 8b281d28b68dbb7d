// In each check a wipe from what was drawn to what is expected. Without it the pictures lie side by side.
for (const pictures of document.querySelectorAll(".pictures")) {
  const mine = pictures.querySelector(".mine img"), expected = pictures.querySelector(".expected img");
  if (!mine || !expected) continue;
  const words = "wipe to the expected picture", over = expected.cloneNode();
  over.alt = "";  // its words stand at the expected picture itself
  const {label} = wipe(mine, over, words, `${words}: ${pictures.dataset.check}`, 0, value => `${value} % expected`);
  pictures.querySelector(".mine").append(label);
}
