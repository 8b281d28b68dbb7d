// A worker that compiles a lab's task.cpp with clang, and links it to an address in the memory of a lab's module.
// Its messages: {fetched} is a share of the compiler; {of, bytes, said} answers the request {of, file, text, memory,
// stack}, and `bytes` is missing if the task does not compile.
import {Exit, runLLVM} from "./compiler/llvm.js";
import {compile_flags} from "./compiler/flags.js";

const utf8 = new TextDecoder();

// Runs a program of LLVM. Returns the files, without one that it did not write, and what it said.
const run_program = async (words, files) => {
  let said = "";
  const say = bytes => { if (bytes) said += utf8.decode(bytes); };
  try {
    return {files: await runLLVM(words, files, {stdout: say, stderr: say, decodeASCII: false,
      fetchProgress: ({doneLength, totalLength}) => postMessage({fetched: doneLength / totalLength})}), said};
  } catch (error) {
    if (error instanceof Exit) return {files: {}, said};
    throw error;
  }
};

const build = async ({file, text, memory, stack}) => {
  const at = file.split("/"), name = at.pop(), tree = {};
  at.reduce((folder, part) => folder[part] = {}, tree)[name] = text;
  const compiled = await run_program(["clang++", "-cc1", ...compile_flags, "-I", "/usr/course/" + at.join("/"),
    "-main-file-name", name, "-o", "task.o", "-x", "c++", file], tree);
  const object = compiled.files["task.o"];
  if (!object) return {said: compiled.said};
  const libraries = "/usr/lib/wasm32-wasip1/";
  const linked = await run_program(["wasm-ld", "task.o", "/usr/lib/task_runtime.o", "--no-entry", "--import-memory",
    "--global-base=" + memory, "--no-stack-first", "-z", "stack-size=" + stack, "--export-dynamic",
    "--export=__stack_pointer", "--export=__heap_base", "--export=__wasm_call_ctors", "-L" + libraries, "-lc++",
    "-lc++abi", "-lc", "-lclang_rt.builtins", "-o", "task.wasm"], {"task.o": object});
  return {bytes: linked.files["task.wasm"], said: compiled.said + linked.said};
};

// A text that was replaced while it waited is not compiled.
let last = Promise.resolve(), newest;
addEventListener("message", ({data}) => {
  newest = data;
  last = last.then(async () => {
    if (data !== newest) return postMessage({of: data.of, said: ""});
    try {
      postMessage({of: data.of, ...await build(data)});
    } catch (error) {
      postMessage({of: data.of, said: "the compiler did not run: " + error});
    }
  });
});
