// Sorts and filters the class. Without this script the table keeps the order of grading, and shows everything.
const table = document.querySelector("#marks"), body = table.tBodies[0], rows = [...body.rows];
const sorters = [...table.tHead.rows[0].cells].filter(cell => cell.querySelector("button"));
const order = new Intl.Collator(undefined, {numeric: true, sensitivity: "base"});
for (const head of sorters) head.querySelector("button").addEventListener("click", () => {
  const column = head.cellIndex, up = head.ariaSort != "ascending", sign = up ? 1 : -1;
  for (const other of sorters) other.ariaSort = other == head ? (up ? "ascending" : "descending") : "none";
  const key = row => column == 0 ? row.cells[0].textContent : parseFloat(row.cells[column].textContent);
  const keys = new Map(rows.map(row => [row, key(row)]));
  const compare = (a, b) => column == 0 ? sign * order.compare(a, b)
    : isNaN(a) || isNaN(b) ? isNaN(a) - isNaN(b) : sign * (a - b);  // without a number: last, either way
  body.append(...rows.sort((a, b) => compare(keys.get(a), keys.get(b))));
});
const filter = document.querySelector("#filter"), told = document.querySelector("#shown");
const words_of = row =>
  [...row.cells].filter(cell => !cell.classList.contains("number")).map(cell => cell.textContent).join(" ").toLowerCase();
const texts = new Map(rows.map(row => [row, words_of(row)]));
const sift = () => {
  const words = filter.value.toLowerCase().split(/[ \t]+/).filter(word => word);
  let shown = 0;
  for (const row of rows) {
    row.hidden = !words.every(word => texts.get(row).includes(word));
    shown += !row.hidden;
  }
  told.textContent = `${shown} of ${rows.length} shown`;
};
filter.addEventListener("input", sift);
sift();
for (const button of document.querySelectorAll(".pick")) button.addEventListener("click", () => {
  filter.value = button.value;
  sift();
  filter.focus();
});
