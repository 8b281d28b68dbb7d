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
// A plot is one stop of the Tab key; arrow keys go from point to point.
document.querySelectorAll('figure[data-topic] svg').forEach(plot => {
  const points = [...plot.querySelectorAll('.point')], topic = plot.closest('figure').dataset.topic;
  points.forEach((point, i) => {
    point.dataset.key = topic + '-' + point.dataset.row;
    point.tabIndex = i ? -1 : 0;
    point.setAttribute('role', 'button');
    point.setAttribute('aria-label', point.querySelector('title').textContent);
    point.addEventListener('mouseenter', () => show(point.dataset.key));
    point.addEventListener('mouseleave', () => show(kept));
    point.addEventListener('focus', () => { if (point.matches(':focus-visible')) show(point.dataset.key); });
    point.addEventListener('blur', () => show(kept));
    point.addEventListener('keydown', event => {
      const way = {ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1}[event.key];
      if (!way || !points[i + way]) return;
      event.preventDefault();
      point.tabIndex = -1, points[i + way].tabIndex = 0;
      points[i + way].focus();
    });
  });
});
document.querySelectorAll('tr[data-key]').forEach(row => { row.tabIndex = 0; });
document.querySelectorAll('[data-key]').forEach(element => {
  element.addEventListener('click', () => keep(element.dataset.key));
  element.addEventListener('keydown', event => { if (event.key === 'Enter') keep(element.dataset.key); });
});
document.addEventListener('keydown', event => { if (event.key === 'Escape') { kept = null; show(null); } });
look.querySelector('button').addEventListener('click', () => { kept = null; show(null); });
