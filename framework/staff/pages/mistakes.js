// Shows the mistakes that match the words in the filter. Left and right go to the neighbours of the shown mistake.
const main = document.querySelector("main"), filter = document.querySelector(".filter");
const words = filter.querySelector("input"), all = [...document.querySelectorAll(".index li")];
const has_one_lab = main.classList.contains("named");
const show = () => {
  const wanted = words.value.toLowerCase().split(/\s+/);
  for (const one of all) one.hidden = !wanted.every(word => one.dataset.words.toLowerCase().includes(word));
  for (const part of document.querySelectorAll("section, .task")) part.hidden = !part.querySelector("li:not([hidden])");
  main.classList.toggle("named", has_one_lab || words.value.trim() != "");
  filter.querySelector("output").textContent = `${all.filter(one => !one.hidden).length} of ${all.length} shown`;
};
words.addEventListener("input", show);
addEventListener("keydown", event => {
  const way = {ArrowLeft: "prev", ArrowRight: "next"}[event.key];
  if (!way || event.altKey || event.ctrlKey || event.metaKey || event.target.matches("input, pre")) return;
  document.querySelector(`article:target [rel=${way}]`)?.click();
});
filter.hidden = false;
show();
