// A lab's page: fetches the module and the lab's files, draws when something has changed, and checks the task while it
// is being written.
"use strict";

const $ = id => document.getElementById(id);
const make = (tag, values = {}, ...children) => {
  const element = Object.assign(document.createElement(tag), values);
  element.append(...children);
  return element;
};
const wait = milliseconds => new Promise(done => setTimeout(done, milliseconds));

const site = JSON.parse(document.body.dataset.lab);
const fetched = new Set();
const status = text => { $("status").textContent = text; };

let relief, lab, camera, home, editor, code_editor, starter, dirty = false, playing = false, moment = 0, does_not_compile = false;

// --- The module ------------------------------------------------------------------------------------------------------

const put = (file, bytes) => {
  const path = "/course/" + file;
  relief.FS.mkdirTree(path.slice(0, path.lastIndexOf("/")));
  relief.FS.writeFile(path, bytes);
};
const take = async file => {
  if (fetched.has(file)) throw new Error(`${file} is empty`);
  fetched.add(file);
  const answer = await fetch("course/" + file);
  if (!answer.ok) throw new Error(`${file}: the server says ${answer.status}`);
  put(file, new Uint8Array(await answer.arrayBuffer()));
};
const take_all = files => Promise.all(files.map(take));

// Calls a function of the module. Fetches the files that it wanted to read, and calls it again.
const call_now = async (name, ...values) => {
  for (;;) {
    code.begin_request();
    const answer = JSON.parse(relief.ccall("relief_" + name, "string", values.map(value => typeof value), values));
    if (answer.missing) { await take_all(answer.missing); continue; }
    if ("error" in answer) throw Object.assign(new Error(answer.error), answer);
    return answer.value;
  }
};
// One after the other.
let last_call = Promise.resolve();
const queue = work => {
  const next = last_call.then(work);
  last_call = next.catch(() => {});
  return next;
};
const call = (name, ...values) => queue(() => call_now(name, ...values));
// Copies a picture out of the module's memory.
const picture_of = ({address, width, height}) =>
  new ImageData(new Uint8ClampedArray(relief.HEAPF32.buffer, address, width * height * 4).slice(), width, height);
const paint = (canvas, picture) => {
  canvas.width = picture.width, canvas.height = picture.height;
  canvas.getContext("2d").putImageData(picture, 0, 0);
};

// --- The view --------------------------------------------------------------------------------------------------------

const is_software = () => /llvmpipe|softpipe|swiftshader/i.test(site.renderer ?? "");
const size_now = () => {
  const box = $("canvas").getBoundingClientRect(), ratio = is_software() ? 1 : Math.min(devicePixelRatio, 2);
  return {width: Math.max(16, Math.round(box.width * ratio)), height: Math.max(16, Math.round(box.height * ratio))};
};
const request = () => ({...size_now(), camera, time: moment, probe: $("probe").value});

// A compiler's other messages, which often follow from the first.
const folded = messages => {
  const box = make("details");
  box.append(make("summary", {textContent: messages.length + " more message" + (messages.length > 1 ? "s" : "")}),
             messages.join("\n"));
  return box;
};

// Shows an error: where it is, and in the editor if it is in the task file.
const complain = error => {
  $("problem").hidden = !error;
  $("problem").textContent = error ? error.message + (error.details ? "\n" + error.details : "") : "";
  if (error?.further?.length) $("problem").append(folded(error.further));
  if (error && error === stopped) $("problem").append(" ", make("button", {type: "button", textContent: "Draw it nevertheless", onclick: trust_text}));
  for (const [file, own] of [[site.task, editor], [site.code, code_editor]])
    own?.mark(error?.file === file ? error.line : 1, error?.file === file ? error.message : "");
};

// An error stays until a later request succeeds. A draw that was requested before the error does not end it. A fault of
// task.cpp stays until task.cpp is compiled again: other requests run its last working text.
let requests = 0, code_error = null, failed_at = Infinity;  // `failed_at`: the last request before the error on screen; infinite: no error
const fail = error => { failed_at = requests; complain(error); };

// Draws onto the canvas, and returns the seconds that it took. The page goes on meanwhile, and no other call does.
let context, is_slow = false;  // of the canvas; while a picture takes long
const draw_picture = wanted => queue(async () => {
  const began = performance.now(), drawn_by = context, seconds = () => (performance.now() - began) / 1000;
  let failed = null;
  const keep = error => { failed ??= error; return true; };
  await call_now("draw", JSON.stringify(wanted)).catch(keep);
  while (!await call_now("show").catch(keep)) {
    is_slow = seconds() > slow_seconds;
    if (is_slow) status(`drawing for more than ${Math.floor(seconds())} s …`);
    await wait(0);
  }
  if (is_slow) status(`drawn in ${seconds().toFixed(1)} s`);
  is_slow = false;
  if (drawn_by.isContextLost()) throw Object.assign(new Error("the browser ended the drawing"), {is_lost: true});
  if (failed) throw failed;
  return seconds();
});

const draw = async () => {
  if (context.isContextLost()) return;
  const wanted = request(), canvas = $("canvas"), request_drawn = requests;
  if (canvas.width !== wanted.width || canvas.height !== wanted.height)
    canvas.width = wanted.width, canvas.height = wanted.height;
  try {
    const is_drawn = await try_text(wanted);
    if (wanted.probe)
      paint($("numbers"), picture_of(await call("probe", JSON.stringify(wanted))));
    else if (!is_drawn)
      await draw_picture(wanted);
    $("numbers").hidden = !wanted.probe;
    if (failed_at < request_drawn) failed_at = Infinity, complain(code_error ?? stopped);
    does_not_compile = false;
  } catch (error) {
    if (error.is_lost) return;  // the page starts again
    does_not_compile = error.file === site.task;
    fail(code_error && error.file === site.code ? code_error : error);  // the newest text's error, not that of the last working one
  }
};

// A loop in a shader that does not end keeps the graphics driver busy, and a browser may then end all drawing of the
// page. So a new text is drawn alone, before the checks. If that takes long, the page goes on with the last text that
// was drawn in time. The browser keeps the suspicion until the text changes, also when the page is closed meanwhile.
let slow_seconds = 2, drawn_text = null, good_text = null, stopped = null;
const place_of_suspicion = `relief ${location.pathname} suspected`;
const suspicion = {
  get: () => { try { return localStorage.getItem(place_of_suspicion); } catch { return null; } },
  set: whom => { try { localStorage.setItem(place_of_suspicion, whom); } catch { /* kept in this visit only */ } },
  end: () => { try { localStorage.removeItem(place_of_suspicion); } catch { /* nothing was kept */ } },
};

// The parts of a task file, by task: from its first line "// TASK 11.2" to that of another task.
const task_parts = text => {
  const parts = new Map([["", ""]]);
  let task = "";
  for (const line of text.split("\n")) {
    const found = /^\s*\/\/[\/\s]*TASK ([0-9.]*[0-9])/.exec(line)?.[1];
    if (found && !parts.has(found)) parts.set(task = found, "");
    parts.set(task, parts.get(task) + line + "\n");
  }
  return parts;
};
// The tasks that were changed since a text was drawn in time, and have a loop; all changed ones if none has.
const suspects_in = (text, good) => {
  const before = task_parts(good), changed = [...task_parts(text)].filter(([task, part]) => task && part !== before.get(task));
  const loops = changed.filter(([, part]) => /\b(for|while)\b/.test(part.replace(/\/\/.*/g, "")));
  return (loops.length ? loops : changed).map(([task]) => task).join(", ");
};
const stop_text = (whom, why) => {
  const place = editor.text().split("\n").findIndex(line => whom && line.includes("TASK " + whom.split(",")[0]));
  stopped = Object.assign(new Error(`${whom ? (whom.includes(",") ? "Tasks " : "Task ") + whom + ": does" : "Does"} a loop not end? ${why} The page draws with an older text until you change yours.`),
                          place < 0 ? {} : {file: site.task, line: place + 1});
  put_drawn_text(good_text ?? starter);
  show_stale("waits for a text that is drawn in time");
  $("check").disabled = true;
  fail(stopped);
  status("your text was stopped");
};
// A slow machine may need long for a text that ends.
const trust_text = async () => {
  stopped = null;
  complain(code_error);
  good_text = editor.text();
  suspicion.end();
  put_drawn_text(good_text);
  await redraw();
  pause = setTimeout(check, pauses.check);
};
const stop_suspected = why => {
  const whom = suspicion.get();
  if (whom !== null && editor.text() !== starter) stop_text(whom, why);
};
// Draws a new text, and returns whether the picture is that of the module's text. The first picture of a text includes
// the compilation, so only a second one counts.
const try_text = async wanted => {
  if ([good_text, starter].includes(drawn_text)) return false;
  const text = drawn_text, whom = suspects_in(text, good_text ?? starter);
  suspicion.set(whom);
  let seconds = 0;
  for (let i = 0; i < 2; ++i) {
    try {
      seconds = await draw_picture(wanted);
    } catch (error) {
      if (!error.is_lost) suspicion.end();
      throw error;
    }
    if (text !== drawn_text) return true;  // a newer text will be drawn
    if (seconds <= slow_seconds) {
      good_text = text;
      suspicion.end();
      return true;
    }
  }
  stop_text(whom, `A picture took ${seconds.toFixed(1)} s.`);
  return false;
};

const redraw = () => { ++requests; return draw(); };

// Draws once for all changes since the last frame.
let frame = null;
const schedule = () => {
  dirty = true;
  frame ??= requestAnimationFrame(async now => {
    if (dirty) { dirty = false; await draw(); }
    frame = null;
    if (playing) moment += Math.min((now - (playing.last ?? now)) / 1000, 0.1), playing.last = now;
    if (dirty || playing) schedule();
  });
};
const change = () => { ++requests; schedule(); };

const camera_text = at =>
  [at.yaw, at.pitch, at.distance, ...at.target].map(value => +value.toFixed(3)).join(",");
const set_camera = text => {
  const [yaw, pitch, distance, x, y, z] = text.split(",").map(Number);
  if (![yaw, pitch, distance].every(Number.isFinite)) return;
  camera = {...home, yaw, pitch, distance, target: [x, y, z].every(Number.isFinite) ? [x, y, z] : home.target};
};

const orbit = (right, up) => {
  camera.yaw = (camera.yaw - right) % 360;
  camera.pitch = Math.max(-89, Math.min(89, camera.pitch + up));
};
const zoom = factor => { camera.distance = Math.max(home.distance / 50, Math.min(home.distance * 20, camera.distance * factor)); };
// Moves the target in the picture's plane, by shares of its height.
const pan = (right, up) => {
  const yaw = camera.yaw * Math.PI / 180, pitch = camera.pitch * Math.PI / 180;
  const metres = 2 * camera.distance * Math.tan(camera.field_of_view * Math.PI / 360);
  const x = [Math.cos(yaw), 0, -Math.sin(yaw)];
  const y = [-Math.sin(yaw) * Math.sin(pitch), Math.cos(pitch), -Math.cos(yaw) * Math.sin(pitch)];
  camera.target = camera.target.map((value, i) => value - metres * (right * x[i] - up * y[i]));
};

const pointers = new Map();
const listen_to_view = () => {
  const canvas = $("canvas");
  canvas.addEventListener("pointerdown", event => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, event);
  });
  for (const end of ["pointerup", "pointercancel"])
    canvas.addEventListener(end, event => pointers.delete(event.pointerId));
  canvas.addEventListener("pointermove", event => {
    const before = pointers.get(event.pointerId), height = canvas.clientHeight;
    if (!before) return;
    const right = event.clientX - before.clientX, up = event.clientY - before.clientY;
    if (pointers.size === 2) {
      const other = [...pointers].find(([id]) => id !== event.pointerId)[1];
      const apart = one => Math.hypot(one.clientX - other.clientX, one.clientY - other.clientY);
      zoom(Math.max(apart(before), 1) / Math.max(apart(event), 1));
      pan(right / 2 / height, up / 2 / height);
    } else if (event.shiftKey || event.buttons & 2) {
      pan(right / height, up / height);
    } else {
      orbit(0.4 * right, 0.4 * up);
    }
    pointers.set(event.pointerId, event);
    change();
  });
  canvas.addEventListener("pointerup", () => remember());
  canvas.addEventListener("contextmenu", event => event.preventDefault());
  canvas.addEventListener("wheel", event => {
    event.preventDefault();
    zoom(Math.exp(event.deltaY * 0.001));
    change();
  }, {passive: false});
  canvas.addEventListener("keydown", event => {
    const step = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[event.key];
    if (step) event.shiftKey ? pan(step[0] * 0.05, step[1] * 0.05) : orbit(5 * step[0], 5 * step[1]);
    else if (event.key === "+" || event.key === "=") zoom(1 / 1.1);
    else if (event.key === "-") zoom(1.1);
    else return;
    event.preventDefault();
    change();
    remember();
  });
  // The numbers under the pointer, once it rests.
  let resting;
  canvas.addEventListener("pointermove", event => {
    clearTimeout(resting);
    if (!$("probe").value || event.buttons) return;
    resting = setTimeout(() => tell_pixel(event.offsetX / canvas.clientWidth, event.offsetY / canvas.clientHeight), 150);
  });
  new ResizeObserver(change).observe(canvas);
};

const tell_pixel = async (right, down) => {
  const from = request();
  const x = Math.floor(right * from.width), y = Math.floor(down * from.height);
  const unit = lab.probes.find(probe => probe.name === from.probe)?.unit ?? "";
  const values = await call("pixel", JSON.stringify({...from, x, y})).catch(error => [error.message]);
  const shown = values.includes("no surface") ? "no surface" : values.slice(0, 3).map(value =>
    typeof value === "number" ? Number(value.toPrecision(4)).toString() : value).join(", ");
  $("pixel").textContent = `${from.probe} at (${x}, ${y}): ${shown}${values.includes("no surface") ? "" : " " + unit}`;
};

// --- Knobs -----------------------------------------------------------------------------------------------------------

// Files of the student's own, in memory only: the bytes by their path in the module.
const own_files = new Map();
const own_path = name => "/own/" + name;
const is_own = knob => knob.takes && own_files.has(own_path(knob.value));

const put_own = (path, bytes) => {
  relief.FS.mkdirTree("/own");
  relief.FS.writeFile(path, bytes);
  own_files.set(path, bytes);
};
// The module reads PNG only; the browser decodes all else.
const png_of = async file => {
  const picture = await createImageBitmap(file).catch(() => { throw new Error(`${file.name}: this browser cannot read the picture`); });
  const canvas = make("canvas", {width: picture.width, height: picture.height});
  canvas.getContext("2d").drawImage(picture, 0, 0);
  return new Promise(done => canvas.toBlob(done, "image/png"));
};
const open_own = async (knob, files) => {
  try {
    const names = [];
    for (const file of files) {
      if (!file.size) throw new Error(`${file.name} is empty`);
      const is_png = !file.type.startsWith("image/") || file.type === "image/png";
      names.push(is_png ? file.name : file.name.replace(/\.[^.]*$/, "") + ".png");
      put_own(own_path(names.at(-1)), new Uint8Array(await (is_png ? file : await png_of(file)).arrayBuffer()));
    }
    // A model's material file and pictures may come with it.
    const name = knob.takes.includes("OBJ") ? names.find(each => /\.(obj|gltf|glb)$/i.test(each)) ?? names[0] : names[0];
    await set_knob(knob.name, own_path(name));
    remember();
  } catch (error) {
    fail(error);
  }
};
const opener_of = knob => {
  const input = make("input", {type: "file", hidden: true, multiple: knob.takes.includes("OBJ"),
                               accept: knob.takes.includes("OBJ") ? ".obj,.mtl,.png,.gltf,.glb,.bin" : "image/*"});
  input.setAttribute("aria-label", knob.takes);
  input.onchange = async () => { await open_own(knob, [...input.files]); input.value = ""; };
  const button = make("button", {type: "button", textContent: "Open …", title: `open ${knob.takes} of your own: it stays in this browser`,
                                 onclick: () => input.click()});
  button.setAttribute("aria-label", `Open ${knob.takes} for ${knob.title}`);
  return make("span", {}, button, input);
};
const show_choices = (control, names) => {
  if (names.length === control.length && names.every((name, i) => control.options[i].value === name)) return;
  control.replaceChildren(...names.map(name => make("option", {value: name, textContent: name})));
};

const show_knobs = () => {
  for (const knob of lab.knobs) {
    const control = $("knobs").elements["knob-" + knob.name], told = $("told-" + knob.name);
    if (knob.kind === "choice") show_choices(control, knob.names);
    control.closest(".knobs").querySelector(`label[for="knob-${knob.name}"]`).classList.toggle("ignored", knob.ignored);
    if (knob.kind === "toggle") control.checked = knob.value === "on";
    else control.value = knob.value;
    if (told) told.textContent = knob.kind === "slider" || knob.kind === "steps" ? knob.value + knob.unit : "";
  }
};
const set_knob = async (name, value) => {
  try {
    lab.knobs = await call("set", name, String(value));
    show_knobs();
    change();
  } catch (error) {
    fail(error);
  }
};
const make_knobs = () => {
  for (const knob of lab.knobs) {
    const id = "knob-" + knob.name, tip = `${knob.help} Its name for --set: ${knob.name}`;
    if (knob.group) $("knobs").append(make("h2", {textContent: knob.group}));
    let control;
    if (knob.kind === "choice") {
      control = make("select");
    } else if (knob.kind === "toggle") {
      control = make("input", {type: "checkbox"});
    } else {
      control = make("input", {type: "range", min: knob.low, max: knob.high});
      control.step = knob.kind === "steps" ? 1 : "any";
    }
    Object.assign(control, {id, name: id, title: tip, autocomplete: "off"});
    control.addEventListener("input", async () => {
      const value = knob.kind === "toggle" ? (control.checked ? "on" : "off")
                  : knob.kind === "slider" ? Number(Number(control.value).toPrecision(4))
                  : knob.takes && own_files.has(own_path(control.value)) ? own_path(control.value) : control.value;
      await set_knob(knob.name, value);
      remember();
    });
    $("knobs").append(make("label", {htmlFor: id, textContent: knob.title, title: tip}),
                      control, knob.takes ? opener_of(knob) : make("span", {id: "told-" + knob.name}));
  }
  $("knobs").addEventListener("submit", event => event.preventDefault());
  show_knobs();
};

// The address has what differs from the opening view: #view=one&steps=8&camera=30,20,3&probe=normal
let defaults;
const remember = () => {
  const parts = lab.knobs.filter(knob => knob.value !== defaults.get(knob.name) && !is_own(knob))
    .map(knob => `${knob.name}=${encodeURIComponent(knob.value)}`);
  if (camera_text(camera) !== camera_text(home)) parts.push("camera=" + camera_text(camera));
  if ($("probe").value) parts.push("probe=" + $("probe").value);
  history.replaceState(null, "", parts.length ? "#" + parts.join("&") : location.pathname);
};
const restore = async () => {
  const wanted = new URLSearchParams(location.hash.slice(1));
  for (const knob of lab.knobs) {
    const value = wanted.get(knob.name) ?? defaults.get(knob.name);
    if (value !== knob.value) await set_knob(knob.name, value);
  }
  camera = structuredClone(home);
  if (wanted.has("camera")) set_camera(wanted.get("camera"));
  $("probe").value = lab.probes.some(probe => probe.name === wanted.get("probe")) ? wanted.get("probe") : "";
  change();
};

// Shows what a check draws.
const show_check = async check => {
  const wanted = new Map([...defaults, ...check.set]);
  for (const knob of lab.knobs)
    if (wanted.get(knob.name) !== knob.value) await set_knob(knob.name, wanted.get(knob.name));
  camera = structuredClone(check.camera);
  $("probe").value = check.probe;
  remember();
  change();
};

// A command of the handout, `./relief shot 06 --set view=one --camera 30,20,3`, as the address of its view.
const view_of = command => {
  const words = command.trim().split(/\s+/);
  if (words[0] !== "./relief" || !["run", "shot"].includes(words[1]) || Number(words[2]) !== site.number) return null;
  const parts = [];
  for (let i = 3; i + 1 < words.length; ++i) {
    if (words[i] === "--set") {
      const [name, ...value] = words[i + 1].split("=");
      parts.push(name + "=" + encodeURIComponent(value.join("=")));
    } else if (words[i] === "--camera") parts.push("camera=" + words[i + 1]);
    else if (words[i] === "--probe") parts.push("probe=" + words[i + 1]);
  }
  return "#" + parts.join("&");
};
const link_commands = () => {
  for (const code of document.querySelectorAll("article code")) {
    const view = view_of(code.textContent);
    if (view !== null) code.after(" ", make("button", {className: "go", type: "button", textContent: "show here",
      onclick: () => { history.pushState(null, "", view); restore(); }}));
  }
};

// --- The task file ---------------------------------------------------------------------------------------------------

const starters = new Map();
const place_of_text = file => `relief ${location.pathname} ${file}`;
const kept = (file = site.task) => { try { return localStorage.getItem(place_of_text(file)); } catch { return null; } };
const keep = (text, file = site.task) => {
  try {
    if (text === starters.get(file)) localStorage.removeItem(place_of_text(file));
    else localStorage.setItem(place_of_text(file), text);
  } catch { status("this browser keeps no text: download your file before you leave"); }
};
const put_text = (file, text) => put(file, new TextEncoder().encode(text));
const put_drawn_text = text => put_text(site.task, drawn_text = text);
const put_texts = () => {
  put_drawn_text(editor.text());
  if (code_editor) put_text(site.code, code_editor.text());
};

const pauses = {draw: 400, check: 700, build: 1000};  // after the last key, in milliseconds
let pause, checking = 0, is_open = false;
const written = text => {
  ++checking;  // ends a run of checks
  keep(text);
  suspicion.end();
  if (!is_open) return;
  clearTimeout(pause);
  pause = setTimeout(async () => {
    if (stopped) stopped = null, $("check").disabled = false, complain(code_error);
    put_drawn_text(text);
    await redraw();
    if (does_not_compile) show_stale("waits for a text that compiles");
    else if (!stopped) pause = setTimeout(check, pauses.check);
  }, pauses.draw);
};

// The task in C++, which a worker compiles.
const code = new CompiledTask({module: () => relief, file: site.code, starter: () => starters.get(site.code),
  progress: share => { $("fetching").hidden = share >= 1; $("share").value = share; }});

// The messages of clang: the first error with its lines, and the first lines of the others.
const errors_in = said => {
  const parts = said.split(/^(?=\S+:\d+:\d+: (?:fatal error|error|warning): )/m).filter(part => /^\S+:\d+:/.test(part));
  const first = parts.find(part => /^\S+ (fatal )?error:/.test(part));
  if (!first) return {message: said.trim(), further: []};
  const [head, ...lines] = first.replace(/^\d+ (warning|error)s?( and \d+ errors?)? generated\.\n?/m, "").split("\n");
  const [, file, line, what] = /^(\S+?):(\d+):\d+: (?:fatal )?error: (.*)$/.exec(head);
  return {message: `${file}:${line}: ${what}`, file, line: Number(line), details: lines.join("\n").trimEnd(),
          further: parts.filter(part => part !== first).map(part => part.split("\n")[0])};
};

let builds = 0, pause_of_code;
const build = async () => {
  const run = ++builds, text = code_editor.text(), began = performance.now();
  ++checking;
  status("compiling task.cpp …");
  const {bytes, said} = await code.build(text);
  if (run !== builds) return;  // of an older text
  const seconds = (performance.now() - began) / 1000;
  $("warnings").hidden = !bytes || !said.trim();
  $("warnings").textContent = said;
  put_text(site.code, text);
  try {
    if (!bytes) throw Object.assign(new Error(), errors_in(said));
    await code.load(bytes, text);
    const values = lab.knobs.map(knob => [knob.name, is_own(knob) ? own_path(knob.value) : knob.value]);
    lab.knobs = await call("renew");
    for (const [name, value] of values)
      if (lab.knobs.find(knob => knob.name === name).value !== value) await set_knob(name, value);
    code_error = null;
    $("points").textContent = "";
    await redraw();
    check();
  } catch (error) {
    code_error = error;
    fail(error);
    show_stale(bytes ? "waits for a task.cpp that runs" : "waits for a text that compiles");
    status(bytes ? "task.cpp cannot run" : "task.cpp does not compile");
  }
  if (run === builds) window.built = seconds;  // for tests
};
const written_code = text => {
  ++checking;
  ++builds;
  keep(text, site.code);
  if (!is_open) return;
  clearTimeout(pause_of_code);
  pause_of_code = setTimeout(build, pauses.build);
};

const save = (name, bytes, type) => {
  const address = URL.createObjectURL(new Blob([bytes], {type}));
  make("a", {href: address, download: name}).click();
  setTimeout(() => URL.revokeObjectURL(address), 1000);
};
// A lab with two files has them in one archive, as `relief hand-in` makes it.
const download = async () => {
  if (!code_editor) return save(site.task.split("/").pop(), editor.text(), "text/plain");
  put_text(site.task, editor.text()), put_text(site.code, code_editor.text());
  const {address, size} = await call("hand_in");
  put_text(site.task, drawn_text);
  save("hand-in.zip", relief.HEAPF32.buffer.slice(address, address + size), "application/zip");
};
const load = async () => {
  const [file] = $("chosen").files;
  $("chosen").value = "";
  if (!file) return;
  const is_code = code_editor && /\.cpp$/i.test(file.name);
  (is_code ? code_editor : editor).replace(await file.text());
  show_file(is_code ? site.code : site.task);
};
let shown_file;
const show_file = file => {
  shown_file = file;
  $("editor").hidden = file !== site.task, $("code").hidden = file !== site.code;
  for (const button of $("file").querySelectorAll("button")) button.setAttribute("aria-pressed", String(button.title === file));
};
// The texts are here before the module, and can be edited while it is fetched.
const open_editor = async () => {
  await Promise.all(site.task_files.map(async file => {
    const answer = await fetch("course/" + file);
    if (!answer.ok) throw new Error(`${file}: the server says ${answer.status}`);
    starters.set(file, await answer.text());
  }));
  const text_of = file => kept(file) ?? starters.get(file);
  editor = openEditor($("editor"), text_of(site.task), written);
  starter = starters.get(site.task);
  if (site.code && site.compiler) {
    code_editor = openEditor($("code"), text_of(site.code), written_code, "C++");
    $("file").replaceChildren(...site.task_files.map(file =>
      make("button", {type: "button", textContent: file.split("/").pop(), title: file, onclick: () => show_file(file)})));
    show_file(site.task_files[0]);
  } else {
    $("file").textContent = site.task;
    show_file(site.task);
  }
  $("load").onclick = () => $("chosen").click();
  $("chosen").onchange = load;
  $("reset").onclick = () => {
    const own = shown_file === site.code ? code_editor : editor;
    if (confirm("Replace your text by the starter?")) own.replace(starters.get(shown_file));
  };
};

// --- Checks ----------------------------------------------------------------------------------------------------------

// Without the compiler, a task in C++ cannot pass its checks here, and they are not shown.
const is_here = check => !site.not_here.includes(check.task);
const words = {out_of_time: "out of time", out_of_memory: "out of memory"};
const rows = new Map();  // of each check, by index

const make_checks = () => {
  for (const task of lab.tasks) {
    const own = lab.checks.map((check, index) => ({...check, index})).filter(check => check.task === task.id);
    const box = make("section", {className: "task", id: "task-" + task.id},
      make("h3", {}, `${task.id} ${task.title} `, make("span", {className: "points"})), make("p", {className: "hint", hidden: true}));
    if (own.some(is_here)) {
      for (const check of own) {
        const row = make(check.has_view ? "button" : "div", {className: "row"}, make("b", {textContent: "–"}), check.name,
                         make("small"));
        if (check.has_view) {
          row.type = "button";
          row.setAttribute("aria-expanded", "false");
          row.onclick = () => toggle_pictures(check.index);
        }
        rows.set(check.index, row);
        box.append(row);
      }
    } else {
      box.append(make("p", {className: "note", textContent: "C++: see above"}));
    }
    $("checks").append(box);
  }
};

const show_result = (index, {outcome, found, details, look_at}) => {
  const row = rows.get(index);
  row.className = "row " + outcome;
  row.querySelector("b").textContent = words[outcome] ?? outcome;
  // A compiler's message stands once, at the top.
  row.querySelector("small").textContent = outcome === "broken" && details && $("problem").textContent.startsWith(found)
    ? "the message above keeps it from drawing"
    : [found, look_at && "look at " + look_at, details].filter(Boolean).join("; ");
  if (row.nextElementSibling?.className === "seen") row.nextElementSibling.remove(), toggle_pictures(index);
};

// The results of an older text say nothing about the text in the editor.
const show_stale = why => {
  for (const [index, row] of rows) {
    if (row.nextElementSibling?.className === "seen") row.nextElementSibling.remove();
    show_result(index, {outcome: "waiting", found: why});
  }
  for (const task of lab.tasks) show_task({id: task.id, said: "", hint: ""});
  $("points").textContent = why.includes("compiles") ? "does not compile" : "";
};

const show_task = task => {
  const box = $("task-" + task.id), hint = box.querySelector(".hint");
  if (!site.not_here.includes(task.id)) box.querySelector(".points").textContent = task.said;
  hint.hidden = !task.hint;
  hint.textContent = task.hint;
  box.querySelector(".compare")?.remove();
  if (task.has_all && site.solutions) box.append(make("p", {className: "compare"}, make("button", {type: "button",
    textContent: "Compare with the solution", onclick: () => compare(task.id).catch(fail)})));
};

// The learner's own text beside the solution and a correct variant, if the site has them.
const compare = async id => {
  const answer = await fetch(site.solutions);
  if (!answer.ok) throw new Error(`${site.solutions}: the server says ${answer.status}`);
  const {solution, variant, why} = (await answer.json())[id], {file, title} = lab.tasks.find(task => task.id === id);
  const own = (file === site.code ? code_editor : editor).text();
  const column = (heading, text) => make("section", {}, make("h3", {textContent: heading}), make("pre", {tabIndex: 0, textContent: text.trim()}));
  const box = make("dialog", {className: "solution"}, make("div", {className: "bar"}, make("h2", {textContent: `${id} ${title}`}),
    make("button", {type: "button", textContent: "Close", onclick: () => box.close()})));
  box.setAttribute("aria-label", "the solution of task " + id);
  const columns = make("div", {className: "columns"}, column("Yours", task_parts(own).get(id) ?? own), column("The solution", solution));
  if (variant) columns.append(column("Also correct: " + why, variant));
  box.append(columns);
  box.onclose = () => box.remove();
  document.body.append(box);
  box.showModal();
};

// The course page reads the points of the last checks (index.js).
const keep_points = ({points, of, optional}) => {
  try { localStorage.setItem(place_of_text("points"), JSON.stringify({points, of, optional, at: Date.now()})); } catch { /* kept nowhere */ }
};

const toggle_pictures = async index => {
  const row = rows.get(index);
  if (row.nextElementSibling?.className === "seen") {
    row.setAttribute("aria-expanded", "false");
    return row.nextElementSibling.remove();
  }
  const pictures = [];
  try {
    for (const which of [0, 1, 2]) pictures.push(picture_of(await call("picture", index, which)));
  } catch (error) {
    row.querySelector("small").textContent += " " + error.message;
    return;
  }
  const [yours, expected, difference] = pictures.map(picture => {
    const canvas = make("canvas");
    paint(canvas, picture);
    return canvas;
  });
  const figure = (canvas, text) => make("figure", {}, canvas, make("figcaption", {textContent: text}));
  const both = figure(expected, "yours on the left, expected on the right");
  const seen = make("div", {className: "seen"}, both, figure(difference, "difference, brightest where it is largest"));
  const {label} = wipe(expected, yours, "", "share of yours", 50, value => `${value} % yours`);
  both.append(label);
  seen.append(make("button", {type: "button", textContent: "Show this view", onclick: () => show_check(lab.checks[index])}));
  row.after(seen);
  row.setAttribute("aria-expanded", "true");
};

const check = async () => {
  if (stopped) return;
  const run = ++checking, began = performance.now();
  $("check").disabled = true;
  suspicion.set(suspects_in(drawn_text, starter));
  try {
    let done = 0;
    for (let index = 0; index < lab.checks.length; ++index) {
      status(`checking ${index + 1} of ${lab.checks.length} …`);
      await wait(0);  // the page stays alive
      if (run !== checking) return;
      const result = await call("check", index);
      if (rows.has(index)) show_result(index, result);
    }
    if (run !== checking) return;
    const advice = await call("advice", Number(site.compiler));
    for (const [index] of rows) show_result(index, advice.checks[index]);
    advice.tasks.forEach(show_task);
    $("points").textContent = advice.said;
    keep_points(advice);
    status(`checked in ${((performance.now() - began) / 1000).toFixed(1)} s`);
    window.checked = run;  // for tests
  } catch (error) {
    complain(error);
    status("the checks did not run");
  } finally {
    if (run === checking) {
      $("check").disabled = Boolean(stopped);
      suspicion.end();
    }
  }
};

// --- Start -----------------------------------------------------------------------------------------------------------

// Fetching is the first part of the bar, and the other steps of the start are the rest.
const show_loading = (share, text) => {
  $("loading").value = share;
  status(text);
};
const megabytes = bytes => (bytes / 1e6).toFixed(1);
const count_bytes = async answer => {
  let bytes = 0;
  for (const reader = answer.body.getReader();;) {
    const {done, value} = await reader.read();
    if (done) return show_loading(0.7, "compiling …");
    bytes += value.length;
    show_loading(0.7 * bytes / site.module_bytes, `fetching ${megabytes(bytes)} of ${megabytes(site.module_bytes)} MB …`);
  }
};
const compiled_module = async () => {
  const answer = await fetch("relief.wasm");
  if (!is_open) count_bytes(answer.clone());
  try {
    return await WebAssembly.compileStreaming(answer);
  } catch {  // a server that does not know the type
    return WebAssembly.compile(await (await fetch("relief.wasm")).arrayBuffer());
  }
};
const open_module = () => new Promise((done, fail) => {
  const instantiateWasm = (imports, receive) => {
    compiled_module().then(async module => {
      const names = WebAssembly.Module.imports(module).map(each => each.name).filter(name => name.startsWith("_ZN6relief"));
      code.join(imports.env, names);
      receive(await WebAssembly.instantiate(module, imports), module);
    }).catch(fail);
    return {};
  };
  openRelief({print: () => {}, printErr: text => console.info(text), instantiateWasm}).then(done, fail);
});

const start = async (module = open_module()) => {
  relief = await module;
  if (!is_open) show_loading(0.8, "opening the lab …");
  for (const file of site.files) put(file, new Uint8Array());  // they exist, and are fetched when they are read
  await take_all(site.first);
  site.renderer = await call("start", "#canvas");
  context = $("canvas").getContext("webgl2");
  $("renderer").textContent = `Drawn by ${site.renderer.replace(/^ANGLE \(|\)$/g, "")}.`;
  lab = await call("open", site.number);
  home = structuredClone(lab.camera), camera = structuredClone(lab.camera);
  defaults = new Map(lab.knobs.map(knob => [knob.name, knob.value]));
};

const set_up_page = async () => {
  for (const probe of lab.probes) $("probe").append(make("option", {value: probe.name, textContent: probe.name}));
  make_knobs();
  link_commands();
  $("download").onclick = download;
  make_checks();
  listen_to_view();
  $("probe").onchange = () => { remember(); $("pixel").textContent = ""; change(); };
  $("home").onclick = () => { camera = structuredClone(home); remember(); change(); };
  $("check").onclick = check;
  $("play").hidden = !lab.animated;
  $("play").onclick = () => {
    playing = playing ? false : {};
    $("play").setAttribute("aria-pressed", String(Boolean(playing)));
    change();
  };
  addEventListener("hashchange", restore);
  addEventListener("popstate", restore);
  // A lab whose opening view waits for a task in C++ opens with the view of a task that can be written here.
  const first = lab.checks.find(is_here);
  if (site.not_here.length && first && !location.hash) await show_check({...first, probe: ""});
  else await restore();
};

// A lost context takes all textures and programs with it: a new module starts on a new canvas, with the same text.
const survive_a_lost_context = () => {
  $("canvas").addEventListener("webglcontextlost", async event => {
    event.preventDefault();
    status("the graphics driver was reset: starting again …");
    ++checking;
    const at = camera;
    const values = lab.knobs.map(knob => [knob.name, is_own(knob) ? own_path(knob.value) : knob.value]);
    $("canvas").replaceWith($("canvas").cloneNode());
    fetched.clear();
    last_call = Promise.resolve();
    await start();
    put_texts();
    stop_suspected("The browser ended the drawing.");
    if (code.bytes) await code.load(code.bytes, code.text);
    for (const [path, bytes] of own_files) put_own(path, bytes);
    camera = at;
    listen_to_view();
    survive_a_lost_context();
    for (const [name, value] of values) await set_knob(name, value);
    await redraw();
    $("check").disabled = Boolean(stopped);
    status(stopped ? "restarted without your text" : "restarted");
  });
};

(async () => {
  const began = performance.now();
  try {
    const module = open_module();
    await open_editor();
    await start(module);
    show_loading(0.9, "drawing …");
    await set_up_page();
    is_open = true;
    put_texts();
    stop_suspected("It was not drawn in time in an earlier visit.");
    await redraw();
    $("first").remove();
    $("loading").remove();
    survive_a_lost_context();
    $("check").disabled = Boolean(stopped);
    addEventListener("pagehide", () => { if (!stopped && !is_slow) suspicion.end(); });
    status(stopped ? "opened without your text" : `ready in ${((performance.now() - began) / 1000).toFixed(1)} s`);
    window.ready = true;  // for tests
    if (code_editor && code_editor.text() !== starters.get(site.code)) build();  // written in an earlier visit
  } catch (error) {
    $("loading").remove();
    status("cannot run here");
    complain(error);
    window.ready = "failed";
  }
})();
