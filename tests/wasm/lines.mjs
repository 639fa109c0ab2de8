// Prints the lines that the WebAssembly makes: node lines.mjs F.wasm
import { readFile } from "node:fs/promises";

const { instance } = await WebAssembly.instantiate(await readFile(process.argv[2]), {});
const { memory, cases, run, length } = instance.exports;
for (let number = 0; number < cases(); number++) {
  const at = run(number);
  console.log(new TextDecoder().decode(new Uint8Array(memory.buffer, at, length())));
}
