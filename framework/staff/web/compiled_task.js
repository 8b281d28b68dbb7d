// A lab's task.cpp in its page: compiles it in a worker, and answers the module's calls of its functions. An endless
// loop, a trap or a failed assertion becomes an error of the module that names the line.
"use strict";

const task_seconds = 2;      // of one call of a function
const request_seconds = 10;  // of all calls while the module answers one request of the page, such as a check
const stack_bytes = 1 << 18;

// Reads the tables of lines of a WebAssembly file: custom section .debug_line, DWARF 4. Returns a function from an
// offset in the WebAssembly file to {file, line}.
const lines_of = bytes => {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = 8;
  const leb = () => { for (let value = 0, shift = 0;; shift += 7) { const byte = view.getUint8(at++); value += (byte & 127) * 2 ** shift; if (byte < 128) return value; } };
  const sleb = () => { for (let value = 0, shift = 0;;) { const byte = view.getUint8(at++); value |= (byte & 127) << shift; shift += 7; if (byte < 128) return byte & 64 && shift < 32 ? value | -1 << shift : value; } };
  const text = () => { const from = at; while (view.getUint8(at++)); return new TextDecoder().decode(bytes.subarray(from, at - 1)); };
  const rows = [];
  let code = 0, table = null;
  while (at < bytes.length) {
    const kind = view.getUint8(at++), size = leb(), end = at + size;
    if (kind === 10) code = at;
    if (kind === 0) { const length = leb(), name = new TextDecoder().decode(bytes.subarray(at, at + length)); at += length; if (name === ".debug_line") table = [at, end]; }
    at = end;
  }
  for (at = table?.[0]; table && at < table[1];) {
    const unit_end = at + 4 + view.getUint32(at, true);
    at += 6;  // length, version
    const program = at + 4 + view.getUint32(at, true);
    at += 4;
    const least = view.getUint8(at), line_base = view.getInt8(at + 3), line_range = view.getUint8(at + 4), opcode_base = view.getUint8(at + 5);
    at += 6;
    const lengths = [0];
    for (let i = 1; i < opcode_base; ++i) lengths.push(view.getUint8(at++));
    while (view.getUint8(at)) text();  // folders
    ++at;
    const names = [""];
    while (view.getUint8(at)) { names.push(text()); leb(), leb(), leb(); }
    at = program;
    let address = 0, file = 1, line = 1;
    const add = () => rows.push({at: code + address, file: names[file], line});
    while (at < unit_end) {
      const opcode = view.getUint8(at++);
      if (opcode >= opcode_base) {
        const step = opcode - opcode_base;
        address += Math.floor(step / line_range) * least, line += line_base + step % line_range, add();
      } else if (opcode === 0) {
        const length = leb(), next = at + length, what = view.getUint8(at++);
        if (what === 2) address = view.getUint32(at, true);
        if (what === 1) rows.push({at: code + address, file: "", line: 0}), address = 0, file = 1, line = 1;
        at = next;
      } else if (opcode === 1) add();
      else if (opcode === 2) address += leb() * least;
      else if (opcode === 3) line += sleb();
      else if (opcode === 4) file = leb();
      else if (opcode === 8) address += Math.floor((255 - opcode_base) / line_range) * least;
      else if (opcode === 9) address += view.getUint16(at, true), at += 2;
      else for (let i = 0; i < lengths[opcode]; ++i) leb();
    }
    at = unit_end;
  }
  rows.sort((a, b) => a.at - b.at);
  return offset => rows.findLast(row => row.at <= offset && offset - row.at < 4096);
};

// The name of a function in a C++ symbol of functions in namespaces: _ZN6relief5basis5solveE... is solve.
const function_name = symbol => {
  let name = "";
  for (let rest = symbol.replace(/^_ZN/, ""), found; (found = /^(\d+)/.exec(rest)); rest = rest.slice(found[1].length + name.length))
    name = rest.slice(found[1].length, found[1].length + Number(found[1]));
  return name;
};

// `module`: returns the lab's module. `file`: task.cpp's path. `starter`: returns its first text.
class CompiledTask {
  constructor({module, file, starter, progress}) {
    Object.assign(this, {module, file, starter, progress});
  }

  // Gives the module's imports the functions that task.cpp defines.
  join(imports, names) {
    for (const name of names) imports[name] = (...values) => this.call_task(name, values);
  }

  // Starts the worker, which fetches the compiler when it first compiles.
  build(text) {
    if (!this.worker) {
      this.worker = new Worker("compiler.js", {type: "module"});
      this.answers = new Map();
      this.count = 0;
      this.worker.onmessage = ({data}) => {
        if ("fetched" in data) return this.progress(data.fetched);
        this.answers.get(data.of)(data);
        this.answers.delete(data.of);
      };
      this.worker.onerror = event => {
        this.worker = null;  // the next build tries again
        this.progress(1);
        for (const answer of this.answers.values()) answer({said: "the compiler did not run: " + (event.message ?? "its files could not be fetched")});
        this.answers.clear();
      };
    }
    const of = ++this.count;
    return new Promise(done => {
      this.answers.set(of, done);
      this.worker.postMessage({of, file: this.file, text, memory: this.module().asm.relief_task_memory(), stack: stack_bytes});
    });
  }

  // Places a compiled task in the module's memory. Its own variables are new.
  async load(bytes, text) {
    const {asm} = this.module(), place = asm.relief_task_memory(), room = asm.relief_task_memory_bytes();
    const written = address => { const all = new Uint8Array(asm.memory.buffer); return new TextDecoder().decode(all.slice(address, all.indexOf(0, address))); };
    const page = {
      allocate: asm.relief_allocate,
      reallocate: asm.relief_reallocate,
      free: asm.relief_free,
      stop: why => { throw new Error(written(why)); },
      unfinished: (task, file, line) => this.throw_unfinished(written(task), line),
      tick: () => {
        const seconds = (performance.now() - this.began) / 1000;
        if (seconds > task_seconds) throw this.stuck = new Error(`it runs for more than ${task_seconds} s: an endless loop?`);
        if (this.spent + seconds > request_seconds) throw this.stuck = new Error(`its calls take more than ${request_seconds} s together`);
      },
    };
    const nothing = new Proxy({}, {get: () => () => 52});  // a task has no system: ENOSYS
    const compiled = await WebAssembly.compile(bytes);
    for (const {module, name} of WebAssembly.Module.imports(compiled))
      if (module === "env" && name !== "memory") throw new Error(name);
    new Uint8Array(asm.memory.buffer).fill(0, place, place + room);
    const {exports} = await WebAssembly.instantiate(compiled, {page, env: {memory: asm.memory}, wasi_snapshot_preview1: nothing});
    if (exports.__heap_base.value > place + room) throw new Error(`${this.file}: its constants and variables are larger than ${(room - stack_bytes) >> 10} KiB`);
    Object.assign(this, {exports, bytes, text, stack: exports.__stack_pointer.value, line_at: lines_of(bytes), stuck: null});
    this.begin_request();
    try {
      exports.__wasm_call_ctors();  // of its own variables
    } catch (error) {
      this.exports = null;
      const {message, line} = this.told(error);
      throw Object.assign(new Error(`${this.file}:${line ? line + ":" : ""} ${message}`), {file: this.file, line});
    }
  }

  begin_request() {
    this.began = performance.now(), this.spent = 0;
  }

  throw_unfinished(task, line) {
    this.module().ccall("relief_unfinished", null, ["string", "string", "number"], [task, this.file, line]);
  }
  call_task(symbol, values) {
    const own = this.exports?.[symbol];
    if (!own) {
      const text = this.starter(), from = text.search(new RegExp(`\\b${function_name(symbol)}\\(`));
      const unfinished = /\bunfinished\("([0-9.]+)"\)/.exec(text.slice(from));
      return this.throw_unfinished(unfinished?.[1] ?? "in C++", text.slice(0, from + (unfinished?.index ?? 0)).split("\n").length);
    }
    if (this.stuck) this.fail(this.stuck, symbol);
    this.began = performance.now();
    try {
      return own(...values);
    } catch (error) {
      this.exports.__stack_pointer.value = this.stack;
      if (error instanceof WebAssembly.Exception) throw error;
      this.fail(error, symbol);
    } finally {
      this.spent += (performance.now() - this.began) / 1000;
    }
  }
  fail(error, symbol) {
    const {message, line} = this.told(error, symbol);
    this.module().ccall("relief_task_failed", null, ["string", "string", "number"], [message, this.file, line]);
  }
  // What an error says. Its line is 0 if the browser does not tell the place (WebKit): the task is then that of the
  // function that was called, `symbol`.
  told(error, symbol) {
    let place;
    for (const [, offset] of String(error.stack).split("call_task")[0].matchAll(/wasm-function\[\d+\]:0x([0-9a-f]+)/g)) {
      const row = this.line_at(parseInt(offset, 16));
      if (row && this.file.endsWith("/" + row.file)) { place = row.line; break; }
    }
    const called = symbol && new RegExp(`\\b${function_name(symbol)}\\([^;{}]*\\)[^;{}]*\\{`).exec(this.text);
    const before = place ? this.text.split("\n").slice(0, place).join("\n") : this.text.slice(0, called?.index ?? 0);
    const task = /.*TASK ([0-9.]+[0-9])/s.exec(before)?.[1];
    const why = error.name === "RangeError" ? "the stack is full: a function calls itself without an end"
      : error.message.replace(/^.* assertion .* failed: /, "").replace(" in -fno-exceptions mode with message", ":").trim();  // without a place in the library of C++
    return {message: (task ? `task ${task} stops: ` : "the task stops: ") + why, line: place ?? 0};
  }
}
