// Shows the labs that have all words of the search. Without this script all labs are there.
const box = document.querySelector(".find"), words = box.querySelector("input");
const cards = [...document.querySelectorAll(".cards article")];
words.addEventListener("input", () => {
  const wanted = words.value.toLowerCase().split(/\s+/);
  for (const card of cards) card.hidden = !wanted.every(word => card.textContent.toLowerCase().includes(word));
  for (const group of document.querySelectorAll("section:has(.cards)"))
    group.hidden = !group.querySelector("article:not([hidden])");
  box.querySelector("output").textContent = `${cards.filter(card => !card.hidden).length} of ${cards.length} labs`;
});
box.hidden = false;
