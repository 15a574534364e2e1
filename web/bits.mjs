// Prints what the module answers about every gallery scene: node bits.mjs MODULE COUNT SEED
import { readFileSync } from "node:fs";

const [path, count, seed] = process.argv.slice(2);
const { instance } = await WebAssembly.instantiate(readFileSync(path), {});
const { memory, question, answer, forget } = instance.exports;

function ask(text) {
  const bytes = new TextEncoder().encode(text);
  const at = question(bytes.length);
  new Uint8Array(memory.buffer, at, bytes.length).set(bytes);
  const found = answer(at, bytes.length);
  const length = new DataView(memory.buffer).getUint32(found, true);
  const words = new TextDecoder().decode(new Uint8Array(memory.buffer, found + 4, length));
  forget(found);
  if (words.startsWith("error: ")) throw new Error(words);
  return words;
}

for (const scene of ask("scenes").trim().split("\n")) {
  process.stdout.write(`${scene}\n${ask(`pixels ${scene} ${count} ${seed}`)}`);
}
