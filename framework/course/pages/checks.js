// Adds to each check a wipe from the drawn to the expected picture. Without this script they are side by side.
for (const pictures of document.querySelectorAll(".pictures")) {
  const mine = pictures.querySelector(".mine img"), expected = pictures.querySelector(".expected img");
  if (!mine || !expected) continue;
  const words = "wipe to the expected picture", over = expected.cloneNode();
  over.alt = "";  // the expected picture itself has the words
  const {label} = wipe(mine, over, words, `${words}: ${pictures.dataset.check}`, 0, value => `${value} % expected`);
  pictures.querySelector(".mine").append(label);
}
