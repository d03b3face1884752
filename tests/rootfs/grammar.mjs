// Parses bitbake's files and names the lines that are none of its language: grammar.mjs NODE_MODULES FILE...
import fs from "node:fs";
import path from "node:path";
import { createRequire } from "node:module";

const [modules, ...files] = process.argv.slice(2);
const require = createRequire(path.join(path.resolve(modules), "/"));
const Parser = require("web-tree-sitter");
const find = (folder) => fs.readdirSync(folder, { recursive: true }).find((name) => name.endsWith("tree-sitter-bitbake.wasm"));

await Parser.init();
const home = path.dirname(require.resolve("language-server-bitbake/package.json"));
const parser = new Parser();
parser.setLanguage(await Parser.Language.load(path.join(home, find(home))));

// The innermost places at which the text is not what the grammar expects.
const faults = (node) => {
  const below = node.children.flatMap(faults);
  return below.length || !(node.type === "ERROR" || node.isMissing()) ? below : [node.startPosition.row + 1];
};
let count = 0;
for (const file of files) {
  for (const line of new Set(faults(parser.parse(fs.readFileSync(file, "utf8")).rootNode))) {
    console.log(`${file}:${line}: not what bitbake's grammar expects`);
    ++count;
  }
}
process.exit(count ? 1 : 0);
