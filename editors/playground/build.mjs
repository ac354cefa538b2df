// Bundles codemirror.js into the playground page, with the licences of all packages in it.
import { build } from "esbuild";
import { readFileSync, writeFileSync } from "node:fs";

const PAGE = "../../cli/nscc_cli/playground/page/";

const { metafile, outputFiles } = await build({
  entryPoints: ["codemirror.js"],
  bundle: true,
  format: "esm",
  minify: true,
  charset: "utf8",
  target: "es2022",
  legalComments: "none",
  metafile: true,
  write: false,
});
const names = Object.keys(metafile.inputs).map((path) => path.match(/^node_modules\/((@[^/]+\/)?[^/]+)/)?.[1]);
const packages = [...new Set(names.filter(Boolean))].sort().map((name) => {
  const folder = `node_modules/${name}/`;
  const { version, license } = JSON.parse(readFileSync(`${folder}package.json`, "utf8"));
  return { title: `${name} ${version} (${license})`, text: readFileSync(`${folder}LICENSE`, "utf8") };
});
const titles = packages.map(({ title }) => title).join(", ");
writeFileSync(`${PAGE}codemirror.js`, `/*! ${titles}: see codemirror.LICENSE.txt */\n${outputFiles[0].text}`);
writeFileSync(`${PAGE}codemirror.LICENSE.txt`, packages.map(({ title, text }) => `${title}\n\n${text}`).join("\n"));
