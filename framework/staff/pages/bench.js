// Hovering over a point of a plot, or over its row in the table, shows its pictures. A click keeps them in view.
const look = document.getElementById('look'), words = look.querySelector('p'), images = look.querySelector('.looks');
let kept = null;
function all(key) { return document.querySelectorAll('[data-key="' + key + '"]'); }
function show(key) {
  document.querySelectorAll('.chosen').forEach(e => e.classList.remove('chosen'));
  if (!key) { look.hidden = true; return; }
  all(key).forEach(e => e.classList.add('chosen'));
  const row = document.querySelector('tr[data-key="' + key + '"]');
  words.textContent = row.dataset.words;
  images.replaceChildren();
  row.querySelectorAll('img').forEach(image => {
    const box = document.createElement('div'), copy = document.createElement('img');
    copy.src = image.src; copy.alt = image.alt;
    box.append(copy, image.alt);
    images.append(box);
  });
  look.hidden = false;
}
function keep(key) { kept = kept === key ? null : key; show(kept || key); }
document.querySelectorAll('figure[data-topic]').forEach(figure => figure.querySelectorAll('.point').forEach(point => {
  point.dataset.key = figure.dataset.topic + '-' + point.dataset.row;
  point.addEventListener('mouseenter', () => show(point.dataset.key));
  point.addEventListener('mouseleave', () => show(kept));
}));
document.querySelectorAll('tr[data-key]').forEach(row => { row.tabIndex = 0; });
document.querySelectorAll('[data-key]').forEach(element => {
  element.addEventListener('click', () => keep(element.dataset.key));
  element.addEventListener('keydown', event => { if (event.key === 'Enter') keep(element.dataset.key); });
});
document.addEventListener('keydown', event => { if (event.key === 'Escape') { kept = null; show(null); } });
look.querySelector('button').addEventListener('click', () => { kept = null; show(null); });
