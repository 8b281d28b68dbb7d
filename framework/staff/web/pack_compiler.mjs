// node pack_compiler.mjs PACKAGE COURSE GLM OUT: copies the compiler of the npm package @yowasp/clang for the pages of
// labs with tasks in C++, with only those headers and libraries that a task needs, and the course's headers.
import {copyFileSync, mkdirSync, readFileSync, readdirSync, statSync, writeFileSync} from "node:fs";
import {posix} from "node:path";
import {pathToFileURL} from "node:url";

const [place, course, glm, out] = process.argv.slice(2);
const {runClang} = await import(pathToFileURL(place + "/gen/bundle.js"));
const run = (...values) => runClang(...values).catch(() => process.exit(1));  // clang has said why

const read_tree = (folder, wanted) => {
  const files = new Map();
  for (const file of readdirSync(folder, {recursive: true}))
    if (wanted(file) && statSync(folder + "/" + file).isFile()) files.set(file, readFileSync(folder + "/" + file, "utf8"));
  return files;
};
const put = (tree, file, contents) => {
  const folders = file.split("/"), name = folders.pop();
  folders.reduce((at, folder) => at[folder] ??= {}, tree)[name] = contents;
};

// The compiler's file system does not resolve "..", so includes name the file from the top.
const headers = new Map();
for (const [file, text] of read_tree(glm, () => true))
  headers.set("include/glm/" + file, text.replace(/^(\s*#\s*include\s*)"(\.\.?\/[^"]*)"/gm,
    (_, before, included) => `${before}<${posix.join("glm", posix.dirname(file), included)}>`));
const tasks = [];
for (const [file, text] of read_tree(course + "/labs", name => /\.h$|task\.cpp$/.test(name)))
  if (file.endsWith(".cpp")) tasks.push(["course/labs/" + file, text]);
  else headers.set("course/labs/" + file, text);
for (const part of ["core", "library"])
  for (const [file, text] of read_tree(`${course}/framework/${part}`, name => name.endsWith(".h")))
    headers.set(`course/framework/${part}/${file}`, text);

// The standard headers that a task may include in addition to its own.
const standard = "algorithm array bit bitset cassert cfloat climits cmath compare complex concepts cstddef cstdint " +
  "cstdio cstdlib cstring deque functional initializer_list iterator limits list map memory numbers numeric optional " +
  "queue random ranges set span stack string string_view tuple type_traits unordered_map unordered_set utility variant " +
  "vector glm/gtc/constants.hpp glm/gtc/matrix_transform.hpp glm/gtc/epsilon.hpp";
const target = ["--target=wasm32-wasip1", "-std=c++20"];
const system = {};
for (const [file, text] of [...headers, ...tasks]) put(system, file, text);
put(system, "all.cpp", [...standard.split(" "), ...tasks.map(([file]) => file.slice("course/".length))]
  .map(name => `#include <${name}>\n`).join(""));
const {list} = await run(["clang++", ...target, "-Iinclude", "-Icourse", "-M", "-MF", "list", "all.cpp"], system);
const needed = new Set(list.split(/\s+/).map(name => posix.normalize("/" + name)));

// What is in the package's own archive.
const archive = readFileSync(place + "/gen/llvm-resources.tar");
const packed = new Map();
for (let at = 0; at + 512 < archive.length && archive[at];) {
  const field = (from, length) => archive.toString("latin1", at + from, at + from + length).replace(/\0.*$/s, "");
  const name = field(0, 100), size = parseInt(field(124, 12), 8) || 0;
  if (needed.has("/usr/" + name) || /^lib\/wasm32-wasip1\/(libc|libc\+\+|libc\+\+abi)\.a$/.test(name))
    packed.set(name, archive.subarray(at + 512, at + 512 + size));
  if (/libclang_rt\.builtins\.a$/.test(name) && name.includes("wasm32-unknown-wasip1"))
    packed.set("lib/wasm32-wasip1/libclang_rt.builtins.a", archive.subarray(at + 512, at + 512 + size));
  at += 512 + Math.ceil(size / 512) * 512;
}
for (const [file, text] of headers)
  if (needed.has("/" + file)) packed.set(file, Buffer.from(text));

const runtime = readFileSync(new URL("task_runtime.cc", import.meta.url), "utf8");
const made = await run(["clang++", ...target, "-O2", "-fno-exceptions", "-c", "-o", "task_runtime.o", "task_runtime.cpp"],
                            {"task_runtime.cpp": runtime}, {decodeASCII: false});
packed.set("lib/task_runtime.o", made["task_runtime.o"]);

const tar_of = files => {
  const parts = [], folders = new Set();
  const add = (name, contents) => {
    const header = Buffer.alloc(512);
    if (name.length > 99) throw new Error("too long a name: " + name);
    header.write(name, 0), header.write("0000644\0", 100), header.write((contents?.length ?? 0).toString(8).padStart(11, "0") + "\0", 124);
    header.write("00000000000\0", 136), header.write("        ", 148), header.write(contents ? "0" : "5", 156), header.write("ustar\0" + "00", 257);
    header.write(header.reduce((sum, byte) => sum + byte, 0).toString(8).padStart(6, "0") + "\0 ", 148);
    parts.push(header);
    if (contents) parts.push(contents, Buffer.alloc((512 - contents.length % 512) % 512));
  };
  for (const [name, contents] of [...files].sort()) {
    const at = name.split("/");
    for (let i = 1; i < at.length; ++i) {
      const folder = at.slice(0, i).join("/");
      if (!folders.has(folder)) folders.add(folder), add(folder, null);
    }
    add(name, contents);
  }
  return Buffer.concat([...parts, Buffer.alloc(1024)]);
};

// The words of one run of the compiler itself, which the driver would need a run of its own to find.
const flags = ["-triple", "wasm32-unknown-wasip1", "-emit-obj", "-O1", "-std=c++20", "-fdeprecated-macro", "-fgnuc-version=4.2.1",
  "-mrelocation-model", "static", "-mframe-pointer=none", "-ffp-contract=off", "-mconstructor-aliases", "-target-cpu", "generic",
  "-debug-info-kind=line-tables-only", "-dwarf-version=4", "-debugger-tuning=gdb", "-fdebug-compilation-dir=/", "-resource-dir", "/usr", "-isysroot", "/usr",
  "-internal-isystem", "/usr/include/wasm32-wasip1/c++/v1", "-internal-isystem", "/usr/include/c++/v1", "-internal-isystem", "/usr/include",
  "-internal-isystem", "/usr/include/wasm32-wasip1", "-I", "/usr/course", "-D", "_LIBCPP_HARDENING_MODE=_LIBCPP_HARDENING_MODE_DEBUG",
  // A failed assertion of the library is then called from a line of the task.
  "-fno-inline",
  "-ferror-limit", "19", "-fno-implicit-modules", "-fmessage-length=0",
  // A call at each edge ends an endless loop; see task_runtime.cc.
  "-fsanitize-coverage-type=3", "-fsanitize-coverage-trace-pc", "-fsanitize-coverage-no-prune",
  "-Wall", "-Wextra", "-Wshadow"];

mkdirSync(out, {recursive: true});
const files = ["llvm.core.wasm", "llvm.core2.wasm", "llvm.core3.wasm", "llvm.core4.wasm"];
for (const file of files) copyFileSync(`${place}/gen/${file}`, `${out}/${file}`);
const resources = tar_of(packed);
writeFileSync(out + "/llvm-resources.tar", resources);
const total = resources.length + files.reduce((sum, file) => sum + statSync(`${out}/${file}`).size, 0);
writeFileSync(out + "/llvm.js", readFileSync(place + "/gen/bundle.js", "utf8").replace(/var totalSize = \d+;/, `var totalSize = ${total};`));
writeFileSync(out + "/flags.js", "export const compile_flags = " + JSON.stringify(flags) + ";\n");
