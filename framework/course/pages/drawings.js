// Drawings that move: each svg with data-moves="NAME" gets sliders below it, which move its parts, the elements with
// data-part. A drag over the drawing does the same. A drawing computes what its lab's task computes. Without this
// script, and on paper, it is complete and does not move.
{
  const radians = degrees => degrees * Math.PI / 180, degrees = radians => radians * 180 / Math.PI;
  const mix = (from, to, share) => from + (to - from) * share;
  const number = value => value.toFixed(2).replace("-", "−");

  // Lab 10: by how much a ray goes sideways on its way down. `angle` is measured from the normal.
  const along_of = (angle, depth) => Math.tan(radians(angle)) * depth;
  // Lab 11: the share of the way between two samples at which two straight lines cross.
  const crossing = (gap_before, gap_after) => gap_before / (gap_before - gap_after);
  // A relief of straight pieces, [x, height], and the first t at which the ray meets it: over uv + t along, at 1 - t.
  const height_at = (relief, x) => {
    const next = Math.max(1, relief.findIndex(point => point[0] >= x)), [a, b] = [relief[next - 1], relief[next]];
    return mix(a[1], b[1], (x - a[0]) / (b[0] - a[0]));
  };
  const first_hit = (relief, uv, along) => {
    const gap = t => 1 - t - height_at(relief, uv + t * along);
    let before = 0;
    for (const t of [...relief.map(point => (point[0] - uv) / along).filter(t => t > 0 && t < 1), 1]) {
      if (gap(t) <= 0) return mix(before, t, crossing(gap(before), gap(t)));
      before = t;
    }
    return 1;
  };
  // Lab 13: the points of an edge, as Direct3D's tessellator places them. OpenGL leaves open which two segments of a
  // fractional level are the short ones.
  const places = (spacing, level) => {
    if (spacing == 0) return Array.from({length: Math.ceil(level) + 1}, (_, i) => i / Math.ceil(level));
    const odd = spacing == 1 ? 0 : 1, halves = (Math.max(level, 2 - odd) + odd) / 2;
    const few = Math.floor(halves), many = Math.ceil(halves), over = few - odd;
    const short = few == many ? many : few == 1 && odd ? 0 : 2 * (over - 2 ** Math.floor(Math.log2(over))) + 1;
    const first = Array.from({length: many}, (_, i) =>
      mix((i > short ? i - 1 : i) / (2 * few - odd), i / (2 * many - odd), halves - few));
    return [...first, ...odd ? [] : [0.5], ...first.map(place => 1 - place).reverse()];
  };

  // The relief of a drawing whose heights 1 and 0 have these y.
  const relief_of = (part, top, ground) =>
    [...part("surface").points].map(point => [point.x, (ground - point.y) / (ground - top)]);

  const drawings = {
    ray_in_relief: {
      sliders: [{name: "angle from the normal", min: 15, max: 60, step: 1, value: 45, unit: "°"}],
      drag: (x, y) => [degrees(Math.atan2(x - 190, Math.max(y - 120, 1)))],
      draw(part, put, angle) {
        const top = 120, ground = 370, uv = 190, along = along_of(angle, ground - top);
        const t = first_hit(relief_of(part, top, ground), uv, along);
        const x = uv + t * along, y = mix(top, ground, t), begin = uv - along_of(angle, 100);
        put("seen", {x1: begin}), put("ray", {x2: x, y2: y}), put("rest", {x1: x, y1: y, x2: uv + along});
        put("hit", {cx: x, cy: y}), put("hit-name", {x: x + 20, y: y + 4});
        put("along", {x2: uv + along}), put("end-name", {x: uv + along + 13}), put("eye-name", {x: begin + 14});
        return `the hit: t = ${number(t)}`;
      },
    },
    one_tap: {
      sliders: [{name: "entry of the ray", min: 0, max: 100, step: 1, value: 0, unit: " %"},
                {name: "angle from the normal", min: 30, max: 65, step: 1, value: 58, unit: "°"}],
      drag: x => [(x - 150) / 3.1],
      draw(part, put, entry, angle) {
        const top = 120, ground = 380, uv = mix(150, 460, entry / 100), along = along_of(angle, ground - top);
        const relief = relief_of(part, top, ground), height = height_at(relief, uv), level = mix(ground, top, height);
        const hit = first_hit(relief, uv, along), guess = 1 - height;
        const [hit_x, hit_y, guess_x] = [uv + hit * along, mix(top, ground, hit), uv + guess * along];
        put("seen", {x1: uv - along_of(angle, 68), x2: uv}), put("eye-name", {x: uv - along_of(angle, 68) + 35});
        put("ray", {x1: uv, x2: hit_x, y2: hit_y}), put("rest", {x1: hit_x, y1: hit_y, x2: guess_x, y2: level});
        put("entry", {cx: uv}), put("hit", {cx: hit_x, cy: hit_y}), put("guess", {cx: guess_x, cy: level});
        put("level", {y1: level, y2: level}), put("tap", {x1: uv, x2: uv, y2: level});
        put("below", {cx: uv, cy: level});
        // Where points are close together, their names would meet.
        const [end, start] = [{"text-anchor": "end"}, {"text-anchor": "start"}], is_high = level < 250;
        put("tap-name", is_high || hit_x < uv + 140 ? {x: uv + 14, y: 110, ...start}
                                                    : {x: uv - 10, y: (top + level) / 2 + 20, ...end});
        put("hit-name", is_high ? {x: hit_x - 4, y: hit_y + 44} : {x: hit_x - 20, y: hit_y + 42});
        put("guess-name", is_high ? {x: guess_x + 4, y: level + 44} : {x: Math.min(guess_x - 14, 610), y: level - 18});
        put("level-name", is_high ? {x: 36, y: level + 34, ...start} : {x: 728, y: level + 32, ...end});
        return `the hit: t = ${number(hit)}, the guess: t = ${number(guess)}`;
      },
    },
    crossing_of_two_lines: {
      sliders: [{name: "gap after", min: -0.24, max: -0.02, step: 0.01, value: -0.15},
                {name: "bend of the surface", min: -0.04, max: 0.06, step: 0.01, value: 0.05}],
      drag: (x, y) => [(170 - y) / 1000],
      draw(part, put, gap_after, bend) {
        const [left, right, ray, before, after] = [110, 640, 110, 330, 170], end = after - 1000 * gap_after;
        const control = (before + after) / 2 - 2000 * bend, at = s => mix(left, right, s);
        const share = crossing((before - ray) / 1000, gap_after), cross_y = mix(before, after, share);
        // The surface is a parabola in s, from 0 at the first sample to 1 at the second one.
        const a = before + after - 2 * control, b = 2 * (control - before) - (end - ray), c = before - ray;
        const s = 2 * c / (-b + Math.sqrt(b * b - 4 * a * c)), hit_y = mix(ray, end, s);
        const edge = (s, y, slope) => y + (s - left) / (right - left) * slope;
        const curve = `${left} ${before} Q${(left + right) / 2} ${control} ${right} ${after}`;
        put("ground", {d: `M${left} 420 V${curve.slice(4)} V420 Z`});
        put("surface", {d: `M40 ${edge(40, before, 2 * (control - before)).toFixed(1)} L${curve} ` +
                           `L720 ${edge(720 - right + left, after, 2 * (after - control)).toFixed(1)}`});
        put("ray", {y1: edge(50, ray, end - ray), y2: edge(720, ray, end - ray)});
        put("after", {y2: end - 8}), put("below", {cy: end}), put("after-name", {y: (after + end) / 2 + 13});
        put("hit", {cx: at(s), cy: hit_y}), put("hit-name", {x: at(s) + 6, y: hit_y - 46});
        put("cross", {cx: at(share), cy: cross_y}), put("x", {x1: at(share), x2: at(share)});
        put("x-name", {x: at(share)});
        put("pointer", {x1: at(share) - 4, y1: cross_y + 11, x2: at(share) - 34});
        put("cross-name", {x: at(share) - 174});
        return `x = ${number(share)}, the hit: ${number(s)}`;
      },
    },
    gram_schmidt: {
      sliders: [{name: "S above the plane", min: 10, max: 85, step: 1, value: 29, unit: "°"}],
      drag: (x, y) => [degrees(Math.atan2(289 - y, x - 250))],
      draw(part, put, angle) {
        const unit = 229, [x, y] = [250, 289], sum = [1.1 * Math.cos(radians(angle)), 1.1 * Math.sin(radians(angle))];
        const up = sum[1], rest = sum[0];  // S·N, and S - (S·N) N: N is the axis y of the drawing
        const [tip_x, tip_y] = [x + unit * sum[0], y - unit * sum[1]];
        put("sum", {x2: tip_x, y2: tip_y}), put("sum-name", {x: tip_x + 12, y: tip_y - 6});
        put("taken", {x1: tip_x, x2: tip_x, y1: tip_y + 6});
        put("taken-name", {x: tip_x + 12, y: (tip_y + y) / 2 + 14});
        put("tangent", {x2: x + unit * rest}), put("tangent-name", {x: x + unit * rest / 2});
        return `S·N = ${number(up)}, the rest: ${number(rest)}`;
      },
    },
    stages_of_a_patch: {
      sliders: [{name: "level", min: 1, max: 8, step: 0.1, value: 4},
                {name: "spacing", min: 0, max: 2, step: 1, value: 0, words: ["equal", "even", "odd"]}],
      drag: x => [1 + 7 * (x - 500) / 140],
      draw(part, put, level, spacing) {
        const edge = places(spacing, level), last = edge.length - 1;
        const flat = (u, v) => [500 + 140 * u, 128 + 140 * v];
        const bent = (u, v) =>
          [736 + 140 * u + 9 * Math.sin(5 * u + 9 * v), 128 + 140 * v + 12 * Math.cos(7 * u + 4 * v + 2)];
        const line = points => "M" + points.map(point => point.map(value => value.toFixed(1)).join(" ")).join(" ");
        const lines = place => edge.map(v => line(edge.map(u => place(u, v)))).join("") +
          edge.map(u => line(edge.map(v => place(u, v)))).join("");
        const dots = place => edge.flatMap(v => edge.map(u => line([place(u, v)]) + "h0")).join("");
        const cell = (i, j) => {  // a diagonal, mirrored in the middle
          const rises = (2 * i < last) == (2 * j < last);
          return line([flat(edge[rises ? i + 1 : i], edge[j]), flat(edge[rises ? i : i + 1], edge[j + 1])]);
        };
        const cells = edge.slice(1);
        put("grid", {d: lines(flat)}), put("dots", {d: dots(flat)});
        put("diagonals", {d: cells.flatMap((_, j) => cells.map((_, i) => cell(i, j))).join("")});
        put("moved", {d: lines(bent)}), put("vertices", {d: dots(bent)});
        put("filled", {d: line([...edge.map(u => bent(u, 0)), ...edge.map(v => bent(1, v)),
          ...edge.map(u => bent(1 - u, 1)), ...edge.map(v => bent(0, 1 - v))].map(([x, y]) => [x + 236, y])) + "Z"});
        for (const side of ["left", "right", "top", "bottom"]) part(side).textContent = level;
        return `${last} segments on each edge`;
      },
    },
  };

  for (const svg of document.querySelectorAll("svg[data-moves]")) {
    const {sliders, drag, draw} = drawings[svg.dataset.moves], parts = {};
    const part = name => parts[name] ??= svg.querySelector(`[data-part="${name}"]`);
    const put = (name, values) => {
      for (const [key, value] of Object.entries(values))
        part(name).setAttribute(key, typeof value == "number" ? Math.round(value * 10) / 10 : value);
    };
    const box = Object.assign(document.createElement("div"), {className: "sliders"});
    const told = document.createElement("output");
    const inputs = sliders.map(({name, min, max, step, value, unit = "", words}) => {
      const label = document.createElement("label"), input = document.createElement("input");
      const text = document.createElement("span"), shown = document.createElement("b");
      Object.assign(input, {type: "range", min, max, step, value, autocomplete: "off"});
      text.textContent = name;
      label.append(text, input, shown);
      box.append(label);
      return Object.assign(input, {show() {
        const now = words ? words[input.value] : input.value.replace("-", "−") + unit;
        shown.textContent = now;
        input.setAttribute("aria-valuetext", now);
      }});
    });
    const move = () => {
      for (const input of inputs) input.show();
      told.textContent = draw(part, put, ...inputs.map(input => input.valueAsNumber));
    };
    const follow = event => {
      if (!event.buttons) return;
      const frame = svg.getBoundingClientRect(), scale = svg.viewBox.baseVal.width / frame.width;
      drag((event.clientX - frame.left) * scale, (event.clientY - frame.top) * scale)
        .forEach((value, i) => inputs[i].value = value);
      move();
    };
    svg.addEventListener("pointerdown", follow);
    svg.addEventListener("pointermove", follow);
    box.addEventListener("input", move);
    // The keys and the drag are not those that turn a deck's slides.
    for (const kind of ["keydown", "touchstart", "touchmove", "pointerdown"])
      for (const element of [svg, box]) element.addEventListener(kind, event => event.stopPropagation(), {passive: true});
    // A title would be a tooltip over what moves.
    svg.setAttribute("aria-label", svg.querySelector("title").textContent);
    svg.querySelector("title").remove();
    box.append(told);
    (svg.closest(".plate") ?? svg).after(box);
    move();
  }
}
