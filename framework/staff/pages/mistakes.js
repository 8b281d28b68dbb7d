// Shows the mistakes that match the words in the filter and the chosen lab.
const filter = document.querySelector(".filter");
const words = filter.querySelector("input"), lab = filter.querySelector("select");
const all = [...document.querySelectorAll("article")];
const show = () => {
  const wanted = words.value.toLowerCase().split(/\s+/);
  let count = 0;
  for (const one of all) {
    const text = one.dataset.words.toLowerCase();
    one.hidden = !wanted.every(word => text.includes(word)) ||
      (lab.value && one.closest("section[data-lab]").dataset.lab != lab.value);
    count += !one.hidden;
  }
  for (const part of document.querySelectorAll("main section"))
    part.hidden = ![...part.querySelectorAll("article")].some(one => !one.hidden);
  filter.querySelector("output").textContent = `${count} of ${all.length} shown`;
};
words.addEventListener("input", show);
lab.addEventListener("change", show);
// Opens all differences for printing: nobody can open them on paper.
const differences = [...document.querySelectorAll("details.difference:not([open])")];
addEventListener("beforeprint", () => differences.forEach(one => one.open = true));
addEventListener("afterprint", () => differences.forEach(one => one.open = false));
filter.hidden = false;
show();
